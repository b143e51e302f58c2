// Extruding as a command: one step, replayed to the same bits, what moved stays selected, refused in a sentence.
#include "core/mesh/extent/extent.h"
#include "core/selection/field.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"
#include "workbench.h"

#include <numbers>
#include <QTest>

using test::json;
using test::Workbench;

class ExtrudeCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void eachIsAStepThatUndoAndReplayBringBack_data();
    void eachIsAStepThatUndoAndReplayBringBack();
    void whatMovedStaysSelected();
    void strokesGoOnOverItsEdges();
    void whatRunsThroughTheModelIsTold();
    void wrongNumbersAreRefused();
};

namespace {

void openPart(Workbench& bench) {
    bench.run(test::newSphere(2500));
    bench.run({{"op", "select"}, {"by", "plane"}, {"plane", {0, 0, 1, 0.6}}});
}

} // namespace

void ExtrudeCommandTest::eachIsAStepThatUndoAndReplayBringBack_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {R"({"op":"extrude","length":0.4})", R"({"op":"extrude","length":-0.3,"creases":false})",
          R"({"op":"extrude","length":0.4,"direction":"0.3,0,1"})", R"({"op":"extrude","length":-2.2,"merge":true})",
          R"({"op":"extrude","what":"loop","length":0.3})",
          R"({"op":"extrude","what":"loop","length":0.3,"loop":0,"direction":[0,0.2,1]})"})
        QTest::newRow(line) << line;
}

void ExtrudeCommandTest::eachIsAStepThatUndoAndReplayBringBack() {
    QFETCH(QString, line);
    const auto prepare = [&](Workbench& bench) {
        openPart(bench);
        if (line.contains("loop"))
            bench.run({{"op", "delete"}});
    };
    Workbench one;
    QVERIFY(!test::hashOfStep(one, prepare, json::parse(line.toStdString())).empty());
}

/// So that it can be drawn out once more.
void ExtrudeCommandTest::whatMovedStaysSelected() {
    Workbench bench;
    openPart(bench);
    for (int k = 0; k < 2; ++k)
        bench.run({{"op", "extrude"}, {"length", 0.25}, {"direction", "0,0,1"}});
    const mesh::Extent extent = mesh::extentOf(bench.document.surface());
    const double wanted = 4 * std::numbers::pi / 3 + 0.5 * std::numbers::pi * (1 - 0.36);
    QVERIFY2(extent.closed && std::abs(extent.volume / wanted - 1) < 0.01, QByteArray::number(extent.volume));
}

void ExtrudeCommandTest::strokesGoOnOverItsEdges() {
    Workbench bench;
    openPart(bench);
    bench.run({{"op", "extrude"}, {"length", 0.3}});
    for (const double y : {-0.6, 0.0, 0.5}) {
        if (y > 0 && test::sanitized)
            continue;
        bench.run(test::strokeAt(y));
        bench.document.surface().tree().validate();
        QVERIFY(mesh::extentOf(bench.document.surface()).closed);
    }
}

void ExtrudeCommandTest::whatRunsThroughTheModelIsTold() {
    for (const bool merge : {false, true}) {
        Workbench bench;
        openPart(bench);
        bench.run({{"op", "extrude"}, {"length", -2.2}, {"merge", merge}});
        QVERIFY(bench.context.messages.back().find(merge ? "both are one" : "\"merge\" makes one") !=
                std::string::npos);
        QVERIFY(bench.context.figures.at("crossings") > 0);
    }
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(json::parse(R"({"op":"select","by":"plane","plane":[0,0,1,0.95]})"));
    bench.run({{"op", "extrude"}, {"length", -1.9}, {"merge", true}}); // it only just touches the far side
    QVERIFY(bench.context.figures.at("crossings") > 0);
    QVERIFY(bench.context.messages.back().find("nothing was merged") != std::string::npos);
    openPart(bench);
    bench.run({{"op", "extrude"}, {"length", -0.3}});
    QCOMPARE(bench.context.figures.at("crossings"), 0.0);
    QVERIFY(bench.refusal({{"op", "extrude"}, {"length", 1}, {"what", "loop"}, {"merge", true}}).find("merge") !=
            std::string::npos);
}

void ExtrudeCommandTest::wrongNumbersAreRefused() {
    Workbench bench;
    QVERIFY(bench.refusal({{"op", "extrude"}, {"length", 1}}).find("no model") != std::string::npos);
    bench.run(test::newSphere(2000));
    QVERIFY(bench.refusal({{"op", "extrude"}, {"length", 1}}).find("nothing is selected") != std::string::npos);
    openPart(bench);
    QVERIFY(bench.refusal({{"op", "extrude"}}).find("length") != std::string::npos);
    QVERIFY(bench.refusal({{"op", "extrude"}, {"length", 0}}).find("length of 0") != std::string::npos);
    QVERIFY(bench.refusal({{"op", "extrude"}, {"length", 1}, {"loop", 0}}).find("loop") != std::string::npos);
    QVERIFY(bench.refusal({{"op", "extrude"}, {"length", 1}, {"what", "loop"}}).find("no boundary") !=
            std::string::npos);
    QVERIFY(bench.refusal({{"op", "extrude"}, {"length", 1}, {"direction", "0,0,0"}}).find("direction") !=
            std::string::npos);
}

static const test::Registered<ExtrudeCommandTest> registered;
#include "extrude_command_test.moc"
