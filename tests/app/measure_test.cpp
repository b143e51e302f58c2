// measure as a person types it: places, ways, angles, thickness, deviations, and the files that it writes.
#include "program.h"
#include "support/registry.h"

#include <cmath>
#include <numbers>
#include <QTest>

using test::json;
using test::Outcome;
using test::Program;
using test::rowsOf;

class MeasureTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void placesAreMeasured();
    void waysAreWritten();
    void placesAreTheFilesOwn();
    void thicknessIsToldAndKept();
    void openSheetsHaveNoThickness();
    void deviationsAreCountedTabledAndColoured();
    void wrongUsageIsRefused_data();
    void wrongUsageIsRefused();
};

void MeasureTest::placesAreMeasured() {
    const Program program;
    const Outcome outcome = program.run({"measure", "sample:sphere:4000", "--distance", "1,0,0", "-1,2,0", "--geodesic",
                                         "0,0,1", "-1,0,0", "--angle", "1,0,0", "0,0,0", "0,2,0", "--json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json found = json::parse(outcome.out);
    QVERIFY(std::abs(found.at("distance").at("length").get<double>() - std::sqrt(8)) < 1e-12);
    QCOMPARE(found.at("distance").at("delta"), (json{-2, 2, 0}));
    QVERIFY(std::abs(found.at("geodesic").at("length").get<double>() - std::numbers::pi / 2) < 1e-3);
    QVERIFY(std::abs(found.at("geodesic").at("straight").get<double>() - std::sqrt(2)) < 1e-3);
    QCOMPARE(found.at("geodesic").at("along_rim").get<double>(), 0.0);
    QVERIFY(std::abs(found.at("angle").at("degrees").get<double>() - 90) < 1e-9);
    QVERIFY(!found.contains("area"));
    const Outcome normals = program.run({"measure", "sample:sphere:4000", "--angle", "1,0,0", "0,0,-2"});
    QVERIFY2(normals.out.starts_with("angle       90.0") || normals.out.starts_with("angle       89.9"),
             normals.out.c_str());
}

void MeasureTest::waysAreWritten() {
    const Program program;
    const Outcome outcome =
        program.run({"measure", "sample:sphere:4000", "--geodesic", "0,0,1", "0,1,0", "--path", "way.csv"});
    QVERIFY2(outcome.code == 0 && outcome.out.find("along the surface") != std::string::npos, outcome.err.c_str());
    const auto rows = rowsOf(program.read("way.csv"));
    QCOMPARE(rows.at(0), (std::vector<std::string>{"curve", "closed", "x", "y", "z", "nx", "ny", "nz"}));
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto at = [&](std::size_t k) { return std::stod(rows[i].at(k)); };
        QVERIFY(std::abs(at(2)) < 1e-3 && std::abs(std::hypot(at(3), at(4)) - 1) < 1e-3);
    }
    for (const char* file : {"way.obj", "way.dxf"})
        QCOMPARE(program.run({"measure", "sample:sphere:4000", "--geodesic", "0,0,1", "0,1,0", "--path", file}).code,
                 0);
    QVERIFY(program.read("way.dxf").find("POLYLINE") != std::string::npos);
}

void MeasureTest::placesAreTheFilesOwn() {
    const Program program;
    std::ostringstream ball;
    ball.precision(12);
    for (int i = 0; i < 4000; ++i) {
        const double z = 1 - (2 * i + 1.0) / 4000, r = std::sqrt(1 - z * z), a = i * 2.399963229728653;
        ball << 1e7 + r * std::cos(a) << ' ' << r * std::sin(a) - 3e6 << ' ' << z << '\n';
    }
    program.write("ball.xyz", ball.str());
    const Outcome outcome = program.run({"measure", "ball.xyz", "--geodesic", "10000001,-3000000,0",
                                         "9999999,-3000000,0.1", "--thickness-at", "10000000,-3000001.5,0", "--json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json found = json::parse(outcome.out);
    QVERIFY(std::abs(found.at("geodesic").at("length").get<double>() - (std::numbers::pi - 0.0997)) < 3e-3);
    const json at = found.at("thickness_at").at(0);
    QVERIFY(std::abs(at.at("thickness").get<double>() - 2) < 1e-3 && at.at("lean_deg").get<double>() < 1);
    QVERIFY(std::abs(at.at("opposite").at(1).get<double>() + 2999999) < 1e-3);
}

void MeasureTest::thicknessIsToldAndKept() {
    const Program program;
    const Outcome outcome = program.run({"measure", "sample:torus:5000", "--thickness", "--csv", "t.csv", "-o", "t.ply",
                                         "--colours", "thickness", "--json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json found = json::parse(outcome.out).at("thickness");
    const double median = found.at("median").get<double>();
    QVERIFY(std::abs(found.at("max").get<double>() / median - 1) < 0.01 && found.at("none") == 0);
    const auto rows = rowsOf(program.read("t.csv"));
    QCOMPARE(rows.at(0), (std::vector<std::string>{"x", "y", "z", "thickness"}));
    QVERIFY(std::abs(std::stod(rows.at(17).at(3)) / median - 1) < 0.01);
    const json info = json::parse(program.run({"info", "t.ply", "--json"}).out);
    const json names = info.at("attributes");
    QVERIFY(std::find(names.begin(), names.end(), "thickness") != names.end() &&
            std::find(names.begin(), names.end(), "colour") != names.end());
    // what the attribute holds is what the table holds
    QCOMPARE(program.run({"run", "/dev/null", "--model", "t.ply", "-o", "again.ply"}).code, 0);
    QCOMPARE(json::parse(program.run({"info", "again.ply", "--json"}).out).at("hash"), info.at("hash"));
}

/// Nothing opposite is not a thickness of 0.
void MeasureTest::openSheetsHaveNoThickness() {
    const Program program;
    std::string sheet =
        "ply\nformat ascii 1.0\nelement vertex 400\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nend_header\n";
    for (int i = 0; i < 400; ++i)
        sheet += QString("%1 %2 0 0 0 1\n").arg(0.1 * (i % 20)).arg(0.1 * (i / 20)).toStdString();
    program.write("sheet.ply", sheet);
    const Outcome outcome = program.run({"measure", "sheet.ply", "--thickness", "--json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json found = json::parse(outcome.out).at("thickness");
    QVERIFY2(found.at("count") == 0 && found.at("none") == 400 && found.at("min").is_null() &&
                 found.at("median").is_null(),
             outcome.out.c_str());
}

void MeasureTest::deviationsAreCountedTabledAndColoured() {
    const Program program;
    std::string points;
    for (int i = 0; i < 900; ++i) { // a third within, two thirds outside
        const double z = 1 - (2 * i + 1.0) / 900, r = std::sqrt(1 - z * z), a = i * 2.399963229728653;
        const double s = i % 3 ? 1.05 : 0.9;
        points += QString("%1 %2 %3\n").arg(s * r * std::cos(a)).arg(s * r * std::sin(a)).arg(s * z).toStdString();
    }
    program.write("two.xyz", points);
    const Outcome outcome =
        program.run({"measure", "two.xyz", "--to", "sample:sphere:6000", "--histogram", "4", "--range", "-0.25,0.25",
                     "--csv", "d.csv", "-o", "d.ply", "--colours", "deviation", "--json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json histogram = json::parse(outcome.out).at("to").at("histogram");
    QCOMPARE(histogram.at("counts"), (json{0, 300, 600, 0}));
    QVERIFY(histogram.at("below") == 0 && histogram.at("low") == -0.25);
    const auto rows = rowsOf(program.read("d.csv"));
    QCOMPARE(rows.at(0), (std::vector<std::string>{"x", "y", "z", "deviation", "status"}));
    int inside = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        inside += std::stod(rows[i].at(3)) < 0;
        QCOMPARE(rows[i].at(4), std::string("ok"));
    }
    QVERIFY(inside == 300 && rows.size() == 901);
    const Outcome text = program.run({"measure", "two.xyz", "--to", "sample:sphere:6000", "--histogram", "6"});
    QVERIFY2(text.out.find("  from -0.1") != std::string::npos && text.out.find(" 300 #") != std::string::npos,
             text.out.c_str());
}

void MeasureTest::wrongUsageIsRefused_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* arguments, int code, const char* told) {
        QTest::newRow(arguments) << QString(arguments).split(' ', Qt::SkipEmptyParts) << code << told;
    };
    row("--histogram 5", 2, "--to");
    row("--distance 1,2,3", 2, "--distance");
    row("--distance 1,2,3 1,2", 2, "x,y,z");
    row("--thickness --colours thickness", 2, "-o");
    row("--thickness -o a.ply --colours deviation", 2, "--to");
    row("--path a.csv", 2, "--geodesic");
    row("--geodesic 1,0,0 0,1,0 --path a.svg", 2, ".csv");
    row("--thickness --range 3,1 --colours thickness -o a.ply", 2, "LOW,HIGH");
    row("--csv a.csv", 2, "--thickness");
    row("--angle 1,0,0 1,0,0 0,1,0", 1, "no angle");
    row("--geodesic 1e30,0,0 0,1,0", 1, "no surface");
    row("--thickness-at 0,0,1e30", 1, "no surface");
}

void MeasureTest::wrongUsageIsRefused() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, told);
    const Program program;
    const Outcome outcome = program.run(QStringList{"measure", "sample:sphere:500"} + arguments);
    QCOMPARE(outcome.code, code);
    QVERIFY2(outcome.err.find(told.toStdString()) != std::string::npos, outcome.err.c_str());
}

static const test::Registered<MeasureTest> registered;
#include "measure_test.moc"
