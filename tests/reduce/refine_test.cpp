// The way back: dense samples on the surface of a reduced set.
#include "core/reduce/refine.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/estimation/spacing.h"
#include "reduce/reduced_models.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using namespace reduce;
using test::Shape;

class RefineTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void refiningComesBackToTheSurface();
    void anySpacingIsReached();
    void bendsBetweenFewSamplesLeaveNoGap();
    void openSurfacesKeepTheirRims();
    void sameBitsAtAnyThreadCount();
    void impossibleSpacingsAreRefused();
};

void RefineTest::refiningComesBackToTheSurface() {
    const Shape shape = test::torus(std::size_t(test::effort(6000)));
    const Reduced few = reduceByRatio(shape.surface, 0.1);
    const Refined many = refine(few.surface, float(shape.spacing));
    many.surface.tree().validate();
    const test::Errors errors = test::errorsOf(many.surface, shape, test::positionsOf(shape.surface));
    const QByteArray told =
        (summaryOf(many.report) + "; exact rms " + std::to_string(errors.rms / shape.spacing) + " s").c_str();
    qInfo("%s", told.constData());
    QVERIFY2(errors.lost == 0 && errors.rms < 0.04 * shape.spacing, told);
    QVERIFY2(many.report.holes == 0 && many.report.rms < 0.02 * shape.spacing, told);
    const double n = double(shape.surface.tree().size());
    QVERIFY2(std::abs(double(many.report.count) / n - 1) < 0.15, told);
    QCOMPARE(many.surface.definition().neighbours, 38);
}

void RefineTest::anySpacingIsReached() {
    const Reduced few = reduceToCount(test::sphere(3000).surface, 300);
    const double wide = std::sqrt(4 * std::numbers::pi / 300);
    for (const double part : {1.3, 0.6, 0.2}) {
        const Refined many = refine(few.surface, float(part * wide));
        const process::Summary s = process::summarise(process::spacings(many.surface.tree().surfels().items));
        const double target = part * wide;
        const QByteArray told = QString("%1: %2 %3 %4").arg(target).arg(s.min).arg(s.median).arg(s.max).toUtf8();
        QVERIFY2(double(s.min) > 0.6 * target && double(s.max) < 1.5 * target, told);
        QVERIFY2(std::abs(double(s.median) / target - 1) < 0.12, told);
    }
}

/// Where tangent planes of neighbours stand steeply to each other, they meet above the middle.
void RefineTest::bendsBetweenFewSamplesLeaveNoGap() {
    base::Random random(test::seed());
    const std::size_t count = 24 + random.below(8);
    const Reduced few = reduceToCount(test::sphere(3000).surface, count);
    const float spacing = test::sanitized ? 0.07f : 0.035f;
    const Refined many = refine(few.surface, spacing);
    double farthest = 0;
    std::vector<tree::Neighbour> near;
    for (int i = 0; i < 3000; ++i) {
        many.surface.tree().nearest(base::cast<float>(random.unitVector()), 1, near);
        farthest = std::max(farthest, std::sqrt(double(near.front().distanceSq)));
    }
    QVERIFY2(
        farthest < 2 * double(spacing),
        qPrintable(
            QString("%1 samples: %2 spacings, seed %3").arg(count).arg(farthest / double(spacing)).arg(test::seed())));
}

void RefineTest::openSurfacesKeepTheirRims() {
    const Shape shape = test::halfSphere(std::size_t(test::effort(4000)));
    const Reduced few = reduceByRatio(shape.surface, 0.1);
    const Refined many = refine(few.surface, float(shape.spacing));
    double lowest = 1;
    for (const test::Vec3f& p : test::positionsOf(many.surface))
        lowest = std::min(lowest, double(p.z));
    const double wide = shape.spacing * std::sqrt(10.0);
    QVERIFY2(lowest > -0.8 * wide, qPrintable(QString::number(lowest / wide)));
    const test::Errors errors = test::errorsOf(many.surface, shape, test::positionsOf(shape.surface));
    QVERIFY2(errors.lost == 0, qPrintable(QString::number(errors.lost)));
}

void RefineTest::sameBitsAtAnyThreadCount() {
    const Reduced few = reduceToCount(test::torus(1500).surface, 300);
    const int threads = base::threadCount();
    base::setThreadCount(1);
    const std::string one = refine(few.surface, 0.07f).surface.tree().contentHash().text();
    base::setThreadCount(3);
    const std::string three = refine(few.surface, 0.07f).surface.tree().contentHash().text();
    base::setThreadCount(threads);
    QCOMPARE(one, three);
}

void RefineTest::impossibleSpacingsAreRefused() {
    const surface::Surface model = test::sphere(500).surface;
    for (const float spacing : {0.0f, -1.0f, std::numeric_limits<float>::infinity(), 1e-7f})
        QVERIFY_EXCEPTION_THROWN(refine(model, spacing), base::Error);
    surface::SurfaceDefinition definition;
    definition.manifold = surface::Manifold::Curve;
    QVERIFY_EXCEPTION_THROWN(refine({model.tree(), definition}, 0.1f), base::Error);
}

static const test::Registered<RefineTest> registered;
#include "refine_test.moc"
