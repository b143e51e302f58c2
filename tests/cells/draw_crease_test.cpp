// Creases that are drawn: what lies beside them stays where it is, both sides know each other, sharpness fades at the
// ends and can be taken back.
#include "core/cells/creases/draw_crease.h"

#include "cells/solids.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cells/cell_rays.h"
#include "core/cells/cell_value.h"
#include "core/cells/seams.h"
#include "support/registry.h"

#include <QTest>

using namespace plane_solids;
using base::Random;
using cells::CellSurface;
using cells::Label;
using cells::LabelLayout;
using cells::Meeting;

class DrawCreaseTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void besideALineBothSidesMeet();
    void drawingMovesADomeHardlyAtAll();
    void noSideIsPassedTwice();
    void closedLinesAreClosedSeams();
    void linesThatRunBesideACreaseAreNoneOfTheirOwn();
    void edgesBecomeSharp();
    void smoothedCreasesAreGone();
    void halfSharpIsHalfWay();
    void linesOffTheSurfaceAreRefused();
    void bitsAreThoseOfOneThread();
    void cleanup() { base::setThreadCount(0); }
};

namespace {

constexpr double spacing = 0.1;

surfel::SurfelList ball() {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    const auto count = static_cast<int>(4 * pi / (spacing * spacing));
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2.0 * i + 1) / count, r = std::sqrt(1 - z * z), angle = i * pi * (3 - std::sqrt(5.0));
        const Vec3d n{r * std::cos(angle), r * std::sin(angle), z};
        surfel::Surfel s;
        s.position = base::cast<float>(n);
        s.normal = base::cast<float>(n);
        s.support = static_cast<float>(3.5 * spacing);
        out.append(s, {});
    }
    return out;
}

/// On the unit sphere, from one angle of longitude to another along a parallel.
std::vector<Vec3d> parallelOf(double latitude, double from, double to, int count) {
    std::vector<Vec3d> out;
    for (int k = 0; k < count; ++k) {
        const double a = from + (to - from) * k / (count - 1);
        out.push_back({std::cos(latitude) * std::cos(a), std::cos(latitude) * std::sin(a), std::sin(latitude)});
    }
    return out;
}

surfel::SurfelList withoutLabels(surfel::SurfelList list) {
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    list.layout = layout;
    list.extra.clear();
    return list;
}

template <class Fn>
void forLabels(const surface::Surface& surface, const Fn& fn) {
    const auto labels = LabelLayout::of(*surface.tree().layout());
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            fn(base::cast<double>(block.position(slot)), labels ? labels->at(block, slot) : Label());
    });
}

} // namespace

void DrawCreaseTest::besideALineBothSidesMeet() {
    const std::vector<Vec3d> line = parallelOf(0.2, -0.6, 0.6, 5);
    const cells::DrawnCrease drawn = cells::drawCrease(surfaceOf(ball()), line, 1);
    QVERIFY(drawn.creased > 40 && drawn.changed == 0);
    int above = 0, below = 0;
    forLabels(drawn.surface, [&](const Vec3d& p, const Label& label) {
        const double latitude = std::asin(p.z), longitude = std::atan2(p.y, p.x);
        if (label.meeting == Meeting::None)
            return;
        QVERIFY(std::abs(latitude - 0.2) < 3 * spacing && std::abs(longitude) < 0.6 + 3 * spacing);
        // of the sides each is one cell
        if (std::abs(latitude - 0.2) > 0.25 * spacing && std::abs(longitude) < 0.5) {
            int& side = latitude > 0.2 ? above : below;
            if (side == 0)
                side = static_cast<int>(label.cell);
            QCOMPARE(static_cast<int>(label.cell), side);
            QVERIFY(label.sharpness > 200);
        }
    });
    QVERIFY(above != 0 && below != 0 && above != below);
}

void DrawCreaseTest::drawingMovesADomeHardlyAtAll() {
    const surface::Surface plain = surfaceOf(ball());
    const cells::DrawnCrease drawn = cells::drawCrease(plain, parallelOf(0, -0.6, 0.6, 9), 1);
    const CellSurface byCells = *CellSurface::of(drawn.surface);
    Random random(test::seed());
    double most = 0;
    for (int k = 0; k < test::effort(400); ++k) {
        const double a = random.uniform(-0.8, 0.8), b = random.uniform(-0.3, 0.3);
        const Vec3d p{std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)};
        most = std::max(most, std::abs(evaluate(byCells, p, surface::Need::Value).at.value -
                                       plain.evaluateReference(p, surface::Need::Value).value));
    }
    QVERIFY2(most < 0.03 * spacing, qPrintable(QString("seed %1: %2 s").arg(test::seed()).arg(most / spacing)));
}

/// Cells on both sides of a crease that is flat, or ends, have nearly the same zeros: they are one place.
void DrawCreaseTest::noSideIsPassedTwice() {
    Random random(test::seed());
    surfel::SurfelList noisy = ball();
    for (surfel::Surfel& s : noisy.items)
        s.position += s.normal * static_cast<float>(0.05 * spacing * random.uniform(-1, 1));
    const cells::DrawnCrease drawn = cells::drawCrease(surfaceOf(noisy), parallelOf(0.2, 0, 1.2, 25), 1);
    const CellSurface surface = *CellSurface::of(drawn.surface);
    std::size_t twice = 0;
    for (int k = 0; k < 1500; ++k) {
        const double a = random.uniform(-0.3, 1.5), b = 0.2 + random.uniform(-0.2, 0.2);
        const Vec3d p{std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)};
        const base::Rayd ray = towards(p, random.unitVector(), 5);
        double side = -1;
        for (const auto& hit : cells::intersectAllReference(surface, ray)) {
            twice += dot(hit.outward, ray.direction) * side < 0 ? 1 : 0;
            side = -side;
        }
    }
    QVERIFY2(twice == 0, qPrintable(QString("%1, seed %2").arg(twice).arg(test::seed())));
}

void DrawCreaseTest::closedLinesAreClosedSeams() {
    const cells::DrawnCrease drawn = cells::drawCrease(surfaceOf(ball()), parallelOf(0.7, 0, 2 * pi, 40), 1);
    int above = 0, below = 0;
    forLabels(drawn.surface, [&](const Vec3d& p, const Label& label) {
        if (label.meeting == Meeting::None)
            return;
        const double latitude = std::asin(p.z);
        QVERIFY(std::abs(latitude - 0.7) < 3 * spacing && label.sharpness > 200);
        if (std::abs(latitude - 0.7) > 0.25 * spacing) {
            int& side = latitude > 0.7 ? above : below;
            if (side == 0)
                side = static_cast<int>(label.cell);
            QCOMPARE(static_cast<int>(label.cell), side);
        }
    });
    QVERIFY(above != below);
    const std::vector<cells::Seam> seams = traceSeams(*CellSurface::of(drawn.surface));
    const double length = 2 * pi * std::cos(0.7);
    QCOMPARE(seams.size(), std::size_t(1));
    QVERIFY2(seams[0].closed && std::abs(seams[0].length() - length) < 0.05 * length,
             qPrintable(QString::number(seams[0].length())));
}

/// A spacing and a half apart both would share the surfels between them, which have one partner each.
void DrawCreaseTest::linesThatRunBesideACreaseAreNoneOfTheirOwn() {
    const cells::DrawnCrease first = cells::drawCrease(surfaceOf(ball()), parallelOf(0.2, -0.6, 0.6, 5), 1);
    for (const double beside : {-1.4, 1.4}) {
        const auto line = parallelOf(0.2 + beside * spacing, -0.5, 0.5, 5);
        QCOMPARE(cells::drawCrease(first.surface, line, 1).creased, std::size_t(0));
    }
    QVERIFY(cells::drawCrease(first.surface, parallelOf(0.2 + 6 * spacing, -0.5, 0.5, 5), 1).creased > 40);
    std::vector<Vec3d> across;
    for (double latitude = -0.3; latitude < 0.75; latitude += 0.1)
        across.push_back({std::cos(latitude), 0, std::sin(latitude)});
    QVERIFY(cells::drawCrease(first.surface, across, 1).creased > 20);
}

void DrawCreaseTest::edgesBecomeSharp() {
    Random random(test::seed());
    const SampledSolid s = sampled(cube(0.7), 2.4, spacing, random);
    const std::vector<Vec3d> line{{0.7, -0.4, 0.7}, {0.7, 0.4, 0.7}};
    const cells::DrawnCrease drawn = cells::drawCrease(surfaceOf(withoutLabels(s.surfels)), line, 1);
    const std::vector<cells::Seam> seams = traceSeams(*CellSurface::of(drawn.surface));
    QVERIFY(seams.size() >= 1);
    double length = 0;
    for (const cells::Seam& seam : seams) {
        length += seam.length();
        for (const Vec3d& p : seam.points)
            if (std::abs(p.y) < 0.2)
                QVERIFY(std::abs(p.x - 0.7) < 0.05 * spacing && std::abs(p.z - 0.7) < 0.05 * spacing);
    }
    // it fades over four spacings at either end
    QVERIFY2(length > 0.7 && length < 0.8 + 8 * spacing, qPrintable(QString::number(length)));
}

void DrawCreaseTest::smoothedCreasesAreGone() {
    const surface::Surface plain = surfaceOf(ball());
    const std::vector<Vec3d> line = parallelOf(0.2, -0.6, 0.6, 5);
    const cells::DrawnCrease drawn = cells::drawCrease(plain, line, 1);
    QVERIFY(drawn.surface.tree().layout()->find("cell"));
    // a bit beyond its ends
    const cells::DrawnCrease smooth = cells::drawCrease(drawn.surface, parallelOf(0.2, -0.8, 0.8, 5), 0);
    QVERIFY(smooth.changed > 40);
    QVERIFY(smooth.surface.tree().contentHash() == plain.tree().contentHash());
    // and where there is nothing, nothing happens
    QVERIFY(cells::drawCrease(plain, line, 0).surface.tree() == plain.tree());
}

void DrawCreaseTest::halfSharpIsHalfWay() {
    const std::vector<Vec3d> line = parallelOf(0.2, -0.6, 0.6, 5);
    const cells::DrawnCrease drawn = cells::drawCrease(surfaceOf(ball()), line, 1);
    const cells::DrawnCrease half = cells::drawCrease(drawn.surface, line, 0.5);
    QVERIFY(half.creased == 0 && half.changed > 20);
    forLabels(half.surface, [&](const Vec3d& p, const Label& label) {
        if (label.meeting != Meeting::None && std::abs(std::atan2(p.y, p.x)) < 0.4)
            QCOMPARE(static_cast<int>(label.sharpness), 128);
    });
}

void DrawCreaseTest::linesOffTheSurfaceAreRefused() {
    const surface::Surface plain = surfaceOf(ball());
    for (const std::vector<Vec3d>& line :
         {std::vector<Vec3d>{{3, 0, 0}, {1, 0, 0}}, {{1, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {-1, 0, 0}}, {}})
        QVERIFY_THROWS_EXCEPTION(base::Error, static_cast<void>(cells::drawCrease(plain, line, 1)));
}

void DrawCreaseTest::bitsAreThoseOfOneThread() {
    const surface::Surface plain = surfaceOf(ball());
    const std::vector<Vec3d> line = parallelOf(0.2, -0.6, 0.6, 5);
    const base::Hash128 many = cells::drawCrease(plain, line, 0.7).surface.tree().contentHash();
    base::setThreadCount(1);
    QVERIFY(cells::drawCrease(plain, line, 0.7).surface.tree().contentHash() == many);
}

static const test::Registered<DrawCreaseTest> registered;
#include "draw_crease_test.moc"
