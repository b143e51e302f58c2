// Strokes beside what is hidden: they are those on what is shown alone, and move nothing else.
#include "core/base/random.h"
#include "core/sculpt/tool.h"
#include "hiding.h"
#include "random_strokes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <QTest>

using test::json;
using test::Workbench;
using test::hiding::hashOfHidden, test::hiding::hiddenIn, test::hiding::makeHidden, test::hiding::parsed;

class HideStrokesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void strokesLeaveWhatIsHidden_data();
    void strokesLeaveWhatIsHidden();
    void strokesOnWhatIsShownAreThoseOnItAlone();
    void strokesUndoReplayAndDependOnNoThreads();
    void strokesOnLayersLeaveWhatIsHidden();
    void stepsBesideWhatIsHiddenAreTold();
};

void HideStrokesTest::strokesLeaveWhatIsHidden_data() {
    QTest::addColumn<QString>("tool");
    for (const sculpt::ToolRow& row : sculpt::toolTable())
        if (!row.needs.layer)
            QTest::newRow(row.id) << row.id;
}

/// By strokes that run over its end.
void HideStrokesTest::strokesLeaveWhatIsHidden() {
    QFETCH(QString, tool);
    Workbench bench;
    makeHidden(bench);
    bench.run(test::strokeAt(0, "paint")); // something to smear
    const base::Hash128 before = hashOfHidden(bench.document.surface());
    const std::size_t count = hiddenIn(bench), size = bench.size();
    const std::string hash = bench.hash();
    bench.run(test::strokeAt(0.1, tool.toStdString()));
    QCOMPARE(hiddenIn(bench), count);
    QVERIFY(hashOfHidden(bench.document.surface()) == before);
    QVERIFY(bench.hash() != hash);
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), hash);
    QCOMPARE(bench.size(), size);
}

void HideStrokesTest::strokesOnWhatIsShownAreThoseOnItAlone() {
    Workbench bench;
    makeHidden(bench);
    const surface::Surface shown = selection::shownOf(bench.document.surface());
    session::Document alone = bench.document;
    alone.commit(shown, "Shown");
    session::Context other{alone, {}, {}, {}, 0, {}, nullptr};
    for (const double y : {0.1, 0.3}) {
        bench.run(test::strokeAt(y));
        session::run(other, test::strokeAt(y));
        const surface::Surface now = selection::shownOf(bench.document.surface());
        QCOMPARE(now.tree().size(), alone.surface().tree().size());
        QVERIFY(y > 0.2 || now.tree().contentHash() == alone.surface().tree().contentHash());
    }
}

void HideStrokesTest::strokesUndoReplayAndDependOnNoThreads() {
    const std::uint64_t seed = test::seed();
    const auto made = [&](Workbench& bench) {
        session::Journal journal(bench.path("j.jsonl"));
        bench.context.journal = &journal;
        makeHidden(bench, 6000);
        base::Random random(seed);
        test::RandomStrokes strokes(bench.document, random);
        std::vector<std::string> hashes{bench.hash()};
        for (int k = 0; k < (test::sanitized ? 4 : 12); ++k) {
            bench.run(strokes.next());
            hashes.push_back(bench.hash());
        }
        bench.context.journal = nullptr;
        return hashes;
    };
    Workbench one, two;
    const std::vector<std::string> hashes = test::onThreads(1, [&] { return made(one); });
    QCOMPARE(test::onThreads(2, [&] { return made(two); }), hashes);
    Workbench again;
    session::recover(one.path("j.jsonl"), again.context);
    QVERIFY2(again.hash() == hashes.back(), qPrintable(QString("seed %1").arg(seed)));
    while (one.document.undoLabel() != std::string("Hide"))
        one.run({{"op", "undo"}});
    QCOMPARE(one.hash(), hashes.front());
}

void HideStrokesTest::strokesOnLayersLeaveWhatIsHidden() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(parsed(R"({"op":"layer","do":"add","name":"a"})"));
    bench.run(test::strokeAt(0.2));
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[1,0,0,0.1]})"));
    bench.run(parsed(R"({"op":"hide"})"));
    const base::Hash128 before = hashOfHidden(bench.document.surface());
    bench.run(test::strokeAt(-0.1));
    QVERIFY(hashOfHidden(bench.document.surface()) == before);
    bench.run(parsed(R"({"op":"layer","do":"strength","name":"a","strength":0})")); // of all of the model
    QVERIFY(!(hashOfHidden(bench.document.surface()) == before));
    float most = 0;
    bench.document.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            most = std::max(most, std::abs(length(block.position(slot)) - 1));
    });
    QVERIFY2(most < 0.01f, qPrintable(QString::number(most)));
}

void HideStrokesTest::stepsBesideWhatIsHiddenAreTold() {
    const auto toldBy = [](Workbench& bench, const char* tool, double x) {
        bench.context.messages.clear();
        json samples = json::array();
        for (int k = 0; k < 8; ++k)
            samples.push_back({x, 0.1 * k - 0.4, 5.0, 0.0, 0.0, -1.0, 1.0, 0.02 * k});
        bench.run({{"op", "stroke"}, {"tool", tool}, {"radius", 0.25}, {"strength", 1}, {"samples", samples}});
        return std::ranges::any_of(bench.context.messages,
                                   [](const std::string& each) { return each.find("A step of") != std::string::npos; });
    };
    for (const double x : {0.0, -0.5}) { // the end is at 0.1
        Workbench bench;
        makeHidden(bench);
        QCOMPARE(toldBy(bench, "draw", x), x == 0);
    }
    // an edge is no step, and colours make none
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(parsed(R"({"op":"cut","plane":"-1,0,0,-0.5","cap":true})"));
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[1,0,0,0.49]})"));
    bench.run(parsed(R"({"op":"hide"})"));
    QVERIFY(hiddenIn(bench) > 100);
    const std::string before = bench.hash();
    QVERIFY(!toldBy(bench, "paint", 0.4));
    QVERIFY(bench.hash() != before);
}

static const test::Registered<HideStrokesTest> registered;
#include "hide_strokes_test.moc"
