// Resampling of models with cells: no edge is rounded, nothing crosses one, what is born knows its cell.
#include "core/process/resampling/resample.h"

#include "cells/solids.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using base::Random, base::Vec3d;
using plane_solids::SampledSolid;

class ResampleCellsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void drawnSolidsKeepTheirEdges_data();
    void drawnSolidsKeepTheirEdges();
    void wholeModelsKeepTheirEdges_data();
    void wholeModelsKeepTheirEdges();
    void withinOneCellBitsStay();
};

namespace {

constexpr double spacing = 0.1;

tree::Selection all(const tree::SurfelTree& tree) {
    tree::Selection out;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        tree::SelectedBlock some{number, {}};
        for (int slot = 0; slot < block.size(); ++slot)
            some.slots.set(static_cast<std::size_t>(slot));
        out.push_back(some);
    });
    return out;
}

process::ResampleOptions options() {
    process::ResampleOptions out;
    out.spacing = static_cast<float>(spacing);
    out.support = static_cast<float>(3.5 * spacing);
    return out;
}

} // namespace

void ResampleCellsTest::drawnSolidsKeepTheirEdges_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("cube") << 0;
    QTest::newRow("L-block") << 1;
    QTest::newRow("pyramid") << 2;
}

/// Drawn to twice the length along one axis, then resampled twice.
void ResampleCellsTest::drawnSolidsKeepTheirEdges() {
    QFETCH(int, kind);
    Random random(test::seed());
    const double size = test::sanitized ? 0.5 : 0.8;
    const plane_solids::Solid solid = kind == 0   ? plane_solids::cube(size)
                                      : kind == 1 ? plane_solids::lBlock(size)
                                                  : plane_solids::pyramid(5, size, size);
    SampledSolid s = plane_solids::sampled(solid, 3 * size, spacing, random);
    plane_solids::Solid drawn = solid;
    for (plane_solids::Plane& plane : drawn.planes) {
        const Vec3d n{plane.n.x / 2, plane.n.y, plane.n.z};
        plane = {base::normalized(n), plane.d / length(n)};
    }
    for (surfel::Surfel& each : s.surfels.items) {
        each.position.x *= 2;
        each.normal = base::normalized(base::Vec3f{each.normal.x / 2, each.normal.y, each.normal.z});
    }
    surface::Surface version = plane_solids::surfaceOf(s.surfels);
    const std::size_t before = version.tree().size();
    for (int round = 0; round < 2; ++round)
        version = {version.tree().apply(process::resample(version, all(version.tree()), options())),
                   version.definition()};
    const cells::LabelLayout labels = *cells::LabelLayout::of(*version.tree().layout());
    std::size_t count = 0, off = 0, elsewhere = 0, turned = 0;
    double worst = 0;
    version.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const Vec3d p = base::cast<double>(block.position(slot));
            const plane_solids::Plane& plane = drawn.planes[labels.cellAt(block, slot)];
            const double far = std::max(std::abs(plane.f(p)), std::abs(drawn.value(p)));
            worst = std::max(worst, far / spacing);
            ++count;
            off += std::abs(plane.f(p)) > 1e-3 * spacing ? 1 : 0;
            elsewhere += std::abs(drawn.value(p)) > 0.02 * spacing ? 1 : 0;
            turned += dot(base::cast<double>(block.normal(slot)), plane.n) < 0.9999 ? 1 : 0;
        }
    });
    const QByteArray told =
        QString("seed %1: %2 surfels of %3, %4 off their plane, %5 off the solid, %6 turned, worst %7")
            .arg(test::seed())
            .arg(count)
            .arg(before)
            .arg(off)
            .arg(elsewhere)
            .arg(turned)
            .arg(worst)
            .toUtf8();
    QVERIFY2(count > before * 5 / 4, told); // room was filled
    QVERIFY2(off == 0 && turned == 0, told);
    QVERIFY2(elsewhere == 0, told);
}

void ResampleCellsTest::wholeModelsKeepTheirEdges_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("ratio");
    for (const double ratio : {0.8, 1.3}) {
        QTest::addRow("cube by %g", ratio) << 0 << ratio;
        QTest::addRow("L-block by %g", ratio) << 1 << ratio;
    }
}

/// Every surfel on the plane of its cell, none beyond an edge, and as many as the area wants.
void ResampleCellsTest::wholeModelsKeepTheirEdges() {
    QFETCH(int, kind);
    QFETCH(double, ratio);
    Random random(test::seed());
    const plane_solids::Solid solid = kind == 0 ? plane_solids::cube(0.8) : plane_solids::lBlock(0.8);
    const SampledSolid s = plane_solids::sampled(solid, 2.4, spacing, random);
    const surface::Surface before = plane_solids::surfaceOf(s.surfels);
    const auto result = process::resampleAll(before, static_cast<float>(ratio * spacing));
    const cells::LabelLayout labels = *cells::LabelLayout::of(*result.surface.tree().layout());
    double off = 0;
    result.surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const Vec3d p = base::cast<double>(block.position(slot));
            off = std::max({off, std::abs(solid.planes[labels.cellAt(block, slot)].f(p)), std::abs(solid.value(p))});
        }
    });
    const double count = static_cast<double>(result.surface.tree().size());
    const double wanted = static_cast<double>(before.tree().size()) / (ratio * ratio);
    const QByteArray told =
        QString("seed %1: %2 surfels for %3, off %4").arg(test::seed()).arg(count).arg(wanted).arg(off).toUtf8();
    QVERIFY2(off < 0.02 * spacing, told);
    QVERIFY2(count > 0.8 * wanted && count < 1.25 * wanted, told);
}

void ResampleCellsTest::withinOneCellBitsStay() {
    Random random(test::seed());
    const SampledSolid s =
        plane_solids::sampled(plane_solids::intersection({{{0, 0, 1}, 0.3}}), 1, 1.4 * spacing, random);
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    surfel::SurfelList bare;
    bare.layout = layout;
    for (const surfel::Surfel& each : s.surfels.items)
        bare.append(each, {});
    const surface::Surface with = plane_solids::surfaceOf(s.surfels), without = plane_solids::surfaceOf(bare);
    const tree::Edit a = process::resample(with, all(with.tree()), options());
    const tree::Edit b = process::resample(without, all(without.tree()), options());
    QVERIFY(!a.empty());
    QVERIFY(a.inserted.items == b.inserted.items);
}

static const test::Registered<ResampleCellsTest> registered;
#include "resample_cells_test.moc"
