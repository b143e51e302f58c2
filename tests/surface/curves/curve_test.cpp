// Curves in space (surface/README 7.1): analytic curves, finite differences, ends and degenerate cases.
#include "core/surface/curves/curve.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <functional>
#include <QTest>

using base::Vec3d;
using surface::Cause, surface::Frame, surface::Need, surface::Projector, surface::Status, surface::Surface,
    surface::Weight;

namespace {

using Parametric = std::function<Vec3d(double)>;

/// `count` surfels at equal steps of the parameter in [0, end), normals holding the chord directions as tangents.
Surface curveOf(const Parametric& at, int count, double end, double support, Frame frame = Frame::CovarianceAtCentroid,
                Weight weight = Weight::Wendland) {
    surfel::SurfelList list;
    list.layout = shapes::layout(true, false);
    for (int i = 0; i < count; ++i) {
        const double u = end * i / count;
        const Vec3d t = base::normalized(at(u + 1e-5) - at(u - 1e-5));
        list.items.push_back(shapes::surfelAt(at(u), i % 2 ? t : -t, support));
    }
    surface::SurfaceDefinition definition;
    definition.manifold = surface::Manifold::Curve;
    definition.frame = frame;
    definition.weight = weight;
    return {tree::SurfelTree::build(list), definition};
}

Vec3d circle(double u) {
    return {std::cos(u), std::sin(u), 0};
}
Vec3d helix(double u) {
    return {std::cos(u), std::sin(u), 0.1 * u};
}
Vec3d line(double u) {
    return Vec3d{1, 2, -1} * ((u - 1) / std::sqrt(6.0));
}

Surface fineCircle(double h, Frame frame = Frame::CovarianceAtCentroid, Weight weight = Weight::Wendland) {
    return curveOf(circle, 2000, 2 * shapes::pi, h, frame, weight);
}

constexpr Frame frames[] = {Frame::Covariance, Frame::CovarianceAtCentroid, Frame::CentroidGradient,
                            Frame::Hyperplanes};

} // namespace

class CurveTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void lineIsExact();
    void circleShrinksByItsMoment();
    void helixShrinksByItsCurvature();
    void orthogonalFootIsClosest();
    void gradientMatchesDifferences();
    void endsLieWhereTheOffCentreSaysSo();
    void degenerateCasesHaveNames();
    void feetAreFoundFromAfar();
};

static QByteArray nameOf(Frame frame, double error) {
    return QString("frame %1, error %2").arg(int(frame)).arg(error).toUtf8();
}

void CurveTest::lineIsExact() {
    base::Random random(5);
    const Vec3d t = base::normalized(Vec3d{1, 2, -1});
    for (const Frame frame : frames) {
        const Surface curve = curveOf(line, 200, 2, 0.05, frame);
        for (int i = 0; i < 40; ++i) {
            const Vec3d away = cross(t, random.unitVector()) * 0.01, on = t * random.uniform(-0.8, 0.8);
            const auto e = evaluateCurve(curve, on + away, Need::Hessian);
            QCOMPARE(int(e.status), int(Status::Ok));
            const double loose = frame == Frame::Covariance ? 1e-3 : 1e-6; // positions are floats
            QVERIFY2(length(e.value - away) < loose, nameOf(frame, length(e.value - away)));
            QVERIFY(std::abs(dot(e.tangent, t)) > 1 - 10 * loose);
            if (frame != Frame::Covariance)
                QVERIFY(length(e.curvature) < 0.02);
        }
    }
}

/// surface/README 7.1: circle 1 - h^2/28, curvature towards the centre; 1.2 for the Gaussian kappa h^2/4.
void CurveTest::circleShrinksByItsMoment() {
    for (const Frame frame : frames)
        for (const Projector projector : {Projector::Basic, Projector::Almost, Projector::Orthogonal}) {
            const Surface curve = fineCircle(0.2, frame);
            const auto p = projectOnCurve(curve, {1.03, 0.02, 0.01}, {projector, 0, 60, true, Need::Hessian});
            QVERIFY(p.ok());
            const double radius = length(p.foot);
            QVERIFY2(std::abs(radius - (1 - 0.04 / 28)) < 1e-5, qPrintable(QString::number(radius, 'g', 9)));
            QVERIFY(std::abs(p.foot.z) < 1e-7);
            QVERIFY(length(p.at.curvature + p.foot * (1 / (radius * radius))) < 2e-2);
            QVERIFY(std::abs(dot(p.at.tangent, p.foot)) < 1e-5);
        }
    const auto p =
        projectOnCurve(fineCircle(0.1 * surface::gaussianReach, Frame::Covariance, Weight::Gaussian), {1.01, 0, 0.01});
    QVERIFY(p.ok());
    QVERIFY(std::abs(length(p.foot) - (1 - 0.01 / 4)) < 2e-5);
}

/// surface/README 7.1: radius 1, pitch 0.1, support 0.2: the foot at 1 - kappa h^2/28, oracle 0.998583.
void CurveTest::helixShrinksByItsCurvature() {
    const Surface curve = curveOf(helix, 4000, 6 * shapes::pi, 0.2);
    const auto p = projectOnCurve(curve, helix(9.4) * 1.001);
    QVERIFY(p.ok());
    QVERIFY2(std::abs(std::hypot(p.foot.x, p.foot.y) - 0.998583) < 2e-6,
             qPrintable(QString::number(std::hypot(p.foot.x, p.foot.y), 'g', 9)));
}

void CurveTest::orthogonalFootIsClosest() {
    const Surface curve = curveOf(helix, 1500, 6 * shapes::pi, 0.2);
    const auto seed = test::seed();
    base::Random random(seed);
    for (int i = 0; i < 100; ++i) {
        const Vec3d x = helix(random.uniform(2, 16)) + random.unitVector() * random.uniform(0, 0.08);
        const auto p = projectOnCurve(curve, x);
        QVERIFY2(p.ok(), qPrintable(QString("seed %1, query %2").arg(seed).arg(i)));
        const Vec3d back = x - p.foot;
        QVERIFY(std::abs(dot(back, p.at.tangent)) < 1e-7 * length(back) + 1e-12);
        for (const double step : {-1e-3, 1e-3}) { // along the curve it only gets farther
            const auto beside = projectOnCurve(curve, p.foot + p.at.tangent * step, {Projector::Basic});
            QVERIFY(beside.ok() && length(x - beside.foot) > length(back));
        }
        const auto again = projectOnCurve(curve, p.foot);
        QVERIFY(again.ok() && length(again.foot - p.foot) < 1e-10);
    }
}

void CurveTest::gradientMatchesDifferences() {
    for (const Frame frame : frames) {
        const Surface curve = curveOf(helix, 1500, 6 * shapes::pi, 0.25, frame, Weight::WendlandC4);
        const Vec3d x = helix(7.7) + Vec3d{0.02, -0.03, 0.01};
        const auto e = evaluateCurve(curve, x, Need::Gradient);
        for (std::size_t k = 0; k < 3; ++k) {
            Vec3d step;
            step[k] = 1e-5;
            const auto ahead = evaluateCurve(curve, x + step), back = evaluateCurve(curve, x - step);
            const Vec3d slope = (ahead.value - back.value) * (1 / 2e-5);
            for (std::size_t a = 0; a < 3; ++a)
                QVERIFY2(std::abs(slope[a] - e.gradient.m[a][k]) < 1e-7, nameOf(frame, slope[a] - e.gradient.m[a][k]));
        }
    }
}

/// surface/README 1.2: o at the end of a curve is 3h/14, the end half a spacing beyond the last point.
void CurveTest::endsLieWhereTheOffCentreSaysSo() {
    Surface curve = curveOf(line, 2000, 2, 0.1);
    const Vec3d t = base::normalized(Vec3d{1, 2, -1});
    const auto end = evaluateCurve(curve, t * (-1 - 0.0005));
    QVERIFY2(std::abs(end.offCentre / 0.1 - 3.0 / 14) < 1e-4, qPrintable(QString::number(end.offCentre / 0.1)));
    surface::SurfaceDefinition definition = curve.definition();
    definition.boundaryLimit = 3.0f / 14;
    const Surface bounded(curve.tree(), definition);
    QCOMPARE(int(evaluateCurve(bounded, t * -1.01).status), int(Status::BeyondBoundary));
    QCOMPARE(int(evaluateCurve(bounded, t * -0.99).status), int(Status::Ok));
    QCOMPARE(int(projectOnCurve(bounded, t * -1.02).status), int(Status::BeyondBoundary));
}

void CurveTest::degenerateCasesHaveNames() {
    const auto at = [](std::vector<Vec3d> points, const Vec3d& x) {
        surfel::SurfelList list;
        list.layout = shapes::layout(false, false);
        for (const Vec3d& p : points)
            list.items.push_back(shapes::surfelAt(p, {}, 1));
        surface::SurfaceDefinition definition;
        definition.manifold = surface::Manifold::Curve;
        return surface::evaluateCurve({tree::SurfelTree::build(list), definition}, x);
    };
    QCOMPARE(int(at({{0, 0, 0}}, {5, 0, 0}).status), int(Status::Outside));
    QCOMPARE(int(at({{0, 0, 0}}, {5, 0, 0}).cause), int(Cause::NoSupport));
    QCOMPARE(int(at({{0, 0, 0}}, {0.1, 0, 0}).cause), int(Cause::OnePoint));
    QCOMPARE(int(at({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {0.1, 0, 0}).cause), int(Cause::Coincident));
    const auto cross = at({{0.3, 0, 0}, {-0.3, 0, 0}, {0, 0.3, 0}, {0, -0.3, 0}}, {0, 0, 0});
    QCOMPARE(int(cross.status), int(Status::Degenerate));
    QCOMPARE(int(cross.cause), int(Cause::ClosedGap));
    QCOMPARE(int(at({{0.3, 0, 0}, {-0.3, 0, 0}}, {0, 0, 0}).status), int(Status::Ok));
}

/// Outside all supports the foot starts from the nearest point (surface/README 3.3).
void CurveTest::feetAreFoundFromAfar() {
    const auto p = projectOnCurve(fineCircle(0.2), {2, 0.01, 0.5});
    QVERIFY(p.ok());
    QVERIFY(std::abs(length(p.foot) - (1 - 0.04 / 28)) < 1e-5);
}

static const test::Registered<CurveTest> registered;
#include "curve_test.moc"
