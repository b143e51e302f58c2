// The command `crease`: each way is a step that undo, replay and the journal bring back; wrong wishes are refused.
#include "core/base/parallel.h"
#include "core/cells/cell_surface.h"
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using nlohmann::json;
using test::Workbench;

class CreaseCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void eachIsAStepThatUndoAndReplayBringBack_data();
    void eachIsAStepThatUndoAndReplayBringBack();
    void strokesAlongADrawnCreaseMakeAnEdge();
    void smoothedAgainTheModelIsTheOneBefore();
    void whatIsNotThereChangesNothing();
    void wrongWishesAreRefused();
    void cleanup() { base::setThreadCount(0); }
};

namespace {

/// A box, as points without labels.
json points(Workbench& bench) {
    const std::string faces = "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 2 1 0\nv 0 0 1\nv 2 0 1\nv 0 1 1\nv 2 1 1\n"
                              "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    return {{"op", "open"},
            {"path", test::write(bench.path("box.obj"), faces).string()},
            {"faces", "sample"},
            {"sample_count", 4000},
            {"sharp", "off"}};
}

std::size_t cellsOf(const Workbench& bench) {
    return cells::countCells(bench.document.surface().tree().surfels()).cells;
}

const json alongRim{{"op", "crease"}, {"along", {{0.2, 0, 1}, {1.8, 0, 1}}}, {"sharpness", 0.8}};

} // namespace

void CreaseCommandTest::eachIsAStepThatUndoAndReplayBringBack_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("cells");
    QTest::newRow("detect") << R"({"op":"crease","detect":true})" << 6;
    QTest::newRow("half sharp") << R"({"op":"crease","detect":"on","angle":60,"sharpness":0.5})" << 6;
    QTest::newRow("along") << R"({"op":"crease","along":[[0.2,0,1],[1.8,0,1]]})" << 3;
    QTest::newRow("flat list") << R"({"op":"crease","along":[0.2,0.5,1,1.8,0.4,1],"sharpness":0.8})" << 3;
}

void CreaseCommandTest::eachIsAStepThatUndoAndReplayBringBack() {
    QFETCH(QString, line);
    QFETCH(int, cells);
    const json command = json::parse(line.toStdString());
    Workbench bench;
    session::Journal journal(bench.path("journal.jsonl"));
    bench.context.journal = &journal;
    bench.run(points(bench));
    const std::string before = bench.hash();
    bench.run(command);
    bench.document.surface().tree().validate();
    const std::string after = bench.hash();
    QCOMPARE(static_cast<int>(cellsOf(bench)), cells);
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "redo"}});
    QCOMPARE(bench.hash(), after);
    base::setThreadCount(1);
    Workbench again;
    session::replay(bench.path("journal.jsonl"), again.context);
    QCOMPARE(again.hash(), after);
    base::setThreadCount(0);
    const auto saved = bench.path("saved.ply");
    bench.run({{"op", "save"}, {"path", saved.string()}});
    Workbench opened;
    opened.run({{"op", "open"}, {"path", saved.string()}});
    QCOMPARE(opened.hash(), after);
}

void CreaseCommandTest::strokesAlongADrawnCreaseMakeAnEdge() {
    Workbench bench;
    bench.run(test::newSphere(4000));
    bench.run({{"op", "crease"}, {"along", {{-0.5, 0.05, 0.86}, {0, 0.05, 1}, {0.5, 0.05, 0.86}}}});
    QCOMPARE(cellsOf(bench), std::size_t(3));
    bench.run(test::strokeAt(0.05, "crease"));
    bench.document.surface().tree().validate();
    // both sides still know each other
    QVERIFY(cells::countCells(bench.document.surface().tree().surfels()).pairs > 0);
}

void CreaseCommandTest::smoothedAgainTheModelIsTheOneBefore() {
    for (const bool all : {true, false}) {
        Workbench bench;
        bench.run(test::newSphere(4000));
        const std::string before = bench.hash();
        json line{{"op", "crease"}, {"along", {{-0.5, 0.05, 0.86}, {0, 0.05, 1}, {0.5, 0.05, 0.86}}}};
        bench.run(line);
        QVERIFY(bench.hash() != before);
        if (all) {
            bench.run({{"op", "crease"}, {"detect", true}, {"sharpness", 0}});
        } else {
            line["along"] = {
                {-0.7, 0.05, 0.71}, {-0.5, 0.05, 0.86}, {0, 0.05, 1}, {0.5, 0.05, 0.86}, {0.7, 0.05, 0.71}};
            line["sharpness"] = 0;
            bench.run(line);
        }
        QCOMPARE(cellsOf(bench), std::size_t(0));
        QCOMPARE(bench.hash(), before);
    }
}

void CreaseCommandTest::whatIsNotThereChangesNothing() {
    Workbench bench;
    bench.run(test::newSphere(4000));
    const std::string before = bench.hash();
    for (const char* line : {R"({"op":"crease","detect":true})", R"({"op":"crease","detect":true,"sharpness":0})",
                             R"({"op":"crease","along":[[0,0,1],[0.3,0,0.95]],"sharpness":0})"}) {
        bench.context.messages.clear();
        bench.run(json::parse(line));
        QVERIFY(!bench.context.messages.empty());
        QCOMPARE(bench.hash(), before);
        QVERIFY(!bench.document.canUndo());
    }
}

void CreaseCommandTest::wrongWishesAreRefused() {
    Workbench bench;
    bench.run(test::newSphere(1500));
    const std::string before = bench.hash();
    for (const char* line :
         {R"({"op":"crease"})", R"({"op":"crease","detect":true,"along":[[0,0,1],[0.3,0,0.95]]})",
          R"({"op":"crease","along":[]})", R"({"op":"crease","along":[[0,0,1]]})", R"({"op":"crease","along":[0,0]})",
          R"({"op":"crease","along":[[0,0],[1,1]]})", R"({"op":"crease","along":["a","b","c"]})",
          R"({"op":"crease","along":[[0,0,9],[0.3,0,9]]})", R"({"op":"crease","along":"line.txt"})",
          R"({"op":"crease","detect":true,"sharpness":2})", R"({"op":"crease","detect":true,"angle":0})"}) {
        QVERIFY2(!bench.refusal(json::parse(line)).empty(), line);
        QCOMPARE(bench.hash(), before);
    }
    Workbench empty;
    QVERIFY(!empty.refusal(alongRim).empty());
}

static const test::Registered<CreaseCommandTest> registered;
#include "crease_command_test.moc"
