// Where along a ray zeros of a cell are looked for: no surface is left out.
#include "core/cells/cell_roots.h"

#include "cells/solids.h"
#include "core/cells/local_boolean.h"
#include "support/registry.h"

#include <QTest>

using namespace plane_solids;
using cells::CellSource, cells::CellSurface, cells::Stretch;

class CellRootsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void piecesHoldAllZerosThatAreSurface_data();
    void piecesHoldAllZerosThatAreSurface();
    void planesThatAreNotCrossedAreNotLookedAt();
};

void CellRootsTest::piecesHoldAllZerosThatAreSurface_data() {
    QTest::addColumn<bool>("curved");
    QTest::newRow("an eighth of a ball") << true;
    QTest::newRow("a polyhedron") << false;
}

/// Whole stretches are marched, and each zero is a piece's.
void CellRootsTest::piecesHoldAllZerosThatAreSurface() {
    QFETCH(bool, curved);
    base::Random random(test::seed());
    constexpr double spacing = 0.12;
    const CellSurface surface =
        cellsOf(curved ? octant(spacing, random) : sampled(polyhedron(random), 1.6, spacing, random).surfels);
    const surfel::SurfelList all = surface.surface().tree().surfels();
    CellSource source(surface);
    int zeros = 0;
    for (int k = 0; k < test::effort(150); ++k) {
        const Vec3d target = base::cast<double>(all.items[random.below(all.size())].position) +
                             random.unitVector() * (spacing * random.uniform());
        const base::Rayd ray = towards(target, random.unitVector(), 3);
        const std::vector<Stretch> pieces = stretches(surface, ray, 0, 10);
        for (const Stretch& piece : pieces) {
            Stretch whole = piece;
            whole.first = whole.begin, whole.last = whole.end;
            whole.least = -1, whole.most = 1; // to be marched
            std::vector<double> found;
            cells::CellRoots<CellSource>(source, ray).find(whole, found);
            for (const double t : found) {
                source.moveTo(ray.at(t));
                const std::size_t i = source.find(piece.cell);
                if (i == CellSource::none || !isFace(source, i, 1e-9))
                    continue;
                ++zeros;
                const bool held = std::any_of(pieces.begin(), pieces.end(), [&](const Stretch& p) {
                    return p.cell == piece.cell && t >= p.first - 1e-6 && t <= p.last + 1e-6;
                });
                QVERIFY2(held, qPrintable(QString("seed %1, ray %2, at %3").arg(test::seed()).arg(k).arg(t)));
            }
        }
    }
    QVERIFY(zeros > test::effort(150));
}

void CellRootsTest::planesThatAreNotCrossedAreNotLookedAt() {
    base::Random random(test::seed());
    const CellSurface surface = cellsOf(sampled(cube(1), 2, 0.1, random).surfels);
    for (int k = 0; k < 50; ++k) { // along a face, above it
        const double height = random.uniform(1.001, 1.1), aside = random.uniform(-0.5, 0.5);
        for (const Stretch& each : stretches(surface, {{-3, aside, height}, {1, 0, 0}}, 0, 10))
            QVERIFY2(each.last - each.first < 0.1, qPrintable(QString("height %1").arg(height)));
    }
}

static const test::Registered<CellRootsTest> registered;
#include "cell_roots_test.moc"
