// mesh: the files it writes, what --check and --report tell, and what is refused in one sentence.
#include "program.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using test::json, test::Outcome, test::Program;

class MeshCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void bothMethodsMeshAnOpenStrip_data();
    void bothMethodsMeshAnOpenStrip();
    void delaunayKeepsItsPromises();
    void curvesAreMeshedAsTubes();
    void farModelsKeepTheirCoordinates();
    void wrongUsageIsRefused_data();
    void wrongUsageIsRefused();
    void nothingIsLeftBehindWhereWritingFails();
};

void MeshCommandTest::bothMethodsMeshAnOpenStrip_data() {
    QTest::addColumn<QString>("method");
    for (const char* method : {"marching-cubes", "delaunay"})
        QTest::addRow("%s", method) << method;
}

void MeshCommandTest::bothMethodsMeshAnOpenStrip() {
    QFETCH(QString, method);
    const Program program;
    const Outcome outcome = program.run(
        {"mesh", "sample:moebius:2000", "-o", "strip.ply", "--method", method, "--check", "--report", "strip.json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json report = json::parse(program.read("strip.json"));
    QCOMPARE(report.at("components").get<int>(), 1);
    QCOMPARE(report.at("boundary_loops").get<int>(), 1);
    QCOMPARE(report.at("euler").get<int>(), 0);
    QCOMPARE(report.at("orientable").get<bool>(), false);
    QCOMPARE(report.at("manifold").get<bool>(), true);
    QCOMPARE(report.at("self_intersections").get<int>(), 0);
    QCOMPARE(report.at("crosscaps").get<int>(), 1);
    for (const char* key : {"vertices", "faces", "min_angle_deg", "max_vertex_distance", "max_face_distance"})
        QVERIFY2(report.at(key).get<double>() >= 0, key);
    for (const char* part :
         {"vertices   ", "faces   ", "Euler characteristic      0", "crosscaps   ", "smallest angle", "spacings)"})
        QVERIFY2(outcome.out.find(part) != std::string::npos, part);
    const Outcome info = program.run({"info", "strip.ply", "--json", "--faces", "vertices"});
    QCOMPARE(json::parse(info.out).at("surfels").get<int>(), report.at("vertices").get<int>());
    QCOMPARE(json::parse(info.out).at("faces").get<int>(), report.at("faces").get<int>());
}

void MeshCommandTest::delaunayKeepsItsPromises() {
    const Program program;
    const Outcome outcome =
        program.run({"mesh", "sample:torus:3000", "-o", "torus.off", "--method", "delaunay", "--angle", "28", "--size",
                     "0.08", "--distance", "0.004", "--report", "torus.json", "--threads", "1"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY(outcome.out.empty()); // --check was not asked for
    const json report = json::parse(program.read("torus.json"));
    QVERIFY(report.at("min_angle_deg").get<double>() >= 28);
    QVERIFY(report.at("max_face_distance").get<double>() <= 0.004);
    QVERIFY(report.at("longest_edge").get<double>() <= 0.16);
    QCOMPARE(report.at("genus").get<int>(), 1);
    const std::string once = program.read("torus.off");
    QCOMPARE(program
                 .run({"mesh", "sample:torus:3000", "-o", "torus.off", "--method", "delaunay", "--angle", "28",
                       "--size", "0.08", "--distance", "0.004"})
                 .code,
             0);
    QVERIFY2(program.read("torus.off") == once, "the same bits in another process with other threads");
}

void MeshCommandTest::curvesAreMeshedAsTubes() {
    if (test::sanitized)
        QSKIP("half a minute under a sanitizer");
    const Program program;
    const Outcome outcome = program.run({"mesh", "sample:coil:400", "-o", "coil.stl", "--report", "coil.json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY(json::parse(program.read("coil.json")).at("faces").get<int>() > 100);
}

void MeshCommandTest::farModelsKeepTheirCoordinates() {
    const Program program;
    std::string points;
    for (int i = 0; i < 30; ++i)
        for (int j = 0; j < 30; ++j)
            points += std::to_string(637000 + 0.5 * i) + " " + std::to_string(851000 + 0.5 * j) + " 400.25\n";
    program.write("far.xyz", points);
    const Outcome outcome = program.run({"mesh", "far.xyz", "-o", "far.obj", "--method", "delaunay"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    std::istringstream lines(program.read("far.obj"));
    int vertices = 0;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("v ")) {
            std::istringstream numbers(line.substr(2));
            double x = 0, y = 0, z = 0;
            numbers >> x >> y >> z;
            QVERIFY(x > 636999 && x < 637016 && y > 850999 && y < 851016 && std::abs(z - 400.25) < 1e-4);
            ++vertices;
        }
    QVERIFY(vertices > 100);
}

void MeshCommandTest::wrongUsageIsRefused_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* tag, const QStringList& more, const char* part) {
        QTest::newRow(tag) << QStringList{"mesh", "sample:sphere:500"} + more << part;
    };
    row("no output", {}, "--output");
    row("points only", {"-o", "a.xyz"}, "ply obj stl off");
    row("cell", {"-o", "a.ply", "--method", "delaunay", "--cell", "1"}, "--cell goes with --method marching-cubes");
    row("angle", {"-o", "a.ply", "--angle", "20"}, "--angle goes with --method delaunay");
    row("wide angle", {"-o", "a.ply", "--method", "delaunay", "--angle", "40"}, "--angle");
    row("no size", {"-o", "a.ply", "--method", "delaunay", "--size", "0"}, "--size");
    row("method", {"-o", "a.ply", "--method", "cubes"}, "--method");
}

void MeshCommandTest::wrongUsageIsRefused() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, part);
    const Program program;
    const Outcome outcome = program.run(arguments);
    QCOMPARE(outcome.code, 2);
    QVERIFY2(outcome.err.find(part.toStdString()) != std::string::npos, outcome.err.c_str());
    QVERIFY(!std::filesystem::exists(program.path("a.ply")));
}

void MeshCommandTest::nothingIsLeftBehindWhereWritingFails() {
    const Program program;
    const Outcome outcome = program.run({"mesh", "sample:sphere:500", "-o", "missing/a.ply"});
    QCOMPARE(outcome.code, 1);
    QVERIFY(outcome.err.find("missing/a.ply") != std::string::npos);
}

static const test::Registered<MeshCommandTest> registered;
#include "mesh_test.moc"
