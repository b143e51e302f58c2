// Commands that select and that work on what is selected: undone and replayed to the same bits, saved with the model,
// exact in numbers, and refused with a sentence where they make no sense.
#include "core/selection/field.h"
#include "core/session/journal.h"
#include "core/session/recover.h"
#include "core/surface/curves/boundary_curves.h"
#include "far_ball.h"
#include "process/even_shapes.h"
#include "support/registry.h"

#include <QTest>

using test::json, test::openBall, test::parsed, test::Workbench;

class SelectionCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyStepUndoesAndReplays_data();
    void everyStepUndoesAndReplays();
    void waysSelectWhatTheySay_data();
    void waysSelectWhatTheySay();
    void selectionIsSavedAndOpened();
    void strokesCarryTheSelection();
    void partsAreSplitOff();
    void closedModelsThatLoseAPartEndThereOnly();
    void whatHasNothingToDoLeavesNoStep();
    void nonsenseIsRefused_data();
    void nonsenseIsRefused();
};

namespace {

std::size_t selected(const Workbench& bench) {
    return tree::sizeOf(selection::selectedIn(bench.document.surface().tree()));
}

} // namespace

void SelectionCommandTest::everyStepUndoesAndReplays_data() {
    QTest::addColumn<QString>("line");
    for (const char* line : {R"({"op":"select","by":"all"})",
                             R"({"op":"select","by":"plane","plane":[1,0,0,1e7],"mode":"intersect"})",
                             R"({"op":"select","by":"piece","mode":"subtract"})",
                             R"({"op":"selection","do":"invert"})",
                             R"({"op":"selection","do":"grow","length":0.2})",
                             R"({"op":"selection","do":"shrink","length":0.2})",
                             R"({"op":"selection","do":"blur","length":0.4})",
                             R"({"op":"selection","do":"border"})",
                             R"({"op":"selection","do":"clear"})",
                             R"({"op":"mask","do":"copy"})",
                             R"({"op":"mask","do":"invert"})",
                             R"({"op":"mask","do":"curvature","to":3})",
                             R"({"op":"delete"})",
                             R"({"op":"keep"})",
                             R"({"op":"duplicate","move":[3,0,0]})",
                             R"({"op":"transform","axis":[1,2,3],"angle":20,"scale":1.5})",
                             R"({"op":"transform","stretch":[1,2,-1],"of":"all"})",
                             R"({"op":"transform","mirror":[0,1,1,-1e7],"move":[0,0,0.25]})",
                             R"({"op":"colour","colour":[10,200,30],"strength":0.5})",
                             R"({"op":"flip"})",
                             R"({"op":"smooth","scale":3,"of":"all"})",
                             R"({"op":"sharpen"})",
                             R"({"op":"inflate","length":-0.1})",
                             R"({"op":"noise","amplitude":0.05,"size":0.3})",
                             R"({"op":"align","do":"axes"})",
                             R"({"op":"shell","thickness":0.2})",
                             R"({"op":"unit","from":[1e7,-1e7,-1],"to":[1e7,-1e7,1],"length":3})"})
        QTest::newRow(line) << line;
}

void SelectionCommandTest::everyStepUndoesAndReplays() {
    QFETCH(QString, line);
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(openBall(bench, 1e7));
    bench.run(parsed(R"({"op":"select","by":"ball","at":[1e7,-1e7,1],"radius":0.8})"));
    QVERIFY(selected(bench) > 200 && selected(bench) < 600);
    const std::string before = bench.hash();
    bench.run(json::parse(line.toStdString()));
    const std::string after = bench.hash();
    QVERIFY(before != after);
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "redo"}});
    QCOMPARE(bench.hash(), after);
    Workbench other;
    session::recover(bench.path("j.jsonl"), other.context);
    QCOMPARE(other.hash(), after);
}

void SelectionCommandTest::waysSelectWhatTheySay_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<double>("share"); // of the 2000 surfels
    const auto row = [](const char* line, double share) { QTest::newRow(line) << line << share; };
    row(R"({"op":"select","by":"all"})", 1);
    row(R"({"op":"select","by":"none"})", 0);
    row(R"({"op":"select","by":"ball","at":[1000,-1000,1],"radius":1})", 0.25);
    row(R"({"op":"select","by":"box","least":[999,-1001,-1],"most":[1001,-999,0.5]})", 0.75);
    row(R"({"op":"select","by":"plane","plane":[0,0,2,1.2]})", 0.2);
    row(R"({"op":"select","by":"range","of":"z","from":-0.5,"to":0})", 0.25);
    row(R"({"op":"select","by":"range","of":"quality","from":500})", 0.75);
    row(R"({"op":"select","by":"range","of":"curvature-mean","from":0.5,"to":1.5})", 1);
    row(R"({"op":"select","by":"colour","colour":[255,0,0]})", 0.5);
    row(R"({"op":"select","by":"normal","direction":[0,0,-1],"angle":60})", 0.25);
    row(R"({"op":"select","by":"piece","at":[1000,-1000,1]})", 1);
    row(R"({"op":"select","by":"view","eye":[1000,-1000,9],"target":[1000,-1000,0],"up":[0,1,0],"ortho":4,
            "size":[400,400],"rectangle":[0,0,200,400]})",
        0.5);
    row(R"({"op":"select","by":"view","eye":[1000,-1000,9],"target":[1000,-1000,0],"up":[0,1,0],"ortho":4,
            "size":[400,400],"polygon":[[0,0],[200,0],[200,200],[0,200]],"visible":true})",
        0.125);
    row(R"({"op":"select","by":"view","eye":[1000,-1000,9],"target":[1000,-1000,0],"up":[0,1,0],
            "rectangle":[-9999,-9999,9999,9999],"depth":[0,8.5]})",
        0.25);
}

void SelectionCommandTest::waysSelectWhatTheySay() {
    QFETCH(QString, line);
    QFETCH(double, share);
    Workbench bench;
    bench.run(openBall(bench, 1000));
    bench.run(json::parse(line.toStdString()));
    QVERIFY2(std::abs(double(selected(bench)) / 2000 - share) < 0.02, qPrintable(QString::number(selected(bench))));
}

void SelectionCommandTest::selectionIsSavedAndOpened() {
    Workbench bench, other;
    bench.run(openBall(bench, 1e7));
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[0,0,1,0.3]})"));
    bench.run(parsed(R"({"op":"selection","do":"blur","length":0.3})"));
    bench.run({{"op", "save"}, {"path", bench.path("out.ply").string()}});
    other.run({{"op", "open"}, {"path", bench.path("out.ply").string()}});
    QCOMPARE(other.hash(), bench.hash());
    QCOMPARE(selected(other), selected(bench));
}

void SelectionCommandTest::strokesCarryTheSelection() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[0,1,0,0.02]})"));
    json stroke = test::strokeAt(0.1, "clay");
    stroke["strength"] = 1.0;
    for (int k = 0; k < 3; ++k)
        bench.run(stroke);
    QVERIFY(bench.size() != 3000); // surfels were born
    const auto& tree = bench.document.surface().tree();
    const int channel = selection::channelOf(*tree.layout(), selection::Field::Selection);
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const float v = selection::valueAt(block, channel, slot), y = block.position(slot).y;
            QVERIFY(v >= 0 && v <= 1);
            if (std::abs(y) > 0.2f)
                QVERIFY(std::abs(v - (y > 0 ? 1.0f : 0.0f)) < 0.01f); // born there, of surfels within a support
        }
    });
}

void SelectionCommandTest::partsAreSplitOff() {
    Workbench bench, part, rest;
    bench.run(openBall(bench, 1e7));
    bench.run(parsed(R"({"op":"select","by":"range","of":"z","from":0.5})"));
    const std::size_t count = selected(bench);
    bench.run({{"op", "save"}, {"path", bench.path("part.ply").string()}, {"part", "selection"}});
    bench.run({{"op", "save"}, {"path", bench.path("rest.ply").string()}, {"part", "rest"}});
    QVERIFY(bench.document.modified()); // the whole was not saved
    bench.run({{"op", "delete"}});
    part.run({{"op", "open"}, {"path", bench.path("part.ply").string()}});
    rest.run({{"op", "open"}, {"path", bench.path("rest.ply").string()}});
    QCOMPARE(part.size(), count);
    QCOMPARE(rest.size(), 2000 - count);
    QCOMPARE(bench.size(), 2000 - count);
    QVERIFY(selected(part) == 0 && selected(rest) == 0);
    QCOMPARE(rest.hash(), bench.hash());
}

/// The rim of a slender lens counts as a boundary by the points alone.
void SelectionCommandTest::closedModelsThatLoseAPartEndThereOnly() {
    Workbench lens;
    std::string text = "x,y,z,nx,ny,nz\n";
    const auto put = [&](const base::Vec3f& p, const base::Vec3f& n) {
        for (const float v : {p.x, p.y, p.z, n.x, n.y, n.z})
            text += std::to_string(v) + ",";
        text.back() = '\n';
    };
    for (const surfel::Surfel& s : test::spherePoints(30000).items) // two caps of 18 degrees, rim to rim
        if (const float up = std::abs(s.position.z) - 0.95f; up > 0)
            put({s.position.x, s.position.y, std::copysign(up, s.position.z)}, s.normal);
    test::write(lens.path("lens.csv"), text);
    lens.run({{"op", "open"}, {"path", lens.path("lens.csv").string()}});
    lens.run({{"op", "surface"}, {"boundary", "auto"}});
    QVERIFY(std::isinf(lens.document.surface().definition().boundaryLimit));
    lens.run(parsed(R"({"op":"select","by":"ball","at":[0,0,0.05],"radius":0.1})"));
    lens.run(parsed(R"({"op":"scene","do":"split","to":"cap"})"));
    for (const session::SceneModel& each : lens.document.scene().models) {
        const auto curves = findBoundaryCurves(each.surface);
        QCOMPARE(curves.size(), std::size_t(1));
        QVERIFY(curves[0].closed && std::abs(curves[0].length() - 0.63) < 0.1);
    }
    for (const char* op : {"delete", "keep"}) {
        lens.run({{"op", "undo"}});
        lens.run({{"op", op}});
        const auto curves = findBoundaryCurves(lens.document.surface());
        QCOMPARE(curves.size(), std::size_t(1));
    }
}

void SelectionCommandTest::whatHasNothingToDoLeavesNoStep() {
    Workbench bench;
    bench.run(test::newSphere());
    for (const char* line : {R"({"op":"select","by":"none"})", R"({"op":"selection","do":"clear"})",
                             R"({"op":"mask","do":"clear"})", R"({"op":"selection","do":"grow","length":1})",
                             R"({"op":"transform"})", R"({"op":"transform","scale":1,"angle":0,"axis":[0,0,1]})"}) {
        bench.run(parsed(line));
        QVERIFY2(!bench.document.canUndo(), line);
    }
}

void SelectionCommandTest::nonsenseIsRefused_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* line, const char* told) { QTest::newRow(line) << line << told; };
    row(R"({"op":"select","by":"ball","at":[0,0,0]})", "needs the parameter \"radius\"");
    row(R"({"op":"select","by":"all","radius":1})", "\"radius\" has no say");
    row(R"({"op":"select","by":"ball","at":[0,0],"radius":1})", "no list of 3 numbers");
    row(R"({"op":"select","by":"ball","at":[0,0,"x"],"radius":1})", "no list of 3 numbers");
    row(R"({"op":"select","by":"box","least":[0,0,0],"most":[1,-1,1]})", "lies beyond");
    row(R"({"op":"select","by":"plane","plane":[0,0,0,1]})", "no direction");
    row(R"({"op":"select","by":"range","of":"beauty"})", "nothing named \"beauty\"");
    row(R"({"op":"select","by":"view","eye":[0,0,5],"target":[0,0,0]})", "one of rectangle and polygon");
    row(R"({"op":"select","by":"view","eye":[0,0,5],"target":[0,0,5],"rectangle":[0,0,9,9]})", "same place");
    row(R"({"op":"select","by":"view","eye":[0,0,5],"target":[0,0,0],"polygon":[[0,0],[1,1]]})", "fewer than three");
    row(R"({"op":"select","by":"view","eye":[0,0,5],"target":[0,0,0],"polygon":[[0,0],[1,1],[2]]})",
        "no list of 2 numbers");
    row(R"({"op":"select","by":"colour","colour":[0,0,300]})", "no colour");
    row(R"({"op":"select","by":"piece"})", "nothing selected to begin with");
    row(R"({"op":"selection","do":"grow"})", "needs the parameter \"length\"");
    row(R"({"op":"mask","do":"curvature","from":3,"to":2})", "not below");
    row(R"({"op":"delete"})", "nothing is selected");
    row(R"({"op":"duplicate","move":[1,0,0]})", "nothing is selected");
    row(R"({"op":"transform","of":"selection","move":[1,0,0]})", "nothing is selected");
    row(R"({"op":"transform","stretch":[1,0,1]})", "pressed flat");
    row(R"({"op":"transform","scale":1e16})", "keep their places");
    row(R"({"op":"inflate","length":1e9})", "keep their places");
    row(R"({"op":"shell","thickness":100})", "thicker than");
    row(R"({"op":"transform","axis":[0,0,1]})", "belong together");
    row(R"({"op":"unit","from":[1,2,3],"to":[1,2,3],"length":1})", "same place");
    row(R"({"op":"transform","matrix":[1,2,3]})", "no list of 16 numbers");
    row(R"({"op":"save","path":"nowhere.ply","part":"selection"})", "nothing is selected");
}

void SelectionCommandTest::nonsenseIsRefused() {
    QFETCH(QString, line);
    QFETCH(QString, told);
    Workbench bench;
    bench.run(test::newSphere(500));
    const std::string before = bench.hash(), refusal = bench.refusal(json::parse(line.toStdString()));
    QVERIFY2(QString::fromStdString(refusal).contains(told), refusal.c_str());
    QCOMPARE(bench.hash(), before);
    if (told == "nothing is selected") // nor may all of it go
        QVERIFY(bench.size() == 500);
}

static const test::Registered<SelectionCommandTest> registered;
#include "selection_command_test.moc"
