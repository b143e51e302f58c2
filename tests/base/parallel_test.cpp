#include "core/base/parallel.h"

#include "core/base/cancel_scope.h"
#include "core/base/hash.h"
#include "core/base/parallel_sort.h"
#include "core/base/progress.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <atomic>
#include <QTest>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace base;

class ParallelTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyItemIsVisitedOnce();
    void chunksDoNotDependOnThreads();
    void anExceptionReachesTheCaller();
    void cancelledProgressThrows();
    void sortingIsTheSameAtAnyThreadCount();
    void loopsStopWithTheirScope();
    void sortingStopsWithItsScope();
    void loopsOutsideOfTheScopeGoOn();
    void hashOfASetDoesNotDependOnOrder();
    void hashTellsNeighbouringValuesApart();
    void cleanup() { setThreadCount(0); }
};

void ParallelTest::everyItemIsVisitedOnce() {
    for (std::size_t n : {0, 1, 7, 64, 1000, 4097}) {
        std::vector<std::atomic<int>> visits(n);
        parallelFor(n, 16, [&](std::size_t i) { ++visits[i]; });
        for (const auto& count : visits)
            QCOMPARE(count.load(), 1);
    }
}

void ParallelTest::chunksDoNotDependOnThreads() {
    const auto sums = [] {
        std::vector<float> out(chunkCount(10000, 37));
        parallelChunks(10000, 37, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            for (std::size_t i = begin; i < end; ++i)
                out[chunk] += 1.0f / static_cast<float>(i + 1);
        });
        return out;
    };
    setThreadCount(1);
    const auto one = sums();
    setThreadCount(0);
    QVERIFY(one == sums());
}

void ParallelTest::anExceptionReachesTheCaller() {
    QVERIFY_EXCEPTION_THROWN(parallelFor(1000, 1,
                                         [](std::size_t i) {
                                             if (i == 777)
                                                 throw Error("bad item", "item 777");
                                         }),
                             Error);
}

void ParallelTest::sortingIsTheSameAtAnyThreadCount() {
    Random random(test::seed());
    for (const std::size_t n : {0u, 1u, 2u, 1000u, 16384u, 16385u, 70001u}) {
        std::vector<std::uint64_t> items(n);
        for (std::uint64_t& item : items)
            item = random.below(n + 1); // some of them alike
        std::vector<std::uint64_t> wanted = items;
        std::sort(wanted.begin(), wanted.end());
        for (const int threads : {1, 2}) {
            setThreadCount(threads);
            std::vector<std::uint64_t> sorted = items;
            parallelSort(sorted, std::less<>());
            QVERIFY(sorted == wanted);
        }
    }
}

/// Wherever it is then: in the pieces or in putting them together.
void ParallelTest::sortingStopsWithItsScope() {
    Random random(test::seed());
    std::vector<std::uint64_t> items(1 << 18);
    for (std::uint64_t& item : items)
        item = random.next();
    for (const int threads : {1, 2}) {
        setThreadCount(threads);
        for (const long most : {1000l, 4000000l}) {
            std::atomic<bool> cancel{false};
            std::atomic<long> looks{0};
            const CancelScope scope(&cancel);
            const auto less = [&](std::uint64_t a, std::uint64_t b) {
                if (++looks == most)
                    cancel = true;
                return a < b;
            };
            std::vector<std::uint64_t> sorted = items;
            QVERIFY_EXCEPTION_THROWN(parallelSort(sorted, less), Cancelled);
            QVERIFY(looks < most + 600000 * threads);
        }
    }
}

void ParallelTest::loopsStopWithTheirScope() {
    for (const int threads : {1, 0}) {
        setThreadCount(threads);
        std::atomic<bool> cancel{false};
        std::atomic<int> outer{0}, inner{0};
        const CancelScope scope(&cancel);
        QVERIFY_EXCEPTION_THROWN(parallelFor(1000, 1,
                                             [&](std::size_t) {
                                                 ++outer;
                                                 parallelFor(1000, 1, [&](std::size_t i) {
                                                     ++inner; // on any thread
                                                     if (i == 3)
                                                         cancel = true;
                                                 });
                                             }),
                                 Cancelled);
        QVERIFY(outer < 1000 && inner < 2000 * threadCount());
        QVERIFY_EXCEPTION_THROWN(parallelFor(1, 1, [](std::size_t) {}), Cancelled);
        QVERIFY_EXCEPTION_THROWN(CancelScope::check(), Cancelled);
    }
}

void ParallelTest::loopsOutsideOfTheScopeGoOn() {
    std::atomic<bool> cancel{true};
    int visits = 0;
    {
        const CancelScope scope(&cancel);
        const CancelScope none(nullptr); // no scope: the one around it stays
        QVERIFY(CancelScope::flag() == &cancel);
        std::thread([&] { parallelFor(10, 10, [&](std::size_t) { ++visits; }); }).join();
    }
    parallelFor(10, 10, [&](std::size_t) { ++visits; });
    QCOMPARE(visits, 20);
    QVERIFY(CancelScope::flag() == nullptr);
}

void ParallelTest::cancelledProgressThrows() {
    std::atomic<bool> cancel{false};
    double seen = -1;
    const Progress progress{[&](double done, std::string_view) { seen = done; }, &cancel};
    progress.step(0.25, "working");
    QCOMPARE(seen, 0.25);
    cancel = true;
    QVERIFY_EXCEPTION_THROWN(progress.step(0.5, "working"), Cancelled);
    QCOMPARE(seen, 0.25);
}

void ParallelTest::hashOfASetDoesNotDependOnOrder() {
    std::vector<Hash128> items;
    for (std::uint32_t i = 0; i < 100; ++i)
        items.push_back(hashWords(std::vector<std::uint32_t>{i, i * i}));
    Hash128 forward, backward;
    for (std::size_t i = 0; i < items.size(); ++i) {
        forward += items[i];
        backward += items[items.size() - 1 - i];
    }
    QVERIFY(forward == backward);
    QCOMPARE(forward.text().size(), std::size_t(32));
}

void ParallelTest::hashTellsNeighbouringValuesApart() {
    const std::vector<std::uint32_t> a{1, 2}, b{2, 1}, c{1, 2, 0}, d{1, 3};
    QVERIFY(!(hashWords(a) == hashWords(b)) && !(hashWords(a) == hashWords(c)) && !(hashWords(a) == hashWords(d)));
}

static const test::Registered<ParallelTest> registered;
#include "parallel_test.moc"
