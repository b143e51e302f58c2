#include "core/base/error.h"
#include "core/base/parallel.h"
#include "support/registry.h"
#include "support/threads.h"
#include "tree/random_edits.h"

#include <QTest>
#include <set>

using namespace tree;

class ApplyTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void randomEditsKeepContentAndInvariants_data();
    void randomEditsKeepContentAndInvariants();
    void editIsTheSameAtAnyThreadCount();
    void editLeavesTheOldVersionAlone();
    void removingEverythingGivesTheEmptyTree();
    void insertingIntoTheEmptyTreeBuildsOne();
    void treeShrinksToAFewSurfelsAndGrowsAgain();
    void emptyEditReturnsTheSameVersion();
    void removalSharesAllOtherBlocks();
    void changeReplacesOneBlockAndItsPath();
    void removalWinsOverChange();
    void manyInsertionsAtOnePointStayInBlocks();
    void largeInsertionIntoASmallTree();
    void insertedSurfelsMustBeFinite();
};

static QString where(std::size_t round, std::uint64_t seed) {
    return QString("round %1, seed %2").arg(round).arg(seed);
}

static base::Box3f boxOf(const test::Content& content) {
    base::Box3f box;
    for (const auto& [number, surfel] : content)
        box.extend(surfel.position);
    return box;
}

void ApplyTest::randomEditsKeepContentAndInvariants_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("edits");
    QTest::newRow("one block") << 40 << 600;
    QTest::newRow("one level") << 700 << 1500;
    QTest::newRow("two levels") << 5000 << 400;
    QTest::newRow("four levels") << 60000 << 40;
}

void ApplyTest::randomEditsKeepContentAndInvariants() {
    QFETCH(int, count);
    QFETCH(int, edits);
    test::EditedModel model(static_cast<std::size_t>(count), test::seed() + static_cast<std::uint64_t>(count));
    for (std::size_t round = 0; round < static_cast<std::size_t>(edits); ++round) {
        model.apply(model.randomEdit());
        try {
            model.tree().validate();
        } catch (const std::logic_error& error) {
            QFAIL(qPrintable(where(round, test::seed()) + ": " + error.what()));
        }
        QVERIFY2(test::contentOf(model.tree()) == model.content(), qPrintable(where(round, test::seed())));
        QVERIFY2(model.tree().bounds() == boxOf(model.content()), qPrintable(where(round, test::seed())));
    }
}

void ApplyTest::editIsTheSameAtAnyThreadCount() {
    test::EditedModel model(60000, test::seed());
    for (std::size_t round = 0; round < 30; ++round) {
        const Edit edit = model.randomEdit();
        const auto work = [&] { return model.tree().apply(edit); };
        const SurfelTree serial = test::onThreads(1, work), parallel = test::onThreads(2, work);
        QVERIFY2(test::sameStructure(serial, parallel), qPrintable(where(round, test::seed())));
        model.apply(edit);
    }
}

void ApplyTest::editLeavesTheOldVersionAlone() {
    test::EditedModel model(5000, test::seed());
    std::vector<SurfelTree> versions{model.tree()};
    std::vector<test::Content> contents{model.content()};
    for (int round = 0; round < 50; ++round) {
        model.apply(model.randomEdit());
        versions.push_back(model.tree());
        contents.push_back(model.content());
    }
    for (std::size_t v = 0; v < versions.size(); ++v) {
        versions[v].validate();
        QVERIFY2(test::contentOf(versions[v]) == contents[v], qPrintable(where(v, test::seed())));
    }
}

void ApplyTest::removingEverythingGivesTheEmptyTree() {
    test::EditedModel model(5000, test::seed());
    const SurfelTree none = model.tree().apply(model.removeAllBut({}, 0));
    QVERIFY(none.empty());
    QCOMPARE(none.size(), std::size_t(0));
    QCOMPARE(none.blockCount(), 0u);
    QVERIFY(none.layout() == model.tree().layout());
    QVERIFY(none.bounds().empty());
    none.validate();
    QVERIFY(none.contentHash() == base::Hash128());
}

void ApplyTest::insertingIntoTheEmptyTreeBuildsOne() {
    base::Random random(test::seed());
    Edit edit;
    edit.inserted = test::bumpySphere(3000, random);
    const SurfelTree fresh = SurfelTree().apply(edit);
    fresh.validate();
    QVERIFY(test::contentOf(fresh) == test::contentOf(edit.inserted));
    QVERIFY(fresh.layout() == edit.inserted.layout);
}

void ApplyTest::treeShrinksToAFewSurfelsAndGrowsAgain() {
    test::EditedModel model(60000, test::seed());
    for (const double radius : {1.7, 1.2, 0.8, 0.4, 0.2, 0.1, 0.05, 0.03}) {
        model.apply(model.removeAllBut({0, 0, 1.02}, radius));
        model.tree().validate();
        QVERIFY(test::contentOf(model.tree()) == model.content());
    }
    QVERIFY(model.tree().size() > 0);
    QCOMPARE(int(model.tree().root()->level), 1);
    Edit edit;
    base::Random random(test::seed());
    edit.inserted = test::bumpySphere(20000, random);
    const SurfelTree grown = model.tree().apply(edit);
    grown.validate();
    QCOMPARE(grown.size(), model.tree().size() + 20000);
}

void ApplyTest::emptyEditReturnsTheSameVersion() {
    test::EditedModel model(500, test::seed());
    QVERIFY(model.tree().apply({}) == model.tree());
    QVERIFY(SurfelTree().apply({}) == SurfelTree());
}

void ApplyTest::removalSharesAllOtherBlocks() {
    test::EditedModel model(30000, test::seed());
    for (std::uint32_t number = 0; number < model.tree().blockCount(); number += 17) {
        Edit edit;
        edit.blocks.push_back({number, {}, {}});
        edit.blocks[0].removed.set(0, 5);
        const SurfelTree next = model.tree().apply(edit);
        const Diff d = diff(model.tree(), next);
        QCOMPARE(d.removed.size(), std::size_t(1));
        QVERIFY(d.removed[0] == model.tree().block(number));
        QCOMPARE(d.added.size(), std::size_t(1));
        QVERIFY(unsharedBytes(next, model.tree()) < next.bytes() / 10);
    }
}

void ApplyTest::changeReplacesOneBlockAndItsPath() {
    test::EditedModel model(30000, test::seed());
    const SurfelTree& old = model.tree();
    const surfel::MutableBlockPtr changed = old.block(7)->clone();
    changed->setPosition(3, {3, 3, 3});
    changed->seal();
    Edit edit;
    edit.blocks.push_back({7, changed, {}});
    const SurfelTree next = old.apply(edit);
    next.validate();
    QVERIFY(next.block(7) == surfel::BlockPtr(changed));
    for (std::uint32_t number = 0; number < old.blockCount(); ++number)
        if (number != 7)
            QVERIFY(next.block(number) == old.block(number));
    QCOMPARE(unsharedBytes(next, old), changed->bytes() + old.root()->level * sizeof(Node));
    QVERIFY(next.bounds().hi == (base::Vec3f{3, 3, 3}));
}

void ApplyTest::removalWinsOverChange() {
    test::EditedModel model(300, test::seed());
    const surfel::MutableBlockPtr changed = model.tree().block(0)->clone();
    changed->setPosition(0, {9, 9, 9});
    changed->setPosition(1, {5, 5, 5});
    changed->seal();
    Edit edit;
    edit.blocks.push_back({0, changed, {}});
    edit.blocks[0].removed.set(0);
    const SurfelTree next = model.tree().apply(edit);
    QCOMPARE(next.size(), std::size_t(299));
    QVERIFY(next.bounds().hi == (base::Vec3f{5, 5, 5}));
}

void ApplyTest::manyInsertionsAtOnePointStayInBlocks() {
    test::EditedModel model(1000, test::seed());
    Edit edit;
    edit.inserted.layout = test::numberedLayout();
    for (std::uint32_t i = 0; i < 5000; ++i) {
        surfel::Surfel s;
        s.position = {0, 0, 1};
        s.support = 0.1f;
        const std::uint32_t number = 1000 + i;
        edit.inserted.append(s, {&number, 1});
    }
    const SurfelTree next = model.tree().apply(edit);
    next.validate();
    QCOMPARE(next.size(), std::size_t(6000));
    QCOMPARE(test::contentOf(next).size(), std::size_t(6000));
}

void ApplyTest::largeInsertionIntoASmallTree() {
    test::EditedModel model(50, test::seed());
    base::Random random(test::seed() + 1);
    Edit edit;
    edit.inserted = test::bumpySphere(100000, random);
    for (std::uint32_t& number : edit.inserted.extra)
        number += 50;
    test::Content expected = test::contentOf(edit.inserted);
    expected.insert(model.content().begin(), model.content().end());
    const SurfelTree next = model.tree().apply(edit);
    next.validate();
    QVERIFY(test::contentOf(next) == expected);
}

void ApplyTest::insertedSurfelsMustBeFinite() {
    test::EditedModel model(50, test::seed());
    surfel::Surfel s;
    s.support = 1;
    s.position.y = std::numeric_limits<float>::quiet_NaN();
    const std::uint32_t number = 50;
    Edit edit;
    edit.inserted.layout = test::numberedLayout();
    edit.inserted.append(s, {&number, 1});
    QVERIFY_EXCEPTION_THROWN(model.tree().apply(edit), base::Error);
    edit.inserted.items[0] = {};
    QVERIFY_EXCEPTION_THROWN(model.tree().apply(edit), base::Error);
}

static const test::Registered<ApplyTest> registered;
#include "apply_test.moc"
