// Seams as curves: of solids of planes each edge is one, as long as it is, on both planes; corners are where they end.
#include "core/cells/seams.h"

#include "cells/solids.h"
#include "core/cells/creases/draw_crease.h"
#include "support/registry.h"

#include <algorithm>
#include <QTest>

using namespace plane_solids;
using base::Random;
using cells::Seam;

class SeamsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyEdgeIsASeam_data();
    void everyEdgeIsASeam();
    void circlesAreClosed();
    void withoutCreasesThereAreNone();
    void edgesAreOneWhateverIsDrawnOverThem_data();
    void edgesAreOneWhateverIsDrawnOverThem();
};

namespace {

double lengthOf(const std::vector<Seam>& seams) {
    double out = 0;
    for (const Seam& seam : seams)
        out += seam.length();
    return out;
}

/// Two unit balls at distance 1, what is in either.
surfel::SurfelList twoBalls(double spacing, std::vector<cells::CreasePiece>& pieces) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    std::vector<std::uint32_t> cell;
    const auto count = static_cast<int>(4 * pi / (spacing * spacing));
    for (const double side : {-1.0, 1.0})
        for (int i = 0; i < count; ++i) {
            const double z = 1 - (2.0 * i + 1) / count, r = std::sqrt(1 - z * z);
            const double angle = i * pi * (3 - std::sqrt(5.0));
            const Vec3d n{r * std::cos(angle), r * std::sin(angle), z};
            if (side * n.x < -0.5)
                continue;
            surfel::Surfel s;
            s.position = base::cast<float>(n + Vec3d{side / 2, 0, 0});
            s.normal = base::cast<float>(n);
            s.support = static_cast<float>(3.5 * spacing);
            out.append(s, {});
            cell.push_back(side < 0 ? 0 : 1);
        }
    const double r = std::sqrt(0.75);
    for (int k = 0; k < 200; ++k) {
        const auto at = [&](int i) { return Vec3d{0, r * std::cos(i * pi / 100), r * std::sin(i * pi / 100)}; };
        pieces.push_back({at(k), at(k + 1), 0, 1, cells::Meeting::Concave});
    }
    cells::setLabels(out, cells::labelsByCreases(out.items, cell, pieces, spacing));
    return out;
}

} // namespace

void SeamsTest::everyEdgeIsASeam_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("seams");
    QTest::addColumn<int>("corners");
    QTest::addColumn<double>("length");
    QTest::newRow("cube") << 0 << 12 << 8 << 12 * 1.4;
    QTest::newRow("L-block") << 1 << 18 << 12 << 0.8 * (2 * 8 + 6);
    QTest::newRow("octant") << 2 << 6 << 4 << 3 + 1.5 * pi;
}

void SeamsTest::everyEdgeIsASeam() {
    QFETCH(int, kind);
    QFETCH(int, seams);
    QFETCH(int, corners);
    QFETCH(double, length);
    Random random(test::seed());
    const double spacing = kind == 2 ? 0.05 : 0.1;
    const Solid solid = kind == 0 ? cube(0.7) : lBlock(0.8);
    const cells::CellSurface surface =
        cellsOf(kind == 2 ? octant(spacing, random) : sampled(solid, 2.4, spacing, random).surfels);
    const std::vector<Seam> found = traceSeams(surface);
    QCOMPARE(static_cast<int>(found.size()), seams);
    QCOMPARE(static_cast<int>(cornersOf(found).size()), corners);
    QVERIFY2(std::abs(lengthOf(found) - length) < 0.01 * length, qPrintable(QString::number(lengthOf(found))));
    if (kind < 2)
        for (const Seam& seam : found)
            for (const Vec3d& p : seam.points)
                QVERIFY(std::abs(solid.planes[seam.a].f(p)) < 1e-6 && std::abs(solid.planes[seam.b].f(p)) < 1e-6);
}

void SeamsTest::circlesAreClosed() {
    std::vector<cells::CreasePiece> pieces;
    const std::vector<Seam> found = traceSeams(cellsOf(twoBalls(0.1, pieces)));
    QCOMPARE(found.size(), std::size_t(1));
    QVERIFY(found[0].closed && found[0].points.front() == found[0].points.back());
    const double r = std::sqrt(0.75);
    QVERIFY2(std::abs(found[0].length() - 2 * pi * r) < 0.01 * 2 * pi * r,
             qPrintable(QString::number(found[0].length())));
    for (const Vec3d& p : found[0].points)
        QVERIFY(std::abs(p.x) < 0.01 && std::abs(std::hypot(p.y, p.z) - r) < 0.01);
    QVERIFY(cornersOf(found).empty());
}

void SeamsTest::withoutCreasesThereAreNone() {
    Random random(test::seed());
    const SampledSolid s = sampled(intersection({{{0, 0, 1}, 0.3}}), 1, 0.1, random);
    QVERIFY(traceSeams(cellsOf(s.surfels)).empty());
}

namespace {

std::vector<Vec3d> between(const Vec3d& a, const Vec3d& b) {
    std::vector<Vec3d> out;
    for (int k = 0; k <= 8; ++k)
        out.push_back(a + (b - a) * (k / 8.0));
    return out;
}

/// Of the seams of a cube what lies on its edges.
double lengthOnEdges(const std::vector<Seam>& seams, double half, double near) {
    const auto isOnEdge = [&](const Vec3d& p) {
        int planes = 0;
        for (const double x : {p.x, p.y, p.z})
            planes += std::abs(std::abs(x) - half) < near ? 1 : 0;
        return planes >= 2;
    };
    double out = 0;
    for (const Seam& seam : seams)
        for (std::size_t k = 0; k + 1 < seam.points.size(); ++k)
            if (isOnEdge(seam.points[k]) && isOnEdge(seam.points[k + 1]))
                out += base::distance(seam.points[k], seam.points[k + 1]);
    return out;
}

/// Ends where no other seam ends.
int loneEnds(const std::vector<Seam>& seams, double reach) {
    std::vector<Vec3d> ends;
    for (const Seam& seam : seams)
        if (!seam.closed)
            ends.insert(ends.end(), {seam.points.front(), seam.points.back()});
    int out = 0;
    for (const Vec3d& p : ends)
        out += std::count_if(ends.begin(), ends.end(), [&](const Vec3d& q) { return base::distance(p, q) < reach; }) < 2
                   ? 1
                   : 0;
    return out;
}

} // namespace

void SeamsTest::edgesAreOneWhateverIsDrawnOverThem_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("lines");
    QTest::newRow("over an edge") << 0 << 1;
    QTest::newRow("up to an edge") << 1 << 1;
    QTest::newRow("beside an edge") << 2 << 1;
    QTest::newRow("over each other") << 3 << 2;
}

/// Cells that end within a face, bands and their rest, both sides of a line where it has no angle, have the same zeros
/// around their ends: an edge that they share was told twice there.
void SeamsTest::edgesAreOneWhateverIsDrawnOverThem() {
    QFETCH(int, kind);
    QFETCH(int, lines);
    Random random(test::seed());
    constexpr double half = 0.9, spacing = 0.07;
    surface::Surface surface = surfaceOf(sampled(cube(half), 1.7, spacing, random).surfels);
    const double slant = random.uniform(-0.4, 0.4), at = random.uniform(-0.2, 0.2), reach = 0.5;
    const Vec3d onEdge{half, half, at}, down{half, half - reach, at + slant * reach};
    std::vector<std::vector<Vec3d>> drawn;
    if (kind == 0) {
        drawn = {between(down, onEdge)};
        for (const Vec3d& p : between(onEdge, {half - reach, half, at - slant * reach}))
            drawn[0].push_back(p);
    } else if (kind == 1) {
        drawn = {between(down, onEdge)};
    } else if (kind == 2) {
        const double y = half - random.uniform(2.7, 5) * spacing;
        drawn = {between({half, y, -0.4}, {half, y, 0.4})};
    } else {
        drawn = {between({half, -0.45, -slant}, {half, 0.45, slant}), between({half, at, -0.45}, {half, -at, 0.45})};
    }
    for (const std::vector<Vec3d>& line : drawn)
        surface = cells::drawCrease(surface, line, 1).surface;
    const std::vector<Seam> found = traceSeams(*cells::CellSurface::of(surface));
    const double onEdges = lengthOnEdges(found, half, 0.01 * spacing), whole = 24 * half;
    QVERIFY2(std::abs(onEdges - whole) < 0.02 * whole,
             qPrintable(QString("%1 of %2 on edges, seed %3").arg(onEdges).arg(whole).arg(test::seed())));
    const int lone = loneEnds(found, spacing);
    // a line has two of its own, and where it crosses at a slant it may fade before the edge; there were ten
    QVERIFY2(lone <= 2 * lines + 2, qPrintable(QString("%1 lone ends, seed %2").arg(lone).arg(test::seed())));
}

static const test::Registered<SeamsTest> registered;
#include "seams_test.moc"
