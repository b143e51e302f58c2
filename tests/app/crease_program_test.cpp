// pointclay crease: what is found and drawn, the report, what query and info say of it.
#include "program.h"
#include "support/registry.h"

#include <nlohmann/json.hpp>
#include <QTest>

using nlohmann::json;
using test::Outcome, test::Program;

class CreaseProgramTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void cubesAreFound();
    void withoutCellsAllIsOneFace();
    void linesAreDrawnAndTakenBack();
    void wrongUsageIsTold();
};

namespace {

/// The surface of the unit cube as points and normals, without faces: an even grid on each side.
void writePoints(const Program& program, int n) {
    std::ostringstream out;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1})
            for (int a = 0; a < n; ++a)
                for (int b = 0; b < n; ++b) {
                    double p[3], m[3]{};
                    p[axis] = side;
                    p[(axis + 1) % 3] = (a + 0.5) / n;
                    p[(axis + 2) % 3] = (b + 0.5) / n;
                    m[axis] = 2 * side - 1;
                    out << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << m[0] << ' ' << m[1] << ' ' << m[2] << '\n';
                }
    program.write("cube.xyz", out.str());
}

json jsonOf(const Program& program, const std::string& name) {
    return json::parse(program.read(name));
}

} // namespace

void CreaseProgramTest::cubesAreFound() {
    const Program program;
    writePoints(program, 24);
    const Outcome found = program.run({"crease", "cube.xyz", "-o", "out.ply", "--detect", "--report", "r.json"});
    QVERIFY2(found.code == 0, found.err.c_str());
    QVERIFY2(found.err.find("6 smooth patches meet in creases, 12 pairs") != std::string::npos, found.err.c_str());
    const json report = jsonOf(program, "r.json");
    QCOMPARE(report.at("cells").get<int>(), 6);
    QCOMPARE(report.at("seams").get<int>(), 12);
    QCOMPARE(report.at("corners").get<int>(), 8);
    QVERIFY2(report.at("narrow").is_number_integer() && report.at("noise").is_number_float(), report.dump().c_str());
    QVERIFY2(std::abs(report.at("length").get<double>() - 12) < 0.1, report.dump().c_str());
    QCOMPARE(json::parse(program.run({"info", "out.ply", "--json"}).out).at("cells").get<int>(), 6);
    program.write("p.txt", "1.01 0.5 0.5\n1.01 1.01 0.5\n1.01 1.01 1.01\n");
    QCOMPARE(program.run({"query", "out.ply", "--at", "p.txt", "--what", "cell,feature", "-o", "q.csv"}).code, 0);
    const std::string answers = program.read("q.csv");
    for (const char* word : {",face\n", ",seam\n", ",corner\n"})
        QVERIFY2(answers.find(word) != std::string::npos, answers.c_str());
}

void CreaseProgramTest::withoutCellsAllIsOneFace() {
    const Program program;
    writePoints(program, 24);
    program.write("p.txt", "1.01 0.5 0.5\n9 9 9\n");
    for (const char* precision : {"float", "double"}) {
        const Outcome asked = program.run(
            {"query", "cube.xyz", "--at", "p.txt", "--what", "cell,feature", "--precision", precision, "-o", "q.csv"});
        QVERIFY2(asked.code == 0, asked.err.c_str());
        const std::string answers = program.read("q.csv");
        QVERIFY2(answers.find(",ok,0,face\n") != std::string::npos, answers.c_str());
        QVERIFY2(answers.find(",outside,-1,") != std::string::npos, answers.c_str());
    }
    QCOMPARE(program.run({"query", "cube.xyz", "--at", "p.txt", "--what", "cell", "--manifold", "curve", "-o", "q.csv"})
                 .code,
             2);
}

void CreaseProgramTest::linesAreDrawnAndTakenBack() {
    const Program program;
    writePoints(program, 24);
    program.write("line.txt", "0.2 0 1\n0.8 0 1\n");
    QCOMPARE(program.run({"convert", "cube.xyz", "plain.ply"}).code, 0);
    const Outcome drawn =
        program.run({"crease", "cube.xyz", "-o", "out.ply", "--along", "line.txt", "--report", "r.json"});
    QVERIFY2(drawn.code == 0, drawn.err.c_str());
    const json report = jsonOf(program, "r.json");
    QVERIFY(report.at("seams").get<int>() >= 1 && report.at("corners").get<int>() == 0);
    QVERIFY(report.at("creased").is_number_integer() && report.at("changed").is_number_integer());
    const auto length = report.at("length").get<double>();
    QVERIFY2(length > 0.5 && length < 0.85, std::to_string(length).c_str());
    const Outcome gone =
        program.run({"crease", "out.ply", "-o", "back.ply", "--detect", "--sharpness", "0", "--report", "r.json"});
    QVERIFY2(gone.code == 0, gone.err.c_str());
    for (const char* each : {"cells", "seams", "length", "corners"})
        QCOMPARE(jsonOf(program, "r.json").at(each).get<double>(), 0.0);
}

void CreaseProgramTest::wrongUsageIsTold() {
    const Program program;
    writePoints(program, 6);
    program.write("line.txt", "0.2 0 1\n0.8 0 1\n");
    QCOMPARE(program.run({"crease", "cube.xyz", "-o", "o.ply"}).code, 2);
    QCOMPARE(program.run({"crease", "cube.xyz", "-o", "o.ply", "--detect", "--along", "line.txt"}).code, 2);
    QCOMPARE(program.run({"crease", "cube.xyz", "-o", "o.ply", "--detect", "--sharpness", "3"}).code, 2);
    QCOMPARE(program.run({"crease", "cube.xyz", "-o", "o.ply", "--along", "none.txt"}).code, 1);
    QVERIFY(!program.dir().exists("o.ply"));
}

static const test::Registered<CreaseProgramTest> registered;
#include "crease_program_test.moc"
