// Caps of models that are open elsewhere: whole where the section is, and told where it is not.
#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "core/solid/cut.h"
#include "core/surface/curves/boundary_curves.h"
#include "process/even_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using base::Vec3d;

class CapRimsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whereTheSectionIsClosedOnlyTheModelsOwnRimIsLeft();
    void whereTheSectionIsOpenThatIsTold();
};

/// A ball of points drawn by chance, or even ones, without the cap above z = 0.7.
static surface::Surface openBall(base::Random* chance) {
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (surfel::Surfel s : test::spherePoints(test::sanitized ? 1500 : 4000).items) {
        if (chance)
            s.position = s.normal = base::cast<float>(chance->unitVector());
        if (s.position.z < 0.7F)
            points.append(s, {});
    }
    return process::prepare(points, {.definition = {}, .keepSupports = false});
}

void CapRimsTest::whereTheSectionIsClosedOnlyTheModelsOwnRimIsLeft() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(test::sanitized ? 2 : 8); ++round) {
        const surface::Surface ball = openBall(round % 2 ? &random : nullptr);
        QVERIFY(std::isfinite(ball.definition().boundaryLimit));
        const double lean = random.uniform(0, 0.4), turn = random.uniform(0, 6);
        const base::Plane plane{{std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean)},
                                random.uniform(-0.5, 0.2)};
        for (const bool above : {true, false}) {
            const solid::Combined cut = solid::cutByPlane(ball, above ? plane : plane.flipped());
            const auto curves = findBoundaryCurves(cut.surface);
            const QByteArray told = QString("round %1, %2: %3 curves, seed %4")
                                        .arg(round)
                                        .arg(above)
                                        .arg(curves.size())
                                        .arg(test::seed())
                                        .toUtf8();
            QVERIFY2(!cut.open, told);
            QVERIFY2(curves.size() == (above ? 1U : 0U), told);
            for (const surface::BoundaryCurve& each : curves)
                QVERIFY2(each.closed && std::abs(each.length() - 4.49) < 0.6, told);
        }
    }
}

void CapRimsTest::whereTheSectionIsOpenThatIsTold() {
    const surface::Surface ball = openBall(nullptr);
    const solid::Combined cut = solid::cutByPlane(ball, {{1, 0, 0}, 0.1});
    QVERIFY(cut.open && std::abs(cut.open->x - 0.1) < 0.1 && std::abs(cut.open->z - 0.7) < 0.1);
    QVERIFY(!solid::cutByPlane(ball, {{1, 0, 0}, 0.1}, {.cap = false}).open);
}

static const test::Registered<CapRimsTest> registered;
#include "cap_rims_test.moc"
