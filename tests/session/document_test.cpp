#include "core/session/document.h"

#include "support/registry.h"
#include "workbench.h"

#include <algorithm>
#include <QTest>

using test::Workbench;

class DocumentTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void undoAndRedoBringBackTheSameBits();
    void aNewStepDropsRedo();
    void theBudgetDropsTheOldestStepsFirst();
    void sharedBlocksCostNothing();
    void modifiedKnowsTheSavedVersion();
    void theHashIgnoresHowTheTreeIsCut();
    void theHashKnowsNamesTypesAndOrigin();
};

void DocumentTest::undoAndRedoBringBackTheSameBits() {
    Workbench bench;
    bench.run(test::newSphere());
    std::vector<std::string> hashes{bench.hash()};
    for (int k = 0; k < 5; ++k) {
        bench.run(test::strokeAt(0.15 * k - 0.3));
        hashes.push_back(bench.hash());
        QVERIFY(hashes[hashes.size() - 2] != hashes.back());
    }
    for (std::size_t k = hashes.size() - 1; k-- > 0;) {
        bench.document.undo();
        QCOMPARE(bench.hash(), hashes[k]);
    }
    QVERIFY(!bench.document.canUndo());
    for (std::size_t k = 1; k < hashes.size(); ++k) {
        bench.document.redo();
        QCOMPARE(bench.hash(), hashes[k]);
    }
    QVERIFY(!bench.document.canRedo());
}

void DocumentTest::aNewStepDropsRedo() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(test::strokeAt(0));
    bench.run(test::strokeAt(0.2));
    bench.document.undo();
    QVERIFY(bench.document.canRedo());
    bench.run(test::strokeAt(-0.2));
    QVERIFY(!bench.document.canRedo());
    bench.document.undo();
    bench.document.undo();
    QVERIFY(!bench.document.canUndo());
}

void DocumentTest::theBudgetDropsTheOldestStepsFirst() {
    Workbench bench;
    bench.run(test::newSphere());
    std::vector<std::string> hashes{bench.hash()};
    std::vector<std::size_t> held;
    for (int k = 0; k < 6; ++k) {
        bench.run(test::strokeAt(0.1 * k - 0.3));
        hashes.push_back(bench.hash());
        held.push_back(bench.document.historyBytes());
        QVERIFY(held.size() == 1 || held.back() > held[held.size() - 2]);
    }
    const std::size_t lastThree = held[5] - held[2];
    bench.document.setHistoryBudget(lastThree);
    QCOMPARE(bench.document.historyBytes(), lastThree);
    for (std::size_t k = 5; k >= 3; --k) {
        QVERIFY(bench.document.canUndo());
        bench.document.undo();
        QCOMPARE(bench.hash(), hashes[k]);
    }
    QVERIFY(!bench.document.canUndo());
    bench.document.setHistoryBudget(0);
    QVERIFY(bench.document.canRedo());
    bench.document.redo();
    QCOMPARE(bench.hash(), hashes[4]);
    QVERIFY(!bench.document.canRedo());
}

void DocumentTest::sharedBlocksCostNothing() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.document.commit(bench.document.surface(), "nothing");
    QCOMPARE(bench.document.historyBytes(), std::size_t(0));
    bench.run(test::strokeAt(0));
    QVERIFY(bench.document.historyBytes() > 0);
    QVERIFY(bench.document.historyBytes() <= bench.document.surface().tree().bytes());
}

void DocumentTest::modifiedKnowsTheSavedVersion() {
    Workbench bench;
    bench.run(test::newSphere());
    QVERIFY(!bench.document.modified());
    bench.run(test::strokeAt(0));
    QVERIFY(bench.document.modified());
    bench.document.undo();
    QVERIFY(!bench.document.modified());
    bench.document.redo();
    bench.document.saved("somewhere.ply");
    QVERIFY(!bench.document.modified());
    bench.document.undo();
    QVERIFY(bench.document.modified());
    bench.run(test::strokeAt(0));
    QVERIFY(bench.document.modified());
}

void DocumentTest::theHashIgnoresHowTheTreeIsCut() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(test::strokeAt(0));
    surfel::SurfelList points = bench.document.surface().tree().surfels();
    std::reverse(points.items.begin(), points.items.end());
    const auto rebuilt = tree::SurfelTree::build(points);
    QCOMPARE(session::contentHash(rebuilt, {}).text(), bench.hash());
    points.items[17].normal.x += 1e-6f;
    QVERIFY(session::contentHash(tree::SurfelTree::build(points), {}).text() != bench.hash());
}

void DocumentTest::theHashKnowsNamesTypesAndOrigin() {
    surfel::SurfelList points;
    for (int k = 0; k < 8; ++k)
        points.items.push_back({{float(k), float(k % 3), 0}, {0, 0, 1}, 1});
    const auto with = [&](const char* name, surfel::ScalarType type) {
        auto layout = std::make_shared<surfel::AttributeLayout>();
        layout->add(name, type);
        surfel::SurfelList list = points;
        list.layout = layout;
        list.extra.assign(points.size(), 7);
        return session::contentHash(tree::SurfelTree::build(list), {}).text();
    };
    const std::string scan = with("scan", surfel::ScalarType::Int32);
    QVERIFY(scan != with("row", surfel::ScalarType::Int32));
    QVERIFY(scan != with("scan", surfel::ScalarType::UInt32));
    const auto plain = tree::SurfelTree::build(points);
    QVERIFY(session::contentHash(plain, {}).text() != session::contentHash(plain, {0, 0, 1e-9}).text());
    QCOMPARE(session::contentHash(plain, {0, 0, -0.0}).text(), session::contentHash(plain, {}).text());
}

static const test::Registered<DocumentTest> registered;
#include "document_test.moc"
