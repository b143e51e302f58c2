#include "core/base/scratch.h"

#include "core/base/parallel.h"
#include "support/registry.h"

#include <atomic>
#include <QTest>
#include <set>
#include <stdexcept>

using namespace base;

class ScratchTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void memoryIsUsedOverAgain();
    void whoTakesInsideOfAnotherHasItsOwn();
    void threadsNeverShare();
    void whatCannotBeMadeLeavesTheRest();
};

void ScratchTest::memoryIsUsedOverAgain() {
    Scratch<std::vector<int>> scratch;
    const int* grown = nullptr;
    {
        const auto taken = scratch.take();
        taken->assign(1000, 7);
        grown = taken->data();
    }
    const auto again = scratch.take();
    QCOMPARE((*again).data(), grown);
    QCOMPARE(again->size(), std::size_t(1000));
}

void ScratchTest::whoTakesInsideOfAnotherHasItsOwn() {
    Scratch<int> scratch;
    const auto outer = scratch.take();
    *outer = 1;
    {
        const auto inner = scratch.take();
        QVERIFY(&*inner != &*outer);
        *inner = 2;
    }
    QCOMPARE(*outer, 1);
}

void ScratchTest::threadsNeverShare() {
    struct Guarded {
        std::atomic<int> inside{0};
    };
    Scratch<Guarded> scratch;
    std::atomic<int> shared{0};
    parallelFor(20000, 1, [&](std::size_t) {
        const auto mine = scratch.take();
        shared += mine->inside.fetch_add(1);
        mine->inside.fetch_sub(1);
    });
    QCOMPARE(shared.load(), 0);
}

void ScratchTest::whatCannotBeMadeLeavesTheRest() {
    struct Third {
        static int& made() {
            static int count = 0;
            return count;
        }
        Third() {
            if (++made() == 3)
                throw std::runtime_error("no third");
        }
    };
    Scratch<Third> scratch;
    const auto a = scratch.take(), b = scratch.take();
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, scratch.take());
    const auto c = scratch.take();
    QCOMPARE((std::set<const Third*>{&*a, &*b, &*c}).size(), std::size_t(3));
}

static const test::Registered<ScratchTest> registered;
#include "scratch_test.moc"
