// Trees beside each other: one that shares all blocks, whose queries find what each of them finds.
#include "support/registry.h"
#include "tree/random_edits.h"

#include <QTest>
#include <set>

using namespace tree;

class BesideTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void blocksAreThoseOfAll_data();
    void blocksAreThoseOfAll();
    void queriesFindWhatEachTreeFinds();
    void emptyTreesAddNothing();
};

static SurfelTree cloud(std::size_t count, std::uint64_t seed, float shift) {
    base::Random random(seed);
    surfel::SurfelList list;
    for (std::size_t i = 0; i < count; ++i) {
        surfel::Surfel s;
        s.position = {shift + static_cast<float>(random.uniform(0, 1)), static_cast<float>(random.uniform(0, 1)),
                      static_cast<float>(random.uniform(0, 1))};
        s.support = 0.05f;
        list.append(s, {});
    }
    return SurfelTree::build(list);
}

void BesideTest::blocksAreThoseOfAll_data() {
    QTest::addColumn<std::vector<int>>("counts");
    QTest::newRow("alike") << std::vector<int>{3000, 3000};
    QTest::newRow("one block and many") << std::vector<int>{20, 40000};
    QTest::newRow("many and one block") << std::vector<int>{40000, 20, 300};
    QTest::newRow("more than a node holds") << std::vector<int>{50, 60, 7000, 80, 90, 100, 110, 120, 130, 140, 5000};
    QTest::newRow("alone") << std::vector<int>{900};
}

void BesideTest::blocksAreThoseOfAll() {
    QFETCH(std::vector<int>, counts);
    std::vector<SurfelTree> trees;
    std::set<const void*> wanted, found;
    base::Box3f box;
    std::size_t surfels = 0;
    for (const int count : counts) {
        trees.push_back(cloud(static_cast<std::size_t>(count), test::seed() + trees.size(), float(trees.size())));
        box.extend(trees.back().bounds());
        surfels += trees.back().size();
        trees.back().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { wanted.insert(&block); });
    }
    const SurfelTree all = SurfelTree::beside(trees);
    all.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        found.insert(&block);
        QVERIFY(all.block(number).get() == &block);
    });
    QVERIFY(found == wanted);
    QVERIFY(all.bounds() == box);
    QCOMPARE(all.size(), surfels);
    QCOMPARE(std::size_t(all.blockCount()), wanted.size());
    std::size_t added = 0;
    for (const SurfelTree& each : trees)
        added += each.blockCount();
    QCOMPARE(diff(trees.front(), all).added.size(), added - trees.front().blockCount());
    QVERIFY(diff(trees.front(), all).removed.empty());
}

void BesideTest::queriesFindWhatEachTreeFinds() {
    base::Random random(test::seed());
    const std::vector<SurfelTree> trees{cloud(200, test::seed(), 0), cloud(20000, test::seed() + 1, 0.5f),
                                        cloud(3000, test::seed() + 2, 0.2f)};
    const SurfelTree all = SurfelTree::beside(trees);
    for (int k = 0; k < 300; ++k) {
        const base::Vec3f x{static_cast<float>(random.uniform(0, 1.5)), static_cast<float>(random.uniform(0, 1)),
                            static_cast<float>(random.uniform(0, 1))};
        std::set<std::pair<const void*, int>> wanted, found;
        for (const SurfelTree& each : trees)
            each.forClustersInSupport(x, [&](const surfel::SurfelBlock& b, int c) { wanted.emplace(&b, c); });
        all.forClustersInSupport(x, [&](const surfel::SurfelBlock& b, int c) { found.emplace(&b, c); });
        QVERIFY(found == wanted);
    }
}

void BesideTest::emptyTreesAddNothing() {
    const SurfelTree one = cloud(500, test::seed(), 0);
    QVERIFY(SurfelTree::beside({}).empty());
    const std::vector<SurfelTree> trees{{}, one, {}};
    QVERIFY(SurfelTree::beside(trees) == one);
}

static const test::Registered<BesideTest> registered;
#include "beside_test.moc"
