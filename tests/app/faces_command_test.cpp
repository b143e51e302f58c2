// Meshes on the command line: they open as the surface of their faces, whatever reads them.
#include "core/base/random.h"
#include "program.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <nlohmann/json.hpp>
#include <numbers>
#include <QTest>

using nlohmann::json;
using test::Outcome, test::Program;

class FacesCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aCubeOpensAsItsSurface();
    void samplesAreAsManyAsAskedFor();
    void theMeshOfAClosedMeshIsClosed();
    void convertWritesTheSurface();
    void optionsThatExcludeEachOtherAreRefused();
    void sessionsOpenFacesAlike();
    void runAndBenchTakeTheOptions();
    void cloudsHaveNoFacesToSample();
    void errorsSpeakOfOptions();
    void creasesAreKeptAndAnswer();
    void bladesStayWhole_data();
    void bladesStayWhole();
};

namespace {

/// A cube of 12 triangles, as files of several formats hold it.
void writeCubes(const Program& program) {
    program.write("cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
                              "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
    program.write("cube.off", "OFF\n8 6 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
                              "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n");
}

json infoOf(const Program& program, const QStringList& arguments) {
    const Outcome outcome = program.run(QStringList{"info", "--json"} + arguments);
    return outcome.code == 0 ? json::parse(outcome.out) : json::object();
}

} // namespace

void FacesCommandTest::aCubeOpensAsItsSurface() {
    const Program program;
    writeCubes(program);
    for (const char* name : {"cube.obj", "cube.off"}) {
        const Outcome opened = program.run({"info", "--json", name});
        QVERIFY2(opened.err.find("12 triangles sampled to 100,") != std::string::npos, opened.err.c_str());
        QVERIFY2(opened.err.find("--faces vertices keeps the 8 vertices") != std::string::npos, opened.err.c_str());
        const json info = json::parse(opened.out);
        QVERIFY(info.at("sampled").get<bool>() && info.at("closed").get<bool>());
        QVERIFY(info.at("surfels").get<int>() >= 100'000 && info.at("surfels").get<int>() < 105'000);
        QCOMPARE(info.at("faces").get<int>(), 6);
        const json kept = infoOf(program, {name, "--faces", "vertices"});
        QVERIFY(!kept.at("sampled").get<bool>());
        QCOMPARE(kept.at("surfels").get<int>(), 8);
    }
}

void FacesCommandTest::samplesAreAsManyAsAskedFor() {
    const Program program;
    writeCubes(program);
    const int counted = infoOf(program, {"cube.obj", "--sample-count", "3000"}).at("surfels").get<int>();
    QVERIFY2(counted > 2950 && counted < 3150, qPrintable(QString::number(counted)));
    const int spaced = infoOf(program, {"cube.obj", "--sample-spacing", "0.05"}).at("surfels").get<int>(); // 6 / 0.0025
    QVERIFY2(spaced > 2350 && spaced < 2500, qPrintable(QString::number(spaced)));
}

void FacesCommandTest::theMeshOfAClosedMeshIsClosed() {
    const Program program;
    writeCubes(program);
    QCOMPARE(program.run({"mesh", "cube.obj", "--sample-count", "5000", "-o", "out.ply", "--report", "r.json"}).code,
             0);
    const json report = json::parse(program.read("r.json"));
    QCOMPARE(report.at("boundary_loops").get<int>(), 0);
    QCOMPARE(report.at("genus").get<int>(), 0);
    QCOMPARE(report.at("components").get<int>(), 1);
}

void FacesCommandTest::convertWritesTheSurface() {
    const Program program;
    writeCubes(program);
    QCOMPARE(program.run({"convert", "cube.obj", "out.ply", "--sample-count", "2000"}).code, 0);
    QVERIFY(infoOf(program, {"out.ply"}).at("surfels").get<int>() > 1900);
    QCOMPARE(program.run({"convert", "cube.obj", "kept.ply", "--faces", "vertices"}).code, 0);
    QCOMPARE(infoOf(program, {"kept.ply"}).at("surfels").get<int>(), 8);
}

void FacesCommandTest::optionsThatExcludeEachOtherAreRefused() {
    const Program program;
    writeCubes(program);
    QVERIFY(program.run({"info", "cube.obj", "--sample-count", "9000", "--sample-spacing", "0.1"}).code != 0);
    QVERIFY(program.run({"info", "cube.obj", "--sample-count", "9000", "--faces", "vertices"}).code != 0);
    QCOMPARE(program.run({"info", "cube.obj", "--faces", "some"}).code, 2);
    QCOMPARE(program.run({"info", "cube.obj", "--sample-spacing", "1e-9"}).code, 1);
}

void FacesCommandTest::sessionsOpenFacesAlike() {
    const Program program;
    writeCubes(program);
    program.write("s.jsonl", "{\"op\":\"open\",\"path\":\"cube.obj\",\"faces\":\"sample\",\"sample_count\":3000,"
                             "\"sharp\":30}\n{\"op\":\"save\",\"path\":\"out.ply\"}\n");
    QCOMPARE(program.run({"run", "s.jsonl"}).code, 0);
    QCOMPARE(program.hash("out.ply"),
             infoOf(program, {"cube.obj", "--sample-count", "3000", "--sharp", "30"}).at("hash").get<std::string>());
}

void FacesCommandTest::runAndBenchTakeTheOptions() {
    const Program program;
    writeCubes(program);
    program.write("s.jsonl", "{\"op\":\"save\",\"path\":\"out.ply\"}\n");
    QCOMPARE(program.run({"run", "s.jsonl", "--model", "cube.obj", "--sample-count", "3000", "--sharp", "30"}).code, 0);
    QCOMPARE(program.hash("out.ply"),
             infoOf(program, {"cube.obj", "--sample-count", "3000", "--sharp", "30"}).at("hash").get<std::string>());
    QCOMPARE(program.run({"run", "s.jsonl", "--sample-count", "3000"}).code, 2); // of which model?
    QCOMPARE(program
                 .run({"bench", "build", "--model", "cube.obj", "--sample-count", "3000", "--seconds", "0", "--json",
                       "b.json"})
                 .code,
             0);
    const int points = json::parse(program.read("b.json")).at(0).at("points").get<int>();
    QVERIFY(points > 2900 && points < 3150);
    QCOMPARE(program.run({"bench", "build", "--faces", "sample", "--seconds", "0"}).code, 2);
}

void FacesCommandTest::cloudsHaveNoFacesToSample() {
    const Program program;
    program.write("cloud.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 0\n1 0 1\n");
    program.write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
    program.write("s.jsonl", "{\"op\":\"open\",\"path\":\"cloud.xyz\",\"faces\":\"sample\"}\n");
    for (const QStringList& asked :
         {QStringList{"--faces", "sample"}, {"--sample-count", "900"}, {"--sample-spacing", "0.1"}})
        for (const QStringList& command : {QStringList{"info", "cloud.xyz"},
                                           {"info", "line.obj"},
                                           {"convert", "cloud.xyz", "out.ply"},
                                           {"mesh", "cloud.xyz", "-o", "out.ply"},
                                           {"render", "sample:sphere:500", "-o", "out.png"}}) {
            const Outcome outcome = program.run(command + asked);
            QVERIFY2(outcome.code == 1 && outcome.err.find("to sample") != std::string::npos, outcome.err.c_str());
            QVERIFY2(outcome.err.find(command[1].toStdString()) != std::string::npos, outcome.err.c_str());
            QCOMPARE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
        }
    QCOMPARE(program.run({"run", "s.jsonl"}).code, 1);
    for (const QStringList& silent : {QStringList{"--faces", "auto"}, {"--faces", "vertices"}, {"--sharp", "20"}})
        QCOMPARE(program.run(QStringList{"info", "cloud.xyz"} + silent).code, 0);
}

void FacesCommandTest::errorsSpeakOfOptions() {
    const Program program;
    writeCubes(program);
    for (const QStringList& wrong : {QStringList{"--sample-count", "3"},
                                     {"--sample-count", "many"},
                                     {"--sample-spacing", "-1"},
                                     {"--sample-spacing", "1e-9"},
                                     {"--sample-count", "9000", "--faces", "vertices"},
                                     {"--sample-count", "9000", "--sample-spacing", "0.1"}}) {
        const Outcome outcome = program.run(QStringList{"info", "cube.obj"} + wrong);
        QVERIFY2(outcome.code != 0 && !outcome.err.empty(), outcome.err.c_str());
        QVERIFY2(outcome.err.find("sample_") == std::string::npos, outcome.err.c_str());
    }
    QVERIFY(program.run({"mesh", "--help"}).out.find("off for faces sampled so finely") != std::string::npos);
}

/// A cube with creases: saved and opened again it is the same, query and intersect know its edges and corners.
void FacesCommandTest::creasesAreKeptAndAnswer() {
    const Program program;
    writeCubes(program);
    const QStringList options{"--sample-count", "3000"};
    const json info = infoOf(program, QStringList{"cube.obj"} + options);
    QCOMPARE(info.at("cells").get<int>(), 6);
    for (const QStringList& rounded : {QStringList{"--sharp", "off"}, {"--sharp", "100"}, {"--creases", "off"}})
        QCOMPARE(infoOf(program, QStringList{"cube.obj"} + options + rounded).at("cells").get<int>(), 0);
    QCOMPARE(infoOf(program, {"cube.obj", "--sample-count", "3000", "--creases", "on"}).at("hash"), info.at("hash"));
    program.write("s.jsonl", "{\"op\":\"open\",\"path\":\"cube.obj\",\"sample_count\":3000}\n"
                             "{\"op\":\"save\",\"path\":\"out.ply\"}\n");
    QCOMPARE(program.run({"run", "s.jsonl"}).code, 0);
    QCOMPARE(program.hash("out.ply"), info.at("hash").get<std::string>());
    QCOMPARE(infoOf(program, {"out.ply"}).at("cells").get<int>(), 6);

    program.write("p.txt", "1.01 0.5 0.5\n1.01 1.01 0.5\n1.01 1.01 1.01\n5 5 5\n");
    QCOMPARE(program
                 .run({"query", "out.ply", "--at", "p.txt", "--what", "cell,feature,project-orthogonal", "-o", "q.csv",
                       "--precision", "double"})
                 .code,
             0);
    const QStringList rows = QString::fromStdString(program.read("q.csv")).split('\n');
    QCOMPARE(rows[0], QString("x,y,z,status,px,py,pz,iterations,cell,feature"));
    const char* features[] = {"face", "seam", "corner"};
    for (int i = 0; i < 3; ++i) {
        const QStringList row = rows[i + 1].split(',');
        QCOMPARE(row[9], QString(features[i]));
        QVERIFY(std::abs(row[4].toDouble() - 1) < 1e-6);
        QVERIFY(std::abs(row[5].toDouble() - (i > 0 ? 1 : 0.5)) < 1e-6);
    }
    QCOMPARE(rows[4].split(',')[8], QString("-1"));

    program.write("r.csv", "ox,oy,oz,dx,dy,dz\n3,2.999,0.5,-1,-1,0\n3,3.01,0.5,-1,-1,0\n");
    for (const char* precision : {"float", "double"}) {
        QCOMPARE(program.run({"intersect", "out.ply", "--rays", "r.csv", "-o", "h.csv", "--precision", precision}).code,
                 0);
        const QStringList hits = QString::fromStdString(program.read("h.csv")).split('\n');
        for (int i = 1; i <= 2; ++i) { // beside the edge, on either side of it
            const QStringList hit = hits[i].split(',');
            QCOMPARE(hit[0], QString("1"));
            QVERIFY(std::abs(hit[i == 1 ? 2 : 3].toDouble() - 1) < 1e-6);
        }
    }
    // who asks for what is not there is told
    QCOMPARE(program.run({"info", "cube.obj", "--creases", "on", "--faces", "vertices"}).code, 1);
    QCOMPARE(program.run({"info", "cube.obj", "--creases", "on", "--sharp", "off"}).code, 1);
    QCOMPARE(program.run({"info", "out.ply", "--creases", "on"}).code, 1);
}

void FacesCommandTest::bladesStayWhole_data() {
    QTest::addColumn<QString>("method");
    QTest::newRow("marching cubes") << "marching-cubes";
    QTest::newRow("Delaunay") << "delaunay";
}

/// Of some 16 degrees: towards the edge walls get thinner than samples are apart, however many these are.
void FacesCommandTest::bladesStayWhole() {
    QFETCH(QString, method);
    base::Random random(test::seed());
    const Program program;
    const double half = std::tan(random.uniform(14.5, 18) * std::numbers::pi / 360);
    const std::string y = std::to_string(half);
    program.write("blade.off", "OFF\n6 5 0\n0 0 0\n1 -" + y + " 0\n1 " + y + " 0\n0 0 1\n1 -" + y + " 1\n1 " + y +
                                   " 1\n3 0 2 1\n3 3 4 5\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 3 5\n");
    QCOMPARE(program
                 .run({"mesh", "blade.off", "--sample-count", test::sanitized ? "2000" : "6000", "--method", method,
                       "-o", "out.ply", "--report", "r.json"})
                 .code,
             0);
    const json report = json::parse(program.read("r.json"));
    const QByteArray where = "seed " + QByteArray::number(test::seed());
    QVERIFY2(report.at("boundary_loops") == 0 && report.at("genus") == 0, where);
    QVERIFY2(report.at("components") == 1, where);
}

static const test::Registered<FacesCommandTest> registered;
#include "faces_command_test.moc"
