// clean, resample and measure as a person types them.
#include "core/base/random.h"
#include "program.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <cmath>
#include <QTest>

using base::Vec3d;
using test::json;
using test::Outcome;
using test::Program;

class CleanTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aScanIsCleanedWithNumbers();
    void everyWayRuns_data();
    void everyWayRuns();
    void wrongUsageIsRefused_data();
    void wrongUsageIsRefused();
    void resampleReachesCountAndSpacing();
    void measureTellsAreaAndVolume();
    void measureTellsDistances();
    void measureFitsShapesFarFromZero();
    void threadsDoNotChangeAnything();
};

namespace {

/// A noisy sphere, 2 % strays, every tenth point twice.
std::string scan(double noise) {
    base::Random random(5);
    std::ostringstream out;
    out.precision(9);
    for (int i = 0; i < 5000; ++i) {
        const double z = 1 - (2 * i + 1.0) / 5000, r = std::sqrt(1 - z * z), a = i * 2.399963229728653;
        const Vec3d d{r * std::cos(a), r * std::sin(a), z};
        const Vec3d p = d * (1 + noise * random.normal());
        for (int k = 0; k < (i % 10 == 0 ? 2 : 1); ++k)
            out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    for (int i = 0; i < 100; ++i) {
        const Vec3d p = random.unitVector() * random.uniform(1.3, 2);
        out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    return out.str();
}

json infoOf(const Program& program, const char* model) {
    const Outcome info = program.run({"info", model, "--json"});
    return info.code == 0 ? json::parse(info.out) : json();
}

} // namespace

void CleanTest::aScanIsCleanedWithNumbers() {
    const Program program;
    program.write("scan.xyz", scan(0.01));
    const Outcome outcome = program.run({"clean", "scan.xyz", "out.ply", "--duplicates", "--outliers", "statistical",
                                         "--denoise", "auto", "--orient", "tree", "--report", "r.json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    for (const char* said : {"Duplicates: ", "Outliers (statistical): ", "Denoise: noise of ", "Orientation (tree): "})
        QVERIFY2(outcome.err.find(said) != std::string::npos, outcome.err.c_str());
    const json report = json::parse(program.read("r.json"));
    QCOMPARE(report.at("read").get<int>(), 5600);
    QCOMPARE(report.at("merged").get<int>() + report.at("duplicates").at("removed").get<int>(), 500);
    const int removed = report.at("outliers").at("removed");
    QVERIFY2(removed >= 95 && removed <= 115, std::to_string(removed).c_str());
    const double sigma = report.at("denoise").at("sigma");
    QVERIFY2(std::abs(sigma / 0.01 - 1) < 0.15, std::to_string(sigma).c_str());
    QVERIFY(report.at("orient").at("doubtful").get<double>() < 0.01);
    QCOMPARE(infoOf(program, "out.ply").at("surfels"), report.at("surfels"));
}

void CleanTest::everyWayRuns_data() {
    QTest::addColumn<QString>("steps");
    for (const char* steps :
         {"--outliers radius", "--outliers islands", "--outliers surface --limit 3", "--denoise 0.01",
          "--normals plane", "--normals jet", "--normals viewpoint --viewpoint 0,0,9", "--orient viewpoint",
          "--orient global", "--thin 0.1", "--duplicates", "--mixed --viewpoint 0,0,9"})
        QTest::newRow(steps) << steps;
}

void CleanTest::everyWayRuns() {
    QFETCH(QString, steps);
    const Program program;
    program.write("scan.xyz", scan(0.01));
    const Outcome outcome = program.run(QStringList{"clean", "scan.xyz", "out.ply"} + steps.split(' '));
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json info = infoOf(program, "out.ply");
    QVERIFY(info.is_object() && info.at("surfels").get<int>() > 300 && info.at("surfels").get<int>() <= 5100);
}

void CleanTest::wrongUsageIsRefused_data() {
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* arguments, int code, const char* says) {
        QTest::newRow(arguments) << arguments << code << says;
    };
    row("clean sample:sphere:500 out.ply", 2, "nothing to do");
    row("clean sample:sphere:500 out.ply --limit 3", 2, "nothing to do");
    row("clean sample:sphere:500", 2, "OUT");
    row("clean sample:sphere:500 out.ply --outliers magic", 2, "statistical");
    row("clean sample:sphere:500 out.ply --denoise -1", 2, "above 0");
    row("clean sample:sphere:500 out.ply --thin 0", 2, "above 0");
    row("clean sample:sphere:500 out.ply --orient viewpoint --viewpoint 1,2", 2, "x,y,z");
    row("clean sample:sphere:500 out.ply --normals grid", 1, "use plane or jet");
    row("clean sample:sphere:500 out.ply --mixed", 1, "give the viewpoint");
    row("clean sample:sphere:500 out.ply --thin 50", 1, "ask for less");
    row("clean sample:sphere:500 out.unknown --duplicates", 2, "out.unknown");
    row("clean nowhere.ply out.ply --duplicates", 1, "nowhere.ply");
    row("clean sample:coil out.ply --denoise auto", 1, "curve");
    row("resample sample:sphere:500 -o out.ply", 2, "--spacing");
    row("resample sample:sphere:500 -o out.ply --spacing 0.1 --count 900", 2, "exclude");
    row("resample sample:sphere:500 -o out.ply --spacing nan", 2, "--spacing");
    row("resample sample:sphere:500 -o out.ply --count 3", 2, "--count");
    row("measure sample:sphere:500 weight", 2, "weight");
    row("measure sample:sphere:500 --fit cube", 2, "plane");
    row("measure sample:sphere:500 --to nowhere.ply", 1, "nowhere.ply");
    row("measure sample:coil", 1, "curve");
}

void CleanTest::wrongUsageIsRefused() {
    QFETCH(QString, arguments);
    QFETCH(int, code);
    QFETCH(QString, says);
    const Program program;
    const Outcome outcome = program.run(arguments.split(' '));
    QVERIFY2(outcome.code == code && outcome.err.find(says.toStdString()) != std::string::npos,
             (std::to_string(outcome.code) + ": " + outcome.err).c_str());
    QVERIFY(!QFile::exists(program.path("out.ply").c_str()));
}

void CleanTest::resampleReachesCountAndSpacing() {
    if (test::sanitized)
        QSKIP("seconds under a sanitizer");
    const Program program;
    QCOMPARE(program.run({"resample", "sample:torus:3000", "-o", "a.ply", "--count", "5000"}).code, 0);
    const int count = infoOf(program, "a.ply").at("surfels");
    QVERIFY2(std::abs(count - 5000) < 150, std::to_string(count).c_str());
    QCOMPARE(program.run({"resample", "a.ply", "-o", "b.ply", "--spacing", "0.1"}).code, 0);
    const double spacing = infoOf(program, "b.ply").at("spacing").at("median");
    QVERIFY2(std::abs(spacing / 0.1 - 1) < 0.05, std::to_string(spacing).c_str());
    QCOMPARE(program.run({"resample", "a.ply", "-o", "unfitted.ply", "--spacing", "0.1", "--no-fit"}).code, 0);
    QVERIFY(program.hash("unfitted.ply") != program.hash("b.ply"));
    program.write("unfitted.jsonl", R"({"op":"open","path":"a.ply"}
{"op":"resample","spacing":0.1,"fit":false}
{"op":"save","path":"session.ply"}
)");
    QCOMPARE(program.run({"run", "unfitted.jsonl"}).code, 0);
    QCOMPARE(program.hash("session.ply"), program.hash("unfitted.ply"));
    const Outcome adaptive = program.run({"resample", "sample:knot:4000", "-o", "c.ply", "--adaptive", "0.002"});
    QVERIFY2(adaptive.code == 0 && adaptive.err.find("points became") != std::string::npos, adaptive.err.c_str());
    const json even = infoOf(program, "c.ply").at("spacing");
    QVERIFY(even.at("max").get<double>() > 1.2 * even.at("min").get<double>());
}

void CleanTest::measureTellsAreaAndVolume() {
    if (test::sanitized)
        QSKIP("seconds under a sanitizer");
    const Program program;
    const Outcome both = program.run({"measure", "sample:sphere:4000", "--json"});
    QVERIFY2(both.code == 0, both.err.c_str());
    const json found = json::parse(both.out);
    QVERIFY(std::abs(found.at("area").get<double>() / 12.566370614 - 1) < 0.002);
    QVERIFY(std::abs(found.at("volume").get<double>() / 4.188790205 - 1) < 0.002);
    const json area = json::parse(program.run({"measure", "sample:sphere:4000", "area", "--json"}).out);
    QVERIFY(area.contains("area") && !area.contains("volume"));
    const Outcome open = program.run({"measure", "sample:moebius", "area", "volume"});
    QVERIFY2(open.code == 0 && open.out.find("none: the surface has no two sides") != std::string::npos,
             (open.out + open.err).c_str());
    const json none = json::parse(program.run({"measure", "sample:moebius", "volume", "--json"}).out);
    QVERIFY(none.at("volume").is_null() && none.at("closed") == false);
}

void CleanTest::measureTellsDistances() {
    const Program program;
    std::string points;
    for (int i = 0; i < 800; ++i) {
        const double z = 1 - (2 * i + 1.0) / 800, r = std::sqrt(1 - z * z), a = i * 2.399963229728653;
        points +=
            QString("%1 %2 %3\n").arg(1.05 * r * std::cos(a)).arg(1.05 * r * std::sin(a)).arg(1.05 * z).toStdString();
    }
    program.write("larger.xyz", points);
    const Outcome outcome = program.run({"measure", "larger.xyz", "--to", "sample:sphere:6000", "--json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json to = json::parse(outcome.out).at("to");
    for (const char* key : {"rms", "p99", "max", "mean"})
        QVERIFY2(std::abs(to.at(key).get<double>() - 0.05) < 1e-3, key);
    QCOMPARE(to.at("count").get<int>(), 800);
    const Outcome text = program.run({"measure", "larger.xyz", "--to", "sample:sphere:6000"});
    QVERIFY2(text.out.starts_with("distances   800 surfels, rms 0.0"), text.out.c_str());
}

void CleanTest::measureFitsShapesFarFromZero() {
    const Program program;
    std::ostringstream out;
    out.precision(17);
    for (int i = 0; i < 3000; ++i) {
        const double a = 2.39996 * i, x = 4.0 * i / 3000;
        out << 1e7 + x << ' ' << -2e6 + 0.5 * std::cos(a) << ' ' << 0.5 * std::sin(a) << '\n';
    }
    program.write("pipe.xyz", out.str());
    const Outcome outcome = program.run({"measure", "pipe.xyz", "--fit", "cylinder", "--json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json fit = json::parse(outcome.out).at("fit");
    QVERIFY(std::abs(fit.at("radius").get<double>() - 0.5) < 1e-6);
    QVERIFY(std::abs(fit.at("axis").at(0).get<double>() - 1) < 1e-9);
    QVERIFY(std::abs(fit.at("point").at(1).get<double>() + 2e6) < 1e-6);
    QVERIFY(fit.at("inliers").get<int>() > 2950 && fit.at("rms").get<double>() < 1e-6);
    QVERIFY(!json::parse(outcome.out).contains("area"));
    for (const char* shape : {"plane", "sphere", "cylinder", "cone", "torus"}) {
        const Outcome text = program.run({"measure", "pipe.xyz", "--fit", shape});
        QVERIFY2(text.code == 0 && text.out.starts_with(shape) && text.out.find("rms") != std::string::npos,
                 (text.out + text.err).c_str());
    }
}

void CleanTest::threadsDoNotChangeAnything() {
    const Program program;
    program.write("scan.xyz", scan(0.01));
    for (const char* threads : {"1", "2"})
        QCOMPARE(program
                     .run({"clean", "scan.xyz", QString("out%1.ply").arg(threads), "--outliers", "surface", "--denoise",
                           "auto", "--thin", "0.05", "--normals", "jet", "--orient", "global", "--threads", threads})
                     .code,
                 0);
    QVERIFY(!program.read("out1.ply").empty());
    QCOMPARE(program.read("out1.ply"), program.read("out2.ply"));
}

static const test::Registered<CleanTest> registered;
#include "clean_test.moc"
