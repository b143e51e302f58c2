// reduce: as a person types it; the file, the report, the session of the same name, and what is refused.
#include "program.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <cmath>
#include <QTest>

using test::json;
using test::Outcome;
using test::Program;

class ReduceTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void reduceWritesAModelAndTellsOfIt();
    void theFileOpensAsItWas();
    void sessionsDoTheSameAndUndoIt();
    void refineGoesBack();
    void refineTellsHowNearItIs();
    void errorChoosesTheCount();
    void wrongUsageIsRefused();
};

static json infoOf(const Program& program, const char* model) {
    return json::parse(program.run({"info", model, "--json"}).out);
}

void ReduceTest::reduceWritesAModelAndTellsOfIt() {
    const Program program;
    const Outcome outcome =
        program.run({"reduce", "sample:knot:6000", "-o", "few.ply", "--count", "900", "--report", "few.json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY(outcome.out.starts_with("900 surfels"));
    const json report = json::parse(program.read("few.json"));
    QCOMPARE(report.size(), std::size_t(8));
    QCOMPARE(report.at("count"), 900);
    QCOMPARE(report.at("shapes"), "spheres");
    QCOMPARE(report.at("holes"), 0);
    QVERIFY(report.at("least_supports") >= 3);
    const double rms = report.at("rms"), p999 = report.at("p999"), max = report.at("max");
    QVERIFY(rms > 0 && rms < p999 && p999 <= max);
    QVERIFY(report.at("normals_deg") > 0 && report.at("normals_deg") < 20);
    QCOMPARE(infoOf(program, "few.ply").at("surfels"), 900);
}

void ReduceTest::theFileOpensAsItWas() {
    const Program program;
    QCOMPARE(program.run({"reduce", "sample:torus:3000", "-o", "few.ply", "--ratio", "0.1"}).code, 0);
    const std::string once = program.hash("few.ply");
    program.write("again.jsonl", R"({"op":"open","path":"few.ply"})"
                                 "\n"
                                 R"({"op":"save","path":"again.ply"})"
                                 "\n");
    QCOMPARE(program.run({"run", "again.jsonl"}).code, 0);
    QCOMPARE(program.hash("again.ply"), once);
    QCOMPARE(program.read("again.ply"), program.read("few.ply"));
    // One can look at it, and cut it, as at any other.
    QCOMPARE(program.run({"render", "few.ply", "-o", "few.png", "--size", "64x64", "--mode", "raycast"}).code, 0);
    QCOMPARE(program.run({"section", "few.ply", "--plane", "0,0,1,0", "-o", "cut.obj"}).code, 0);
}

void ReduceTest::sessionsDoTheSameAndUndoIt() {
    if (test::sanitized)
        QSKIP("seconds under a sanitizer");
    const Program program;
    QCOMPARE(program.run({"reduce", "sample:torus:3000", "-o", "few.ply", "--count", "400"}).code, 0);
    program.write("few.jsonl", R"({"op":"new","sample":"torus","count":3000}
{"op":"save","path":"many.ply"}
{"op":"reduce","count":400}
{"op":"expect","surfels":400}
{"op":"save","path":"session.ply"}
{"op":"undo"}
{"op":"save","path":"undone.ply"}
{"op":"redo"}
{"op":"expect","surfels":400}
)");
    const Outcome outcome = program.run({"run", "few.jsonl", "--journal", "journal.jsonl"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QCOMPARE(program.hash("session.ply"), program.hash("few.ply"));
    QCOMPARE(program.hash("undone.ply"), program.hash("many.ply"));
    QCOMPARE(program.run({"recover", "journal.jsonl", "-o", "recovered.ply"}).code, 0);
    QCOMPARE(program.hash("recovered.ply"), program.hash("few.ply"));
    program.write("both.jsonl",
                  "{\"op\":\"new\",\"sample\":\"torus\"}\n{\"op\":\"reduce\",\"count\":400,\"ratio\":0.1}\n");
    const Outcome both = program.run({"run", "both.jsonl"});
    QCOMPARE(both.code, 1);
    QVERIFY2(both.err.find("one of count, ratio and error") != std::string::npos, both.err.c_str());
}

void ReduceTest::refineGoesBack() {
    const Program program;
    program.write("back.jsonl", R"({"op":"new","sample":"torus","count":3000}
{"op":"reduce","ratio":0.1}
{"op":"refine","spacing":0.07}
{"op":"save","path":"back.ply"}
)");
    const Outcome outcome = program.run({"run", "back.jsonl"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY2(outcome.err.find("from the surface before") != std::string::npos, outcome.err.c_str());
    const json info = infoOf(program, "back.ply");
    QVERIFY(info.at("surfels") > 1000);
    QVERIFY(std::abs(info.at("spacing").at("median").get<double>() / 0.07 - 1) < 0.15);
}

void ReduceTest::refineTellsHowNearItIs() {
    if (test::sanitized)
        QSKIP("seconds under a sanitizer");
    const Program program;
    QCOMPARE(program.run({"reduce", "sample:torus:3000", "-o", "few.ply", "--ratio", "0.1"}).code, 0);
    const auto refined = [&](const char* out, const QStringList& more) {
        const Outcome outcome = program.run(
            QStringList{"refine", "few.ply", "-o", out, "--spacing", "0.07", "--report", "back.json"} + more);
        return outcome.code == 0 ? json::parse(program.read("back.json")) : json();
    };
    const json alone = refined("alone.ply", {}), beside = refined("beside.ply", {"--to", "sample:torus:3000"});
    QCOMPARE(program.hash("alone.ply"), program.hash("beside.ply"));
    QVERIFY(alone.size() == 8 && beside.size() == 8);
    QCOMPARE(beside.at("count"), alone.at("count"));
    for (const json& report : {alone, beside})
        QVERIFY(report.at("rms") > 0 && report.at("rms") < 0.05 * 0.07 && report.at("holes") == 0);
    QVERIFY(alone.at("rms") != beside.at("rms"));
    // The session's command makes the same model.
    program.write("back.jsonl", R"({"op":"open","path":"few.ply"}
{"op":"refine","spacing":0.07}
{"op":"save","path":"session.ply"}
)");
    QCOMPARE(program.run({"run", "back.jsonl"}).code, 0);
    QCOMPARE(program.hash("session.ply"), program.hash("alone.ply"));
}

void ReduceTest::errorChoosesTheCount() {
    if (test::sanitized)
        QSKIP("seconds under a sanitizer");
    const Program program;
    QCOMPARE(program.run({"reduce", "sample:torus:2000", "-o", "a.ply", "--count", "300", "--report", "a.json"}).code,
             0);
    const double error = json::parse(program.read("a.json")).at("rms");
    const QString text = QString::number(error, 'g', 12);
    const Outcome outcome =
        program.run({"reduce", "sample:torus:2000", "-o", "b.ply", "--error", text, "--report", "b.json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json report = json::parse(program.read("b.json"));
    QVERIFY(report.at("rms") <= error && report.at("count") <= 330);
    const Outcome never = program.run({"reduce", "sample:torus:2000", "-o", "c.ply", "--error", "1e-12"});
    QVERIFY(never.code == 1 && !QFileInfo::exists(program.dir().filePath("c.ply")));
}

void ReduceTest::wrongUsageIsRefused() {
    const Program program;
    const auto outcome = [&](const char* arguments) {
        return program.run(QString(arguments).split(' ', Qt::SkipEmptyParts));
    };
    for (const char* arguments :
         {"reduce sample:torus:2000 -o o.ply", "reduce sample:torus:2000 --count 100",
          "reduce sample:torus:2000 -o o.ply --count 100 --ratio 0.1", "reduce sample:torus:2000 -o o.stl --count 100",
          "reduce sample:torus:2000 -o o.ply --count few", "reduce sample:torus:2000 -o o.ply --ratio -1",
          "reduce sample:torus:2000 -o o.ply --count 100 --shapes cubes", "refine sample:torus:2000 -o o.ply",
          "refine sample:torus:2000 -o o.ply --spacing 0", "refine sample:torus:2000 -o o.stl --spacing 1"})
        QVERIFY2(outcome(arguments).code == 2, arguments);
    for (const char* arguments :
         {"reduce sample:torus:2000 -o o.ply --count 5000", "reduce sample:torus:2000 -o o.ply --count 2",
          "reduce sample:coil -o o.ply --ratio 0.1", "reduce sample:torus:2000 -o o.ply --ratio 1",
          "reduce nothing.ply -o o.ply --count 100", "refine nothing.ply -o o.ply --spacing 1",
          "refine sample:coil -o o.ply --spacing 0.1"}) {
        const Outcome refused = outcome(arguments);
        QVERIFY2(refused.code == 1, arguments);
        QVERIFY2(!refused.err.empty() && std::count(refused.err.begin(), refused.err.end(), '\n') == 1,
                 refused.err.c_str());
    }
    QVERIFY(!QFileInfo::exists(program.dir().filePath("o.ply")));
}

static const test::Registered<ReduceTest> registered;
#include "reduce_test.moc"
