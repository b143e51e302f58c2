// Values and feet of models with cells: nearest points of boxes, on faces, seams and corners; idempotent; exact
// gradients.
#include "core/cells/cell_projection.h"

#include "cells/solids.h"
#include "support/registry.h"

#include <QTest>

using namespace plane_solids;
using base::Random;
using cells::CellFoot;
using cells::CellSurface;
using cells::Feature;

class CellProjectionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void feetOnCubesAreTheNearestPoints();
    void feetOnSolidsLieOnThemAndStay_data();
    void feetOnSolidsLieOnThemAndStay();
    void featuresAreWhatTheyAre();
    void valuesAreTheBooleanOfThePlanes();
    void gradientsAreThoseOfTheValues();
    void awayFromCreasesBitsStay();
    void everyProjectorLandsOnTheSurface();
    void anyLabelsAreAnsweredSomehow();
};

namespace {

/// The nearest point of the cube's surface to x.
Vec3d nearestOnCube(const Vec3d& x) {
    Vec3d out{std::clamp(x.x, -1.0, 1.0), std::clamp(x.y, -1.0, 1.0), std::clamp(x.z, -1.0, 1.0)};
    if (out != x)
        return out;
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(x[k]) > std::abs(x[axis]))
            axis = k;
    out[axis] = x[axis] > 0 ? 1 : -1;
    return out;
}

/// Beside an edge or a face of the solid.
Vec3d beside(const SampledSolid& s, Random& random, double distance) {
    const surfel::Surfel& at = s.surfels.items[random.below(s.surfels.size())];
    return base::cast<double>(at.position) + random.unitVector() * (distance * random.uniform());
}

} // namespace

void CellProjectionTest::feetOnCubesAreTheNearestPoints() {
    Random random(test::seed());
    const SampledSolid s = sampled(cube(1), 2, 0.08, random);
    const CellSurface surface = cellsOf(s.surfels);
    for (int k = 0; k < test::effort(400); ++k) {
        const Vec3d x = beside(s, random, k % 2 == 0 ? 0.2 : 0.6);
        const CellFoot foot = project(surface, x);
        QVERIFY2(foot.projection.ok(), QByteArray::number(k));
        const Vec3d nearest = nearestOnCube(x);
        const double off = std::abs(base::distance(foot.projection.foot, x) - base::distance(nearest, x));
        QVERIFY2(off < 1e-9, QByteArray::number(off) + " at " + QByteArray::number(k));
    }
}

void CellProjectionTest::feetOnSolidsLieOnThemAndStay_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("cube") << 0;
    QTest::newRow("L-block") << 1;
    QTest::newRow("pyramid of 4") << 4;
    QTest::newRow("pyramid of 8") << 8;
}

void CellProjectionTest::feetOnSolidsLieOnThemAndStay() {
    QFETCH(int, kind);
    Random random(test::seed());
    const Solid solid = kind == 0 ? cube(1) : kind == 1 ? lBlock(1) : pyramid(kind, 0.8, 0.9);
    const SampledSolid s = sampled(solid, 2, 0.07, random);
    const CellSurface surface = cellsOf(s.surfels);
    int failed = 0, all = 0;
    double worst = 0, moved = 0;
    for (int k = 0; k < test::effort(300); ++k) {
        const Vec3d x = beside(s, random, 1.5 * s.spacing);
        const CellFoot foot = projectCells(surface, x);
        ++all;
        if (!foot.projection.ok()) {
            ++failed;
            continue;
        }
        worst = std::max(worst, std::abs(s.solid.value(foot.projection.foot)) / s.spacing);
        const CellFoot again = projectCells(surface, foot.projection.foot);
        if (!again.projection.ok())
            ++failed;
        else
            moved = std::max(moved, base::distance(again.projection.foot, foot.projection.foot) / s.spacing);
    }
    qInfo() << all << "feet, failed" << failed << "off" << worst << "moved" << moved;
    const bool exact = kind < 2; // the others' planes are rounded to float
    QVERIFY2(failed == 0, QByteArray::number(failed));
    QVERIFY2(worst < (exact ? 1e-9 : 1e-4), QByteArray::number(worst));
    QVERIFY2(moved < (exact ? 1e-9 : 1e-4), QByteArray::number(moved));
}

void CellProjectionTest::featuresAreWhatTheyAre() {
    Random random(test::seed());
    const SampledSolid s = sampled(lBlock(1), 2, 0.07, random);
    const CellSurface surface = cellsOf(s.surfels);
    const auto at = [&](const Vec3d& x) { return project(surface, x); };
    QCOMPARE(at({0.5, -0.5, 0.55}).feature, Feature::Face);
    QCOMPARE(at({1.05, -0.5, 0.55}).feature, Feature::Seam);
    QCOMPARE(at({1.05, -1.05, 0.55}).feature, Feature::Corner);
    QCOMPARE(at({-0.05, -0.05, 0.1}).feature, Feature::Seam);  // the concave one, from within
    QCOMPARE(at({-0.03, -0.03, 0.53}).feature, Feature::Face); // on the reflex corner's own face
    QCOMPARE(at({0.0, 0.0, 0.5}).feature, Feature::Corner);
    const CellFoot corner = at({1.05, -1.05, 0.55});
    QCOMPARE(corner.cells.size(), std::size_t(3));
    QVERIFY(base::distance(corner.projection.foot, {1, -1, 0.5}) < 1e-9);
}

void CellProjectionTest::valuesAreTheBooleanOfThePlanes() {
    Random random(test::seed());
    for (const bool block : {false, true}) {
        const SampledSolid s = sampled(block ? lBlock(1) : cube(1), 2, 0.07, random);
        const CellSurface surface = cellsOf(s.surfels);
        for (int k = 0; k < test::effort(300); ++k) {
            const Vec3d x = beside(s, random, 1.2 * s.spacing);
            const cells::CellValue value = evaluate(surface, x, surface::Need::Value);
            QVERIFY2(std::abs(value.at.value - s.solid.value(x)) < 1e-9,
                     QByteArray::number(value.at.value) + " is " + QByteArray::number(s.solid.value(x)));
        }
    }
}

/// On a bent cell, whose seam with a plane is bent too.
void CellProjectionTest::gradientsAreThoseOfTheValues() {
    Random random(test::seed());
    SampledSolid s = sampled(intersection({{{1, 0, 0}, 0}, {{0, 0, 1}, 0}}), 1, 0.06, random);
    const cells::LabelLayout labels = *cells::LabelLayout::of(*s.surfels.layout);
    for (std::size_t i = 0; i < s.surfels.size(); ++i)
        if (labels.at(s.surfels.extraOf(i)).cell == 1) {
            surfel::Surfel& at = s.surfels.items[i];
            at.position.z = 0.2f * at.position.x * at.position.x;
            at.normal = base::normalized(base::Vec3f{-0.4f * at.position.x, 0, 1});
        }
    const CellSurface surface = cellsOf(s.surfels);
    int mixed = 0;
    for (int k = 0; k < test::effort(200); ++k) {
        const Vec3d x{random.uniform(-0.15, 0.02), random.uniform(-0.4, 0.4), random.uniform(-0.15, 0.02)};
        const cells::CellValue at = evaluate(surface, x, surface::Need::Gradient);
        if (!at.at.ok() || !at.mixed)
            continue;
        ++mixed;
        constexpr double e = 1e-6;
        for (std::size_t a = 0; a < 3; ++a) {
            Vec3d step;
            step[a] = e;
            const cells::CellValue up = evaluate(surface, x + step, surface::Need::Value);
            const cells::CellValue down = evaluate(surface, x - step, surface::Need::Value);
            if (up.cell == at.cell && down.cell == at.cell)
                QVERIFY(std::abs((up.at.value - down.at.value) / (2 * e) - at.at.gradient[a]) < 1e-6);
        }
    }
    QVERIFY(mixed > 10);
}

void CellProjectionTest::awayFromCreasesBitsStay() {
    Random random(test::seed());
    const SampledSolid s = sampled(cube(1), 2, 0.06, random);
    const CellSurface surface = cellsOf(s.surfels);
    for (int k = 0; k < test::effort(100); ++k) {
        const Vec3d x{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(0.9, 1.1)};
        const CellFoot foot = project(surface, x);
        const auto plain = projectReference(surface.surface(), x);
        QVERIFY(!foot.mixed);
        QVERIFY(foot.projection.foot == plain.foot);
        const cells::CellValue value = evaluate(surface, x, surface::Need::Gradient);
        const auto there = surface.surface().evaluateReference(x);
        QVERIFY(value.at.value == there.value && value.at.gradient == there.gradient);
    }
}

void CellProjectionTest::everyProjectorLandsOnTheSurface() {
    Random random(test::seed());
    const SampledSolid s = sampled(lBlock(1), 2, 0.08, random);
    const CellSurface surface = cellsOf(s.surfels);
    for (const auto projector : {surface::Projector::Basic, surface::Projector::Almost, surface::Projector::Orthogonal})
        for (int k = 0; k < test::effort(100); ++k) {
            const CellFoot foot = project(surface, beside(s, random, s.spacing), {projector});
            QVERIFY(foot.projection.ok());
            QVERIFY(std::abs(s.solid.value(foot.projection.foot)) < 1e-9);
        }
}

/// Labels that mean nothing: every answer is a number on the surface or none, in finite time.
void CellProjectionTest::anyLabelsAreAnsweredSomehow() {
    Random random(test::seed());
    SampledSolid s = sampled(cube(1), 2, 0.15, random);
    std::vector<cells::Label> labels(s.surfels.size());
    for (cells::Label& label : labels) {
        label.cell = static_cast<std::uint32_t>(random.below(40));
        label.partner = static_cast<std::uint32_t>(random.below(40));
        label.meeting =
            label.partner == label.cell ? cells::Meeting::None : static_cast<cells::Meeting>(random.below(3));
        label.sharpness = static_cast<std::uint8_t>(random.below(256));
        label.face = static_cast<std::uint32_t>(random.below(5));
    }
    setLabels(s.surfels, labels);
    const CellSurface surface = cellsOf(s.surfels);
    for (int k = 0; k < test::effort(20); ++k) {
        const Vec3d x = beside(s, random, 0.3);
        const CellFoot foot = project(surface, x);
        QVERIFY(!foot.projection.ok() || base::isFinite(foot.projection.foot));
        const cells::CellValue value = evaluate(surface, x, surface::Need::Gradient);
        QVERIFY(!value.at.ok() || std::isfinite(value.at.value));
    }
}

static const test::Registered<CellProjectionTest> registered;
#include "cell_projection_test.moc"
