#include "support/registry.h"
#include "tree/random_edits.h"

#include <QTest>
#include <set>

using namespace tree;

class DiffTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void diffIsTheUnsharedBlocks_data();
    void diffIsTheUnsharedBlocks();
    void diffTurnsOneContentIntoTheOther();
    void diffWithTheEmptyTreeIsEverything();
    void diffSeesThroughGrowingAndShrinkingRoots();
    void unsharedBytesAreThoseOfUnsharedObjects();
};

using Pointers = std::set<const void*>;

static Pointers blocksIn(const SurfelTree& tree) {
    Pointers out;
    for (const surfel::BlockPtr& block : test::blocksOf(tree))
        out.insert(block.get());
    return out;
}

static Pointers pointers(const std::vector<surfel::BlockPtr>& blocks) {
    Pointers out;
    for (const surfel::BlockPtr& block : blocks)
        out.insert(block.get());
    return out;
}

static Pointers without(const Pointers& a, const Pointers& b) {
    Pointers out;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(out, out.end()));
    return out;
}

static bool isExact(const SurfelTree& from, const SurfelTree& to) {
    const Diff d = diff(from, to);
    const Pointers a = blocksIn(from), b = blocksIn(to);
    return pointers(d.removed) == without(a, b) && pointers(d.added) == without(b, a) &&
           pointers(d.removed).size() == d.removed.size() && pointers(d.added).size() == d.added.size() &&
           d.empty() == (d.removed.empty() && d.added.empty());
}

void DiffTest::diffIsTheUnsharedBlocks_data() {
    QTest::addColumn<int>("count");
    QTest::newRow("one level") << 500;
    QTest::newRow("three levels") << 20000;
}

void DiffTest::diffIsTheUnsharedBlocks() {
    QFETCH(int, count);
    test::EditedModel model(static_cast<std::size_t>(count), test::seed());
    std::vector<SurfelTree> versions{model.tree()};
    for (std::size_t round = 0; round < 120; ++round) {
        model.apply(model.randomEdit());
        versions.push_back(model.tree());
        const SurfelTree& earlier = versions[model.random().below(versions.size())];
        const QString text = QString("round %1, seed %2").arg(round).arg(test::seed());
        QVERIFY2(isExact(versions[versions.size() - 2], model.tree()), qPrintable(text));
        QVERIFY2(isExact(earlier, model.tree()), qPrintable(text));
        QVERIFY2(isExact(model.tree(), earlier), qPrintable(text));
    }
}

void DiffTest::diffTurnsOneContentIntoTheOther() {
    test::EditedModel model(5000, test::seed());
    for (int round = 0; round < 100; ++round) {
        const SurfelTree from = model.tree();
        test::Content content = model.content();
        model.apply(model.randomEdit());
        const Diff d = diff(from, model.tree());
        for (const surfel::BlockPtr& block : d.removed)
            for (int slot = 0; slot < block->size(); ++slot)
                QCOMPARE(content.erase(test::numberOf(*block, slot)), std::size_t(1));
        for (const surfel::BlockPtr& block : d.added)
            for (int slot = 0; slot < block->size(); ++slot)
                QVERIFY(content.emplace(test::numberOf(*block, slot), block->surfel(slot)).second);
        QVERIFY2(content == model.content(), qPrintable(QString("round %1, seed %2").arg(round).arg(test::seed())));
    }
}

void DiffTest::diffWithTheEmptyTreeIsEverything() {
    base::Random random(test::seed());
    const SurfelTree tree = SurfelTree::build(test::bumpySphere(3000, random));
    QCOMPARE(diff({}, tree).added.size(), std::size_t(tree.blockCount()));
    QCOMPARE(diff(tree, {}).removed.size(), std::size_t(tree.blockCount()));
    QVERIFY(diff(tree, tree).empty());
    QVERIFY(diff({}, {}).empty());
    QCOMPARE(unsharedBytes(tree, {}), tree.bytes());
    QCOMPARE(unsharedBytes(tree, tree), std::size_t(0));
    // Added blocks come in tree order.
    QVERIFY(diff({}, tree).added == test::blocksOf(tree));
}

void DiffTest::diffSeesThroughGrowingAndShrinkingRoots() {
    test::EditedModel model(60000, test::seed());
    const SurfelTree large = model.tree();
    model.apply(model.removeAllBut({0, 0, 1}, 0.3));
    const SurfelTree small = model.tree();
    QVERIFY(small.root()->level < large.root()->level);
    QVERIFY(isExact(large, small));
    QVERIFY(isExact(small, large));
    QVERIFY(diff(large, small).removed.size() < large.blockCount()); // what is inside stays shared
    Edit grow;
    base::Random random(test::seed() + 1);
    grow.inserted = test::bumpySphere(60000, random);
    const SurfelTree regrown = small.apply(grow);
    QVERIFY(regrown.root()->level > small.root()->level);
    QVERIFY(isExact(small, regrown));
    QVERIFY(isExact(large, regrown));
}

/// All nodes and blocks of a tree with their bytes.
static void objects(const Node& node, std::map<const void*, std::size_t>& out) {
    out[&node] = sizeof(Node);
    for (std::size_t i = 0; i < node.childCount; ++i) {
        if (node.level > 1)
            objects(*node.nodes[i], out);
        else
            out[node.blocks[i].get()] = node.blocks[i]->bytes();
    }
}

void DiffTest::unsharedBytesAreThoseOfUnsharedObjects() {
    test::EditedModel model(20000, test::seed());
    for (int round = 0; round < 60; ++round) {
        const SurfelTree from = model.tree();
        model.apply(model.randomEdit());
        std::map<const void*, std::size_t> before, after;
        if (!from.empty())
            objects(*from.root(), before);
        if (!model.tree().empty())
            objects(*model.tree().root(), after);
        std::size_t expected = 0, total = 0;
        for (const auto& [object, bytes] : after) {
            total += bytes;
            expected += before.count(object) ? 0 : bytes;
        }
        QCOMPARE(unsharedBytes(model.tree(), from), expected);
        QCOMPARE(model.tree().bytes(), total);
    }
}

static const test::Registered<DiffTest> registered;
#include "diff_test.moc"
