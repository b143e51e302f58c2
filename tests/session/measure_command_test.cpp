// The command `measure`: numbers become attributes and colours, as one step that undo and replay bring back.
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using test::json;
using test::Workbench;

class MeasureCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void attributesUndoReplayAndSurviveFiles();
    void measuringAgainReplaces();
    void nonsenseIsRefused();
};

static std::vector<double> valuesOf(const Workbench& bench, const char* name) {
    const surfel::SurfelList list = bench.document.surface().tree().surfels();
    std::vector<double> out;
    if (const surfel::Attribute* attribute = list.layout->find(name))
        for (std::size_t i = 0; i < list.size(); ++i)
            out.push_back(surfel::read(*attribute, list.extraOf(i)));
    return out;
}

void MeasureCommandTest::attributesUndoReplayAndSurviveFiles() {
    Workbench bench;
    const std::string ball = bench.path("ball.ply").string(), out = bench.path("out.ply").string();
    bench.run({{"op", "new"}, {"sample", "sphere"}, {"count", 2000}});
    bench.run({{"op", "save"}, {"path", ball}});
    session::Journal journal(bench.path("journal.jsonl"));
    bench.context.journal = &journal;
    bench.run({{"op", "new"}, {"sample", "torus"}, {"count", 3000}});
    const std::string before = bench.hash();
    bench.run({{"op", "measure"}, {"thickness", true}, {"to", ball}, {"colours", "thickness"}, {"range", {0, 1}}});
    const std::string after = bench.hash();
    QVERIFY(after != before);
    QCOMPARE(valuesOf(bench, "thickness").size(), bench.size());
    QCOMPARE(valuesOf(bench, "deviation").size(), bench.size());
    bench.document.surface().tree().validate();
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "redo"}});
    QCOMPARE(bench.hash(), after);
    Workbench again;
    session::replay(bench.path("journal.jsonl"), again.context);
    QCOMPARE(again.hash(), after);
    QVERIFY(test::contentOf(bench.path("journal.jsonl")).find("\"hash\"") != std::string::npos); // of the other model
    bench.run({{"op", "save"}, {"path", out}});
    Workbench opened;
    opened.run({{"op", "open"}, {"path", out}});
    QCOMPARE(opened.hash(), after); // NaN of what has no foot among them
}

void MeasureCommandTest::measuringAgainReplaces() {
    Workbench bench;
    bench.run(test::newSphere(2000));
    bench.run({{"op", "measure"}, {"thickness", true}});
    const std::vector<double> first = valuesOf(bench, "thickness");
    bench.run({{"op", "transform"}, {"scale", 2}});
    QCOMPARE(valuesOf(bench, "thickness"), first); // as it was measured
    bench.run({{"op", "measure"}, {"thickness", true}});
    const std::vector<double> second = valuesOf(bench, "thickness");
    for (std::size_t i = 0; i < first.size(); ++i)
        QVERIFY(std::abs(second[i] / first[i] - 2) < 1e-3);
}

void MeasureCommandTest::nonsenseIsRefused() {
    Workbench bench;
    bench.run(test::newSphere(1000));
    const std::string before = bench.hash();
    const auto refused = [&](const json& command, const char* word) {
        const std::string why = bench.refusal(command);
        QVERIFY2(why.find(word) != std::string::npos, why.c_str());
        QCOMPARE(bench.hash(), before);
    };
    refused({{"op", "measure"}}, "nothing to measure");
    refused({{"op", "measure"}, {"thickness", true}, {"colours", "deviation"}}, "was not measured");
    refused({{"op", "measure"}, {"thickness", true}, {"range", {1}}, {"colours", "thickness"}}, "range");
    refused({{"op", "measure"}, {"to", "nowhere.ply"}}, "nowhere.ply");
}

static const test::Registered<MeasureCommandTest> registered;
#include "measure_command_test.moc"
