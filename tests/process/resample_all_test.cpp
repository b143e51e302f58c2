// Resampling of whole models: to one spacing, and to one that follows the curvature.
#include "core/process/resampling/resample.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/surface/projection/project.h"
#include "process/even_shapes.h"
#include "support/registry.h"

#include <QTest>

using namespace process;
using base::Vec3d;
using base::Vec3f;
using test::changed;
using test::meanRadius;

class ResampleAllTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void wholeModelsComeToTheirSpacing();
    void spacingFollowsTheCurvature();
    void impossibleSpacingsAreRefused();
};

void ResampleAllTest::wholeModelsComeToTheirSpacing() {
    constexpr std::size_t count = 3000;
    const double s = test::sphereSpacing(count);
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(count));
    for (const double factor : {0.5, 0.74, 0.77, 0.8, 0.9, 1.1, 1.7}) {
        const ResampleResult result = resampleAll(sphere, float(factor * s), 20);
        result.surface.tree().validate();
        const Summary spacing = test::spacingOver(result.surface, factor * s);
        const QByteArray told = QString("%1 to %2").arg(spacing.min).arg(spacing.max).toUtf8();
        QVERIFY2(spacing.min >= 0.6f && spacing.max <= 1.6f, told);
        const double by = test::sphereSpacing(result.surface.tree().size()) / (factor * s);
        QVERIFY2(by > 0.97 && by < 1.07, told + QByteArray::number(by));
        QVERIFY2(std::abs(meanRadius(result.surface) - 1) < 0.02 * s, told);
        for (const surfel::Surfel& each : result.surface.tree().surfels().items)
            QCOMPARE(each.support, supportOf(sphere.definition(), float(factor * s)));
    }
}

/// Fibonacci-like points on the torus around z, even along both circles at the outer equator.
static surface::Surface torus(double major, double minor, double s) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    const int rings = int(2 * std::numbers::pi * minor / s);
    for (int i = 0; i < rings; ++i) {
        const double v = 2 * std::numbers::pi * i / rings, r = major + minor * std::cos(v);
        const int count = int(2 * std::numbers::pi * r / s);
        for (int j = 0; j < count; ++j) {
            const double u = 2 * std::numbers::pi * (j + 0.5 * (i % 2)) / count;
            const Vec3d n{std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
            out.append(test::surfelAt(Vec3d{major * std::cos(u), major * std::sin(u), 0} + n * minor, n, s), {});
        }
    }
    return test::surfaceOf(out);
}

/// An ellipsoid of revolution, three times as long as wide: its ends are three times as bent as its waist.
static surface::Surface spindle(std::size_t count) {
    const surface::Surface ball = test::surfaceOf(test::spherePoints(count));
    return changed(ball, [](surfel::Surfel& each) {
        each.position.z *= 3;
        each.normal = normalized(Vec3f{each.normal.x, each.normal.y, each.normal.z / 3});
    });
}

void ResampleAllTest::spacingFollowsTheCurvature() {
    const double s = test::sphereSpacing(2500);
    // Sampled evenly, so that there is something to measure; of the torus the tube alone counts, bent everywhere alike.
    for (const surface::Surface& start : {resampleAll(spindle(2500), float(s)).surface, torus(1, 0.3, 0.05)}) {
        CurvatureSpacing by;
        by.tolerance = float(1.5 * s * s), by.finest = float(0.5 * s), by.coarsest = float(2 * s);
        const SpacingField field = SpacingField::byCurvature(start, by);
        const ResampleResult result = resampleByCurvature(start, by);
        result.surface.tree().validate();
        std::vector<float> ratios;
        std::vector<tree::Neighbour> near;
        float finest = 1e9f, coarsest = 0;
        for (const surfel::Surfel& each : result.surface.tree().surfels().items) {
            result.surface.tree().nearest(each.position, 7, near);
            double sum = 0;
            for (std::size_t k = 1; k < 7; ++k) {
                sum += std::sqrt(double(near[k].distanceSq));
                // Supports follow smoothly.
                const float other = near[k].block->support(near[k].slot);
                QVERIFY2(std::abs(other - each.support) < 0.25f * each.support,
                         qPrintable(QString::number(double(other / each.support))));
            }
            const float target = field.at(each.position);
            ratios.push_back(float(0.93 * sum / 6) / target);
            finest = std::min(finest, target), coarsest = std::max(coarsest, target);
            const auto e = result.surface.evaluate(each.position, surface::Need::Value);
            QVERIFY(e.ok() && e.samples >= 6);
            const auto off = start.evaluate(each.position, surface::Need::Gradient);
            QVERIFY2(off.ok() && std::abs(double(off.value)) < 0.06 * s,
                     qPrintable(QString::number(double(off.value) / s)));
        }
        const Summary spacing = summarise(ratios);
        const QByteArray told = QString("targets %1 to %2 s, spacing %3 %4 %5 of them, %6 -> %7 surfels")
                                    .arg(double(finest) / s)
                                    .arg(double(coarsest) / s)
                                    .arg(spacing.min)
                                    .arg(spacing.median)
                                    .arg(spacing.max)
                                    .arg(start.tree().size())
                                    .arg(result.surface.tree().size())
                                    .toUtf8();
        qInfo("%s", told.constData());
        QVERIFY2(spacing.min >= 0.6f && spacing.max <= 1.6f && std::abs(spacing.median - 1) < 0.1f, told);
        base::Random random(test::seed());
        const auto items = result.surface.tree().surfels().items;
        for (int k = 0; k < 1000; ++k) {
            const Vec3d aside = random.unitVector() * (0.5 * s);
            const auto foot = surface::project(
                result.surface, items[random.below(items.size())].position + base::cast<float>(aside), {});
            QVERIFY(foot.ok() && foot.at.samples >= 6);
        }
    }
    CurvatureSpacing wrong;
    wrong.tolerance = 1, wrong.finest = 2, wrong.coarsest = 1;
    QVERIFY_THROWS_EXCEPTION(base::Error, resampleByCurvature(spindle(500), wrong));
}

void ResampleAllTest::impossibleSpacingsAreRefused() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(1000));
    QVERIFY_THROWS_EXCEPTION(base::Error, resampleAll(sphere, 0));
    QVERIFY_THROWS_EXCEPTION(base::Error, resampleAll(sphere, -1));
    QVERIFY_THROWS_EXCEPTION(base::Error, resampleAll(sphere, std::nanf("")));
    QVERIFY_THROWS_EXCEPTION(base::Error, resampleAll(sphere, 1e-7f));
}

static const test::Registered<ResampleAllTest> registered;
#include "resample_all_test.moc"
