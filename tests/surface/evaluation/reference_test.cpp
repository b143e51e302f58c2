// The reference against an independent brute force, and its derivatives against finite differences.
#include "core/surface/definition_text.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "surface/projection/brute_feet.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d;

class ReferenceTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
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
                    const bool own = frame.value == Frame::Apss || frame.value == Frame::Rimls;
                    const bool summed = own || frame.value == Frame::Normals;
                    const bool planes = frame.value == Frame::Hyperplanes;
                    if (own && shrinkFree)
                        continue; // mu has no part in them
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
    const int tries = test::effort(60);
    for (int i = 0; i < tries; ++i) {
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
    QVERIFY2(6 * compared >= 5 * tries, qPrintable(QString("only %1 were valid").arg(compared)));
}

void ReferenceTest::orthogonalFeetAgreeWithBruteForce() {
    for (const auto frame : {Frame::Normals, Frame::Hyperplanes, Frame::CovarianceAtCentroid}) {
        SurfaceDefinition definition;
        definition.frame = frame;
        const surfel::SurfelList list = model(true, true);
        const Surface surface = shapes::surfaceOf(list, definition);
        const brute::Model all = brute::modelOf(list, definition);
        base::Random random(test::seed() + 3);
        for (int i = 0; i < test::effort(20); ++i) {
            const Vec3d x = nearTorus(random, 0.05);
            const Projection<double> p = projectReference(surface, x);
            Vec3d foot;
            QVERIFY(brute::project(all, x, Projector::Orthogonal, foot));
            QVERIFY2(p.ok(), statusName(p.status));
            QVERIFY2(distance(p.foot, foot) <= 1e-9 * support,
                     qPrintable(QString("%1, round %2: %3").arg(nameOf(frame)).arg(i).arg(distance(p.foot, foot))));
        }
    }
}

/// Compares derivatives of the reference with differences of brute force's f, gradient and normal of the same branch,
/// at places where the frame's gap is not about to close; the worst relative error is held to `bound`.
struct Differences {
    Surface surface = shapes::surfaceOf(fetchModel(), fetchDefinition());
    brute::Model all = brute::modelOf(fetchModel(), fetchDefinition());
    base::Random random{test::seed() + 4};
    const double step = 2e-4 * support;
    const int most = test::sanitized ? 2 : 8;
    int compared = 0;
    double worst = 0;

    template <class Fn>
    void compare(Need need, const Fn& errorAt) {
        for (int i = 0; i < 40 && compared < most; ++i) {
            const Vec3d x = nearTorus(random, 0.06);
            const Evaluationd e = surface.evaluateReference(x, need);
            if (!e.ok())
                continue;
            double turning = 0;
            for (const auto& row : e.normalGradient.m)
                for (const double entry : row)
                    turning = std::max(turning, std::abs(entry));
            if (turning * support > 10)
                continue;
            const brute::Answer at = brute::evaluate(all, x, e.normal);
            if (at.sphere < 0.05 || brute::stepsNear(all, at, x, step))
                continue;
            ++compared;
            worst = std::max(worst, errorAt(x, e, at));
        }
    }
    void verify(double bound) const {
        QVERIFY2(compared >= std::min(most, 6), qPrintable(QString::number(compared)));
        QVERIFY2(worst <= bound, qPrintable(QString("%1, seed %2").arg(worst).arg(test::seed())));
    }
};

void ReferenceTest::gradientIsTheDerivativeOfTheValue() {
    Differences d;
    d.compare(Need::Gradient, [&](const Vec3d& x, const Evaluationd& e, const brute::Answer& at) {
        double error = 0;
        for (int k = 0; k < 3; ++k) {
            const double slope =
                brute::difference([&](const Vec3d& y) { return brute::beside(d.all, at, y).f; }, x, k, d.step);
            error = std::max(error, std::abs(slope - e.gradient[static_cast<std::size_t>(k)]));
        }
        return error;
    });
    d.verify(2e-10);
}

void ReferenceTest::hessianIsTheDerivativeOfTheGradient() {
    Differences d;
    d.compare(Need::Hessian, [&](const Vec3d& x, const Evaluationd& e, const brute::Answer& at) {
        const base::Mat3d expected = brute::hessian(d.all, x, at, d.step);
        double error = 0, scale = 1 / support;
        for (int a = 0; a < 3; ++a)
            for (int k = 0; k < 3; ++k) {
                error = std::max(error, std::abs(expected[a][k] - e.hessian[a][k]));
                scale = std::max(scale, std::abs(expected[a][k]));
            }
        return error / scale;
    });
    const Weight weight = fetchDefinition().weight;
    d.verify(weight == Weight::Wendland ? 3e-7 : weight == Weight::WendlandC4 ? 3e-9 : 3e-11);
}

void ReferenceTest::normalGradientIsTheDerivativeOfTheNormal() {
    Differences d;
    d.compare(Need::Gradient, [&](const Vec3d& x, const Evaluationd& e, const brute::Answer& at) {
        double error = 0;
        for (int k = 0; k < 3; ++k) {
            const Vec3d turn =
                brute::difference([&](const Vec3d& y) { return brute::beside(d.all, at, y).n; }, x, k, d.step);
            for (std::size_t a = 0; a < 3; ++a)
                error = std::max(error, std::abs(turn[a] - e.normalGradient.m[a][k]) * support);
        }
        return error;
    });
    d.verify(2e-9);
}

static const test::Registered<ReferenceTest> registered;
#include "reference_test.moc"
