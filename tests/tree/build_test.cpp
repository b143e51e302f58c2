#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/tree/morton.h"
#include "support/registry.h"
#include "support/threads.h"
#include "tree/fixtures.h"

#include <QTest>

using namespace tree;

class BuildTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void treeHoldsEverySurfelOnce_data();
    void treeHoldsEverySurfelOnce();
    void buildIsTheSameAtAnyThreadCount();
    void blocksAreNearlyFull();
    void coincidentSurfelsMakeATree();
    void surfelsOnALineMakeATree();
    void emptyListMakesTheEmptyTree();
    void buildRefusesWhatNoTreeCanHold();
    void buildStopsWhenCancelled();
    void progressRunsFromStartToEnd();
    void hashIsThatOfTheContent();
    void layoutWithTheSameWordsKeepsTheSurfels();
    void keysAreSortedAndComplete();
    void runsAreCutWhereTheCurveJumps();
    void validateNamesABrokenInvariant();
};

void BuildTest::treeHoldsEverySurfelOnce_data() {
    QTest::addColumn<int>("count");
    for (const int count : {1, 2, 15, 16, 17, 112, 113, 128, 129, 300, 896, 897, 1025, 7168, 7169, 58000, 140000})
        QTest::addRow("%d", count) << count;
}

void BuildTest::treeHoldsEverySurfelOnce() {
    QFETCH(int, count);
    base::Random random(test::seed());
    const surfel::SurfelList list = test::bumpySphere(static_cast<std::size_t>(count), random);
    const SurfelTree tree = SurfelTree::build(list);
    tree.validate();
    QCOMPARE(tree.size(), list.size());
    QVERIFY(test::contentOf(tree) == test::contentOf(list));
    base::Box3f box;
    float support = 0;
    for (const surfel::Surfel& s : list.items)
        box.extend(s.position), support = std::max(support, s.support);
    QVERIFY(tree.bounds() == box);
    QCOMPARE(tree.maxSupport(), support);
    std::uint32_t next = 0;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        QCOMPARE(number, next++);
        QVERIFY(tree.block(number).get() == &block);
    });
    QCOMPARE(next, tree.blockCount());
}

void BuildTest::buildIsTheSameAtAnyThreadCount() {
    base::Random random(test::seed());
    const surfel::SurfelList list = test::bumpySphere(200000, random);
    const auto work = [&] { return SurfelTree::build(list); };
    const SurfelTree serial = test::onThreads(1, work), parallel = test::onThreads(2, work);
    QVERIFY(test::sameStructure(serial, parallel));
}

void BuildTest::blocksAreNearlyFull() {
    base::Random random(test::seed());
    const SurfelTree tree = SurfelTree::build(test::bumpySphere(100000, random));
    QVERIFY(tree.blockCount() <= 100000 / 110 + 2);
    tree.forEachBlock([](std::uint32_t, const surfel::SurfelBlock& block) { QVERIFY(block.size() > 80); });
    // 36 bytes per surfel and 4 for its number, the headers and the nodes.
    QVERIFY(static_cast<double>(tree.bytes()) / 100000 < 45);
}

void BuildTest::coincidentSurfelsMakeATree() {
    base::Random random(test::seed());
    surfel::SurfelList list = test::bumpySphere(70000, random);
    for (surfel::Surfel& s : list.items)
        s.position = {1, 2, 3};
    const SurfelTree tree = SurfelTree::build(list);
    tree.validate();
    QVERIFY(test::contentOf(tree) == test::contentOf(list));
}

void BuildTest::surfelsOnALineMakeATree() {
    base::Random random(test::seed());
    surfel::SurfelList list = test::bumpySphere(5000, random);
    for (std::size_t i = 0; i < list.size(); ++i)
        list.items[i].position = {0, static_cast<float>(i % 100) * 1e-30f, -1e6f};
    const SurfelTree tree = SurfelTree::build(list);
    tree.validate();
    QVERIFY(test::contentOf(tree) == test::contentOf(list));
}

void BuildTest::emptyListMakesTheEmptyTree() {
    surfel::SurfelList list;
    list.layout = test::numberedLayout();
    const SurfelTree tree = SurfelTree::build(list);
    QVERIFY(tree.empty());
    QVERIFY(tree.layout() == list.layout);
    QCOMPARE(tree.maxSupport(), 0.0f);
    QCOMPARE(tree.bytes(), std::size_t(0));
    tree.validate();
    tree.forEachBlock([](std::uint32_t, const surfel::SurfelBlock&) { QFAIL("the empty tree has no block"); });
}

void BuildTest::buildRefusesWhatNoTreeCanHold() {
    base::Random random(test::seed());
    surfel::SurfelList list = test::bumpySphere(1000, random);
    list.items[500].position.z = std::numeric_limits<float>::infinity();
    QVERIFY_EXCEPTION_THROWN(SurfelTree::build(list), base::Error);
    list.items[500].position.z = 0;
    list.items[500].support = 0;
    QVERIFY_EXCEPTION_THROWN(SurfelTree::build(list), base::Error);
    list.items[500].support = std::numeric_limits<float>::quiet_NaN();
    QVERIFY_EXCEPTION_THROWN(SurfelTree::build(list), base::Error);
}

void BuildTest::buildStopsWhenCancelled() {
    base::Random random(test::seed());
    const surfel::SurfelList list = test::bumpySphere(1000, random);
    const std::atomic<bool> cancel{true};
    base::Progress progress;
    progress.cancel = &cancel;
    QVERIFY_EXCEPTION_THROWN(SurfelTree::build(list, progress), base::Cancelled);
}

void BuildTest::progressRunsFromStartToEnd() {
    base::Random random(test::seed());
    double last = 0;
    base::Progress progress;
    progress.report = [&](double done, std::string_view) {
        QVERIFY(done >= last);
        last = done;
    };
    SurfelTree::build(test::bumpySphere(1000, random), progress);
    QCOMPARE(last, 1.0);
}

void BuildTest::hashIsThatOfTheContent() {
    base::Random random(test::seed());
    surfel::SurfelList list = test::bumpySphere(20000, random), shuffled;
    shuffled.layout = list.layout;
    for (std::size_t i = list.size(); i-- > 0;)
        shuffled.append(list.items[i], list.extraOf(i));
    const base::Hash128 hash = SurfelTree::build(list).contentHash();
    QVERIFY(hash == SurfelTree::build(shuffled).contentHash());
    Edit edit;
    edit.inserted.layout = list.layout;
    surfel::SurfelList part;
    part.layout = list.layout;
    for (std::size_t i = 0; i < list.size(); ++i)
        (i % 2 ? edit.inserted : part).append(list.items[i], list.extraOf(i));
    QVERIFY(hash == SurfelTree::build(part).apply(edit).contentHash());
    list.items[77].mask += 0.25f;
    QVERIFY(!(hash == SurfelTree::build(list).contentHash()));
}

void BuildTest::layoutWithTheSameWordsKeepsTheSurfels() {
    base::Random random(test::seed());
    const SurfelTree tree = SurfelTree::build(test::bumpySphere(500, random));
    auto coloured = std::make_shared<surfel::AttributeLayout>(*tree.layout());
    coloured->colours = true;
    const SurfelTree other = tree.withLayout(coloured);
    QVERIFY(other.layout()->colours);
    QVERIFY(other.root() == tree.root());
}

void BuildTest::keysAreSortedAndComplete() {
    base::Random random(test::seed());
    const surfel::SurfelList list = test::bumpySphere(100000, random);
    base::Box3f box;
    for (const surfel::Surfel& s : list.items)
        box.extend(s.position);
    const auto sorted = sortedKeys(list.items, box);
    const std::vector<MortonKey> keys(sorted.begin(), sorted.end());
    const MortonGrid grid(box);
    std::vector<MortonKey> expected;
    for (std::uint32_t i = 0; i < list.size(); ++i)
        expected.push_back(MortonKey(grid.code(list.items[i].position)) << 32 | i);
    std::sort(expected.begin(), expected.end());
    QVERIFY(keys == expected);
    std::vector<base::Vec3f> positions;
    for (const surfel::Surfel& s : list.items)
        positions.push_back(s.position);
    QVERIFY(std::ranges::equal(sortedKeys(positions, box), expected));
    // The corners of the grid: all bits of the longest axis at its end, none at the origin.
    QCOMPARE(grid.code(box.lo), 0u);
    QCOMPARE(MortonGrid({{0, 0, 0}, {1, 1, 1}}).code({1, 1, 1}), (1u << 30) - 1);
    QCOMPARE(MortonGrid({{0, 0, 0}, {1, 1, 1}}).code({0, 0.5f, 0}), 1u << 28);
}

void BuildTest::runsAreCutWhereTheCurveJumps() {
    std::vector<MortonKey> keys;
    for (MortonKey i = 0; i < 100; ++i)
        keys.push_back((i < 57 ? i : 4096 + i) << 32 | i);
    QVERIFY(cutRuns(keys, 60) == (std::vector<std::size_t>{57, 100}));
    for (MortonKey& key : keys)
        key &= 0xffffffffu; // one cell: no change anywhere, cut in the middle
    QVERIFY(cutRuns(keys, 60) == (std::vector<std::size_t>{50, 100}));
}

/// Breaks one thing at a time and expects validate() to see it.
void BuildTest::validateNamesABrokenInvariant() {
    base::Random random(test::seed());
    const SurfelTree tree = SurfelTree::build(test::bumpySphere(10000, random));
    Node& root = const_cast<Node&>(*tree.root());
    Node& leaf = [&]() -> Node& {
        const Node* node = &root;
        while (node->level > 1)
            node = node->nodes[0].get();
        return const_cast<Node&>(*node);
    }();
    const auto breaks = [&](auto& field, auto value) {
        const auto kept = std::exchange(field, value);
        const auto restore = [&] { field = kept; };
        try {
            tree.validate();
        } catch (const std::logic_error&) {
            restore();
            return true;
        }
        restore();
        return false;
    };
    tree.validate();
    QVERIFY(breaks(root.loX[0], root.loX[0] - 1));
    QVERIFY(breaks(root.maxSupport[1], root.maxSupport[1] * 2));
    QVERIFY(breaks(root.surfelCount, root.surfelCount + 1));
    QVERIFY(breaks(root.blockCount, root.blockCount - 1));
    QVERIFY(breaks(root.surfelsIn[1], 0u));
    QVERIFY(breaks(root.firstBlock[1], 1u));
    QVERIFY(breaks(root.childCount, std::uint8_t(1)));
    QVERIFY(breaks(root.nodes[0], root.nodes[0]->nodes[0]));
    QVERIFY(breaks(leaf.blocks[0], surfel::BlockPtr()));
    QVERIFY(breaks(leaf.hiY[leaf.childCount - 1], 0.0f));
    float* position = const_cast<float*>(leaf.blocks[0]->channel(0, surfel::X));
    QVERIFY(breaks(position[2], 40.0f));
    QVERIFY(breaks(position[2], std::numeric_limits<float>::quiet_NaN()));
    float* support = const_cast<float*>(leaf.blocks[0]->channel(0, surfel::Support));
    QVERIFY(breaks(support[2], 0.0f));
    QVERIFY(breaks(support[2], 40.0f));
    tree.validate();
}

static const test::Registered<BuildTest> registered;
#include "build_test.moc"
