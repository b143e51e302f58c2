// The reference against an independent brute force, and its derivatives against finite differences.
#include "brute_force.h"
#include "core/surface/definition_text.h"
#include "shapes.h"
#include "support/registry.h"

#include <QtTest>

using namespace surface;
using base::Vec3d;

class ReferenceTest : public QObject {
    Q_OBJECT
  private slots:
    void agreesWithBruteForce_data();
    void agreesWithBruteForce();
    void orthogonalFeetAgreeWithBruteForce();
    void gradientIsTheDerivativeOfTheValue_data() { agreesWithBruteForce_data(); }
    void gradientIsTheDerivativeOfTheValue();
    void hessianIsTheDerivativeOfTheGradient_data() { agreesWithBruteForce_data(); }
    void hessianIsTheDerivativeOfTheGradient();
    void normalGradientIsTheDerivativeOfTheNormal_data() { agreesWithBruteForce_data(); }
    void normalGradientIsTheDerivativeOfTheNormal();
};

static constexpr double support = 0.3;

/// A jittered torus with noisy normals: nothing is symmetric, everything is in play.
static surfel::SurfelList model(bool normals, bool oriented) {
    surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.45, 0.085, support), 0.02, test::seed());
    base::Random random(test::seed() + 1);
    for (surfel::Surfel& s : list.items) {
        s.support *= static_cast<float>(random.uniform(0.9, 1.2));
        if (!normals)
            s.normal = {};
        else if (!oriented && random.uniform() < 0.5)
            s.normal = -s.normal;
    }
    list.layout = shapes::layout(normals, oriented);
    return list;
}

static Vec3d nearTorus(base::Random& random, double reach) {
    const double u = random.uniform(0, 2 * shapes::pi), v = random.uniform(0, 2 * shapes::pi);
    const double minor = 0.45 + random.uniform(-reach, reach), ring = 1 + minor * std::cos(v);
    return {ring * std::cos(u), ring * std::sin(u), minor * std::sin(v)};
}

void ReferenceTest::agreesWithBruteForce_data() {
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("weight");
    QTest::addColumn<bool>("shrinkFree");
    QTest::addColumn<bool>("normals");
    QTest::addColumn<bool>("oriented");
    for (const auto& frame : frameNames())
        for (const auto& weight : weightNames())
            for (const bool shrinkFree : {false, true})
                for (const int normals : {0, 1, 2}) { // none, unoriented, oriented
                    const bool summed = frame.value == Frame::Normals, planes = frame.value == Frame::Hyperplanes;
                    if ((summed && normals < 2) || (planes && normals < 1))
                        continue;
                    QTest::addRow("%s %s mu=%d normals=%d", frame.name, weight.name, shrinkFree, normals)
                        << static_cast<int>(frame.value) << static_cast<int>(weight.value) << shrinkFree
                        << (normals > 0) << (normals > 1);
                }
}

static SurfaceDefinition fetchDefinition() {
    QFETCH(int, frame);
    QFETCH(int, weight);
    QFETCH(bool, shrinkFree);
    SurfaceDefinition d;
    d.frame = static_cast<Frame>(frame);
    d.weight = static_cast<Weight>(weight);
    d.shrinkFree = shrinkFree;
    return d;
}

/// The Gaussian has the same second moment at 1.6 times the reach.
static surfel::SurfelList fetchModel() {
    QFETCH(bool, normals);
    QFETCH(bool, oriented);
    surfel::SurfelList list = model(normals, oriented);
    if (fetchDefinition().weight == Weight::Gaussian)
        for (surfel::Surfel& s : list.items)
            s.support *= 1.6f;
    return list;
}

void ReferenceTest::agreesWithBruteForce() {
    const SurfaceDefinition definition = fetchDefinition();
    const surfel::SurfelList list = fetchModel();
    const Surface surface = shapes::surfaceOf(list, definition);
    const brute::Model all = brute::modelOf(list, definition);
    base::Random random(test::seed() + 2);
    int compared = 0;
    for (int i = 0; i < 60; ++i) {
        const Vec3d x = nearTorus(random, 0.06);
        const Vec3d hint = random.unitVector();
        const Evaluationd e = surface.evaluateReference(x, Need::Gradient, {base::cast<float>(hint)});
        const brute::Answer b = brute::evaluate(all, x, base::cast<double>(base::cast<float>(hint)));
        if (!e.ok())
            continue;
        ++compared;
        const double h = b.unit;
        const QString where = QString("round %1, seed %2").arg(i).arg(test::seed());
        QVERIFY(b.valid);
        QCOMPARE(e.samples, b.samples);
        QVERIFY2(std::abs(e.unit - b.unit) <= 1e-12 * h, qPrintable(where));
        QVERIFY2(distance(e.centroid, b.c) <= 1e-12 * h && std::abs(e.offCentre - b.o) <= 1e-12 * h, qPrintable(where));
        QVERIFY2(std::abs(e.value - b.f) <= 1e-9 * h, qPrintable(where));
        QVERIFY2(distance(e.normal, b.n) <= 1e-9, qPrintable(where));
        QVERIFY2(distance(e.gradient, b.g) <= 1e-9, qPrintable(where));
        QVERIFY2(std::abs(e.agreement - b.agreement) <= 1e-9, qPrintable(where));
    }
    QVERIFY2(compared >= 50, qPrintable(QString("only %1 were valid").arg(compared)));
}

void ReferenceTest::orthogonalFeetAgreeWithBruteForce() {
    for (const auto frame : {Frame::Normals, Frame::Hyperplanes, Frame::CovarianceAtCentroid}) {
        SurfaceDefinition definition;
        definition.frame = frame;
        const surfel::SurfelList list = model(true, true);
        const Surface surface = shapes::surfaceOf(list, definition);
        const brute::Model all = brute::modelOf(list, definition);
        base::Random random(test::seed() + 3);
        for (int i = 0; i < 20; ++i) {
            const Vec3d x = nearTorus(random, 0.05);
            const Projection<double> p = projectReference(surface, x);
            Vec3d foot;
            QVERIFY(brute::projectOrthogonally(all, x, foot));
            QVERIFY2(p.ok(), statusName(p.status));
            QVERIFY2(distance(p.foot, foot) <= 1e-9 * support,
                     qPrintable(QString("%1, round %2: %3").arg(nameOf(frame)).arg(i).arg(distance(p.foot, foot))));
        }
    }
}

static Vec3d axis(int k, double by) {
    return {k == 0 ? by : 0, k == 1 ? by : 0, k == 2 ? by : 0};
}

void ReferenceTest::gradientIsTheDerivativeOfTheValue() {
    const Surface surface = shapes::surfaceOf(fetchModel(), fetchDefinition());
    base::Random random(test::seed() + 4);
    const double step = 1e-4 * support;
    int compared = 0;
    for (int i = 0; i < 20; ++i) {
        const Vec3d x = nearTorus(random, 0.06);
        const Evaluationd e = surface.evaluateReference(x);
        if (!e.ok())
            continue;
        ++compared;
        const Hint hint{base::cast<float>(e.normal)};
        for (int k = 0; k < 3; ++k) {
            const double after = surface.evaluateReference(x + axis(k, step), Need::Value, hint).value;
            const double before = surface.evaluateReference(x - axis(k, step), Need::Value, hint).value;
            const double slope = (after - before) / (2 * step), expected = e.gradient[static_cast<std::size_t>(k)];
            QVERIFY2(std::abs(slope - expected) <= 2e-6,
                     qPrintable(QString("%1 instead of %2, round %3").arg(expected).arg(slope).arg(i)));
        }
    }
    QVERIFY(compared >= 15);
}

void ReferenceTest::hessianIsTheDerivativeOfTheGradient() {
    const Surface surface = shapes::surfaceOf(fetchModel(), fetchDefinition());
    base::Random random(test::seed() + 5);
    const double step = 1e-5 * support;
    int compared = 0;
    for (int i = 0; i < 20; ++i) {
        const Vec3d x = nearTorus(random, 0.06);
        const Evaluationd e = surface.evaluateReference(x, Need::Hessian);
        if (!e.ok())
            continue;
        ++compared;
        const Hint hint{base::cast<float>(e.normal)};
        double scale = 1 / support;
        for (const auto& row : e.hessian.m)
            for (const double entry : row)
                scale = std::max(scale, std::abs(entry));
        for (int k = 0; k < 3; ++k) {
            const Vec3d after = surface.evaluateReference(x + axis(k, step), Need::Gradient, hint).gradient;
            const Vec3d before = surface.evaluateReference(x - axis(k, step), Need::Gradient, hint).gradient;
            for (std::size_t a = 0; a < 3; ++a) {
                const double slope = (after[a] - before[a]) / (2 * step), expected = e.hessian.m[a][k];
                QVERIFY2(std::abs(slope - expected) <= 2e-5 * scale,
                         qPrintable(QString("%1 instead of %2, round %3").arg(expected).arg(slope).arg(i)));
            }
        }
    }
    QVERIFY(compared >= 15);
}

void ReferenceTest::normalGradientIsTheDerivativeOfTheNormal() {
    const Surface surface = shapes::surfaceOf(fetchModel(), fetchDefinition());
    base::Random random(test::seed() + 6);
    const double step = 1e-4 * support;
    for (int i = 0; i < 10; ++i) {
        const Vec3d x = nearTorus(random, 0.05);
        const Evaluationd e = surface.evaluateReference(x);
        if (!e.ok())
            continue;
        const Hint hint{base::cast<float>(e.normal)};
        for (int k = 0; k < 3; ++k) {
            const Vec3d after = surface.evaluateReference(x + axis(k, step), Need::Value, hint).normal;
            const Vec3d before = surface.evaluateReference(x - axis(k, step), Need::Value, hint).normal;
            for (std::size_t a = 0; a < 3; ++a) {
                const double slope = (after[a] - before[a]) / (2 * step), expected = e.normalGradient.m[a][k];
                QVERIFY2(std::abs(slope - expected) <= 1e-5 * (1 / support + std::abs(expected)),
                         qPrintable(QString("%1 instead of %2").arg(expected).arg(slope)));
            }
        }
    }
}

static const test::Registered<ReferenceTest> registered;
#include "reference_test.moc"
