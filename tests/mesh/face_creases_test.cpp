// Labels of samples from the sharp edges of meshes.
#include "core/mesh/faces/face_creases.h"

#include "core/cells/cell_rays.h"
#include "core/mesh/faces/face_spacing.h"
#include "core/mesh/faces/open_faces.h"
#include "mesh/creased_faces.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>
#include <set>

using namespace faces;
using cells::Label;
using cells::LabelLayout;
using cells::Meeting;

class FaceCreasesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void boxesHaveSixCellsAndTwelveCreases();
    void withoutCreasesNothingIsAdded();
    void samplesStayWhereTheyAre();
    void smoothMeshesHaveNone();
    void ofBentPairsTheSignIsThatOfTheNormals();
    void smallPatchesJoinTheirFlattestNeighbour();
    void narrowChamfersAreNoCells();
    void sidesOfThinPlatesAreCells();
    void narrowSidesHaveRowsOfTheirOwn();
    void creasesThatEndFadeBetweenTwoBands();
    void openBoxesAreHitAtTheirEdges();
    void finePartsAreSampledForTheirEdges();
};

namespace {

/// A prism from y = 0 to 1 over a convex outline.
Faces extruded(const std::vector<Vec3f>& outline) {
    Faces out;
    for (const float y : {0.0f, 1.0f})
        for (const Vec3f& p : outline)
            out.positions.push_back({p.x, y, p.z});
    const auto n = static_cast<std::uint32_t>(outline.size());
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t next = (i + 1) % n;
        out.triangles.push_back({i, next, next + n});
        out.triangles.push_back({i, next + n, i + n});
    }
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
        out.triangles.push_back({0, i + 1, i});
        out.triangles.push_back({n, n + i, n + i + 1});
    }
    return out;
}

} // namespace

void FaceCreasesTest::boxesHaveSixCellsAndTwelveCreases() {
    const mesh::OpenedFaces open = openedFaces(box({1, 2, 3}), 4000);
    const cells::CellCounts counts = cells::countCells(open.points);
    QCOMPARE(counts.cells, std::size_t(6));
    QCOMPARE(counts.pairs, std::size_t(12));
    QCOMPARE(counts.concave, std::size_t(0));
    QVERIFY(!open.points.layout->find("sharpness"));
}

void FaceCreasesTest::withoutCreasesNothingIsAdded() {
    const mesh::OpenedFaces open = openedFaces(box({1, 2, 3}), 2000, false);
    QVERIFY(!open.points.layout->find("cell") && !open.points.layout->find("partner"));
    QVERIFY(labelsOf(open.points).empty());
}

void FaceCreasesTest::samplesStayWhereTheyAre() {
    const mesh::OpenedFaces with = openedFaces(box({1, 2, 3}), 2000),
                            without = openedFaces(box({1, 2, 3}), 2000, false);
    QVERIFY(with.points.items == without.points.items);
}

void FaceCreasesTest::smoothMeshesHaveNone() {
    const mesh::OpenedFaces open = openedFaces(band(60, 30, false), 4000);
    QVERIFY(labelsOf(open.points).empty());
}

void FaceCreasesTest::ofBentPairsTheSignIsThatOfTheNormals() {
    for (const double up : {1.0, -1.0}) {
        const mesh::OpenedFaces open =
            openedFaces(sheet(8, [up](double, double y) { return -up * std::abs(y); }), 2000);
        int beside = 0;
        for (const Label& label : labelsOf(open.points)) {
            beside += label.meeting != Meeting::None ? 1 : 0;
            QVERIFY(label.meeting == Meeting::None || label.meeting == (up > 0 ? Meeting::Convex : Meeting::Concave));
        }
        QVERIFY(beside > 50);
        QCOMPARE(cells::countCells(open.points).cells, std::size_t(2));
    }
}

void FaceCreasesTest::smallPatchesJoinTheirFlattestNeighbour() {
    // a box with one edge cut off, so narrowly that hardly a sample lies there
    constexpr float e = 0.0005f;
    const Faces f = extruded({{0, 0, 0}, {1, 0, 0}, {1, 0, 1 - 2 * e}, {1 - e, 0, 1}, {0, 0, 1}});
    QCOMPARE(f.topology(20 * std::numbers::pi / 180).patchCount, std::size_t(7));
    const mesh::OpenedFaces open = openedFaces(f, 1500, true, 20 * std::numbers::pi / 180);
    QCOMPARE(cells::countCells(open.points).cells, std::size_t(6));
}

/// Rows of single samples with gaps longer than the reach of a surfel: as cells they were torn. Wider strips are exact.
void FaceCreasesTest::narrowChamfersAreNoCells() {
    constexpr std::size_t count = 6000;
    constexpr float spacing = 0.0316f;
    for (const float width : {0.1f, 0.25f, 0.5f, 0.75f, 1.5f}) {
        const float e = width * spacing * 0.7071f;
        const Faces f = extruded({{0, 0, 0}, {1, 0, 0}, {1, 0, 1 - e}, {1 - e, 0, 1}, {0, 0, 1}});
        const mesh::OpenedFaces open = openedFaces(f, count);
        QCOMPARE(cells::countCells(open.points).cells, std::size_t(width < 0.4f ? 6 : 7));
        surface::SurfaceDefinition definition;
        definition.oneSheet = false;
        const auto surface = cells::CellSurface::of({tree::SurfelTree::build(open.points), definition});
        QVERIFY(surface);
        base::Random random(test::seed());
        for (int i = 0; i < test::effort(200); ++i) {
            const Vec3d at{1 - double(e) / 2, random.uniform(0.1, 0.9), 1 - double(e) / 2};
            const Vec3d way = base::normalized(Vec3d{-1, 0, -1} + random.unitVector() * 0.6);
            const cells::CellHit hit = intersectCells(*surface, {at - way, way});
            const QString where("seed %1, width %2: %3 spacings off");
            const Vec3d p = hit.hit.position;
            const double off = std::max({p.x - 1, p.z - 1, (p.x + p.z - 2 + double(e)) / std::numbers::sqrt2});
            QVERIFY2(hit.hit.hit && std::abs(off) < (width < 0.4f ? 0.3 : 1e-4) * double(spacing),
                     where.arg(test::seed()).arg(double(width)).arg(off / double(spacing)).toUtf8());
        }
    }
}

/// They turn by as much, but to two sides: as one with either the plate would end in a slope.
void FaceCreasesTest::sidesOfThinPlatesAreCells() {
    const mesh::OpenedFaces open = openedFaces(box({1, 1, 0.012f}), 6000); // of 0.65 spacings
    QCOMPARE(cells::countCells(open.points).cells, std::size_t(6));
}

/// Samples on the plate's large sides do not push those of its rim away.
void FaceCreasesTest::narrowSidesHaveRowsOfTheirOwn() {
    constexpr std::size_t count = 6000;
    const double spacing = std::sqrt(2.0 / count);
    for (const auto& [width, longest] : {std::pair(0.25, 6.0), std::pair(0.5, 3.0), std::pair(0.75, 2.5)}) {
        const mesh::OpenedFaces open = openedFaces(box({1, 1, static_cast<float>(width * spacing)}), count);
        std::vector<double> along[4];
        for (const surfel::Surfel& s : open.points.items) {
            if (std::abs(s.normal.x) > 0.9f)
                along[s.normal.x > 0].push_back(static_cast<double>(s.position.y));
            if (std::abs(s.normal.y) > 0.9f)
                along[s.normal.y > 0 ? 3 : 2].push_back(static_cast<double>(s.position.x));
        }
        for (std::vector<double>& side : along) {
            side.insert(side.end(), {0, 1});
            std::sort(side.begin(), side.end());
            double gap = 0;
            for (std::size_t i = 1; i < side.size(); ++i)
                gap = std::max(gap, side[i] - side[i - 1]);
            QVERIFY2(gap < longest * spacing, qPrintable(QString("%1: %2").arg(width).arg(gap / spacing)));
        }
    }
}

/// A ridge that flattens out half-way: sharp at its beginning, and nothing of it is left at the other side.
void FaceCreasesTest::creasesThatEndFadeBetweenTwoBands() {
    const auto height = [](double x, double y) {
        const double rise = std::max(0.0, -x);
        return -1.2 * rise * std::abs(y) * std::exp(-4 * y * y);
    };
    const Faces f = sheet(40, height);
    QCOMPARE(f.topology().patchCount, std::size_t(1));
    const mesh::OpenedFaces open = openedFaces(f, 12000);
    const std::vector<Label> labels = labelsOf(open.points);
    QVERIFY(!labels.empty());
    std::set<std::uint32_t> cells;
    for (const Label& label : labels) {
        cells.insert(label.cell);
        QCOMPARE(label.face, 0u);
    }
    QCOMPARE(cells.size(), std::size_t(3));
    int sharpOnes = 0, faint = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Vec3f p = open.points.items[i].position;
        if (labels[i].meeting == Meeting::None)
            continue;
        QCOMPARE(labels[i].meeting, Meeting::Convex);
        if (p.x < -0.7f) {
            QVERIFY(labels[i].sharpness > 200);
            QVERIFY(labels[i].cell != 0 && labels[i].partner != 0 && labels[i].cell != labels[i].partner);
            ++sharpOnes;
        }
        if (p.x > -0.2f) { // the edge is flatter than 40 degrees from -0.3 on
            QVERIFY(labels[i].sharpness < 40);
            ++faint;
        }
    }
    QVERIFY(sharpOnes > 40);
    QVERIFY(faint > 0);

    // rays from above meet the ridge, and f has no step where it ends
    surface::SurfaceDefinition definition;
    definition.oneSheet = false;
    const auto surface = cells::CellSurface::of({tree::SurfelTree::build(open.points), definition});
    QVERIFY(surface);
    const double spacing = std::sqrt(4.3 / 12000);
    double worst = 0, before = 0;
    for (double x = -0.8; x < 0.6; x += 0.02) {
        const cells::CellHit hit = intersectCells(*surface, {{x, 0.001, 2}, {0, 0, -1}});
        QVERIFY2(hit.hit.hit, QByteArray::number(x));
        const double off = std::abs(hit.hit.position.z - height(x, 0.001)) / spacing;
        if (x < -0.65 || x > 0.1)
            QVERIFY2(off < 0.05, QByteArray::number(x) + " off " + QByteArray::number(off));
        if (x > -0.79)
            worst = std::max(worst, std::abs(hit.hit.position.z - before) / spacing);
        before = hit.hit.position.z;
    }
    QVERIFY2(worst < 0.2, QByteArray::number(worst));
}

void FaceCreasesTest::openBoxesAreHitAtTheirEdges() {
    const Faces f = box({1, 2, 3});
    const mesh::OpenedFaces open = openedFaces(f, 6000);
    surface::SurfaceDefinition definition;
    definition.oneSheet = false;
    const auto surface = cells::CellSurface::of({tree::SurfelTree::build(open.points), definition});
    QVERIFY(surface);
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(300); ++k) {
        const Vec3d target{1, random.uniform(0.1, 1.9), 3}; // on an edge, and a little beside it
        const Vec3d direction =
            -base::normalized(Vec3d{random.uniform(0.1, 1), random.uniform(-0.3, 0.3), random.uniform(0.1, 1)});
        const Vec3d aside{-random.uniform(0.0, 0.02), 0, -random.uniform(0.001, 0.02)};
        const cells::CellHit hit = intersectCells(*surface, {target + aside - direction * 2, direction});
        QVERIFY(hit.hit.hit);
        const Vec3d p = hit.hit.position;
        QVERIFY(std::min(std::abs(p.x - 1), std::abs(p.z - 3)) < 1e-9);
        QVERIFY(p.x < 1 + 1e-9 && p.z < 3 + 1e-9);
    }
}

/// A cube of so many triangles that its vertices would do; without creases they stay.
void FaceCreasesTest::finePartsAreSampledForTheirEdges() {
    if (test::sanitized)
        QSKIP("half a minute under a sanitizer");
    const int n = test::sanitized ? 90 : 110;
    Faces cube;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const float side : {0.0f, 1.0f}) {
            const auto first = static_cast<std::uint32_t>(cube.positions.size());
            for (int i = 0; i <= n; ++i)
                for (int k = 0; k <= n; ++k) {
                    base::Vec3f p;
                    p[axis] = side;
                    p[(axis + 1) % 3] = static_cast<float>(i) / static_cast<float>(n);
                    p[(axis + 2) % 3] = static_cast<float>(k) / static_cast<float>(n);
                    cube.positions.push_back(p);
                }
            const auto at = [&](int i, int k) { return first + static_cast<std::uint32_t>(i * (n + 1) + k); };
            for (int i = 0; i < n; ++i)
                for (int k = 0; k < n; ++k) {
                    const mesh::Triangle a{at(i, k), at(i + 1, k), at(i + 1, k + 1)};
                    const mesh::Triangle b{at(i, k), at(i + 1, k + 1), at(i, k + 1)};
                    for (const mesh::Triangle& t : {a, b})
                        cube.triangles.push_back(side > 0 ? t : mesh::Triangle{t[0], t[2], t[1]});
                }
        }
    QVERIFY(sampleWell(cube.topology(), cube.positions));
    const mesh::OpenedFaces open = mesh::openFaces(cube.list(), cube.triangles, {}, {});
    QVERIFY(open.sampled);
    QCOMPARE(cells::countCells(open.points).cells, std::size_t(6));
    QVERIFY(!mesh::openFaces(cube.list(), cube.triangles, {}, {.creases = false}).sampled);
    QVERIFY(!mesh::openFaces(cube.list(), cube.triangles, {}, {.sharpRad = 2}).sampled);
}

static const test::Registered<FaceCreasesTest> registered;
#include "face_creases_test.moc"
