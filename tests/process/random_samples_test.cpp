// Samples that were each drawn without regard to the others, as many programs write them: chance leaves gaps between
// them, which are no holes.
#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "core/process/estimation/spacing.h"
#include "core/process/estimation/supports.h"
#include "core/surface/curves/boundary_curves.h"
#include "process/even_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using base::Vec3d;

class RandomSamplesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void gapsAreNoHoles_data();
    void gapsAreNoHoles();
    void supportsReachFartherByChanceOnly();
};

namespace {

/// The unit sphere, by chance, without a cap about z of that radius along the chord.
surfel::SurfelList ball(std::size_t count, double hole, bool normals, base::Random& random) {
    surfel::SurfelList out;
    if (normals)
        out.layout = test::orientedLayout();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d p = random.unitVector();
        if (distance(p, Vec3d{0, 0, 1}) > hole)
            out.append(test::surfelAt(p, normals ? p : Vec3d{}, 0), {});
    }
    return out;
}

/// Of the radii over the spacing, with no radii given.
float medianReach(surfel::SurfelList list, const surface::SurfaceDefinition& definition = {}) {
    const std::vector<float> spacing = process::spacings(list.items);
    process::assignSupports(list, definition);
    std::vector<float> out(list.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = list.items[i].support / spacing[i];
    return process::summarise(std::move(out)).median;
}

} // namespace

void RandomSamplesTest::gapsAreNoHoles_data() {
    QTest::addColumn<bool>("normals");
    QTest::newRow("bare") << false;
    QTest::newRow("with normals") << true;
}

/// One rim each, that of the hole. (Boxes may have false ones yet, on their edges.)
void RandomSamplesTest::gapsAreNoHoles() {
    QFETCH(bool, normals);
    base::Random random(test::seed());
    int rims = 0, models = 0, found = 0;
    for (const std::size_t count : {3000u, 6000u, 12000u}) {
        if (test::sanitized && count > 3000)
            continue;
        const double hole = random.uniform(8, 14) * test::sphereSpacing(count);
        const surface::Surface surface = process::prepare(ball(count, hole, normals, random), {});
        for (const surface::BoundaryCurve& curve : surface::findBoundaryCurves(surface)) {
            const double along = distance(curve.points[0].position, Vec3d{0, 0, 1});
            found += curve.closed && std::abs(along - hole) < 2.5 * test::sphereSpacing(count);
            ++rims;
        }
        ++models;
        QVERIFY(std::isinf(process::prepare(ball(count, 0, normals, random), {}).definition().boundaryLimit));
    }
    QVERIFY2(
        found == models && rims <= models + 1,
        qPrintable(
            QString("%1 rims of %2 models, %3 of holes, seed %4").arg(rims).arg(models).arg(found).arg(test::seed())));
}

void RandomSamplesTest::supportsReachFartherByChanceOnly() {
    base::Random random(test::seed());
    const float usual = surface::SurfaceDefinition().unitInSpacings();
    const float even = medianReach(test::spherePoints(4000)), random4000 = medianReach(ball(4000, 0, true, random));
    QVERIFY2(std::abs(even / usual - 1) < 0.01f, qPrintable(QString::number(even)));
    QVERIFY2(random4000 > 1.25f * usual && random4000 < 1.45f * usual,
             qPrintable(QString("%1, seed %2").arg(random4000).arg(test::seed())));

    surfel::SurfelList curve;
    for (int k = 0; k < 2000; ++k)
        curve.append(test::surfelAt({std::cos(0.01 * k), std::sin(0.01 * k), 0.01 * k}, {}, 0), {});
    surface::SurfaceDefinition definition;
    definition.manifold = surface::Manifold::Curve;
    const float along = medianReach(std::move(curve), definition);
    QVERIFY2(std::abs(along / usual - 1) < 0.01f, qPrintable(QString::number(along)));
}

static const test::Registered<RandomSamplesTest> registered;
#include "random_samples_test.moc"
