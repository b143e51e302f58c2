// info and convert: what is told about a model, and that formats carry it.
#include "program.h"
#include "support/registry.h"

#include <QTest>
#include <set>

using nlohmann::json;
using test::Outcome;
using test::Program;

class InfoTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theObjectHasTheContractsKeys();
    void aGridIsDescribedExactly();
    void fewPointsAreDescribedWithoutASurface();
    void conversionKeepsThePoints();
    void conversionsAreTold();
    void normalsOfFacesAreNotTheFiles();
    void realScansHaveTheirCounts();
};

static std::string grid() {
    std::string out = "# a grid\n";
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 10; ++j)
            out += std::to_string(0.5 * i) + " " + std::to_string(0.5 * j - 2) + " 3\n";
    return out + "nan 0 0\n";
}

void InfoTest::theObjectHasTheContractsKeys() {
    const Program program;
    const Outcome outcome = program.run({"info", "sample:torus:2000", "--json"});
    QCOMPARE(outcome.code, 0);
    const json info = json::parse(outcome.out);
    const std::set<std::string> wanted{"surfels",    "bounds", "origin",  "spacing", "support", "normals",
                                       "attributes", "faces",  "dropped", "format",  "hash",    "sampled",
                                       "closed",     "up",     "merged",  "cells",   "shapes"};
    std::set<std::string> found;
    for (const auto& [key, value] : info.items())
        found.insert(key);
    QVERIFY(found == wanted);
    for (const char* key : {"spacing", "support"}) {
        const double min = info[key]["min"], median = info[key]["median"], max = info[key]["max"];
        QVERIFY(0 < min && min <= median && median <= max);
    }
    QVERIFY(info["bounds"]["min"].size() == 3 && info["bounds"]["max"].size() == 3 && info["origin"].size() == 3);
    QCOMPARE(info["hash"].get<std::string>().size(), std::size_t(32));
    QCOMPARE(info["normals"], json(true));
    QCOMPARE(info["closed"], json(true));
    const Outcome text = program.run({"info", "sample:torus:2000"});
    for (const std::string& key : wanted)
        QVERIFY2(("\n" + text.out).find("\n" + key + " ") != std::string::npos, key.c_str());
}

void InfoTest::aGridIsDescribedExactly() {
    const Program program;
    program.write("grid.xyz", grid());
    const json info = json::parse(program.run({"info", "grid.xyz", "--json"}).out);
    QCOMPARE(info["surfels"], json(120));
    QCOMPARE(info["closed"], json(false));
    QCOMPARE(info["dropped"], json(1));
    QCOMPARE(info["faces"], json(0));
    QCOMPARE(info["normals"], json(false));
    QCOMPARE(info["bounds"]["min"], json({0.0, -2.0, 3.0}));
    QCOMPARE(info["bounds"]["max"], json({5.5, 2.5, 3.0}));
    QCOMPARE(info["origin"], json({0.0, 0.0, 0.0}));
    // Six nearest of an inner point of a square grid: four at 0.5 and two at 0.5 sqrt 2.
    const double inner = 0.93 * (4 * 0.5 + 2 * 0.5 * std::sqrt(2.0)) / 6;
    QVERIFY(std::abs(info["spacing"]["median"].get<double>() - inner) < 1e-6);
}

void InfoTest::fewPointsAreDescribedWithoutASurface() {
    const Program program;
    program.write("three.xyz", "0 0 0\n1 0 0\n0 1 0\n");
    const Outcome outcome = program.run({"info", "three.xyz", "--json"});
    QCOMPARE(outcome.code, 0);
    const json info = json::parse(outcome.out);
    QCOMPARE(info["surfels"], json(3));
    QVERIFY(info["hash"].is_null() && info["support"].is_null());
    QVERIFY(!outcome.err.empty());
}

void InfoTest::conversionKeepsThePoints() {
    const Program program;
    program.write("grid.xyz", grid());
    for (const char* step : {"grid.xyz a.ply", "a.ply b.obj", "b.obj c.xyz", "c.xyz d.ply"})
        QCOMPARE(program.run(QStringList{"convert"} + QString(step).split(' ')).code, 0);
    QCOMPARE(program.hash("a.ply"), program.hash("grid.xyz"));
    QCOMPARE(program.hash("d.ply"), program.hash("a.ply"));
    QCOMPARE(program.run({"convert", "sample:knot:1500", "knot.ply"}).code, 0);
    QCOMPARE(program.hash("knot.ply"), program.hash("sample:knot:1500"));
}

void InfoTest::conversionsAreTold() {
    const Program program;
    program.write("grid.xyz", grid());
    const auto told = [&](const char* out, const std::string& part) {
        const Outcome outcome = program.run({"convert", "grid.xyz", out});
        QVERIFY2(outcome.err.find(part) != std::string::npos, outcome.err.c_str());
    };
    told("a.ply", "a.ply: 120 points written as Polygon file\n");
    told("a.obj", "a.obj: 120 points written as Wavefront OBJ, without faces; pointclay mesh makes them\n");
    told("a.stl", "pointclay mesh, or choose one of the extensions ply");
    told("a.doc", "cannot be written in this format");
    told("grid.xyz", "grid.xyz: 120 points written as Points as text, in the place of what was read\n");
}

void InfoTest::normalsOfFacesAreNotTheFiles() {
    const Program program;
    const std::string faces = "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
    program.write("a.obj", "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n" + faces);
    const Outcome outcome = program.run({"info", "a.obj", "--json", "--sample-count", "500"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json info = json::parse(outcome.out);
    QCOMPARE(info["normals"], json(false));
    const auto names = info["attributes"].get<std::vector<std::string>>();
    QVERIFY(names.front() == "position" && std::find(names.begin(), names.end(), "normal") == names.end());
}

void InfoTest::realScansHaveTheirCounts() {
    const QString data = QString::fromStdString(test::dataFolder());
    if (data.isEmpty())
        QSKIP("POINTCLAY_DATA names no folder with real scans");
    const Program program;
    const std::pair<const char*, int> counts[] = {
        {"kitten.xyz", 5210}, {"fandisk.obj", 6475}, {"odd/float_color.ply", 3}, {"odd/platonic_shelf_ascii.ply", 50}};
    for (const auto& [name, count] : counts) {
        const Outcome outcome = program.run({"info", data + "/" + name, "--json", "--faces", "vertices"});
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
        QCOMPARE(json::parse(outcome.out)["surfels"], json(count));
    }
    for (const char* name : {"odd/empty.ply", "odd/lfs_pointer.ply", "odd/crash_truncated_header.ply"}) {
        const Outcome outcome = program.run({"info", data + "/" + name});
        QCOMPARE(outcome.code, 1);
        QCOMPARE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), std::ptrdiff_t(1));
    }
}

static const test::Registered<InfoTest> registered;
#include "info_test.moc"
