// Analytic surfaces, float against reference, and the promises of evaluate.
#include "core/base/parallel.h"
#include "core/surface/curvature.h"
#include "core/surface/definition_text.h"
#include "core/surface/projection/project.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;
using shapes::definitionOf, shapes::sameBits;

class EvaluateTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void planesAreExactInDouble_data();
    void planesAreExactInDouble();
    void spheresHaveTheRadiusOfTheTheory();
    void symmetricFormKeepsSpheres();
    void straightEdgeHasTheOffCentreOfTheTheory();
    void boundaryLimitTurnsPositionsBeyond();
    void covarianceFlipsAtTheHeightOfTheTheory();
    void floatFollowsTheReference_data();
    void floatFollowsTheReference();
    void batchGivesTheBitsOfSingles();
    void threadsDoNotChangeBits();
    void similarityMapsTheSurface();
    void duplicatesChangeNothing();
    void platesKeepTheirSheets_data();
    void platesKeepTheirSheets();
    void curvatureOfSphereAndCylinder();
};

void EvaluateTest::planesAreExactInDouble_data() {
    QTest::addColumn<int>("frame");
    QTest::addColumn<bool>("shrinkFree");
    for (const auto& frame : frameNames())
        for (const bool shrinkFree : {false, true})
            if (frame.value != Frame::Covariance) // only approximately normal off the plane (surface/README 2.4)
                QTest::addRow("%s mu=%d", frame.name, shrinkFree) << static_cast<int>(frame.value) << shrinkFree;
}

void EvaluateTest::planesAreExactInDouble() {
    QFETCH(int, frame);
    QFETCH(bool, shrinkFree);
    surfel::SurfelList list = shapes::plane(12, 0.1, 0.35);
    base::Random random(test::seed());
    for (surfel::Surfel& s : list.items) {
        s.position.x += static_cast<float>(random.uniform(-0.03, 0.03));
        s.position.y += static_cast<float>(random.uniform(-0.03, 0.03));
    }
    const Surface surface = shapes::surfaceOf(list, definitionOf(static_cast<Frame>(frame), shrinkFree));
    for (int i = 0; i < 200; ++i) {
        const Vec3d x{random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7), random.uniform(-0.15, 0.15)};
        const Evaluationd e = surface.evaluateReference(x, Need::Hessian);
        QCOMPARE(e.status, Status::Ok);
        QVERIFY(std::abs(e.value - x.z) <= 1e-13);
        QVERIFY(distance(e.gradient, Vec3d{0, 0, 1}) <= 1e-12);
        for (const auto& row : e.hessian.m)
            for (const double entry : row)
                QVERIFY(std::abs(entry) <= 1e-9);
    }
}

/// Zero set of f on the z axis by bisection in double.
static double radiusOf(const Surface& surface, double lo, double hi) {
    const Vec3d direction = base::normalized(Vec3d{0.3, -0.2, 0.5});
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (lo + hi);
        (surface.evaluateReference(direction * middle, Need::Value).value < 0 ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
}

void EvaluateTest::spheresHaveTheRadiusOfTheTheory() {
    const double h = 0.35f, rho = (35 + std::sqrt(1296 - 355 * h * h)) / 71;
    for (const auto frame : {Frame::Normals, Frame::Hyperplanes, Frame::CovarianceAtCentroid}) {
        const Surface surface = shapes::surfaceOf(shapes::sphere(40000, 1, h), definitionOf(frame));
        const double radius = radiusOf(surface, 0.9, 1.1);
        QVERIFY2(std::abs(radius - rho) <= 1e-6, nameOf(frame));
        const Vec3d n = base::normalized(Vec3d{0.3, -0.2, 0.5});
        const Evaluationd e = surface.evaluateReference(n * radius);
        QVERIFY(std::abs(dot(e.gradient, n) - (1 - 35.0 / 36 * (1 - rho) / rho)) <= 1e-4);
    }
    const double scale = 0.2, reach = scale * gaussianReach;
    const Surface gauss =
        shapes::surfaceOf(shapes::sphere(40000, 1, reach), definitionOf(Frame::Normals, false, Weight::Gaussian));
    QVERIFY(std::abs(radiusOf(gauss, 0.9, 1.1) - 0.5 * (1 + std::sqrt(1 - 2 * scale * scale))) <= 1e-6);
}

void EvaluateTest::symmetricFormKeepsSpheres() {
    const Surface surface = shapes::surfaceOf(shapes::sphere(20000, 1, 0.3), definitionOf(Frame::Normals, true));
    QVERIFY(std::abs(radiusOf(surface, 0.9, 1.1) - 1) <= 2e-8); // positions and normals are float
}

void EvaluateTest::straightEdgeHasTheOffCentreOfTheTheory() {
    // a grid whose last row lies half a spacing inside x = 0: o = 2h/(3 pi) + 7 s^2/(18 pi h)
    const double s = 1.0 / 128, h = 0.25;
    surfel::SurfelList list;
    list.layout = shapes::layout(true, true);
    for (int i = 0; i < 40; ++i)
        for (int j = -40; j <= 40; ++j)
            list.items.push_back(shapes::surfelAt({-(i + 0.5) * s, j * s, 0}, {0, 0, 1}, h));
    const Surface surface = shapes::surfaceOf(list);
    const Evaluationd e = surface.evaluateReference({0, 0, 0});
    const double expected = 2 * h / (3 * shapes::pi) + 7 * s * s / (18 * shapes::pi * h);
    QVERIFY2(std::abs(e.offCentre - expected) <= 1e-5 * h, qPrintable(QString::number(e.offCentre - expected)));
}

void EvaluateTest::boundaryLimitTurnsPositionsBeyond() {
    SurfaceDefinition d;
    d.boundary = Boundary::Limit;
    d.boundaryLimit = 0.3f;
    const Surface surface = shapes::surfaceOf(shapes::plane(80, 0.0125, 0.25), d);
    int within = 0, beyond = 0;
    for (double x = 0.9; x < 1.24; x += 0.01) {
        const Evaluationd e = surface.evaluateReference({x, 0.01, 0.005});
        QCOMPARE(e.status, e.offCentre > double(0.3f) * 0.25 ? Status::BeyondBoundary : Status::Ok);
        QVERIFY(std::abs(e.value - 0.005) <= 1e-13); // numbers stay valid
        (e.ok() ? within : beyond) += 1;
        QCOMPARE(surface.evaluate(base::cast<float>(Vec3d{x, 0.01, 0.005})).status, e.status);
    }
    QVERIFY(within > 5 && beyond > 5);
    // the boundary lies 0.130 h beyond the continuum edge at 0.3 h (surface/README 5.1)
    const double edge = 80.5 * 0.0125;
    QVERIFY(surface.evaluateReference({edge + 0.12 * 0.25, 0, 0}).ok());
    QVERIFY(!surface.evaluateReference({edge + 0.14 * 0.25, 0, 0}).ok());
}

void EvaluateTest::covarianceFlipsAtTheHeightOfTheTheory() {
    const double h = 0.5;
    const Surface surface = shapes::surfaceOf(shapes::plane(40, 0.02, h), definitionOf(Frame::Covariance));
    const double flip = 0.25936 * h;
    QVERIFY(std::abs(surface.evaluateReference({0, 0, 0.97 * flip}).normal.z) > 0.99);
    // there on, every direction across the plane is as good as the next
    const Evaluationd above = surface.evaluateReference({0, 0, 1.03 * flip});
    QCOMPARE(above.status, Status::Degenerate);
    QCOMPARE(above.cause, Cause::ClosedGap);
}

void EvaluateTest::floatFollowsTheReference_data() {
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("weight");
    QTest::addColumn<QString>("shape");
    for (const auto& frame : frameNames())
        for (const auto& weight : weightNames())
            for (const char* shape : {"sphere", "torus", "jitter"})
                QTest::addRow("%s %s %s", frame.name, weight.name, shape)
                    << static_cast<int>(frame.value) << static_cast<int>(weight.value) << QString(shape);
}

static surfel::SurfelList shapeNamed(const QString& name, double h) {
    if (name == "sphere")
        return shapes::sphere(3000, 1, h);
    const surfel::SurfelList torus = shapes::torus(1, 0.5, 0.07, h);
    return name == "torus" ? torus : shapes::jittered(torus, 0.02, test::seed());
}

void EvaluateTest::floatFollowsTheReference() {
    QFETCH(int, frame);
    QFETCH(int, weight);
    QFETCH(QString, shape);
    const Weight kind = static_cast<Weight>(weight);
    const double h = kind == Weight::Gaussian ? 0.4 : 0.25, unit = unitOf(kind, static_cast<float>(h));
    const Surface surface =
        shapes::surfaceOf(shapeNamed(shape, h), definitionOf(static_cast<Frame>(frame), true, kind));
    base::Random random(test::seed() + 1);
    const auto list = surface.tree().surfels();
    int compared = 0;
    double worstValue = 0, worstGradient = 0, worstFoot = 0;
    for (int i = 0; i < 300; ++i) {
        const surfel::Surfel& near = list.items[random.below(list.size())];
        const Vec3f x = near.position + base::cast<float>(random.unitVector() * (0.2 * unit));
        const Evaluationf f = surface.evaluate(x);
        const Evaluationd d = surface.evaluateReference(base::cast<double>(x));
        if (!f.ok() || !d.ok())
            continue;
        ++compared;
        QCOMPARE(f.samples, d.samples);
        worstValue = std::max(worstValue, std::abs(double(f.value) - d.value));
        worstGradient = std::max(worstGradient, distance(base::cast<double>(f.gradient), d.gradient));
        QVERIFY(distance(base::cast<double>(f.centroid), d.centroid) <= 2e-5 * unit);
        QVERIFY(std::abs(double(f.offCentre) - d.offCentre) <= 2e-5 * unit);
        if (static_cast<Frame>(frame) == Frame::Covariance)
            continue; // its gap may close on the way
        const Projection<float> pf = project(surface, x);
        const Projection<double> pd = projectReference(surface, base::cast<double>(x));
        QCOMPARE(pf.status, pd.status);
        worstFoot = std::max(worstFoot, distance(base::cast<double>(pf.foot), pd.foot));
    }
    QVERIFY2(compared > 250, qPrintable(QString::number(compared)));
    const QString report =
        QString("f %1 h, g %2, foot %3 h").arg(worstValue / unit).arg(worstGradient).arg(worstFoot / unit);
    const bool loose = static_cast<Frame>(frame) == Frame::Covariance; // eigen gaps down to 1e-3 amplify rounding
    QVERIFY2(worstValue <= (loose ? 1e-3 : 2e-5) * unit, qPrintable(report));
    QVERIFY2(worstGradient <= (loose ? 1 : 2e-4), qPrintable(report));
    QVERIFY2(worstFoot <= 2e-5 * unit, qPrintable(report));
}

static bool sameEvaluation(const Evaluationf& a, const Evaluationf& b) {
    return a.status == b.status && a.samples == b.samples && sameBits(a.weight, b.weight) &&
           sameBits(a.value, b.value) && sameBits(a.centroid, b.centroid) && sameBits(a.normal, b.normal) &&
           sameBits(a.gradient, b.gradient) && sameBits(a.normalGradient, b.normalGradient) &&
           sameBits(a.offCentre, b.offCentre) && sameBits(a.unit, b.unit) && sameBits(a.agreement, b.agreement);
}

/// Queries along the model, scattered ones, and some far outside.
static std::vector<Vec3f> queries(const Surface& surface, std::size_t count) {
    base::Random random(test::seed() + 2);
    const auto list = surface.tree().surfels();
    std::vector<Vec3f> out;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = i < count / 2 ? i * list.size() / count : random.below(list.size());
        const double reach = i % 37 == 0 ? 1.0 : 0.05;
        out.push_back(list.items[at].position + base::cast<float>(random.unitVector() * reach));
    }
    return out;
}

void EvaluateTest::batchGivesTheBitsOfSingles() {
    for (const auto& frame : frameNames()) {
        const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.4, 0.04, 0.14), 0.01, 3),
                                                  definitionOf(frame.value, true));
        const std::vector<Vec3f> x = queries(surface, 3000);
        for (const Need need : {Need::Value, Need::Gradient}) {
            std::vector<Evaluationf> out(x.size());
            surface.evaluate(x, need, out);
            for (std::size_t i = 0; i < x.size(); ++i)
                QVERIFY2(sameEvaluation(out[i], surface.evaluate(x[i], need)),
                         qPrintable(QString("%1, query %2").arg(frame.name).arg(i)));
        }
    }
}

void EvaluateTest::threadsDoNotChangeBits() {
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.4, 0.04, 0.14), 0.01, 3));
    const std::vector<Vec3f> x = queries(surface, 3000);
    std::vector<Evaluationf> one(x.size()), two(x.size());
    std::vector<Projection<float>> oneFoot(x.size()), twoFoot(x.size());
    base::setThreadCount(1);
    surface.evaluate(x, Need::Gradient, one);
    project(surface, x, {}, oneFoot);
    base::setThreadCount(2);
    surface.evaluate(x, Need::Gradient, two);
    project(surface, x, {}, twoFoot);
    base::setThreadCount(0);
    for (std::size_t i = 0; i < x.size(); ++i) {
        QVERIFY(sameEvaluation(one[i], two[i]));
        QVERIFY(oneFoot[i].status == twoFoot[i].status && sameBits(oneFoot[i].foot, twoFoot[i].foot));
    }
}

void EvaluateTest::similarityMapsTheSurface() {
    const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.5, 0.08, 0.25), 0.02, test::seed());
    // the axes turned cyclically and scaled by a power of two: exact in float
    for (const float scale : {0.0009765625f, 1024.0f}) {
        surfel::SurfelList mapped = list;
        const auto map = [&](const auto& v) { return std::decay_t<decltype(v)>{v.z, v.x, v.y}; };
        for (surfel::Surfel& s : mapped.items) {
            s.position = map(s.position) * scale;
            s.normal = map(s.normal);
            s.support *= scale;
        }
        for (const auto& frame : frameNames()) {
            const Surface a = shapes::surfaceOf(list, definitionOf(frame.value, true));
            const Surface b = shapes::surfaceOf(mapped, definitionOf(frame.value, true));
            base::Random random(test::seed() + 3);
            for (int i = 0; i < 50; ++i) {
                const Vec3d x =
                    base::cast<double>(list.items[random.below(list.size())].position) + random.unitVector() * 0.03;
                const Evaluationd ea = a.evaluateReference(x, Need::Hessian);
                const Evaluationd eb = b.evaluateReference(map(x) * scale, Need::Hessian);
                QCOMPARE(ea.status, eb.status);
                if (!ea.ok())
                    continue;
                QVERIFY(std::abs(ea.value * scale - eb.value) <= 1e-11 * scale);
                QVERIFY(distance(map(ea.gradient), eb.gradient) <= 1e-9);
                QVERIFY(std::abs(trace(ea.hessian) / scale - trace(eb.hessian)) <= 1e-6 / scale);
                const Evaluationf fa = a.evaluate(base::cast<float>(x));
                const Evaluationf fb = b.evaluate(base::cast<float>(map(x) * scale));
                QVERIFY(std::abs(fa.value * scale - fb.value) <= 1e-4f * scale);
            }
        }
    }
}

void EvaluateTest::duplicatesChangeNothing() {
    const surfel::SurfelList list = shapes::torus(1, 0.5, 0.08, 0.25);
    surfel::SurfelList twice = list;
    twice.items.insert(twice.items.end(), list.items.begin(), list.items.end());
    const Surface a = shapes::surfaceOf(list), b = shapes::surfaceOf(twice);
    for (std::size_t i = 0; i < list.size(); i += 7) {
        const Vec3d x = base::cast<double>(list.items[i].position) * 1.02;
        const Evaluationd ea = a.evaluateReference(x), eb = b.evaluateReference(x);
        QVERIFY(std::abs(ea.value - eb.value) <= 1e-14);
        QVERIFY(distance(ea.gradient, eb.gradient) <= 1e-12);
    }
}

void EvaluateTest::platesKeepTheirSheets_data() {
    QTest::addColumn<double>("thickness");
    for (const double thickness : {3.0, 2.0, 1.5, 1.0})
        QTest::addRow("%g s", thickness) << thickness;
}

/// surface/README 2.7: with the symmetric form and the second pass the top sheet stays where it is.
void EvaluateTest::platesKeepTheirSheets() {
    QFETCH(double, thickness);
    const double s = 0.1, h = 0.35, half = 0.5 * thickness * s;
    const Surface surface = shapes::surfaceOf(shapes::plates(15, s, h, 2 * half));
    base::Random random(test::seed());
    for (int i = 0; i < 100; ++i) {
        const Vec3d x{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), half + random.uniform(-0.3, 0.8) * half};
        const Projection<double> p = projectReference(surface, x);
        QVERIFY2(p.ok(), statusName(p.status));
        QVERIFY2(std::abs(p.foot.z - half) <= 1e-3 * s, qPrintable(QString::number((p.foot.z - half) / s)));
        const Projection<float> f = project(surface, base::cast<float>(x));
        QVERIFY2(f.ok() && std::abs(double(f.foot.z) - half) <= 1e-3 * s, statusName(f.status));
    }
}

void EvaluateTest::curvatureOfSphereAndCylinder() {
    const double h = 0.4;
    const Surface sphere = shapes::surfaceOf(shapes::sphere(40000, 1, h), definitionOf(Frame::Normals));
    const Projection<double> p = projectReference(sphere, {0.3, 0.5, 0.8}, {.need = Need::Hessian});
    const Curvature c = curvatureOf(p.at);
    const double expected = 1 / length(p.foot);
    QVERIFY2(std::abs(c.k1 - expected) < 1e-3 && std::abs(c.k2 - expected) < 1e-3,
             qPrintable(QString("%1 %2 for %3").arg(c.k1).arg(c.k2).arg(expected)));
    surfel::SurfelList tube;
    tube.layout = shapes::layout(true, true);
    for (int i = 0; i < 200; ++i)
        for (int j = -40; j <= 40; ++j) {
            const double a = 2 * shapes::pi * i / 200;
            tube.items.push_back(
                shapes::surfelAt({std::cos(a), std::sin(a), j * 0.0314}, {std::cos(a), std::sin(a), 0}, h));
        }
    const Surface cylinder = shapes::surfaceOf(tube, definitionOf(Frame::Normals));
    const Projection<double> q = projectReference(cylinder, {0.9, 0.3, 0.02}, {.need = Need::Hessian});
    const Curvature k = curvatureOf(q.at);
    const double rho = std::hypot(q.foot.x, q.foot.y);
    QVERIFY(std::abs(rho - (1 - 5.0 / 144 * h * h)) < 1e-4);
    QVERIFY(std::abs(k.k1 - 1 / rho) < 1e-3 && std::abs(k.k2) < 1e-3);
    QVERIFY(std::abs(k.direction2.z) > 0.999);
}

static const test::Registered<EvaluateTest> registered;
#include "evaluate_test.moc"
