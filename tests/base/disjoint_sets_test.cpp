#include "core/base/disjoint_sets.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using namespace base;

class DisjointSetsTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    /// Beside labels that are all rewritten at every join.
    void AgreesWithLabels() {
        constexpr std::uint32_t count = 300;
        Random random(test::seed());
        DisjointSets sets(count);
        std::vector<std::uint32_t> label(count);
        std::iota(label.begin(), label.end(), 0u);
        for (int i = 0; i < 400; ++i) {
            const auto a = static_cast<std::uint32_t>(random.below(count));
            const auto b = static_cast<std::uint32_t>(random.below(count));
            QCOMPARE(sets.join(a, b), label[a] != label[b]);
            const std::uint32_t least = std::min(label[a], label[b]), most = std::max(label[a], label[b]);
            std::replace(label.begin(), label.end(), most, least);
            for (std::uint32_t k = 0; k < count; k += 17)
                QCOMPARE(sets.find(k), label[k]); // the smallest member represents
        }
    }

    /// Every member has a sign of its own: what is said of two of them is true until it is said wrongly.
    void KnowsWhoIsOpposite() {
        constexpr std::uint32_t count = 200;
        Random random(test::seed() + 1);
        std::vector<bool> sign(count);
        for (std::uint32_t i = 0; i < count; ++i)
            sign[i] = random.below(2) == 1;
        ParitySets sets(count);
        for (int i = 0; i < 2000; ++i) {
            const auto a = static_cast<std::uint32_t>(random.below(count));
            const auto b = static_cast<std::uint32_t>(random.below(count));
            const auto p = sets.find(a), q = sets.find(b);
            const bool opposite = sign[a] != sign[b];
            if (p.root == q.root) {
                QCOMPARE(p.opposite != q.opposite, opposite);
                QVERIFY(!sets.relate(a, b, !opposite));
            }
            QVERIFY(sets.relate(a, b, opposite));
            QCOMPARE(sets.find(a).root, sets.find(b).root);
            QVERIFY(sets.find(a).root <= std::min(a, b));
        }
    }
};

static const test::Registered<DisjointSetsTest> registered;
#include "disjoint_sets_test.moc"
