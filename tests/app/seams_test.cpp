// pointclay seams, and complexes on the command line.
#include "program.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <cmath>
#include <QImage>
#include <QTest>
#include <set>

using test::Outcome;
using test::Program;
using test::rowsOf;

class SeamsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aBoxHasTwelve();
    void anOctantHasThoseOfItsComplex();
    void smoothModelsHaveNone();
    void complexesAreQueriedAndMeshed();
    void picturesOfComplexesAgree();
};

/// A box of 2 by 1 by 1.5.
static const char* const box = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 1.5\nv 2 0 1.5\nv 2 1 1.5\nv 0 1 1.5\n"
                               "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

void SeamsTest::aBoxHasTwelve() {
    const Program program;
    program.write("box.obj", box);
    const Outcome outcome = program.run({"seams", "box.obj", "--sample-count", "5000", "-o", "seams.csv"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const auto rows = rowsOf(program.read("seams.csv"));
    QCOMPARE(rows.at(0),
             (std::vector<std::string>{"seam", "closed", "x", "y", "z", "nx", "ny", "nz", "turn", "a", "b"}));
    double most = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto at = [&](std::size_t k) { return std::stod(rows[i].at(k)); };
        const double x = std::min(std::abs(at(2)), std::abs(at(2) - 2)),
                     y = std::min(std::abs(at(3)), std::abs(at(3) - 1)),
                     z = std::min(std::abs(at(4)), std::abs(at(4) - 1.5));
        const int on = (x < 1e-4 ? 1 : 0) + (y < 1e-4 ? 1 : 0) + (z < 1e-4 ? 1 : 0);
        QVERIFY(on >= 2);
        QVERIFY2(std::abs(at(8) - 90) < 0.5, rows[i].at(8).c_str());
        most = std::max(most, at(0));
    }
    QCOMPARE(most, 11.0);
    std::set<std::vector<std::string>> corners; // as written: lines share them to the last digit
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const bool first = i == 1 || rows[i - 1][0] != rows[i][0];
        if (first || i + 1 == rows.size() || rows[i + 1][0] != rows[i][0])
            corners.insert({rows[i][2], rows[i][3], rows[i][4]});
    }
    QCOMPARE(corners.size(), std::size_t(8));
    QVERIFY2(outcome.out.find("all: length 1") != std::string::npos, outcome.out.c_str()); // 18, or just below
}

void SeamsTest::anOctantHasThoseOfItsComplex() {
    const Program program;
    const Outcome outcome = program.run({"seams", "sample:octant:3000", "-o", "seams.obj"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY(outcome.out.find("seam 5") != std::string::npos && outcome.out.find("seam 6") == std::string::npos);
    QVERIFY(!program.read("seams.obj").empty());
}

void SeamsTest::smoothModelsHaveNone() {
    const Program program;
    const Outcome outcome = program.run({"seams", "sample:sphere:2000"});
    QCOMPARE(outcome.code, 0);
    QVERIFY(outcome.out.find("no seams") != std::string::npos);
    QCOMPARE(program.run({"seams", "sample:octant", "--turn", "0.1"}).code, 2); // their steps are not asked for
}

void SeamsTest::complexesAreQueriedAndMeshed() {
    const Program program;
    program.write("at.xyz", "0.5 0.25 0.1\n1.3 0 0\n1.2 1.4 0.2\n");
    QCOMPARE(program.run({"convert", "sample:square:900", "square.ply"}).code, 0);
    const Outcome asked =
        program.run({"query", "square.ply", "--at", "at.xyz", "--what", "project-almost,feature", "-o", "out.csv"});
    QVERIFY2(asked.code == 0, asked.err.c_str());
    const auto rows = rowsOf(program.read("out.csv"));
    const char* const features[] = {"face", "seam", "corner"};
    const double feet[3][3] = {{0.5, 0.25, 0}, {1, 0, 0}, {1, 1, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
        QCOMPARE(rows.at(i + 1).back(), std::string(features[i]));
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY(std::abs(std::stod(rows.at(i + 1).at(4 + k)) - feet[i][k]) < 1e-8);
    }
    program.write("rays.csv", "ox,oy,oz,dx,dy,dz\n0.99,0.2,3,0,0,-1\n1.01,0.2,3,0,0,-1\n");
    QCOMPARE(program.run({"intersect", "square.ply", "--rays", "rays.csv", "-o", "hits.csv"}).code, 0);
    const auto hits = rowsOf(program.read("hits.csv"));
    QVERIFY(hits.at(1).at(0) == "1" && hits.at(2).at(0) == "0");
    const Outcome meshed = program.run({"mesh", "sample:octant:1500", "-o", "octant.stl", "--check"});
    QVERIFY2(meshed.code == 0, meshed.err.c_str());
    QVERIFY(meshed.out.find("boundary loops            0") != std::string::npos);
    QCOMPARE(program.run({"mesh", "sample:octant:1500", "-o", "octant.stl", "--method", "delaunay"}).code, 1);
    const Outcome refused = program.run({"measure", "square.ply", "area"});
    QVERIFY2(refused.code == 1 && refused.err.find("complex") != std::string::npos, refused.err.c_str());
    const Outcome cut = program.run({"section", "square.ply", "--plane", "1,0,0,0.25", "-o", "cut.csv"});
    QVERIFY2(cut.code == 0, cut.err.c_str());
    QVERIFY2(cut.out.find("curve 0: length 2, ") != std::string::npos, cut.out.c_str());
    const Outcome rims = program.run({"boundary", "square.ply", "-o", "rims.csv"});
    QVERIFY2(rims.code == 0, rims.err.c_str());
    QVERIFY2(rims.out.find("boundary curve 0: length 8, ") == 0 && rims.out.find("closed") != std::string::npos,
             rims.out.c_str());
    QCOMPARE(rowsOf(program.read("rims.csv")).at(1).at(1), std::string("1"));
}

void SeamsTest::picturesOfComplexesAgree() {
    if (test::sanitized)
        QSKIP("seconds under a sanitizer");
    const Program program;
    const auto pixelsOf = [&](const QStringList& how) {
        const Outcome outcome =
            program.run(QStringList{"render", "sample:octant:2000", "-o", "a.png", "--size", "160x120"} + how);
        return outcome.code == 0 ? QImage(QString::fromStdString(program.path("a.png"))) : QImage();
    };
    const QImage splats = pixelsOf({"--transparent"}), rays = pixelsOf({"--transparent", "--mode", "raycast"}),
                 lines = pixelsOf({"--transparent", "--seams"});
    QVERIFY(!splats.isNull() && !rays.isNull() && !lines.isNull());
    QVERIFY(lines != splats);
    int apart = 0, there = 0;
    for (int y = 1; y + 1 < rays.height(); ++y)
        for (int x = 1; x + 1 < rays.width(); ++x) {
            const bool hit = qAlpha(rays.pixel(x, y)) > 0;
            bool edge = false;
            for (int d = -1; d <= 1; ++d)
                edge = edge || (qAlpha(rays.pixel(x + d, y)) > 0) != hit || (qAlpha(rays.pixel(x, y + d)) > 0) != hit;
            there += hit ? 1 : 0;
            apart += !edge && (qAlpha(splats.pixel(x, y)) > 127) != hit ? 1 : 0;
        }
    QVERIFY(there > 2000);
    QVERIFY2(apart * 500 < there, qPrintable(QString("%1 of %2").arg(apart).arg(there)));
}

static const test::Registered<SeamsTest> registered;
#include "seams_test.moc"
