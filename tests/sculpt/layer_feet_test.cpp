// Where surfels under a layer have their feet, and what comes of it where a stroke is resampled on its way.
#include "core/base/random.h"
#include "core/sculpt/tools/layer_feet.h"
#include "sculpt/stroke_samples.h"
#include "support/registry.h"

#include <QTest>

class LayerFeetTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void feetLieBelowWhereTheyAreLookedFor();
    void whatIsFarFromItsStartIsProjected();
    void thickLayersLeaveNothingBehindWhereTheyAreResampled();
};

constexpr std::size_t count = 6000;

static double spacing() {
    return test::sphereSpacing(count);
}

/// Largest distance of the feet from what lies below `expected`, and of their normals from its direction.
struct Errors {
    double foot = 0, normal = 0;
};
static Errors errorsOf(std::span<const std::optional<sculpt::LayerFoot>> feet, std::span<const base::Vec3d> expected) {
    Errors out;
    for (std::size_t i = 0; i < feet.size(); ++i) {
        const double none = 1e9;
        out.foot = std::max(out.foot, feet[i] ? distance(base::cast<double>(feet[i]->foot), expected[i]) : none);
        out.normal = std::max(out.normal, feet[i] ? distance(base::cast<double>(feet[i]->normal), expected[i]) : none);
    }
    return out;
}

void LayerFeetTest::feetLieBelowWhereTheyAreLookedFor() {
    const surface::Surface first = test::surfaceOf(test::spherePoints(count));
    base::Random random(test::seed());
    std::vector<base::Vec3f> started, places;
    std::vector<base::Vec3d> expected;
    for (int k = 0; k < 500; ++k) {
        const base::Vec3d u = random.unitVector();
        expected.push_back(u);
        const base::Vec3d off = random.unitVector() * (random.uniform(0, 0.7) * spacing());
        started.push_back(base::cast<float>(u + off));
        places.push_back(base::cast<float>(u * random.uniform(0.7, 1.5)));
    }
    const auto feet = sculpt::layerFeet(first, started, places);
    const Errors errors = errorsOf(feet, expected);
    QVERIFY2(errors.foot < 0.06 * spacing(), qPrintable(QString("%1 seed %2").arg(errors.foot).arg(test::seed())));
    QVERIFY2(errors.normal < 0.02, qPrintable(QString("%1 seed %2").arg(errors.normal).arg(test::seed())));
}

void LayerFeetTest::whatIsFarFromItsStartIsProjected() {
    const surface::Surface first = test::surfaceOf(test::spherePoints(count));
    base::Random random(test::seed());
    std::vector<base::Vec3f> started, places;
    std::vector<base::Vec3d> expected;
    for (int k = 0; k < 200; ++k) {
        const base::Vec3d u = random.unitVector();
        expected.push_back(u);
        started.push_back(base::cast<float>(u * 2.0));
        places.push_back(base::cast<float>(u * 1.1));
    }
    const Errors errors = errorsOf(sculpt::layerFeet(first, started, places), expected);
    QVERIFY2(errors.foot < 0.02 * spacing(), qPrintable(QString("%1 seed %2").arg(errors.foot).arg(test::seed())));
    QVERIFY2(errors.normal < 0.02, qPrintable(QString("%1 seed %2").arg(errors.normal).arg(test::seed())));
}

/// The stroke goes to and fro until the layer is as thick as it gets; its walls are resampled all the time.
void LayerFeetTest::thickLayersLeaveNothingBehindWhereTheyAreResampled() {
    base::Random random(test::seed());
    sculpt::StrokeSettings settings = test::settingsOf("layer", 0.4f);
    settings.strength = 1;
    settings.parameters = {{"height", 0.5}};
    std::vector<sculpt::StrokeSample> samples;
    for (int k = 0; k < 4; ++k)
        for (const float x : {-0.15f, 0.15f})
            samples.push_back(test::down(x, float(random.uniform(-0.01, 0.01))));
    const surface::Surface after = test::stroked(test::surfaceOf(test::spherePoints(count)), settings, samples);
    const double thick = 0.5 * 0.4;
    int above = 0;
    for (const surfel::Surfel& each : after.tree().surfels().items) {
        const base::Vec3d p = base::cast<double>(each.position);
        const double height = length(p) - 1, aside = std::hypot(p.x, p.y) / length(p);
        QVERIFY2(height < thick + 0.15 * spacing(), qPrintable(QString("%1 seed %2").arg(height).arg(test::seed())));
        if (p.z < 0 || aside > 0.1)
            continue;
        ++above;
        QVERIFY2(height > 0.95 * thick, qPrintable(QString("%1 seed %2").arg(height).arg(test::seed())));
    }
    QVERIFY(above > 10);
}

static const test::Registered<LayerFeetTest> registered;
#include "layer_feet_test.moc"
