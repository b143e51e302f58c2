// What the validator says of models with creases: distances are those of feet on faces, seams and corners.
#include "core/cells/cell_projection.h"
#include "core/mesh/check/deviation.h"

#include "cells/solids.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

class CreaseCheckTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void distancesAreThoseOfFeet();
};

/// Places on the solid, and at all heights over it, near edges most of all.
void CreaseCheckTest::distancesAreThoseOfFeet() {
    base::Random random(test::seed());
    constexpr double spacing = 0.15;
    for (int round = 0; round < test::effort(3); ++round) {
        const auto solid = round % 2 == 0 ? plane_solids::lBlock(0.9) : plane_solids::polyhedron(random);
        const auto sampled = plane_solids::sampled(solid, 2.4, spacing, random);
        const surface::Surface surface = plane_solids::surfaceOf(sampled.surfels);
        const auto cells = cells::CellSurface::of(surface);
        QVERIFY(cells);
        for (int k = 0; k < (test::sanitized ? 20 : 200); ++k) {
            const auto& near = sampled.surfels.items[random.below(sampled.surfels.size())];
            const auto start = cells::project(*cells, base::cast<double>(near.position) +
                                                          random.unitVector() * random.uniform(0, 2 * spacing));
            if (!start.projection.ok())
                continue;
            const double height = std::pow(10, random.uniform(-8, -1)) * spacing;
            mesh::Mesh m;
            m.positions = {start.projection.foot + random.unitVector() * height};
            m.triangles = {{0, 0, 0}};
            const auto foot = cells::project(*cells, m.positions[0]);
            const mesh::Deviation told = mesh::vertexDeviation(m, surface);
            const double right = distance(m.positions[0], foot.projection.foot);
            const QString where("seed %1, round %2, place %3: %4 instead of %5 spacings");
            QVERIFY2(told.lost == 0 && std::abs(told.max - right) < 2e-5 * spacing + 1e-3 * right,
                     where.arg(test::seed()).arg(round).arg(k).arg(told.max / spacing).arg(right / spacing).toUtf8());
        }
    }
}

static const test::Registered<CreaseCheckTest> registered;
#include "crease_check_test.moc"
