// Laws of the frames and weights that need no oracle: planes, spheres, edges, interpolation, symmetries (surface/README
// 2).
#include "core/surface/curvature.h"
#include "core/surface/definition_text.h"
#include "support/registry.h"
#include "surface/definition_rows.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;
using shapes::definitionOf, shapes::surfelAt;

class FramesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void planesAreExact_data();
    void planesAreExact();
    void spheresAreExactWithApss();
    void planesFittedByApssAreTheNormalsFrame();
    void flatnessIsNoSpecialCaseOfApss();
    void refitsKeepEdges();
    void refitsOfOneNormalChangeNothing();
    void interpolatingWeightsPassThroughThePoints_data();
    void interpolatingWeightsPassThroughThePoints();
    void interpolatingCurvatureAtASampleIsTheSumOfTheOthers();
    void orderAndMirrorsAndCopiesChangeNothing_data() { planesAreExact_data(); }
    void orderAndMirrorsAndCopiesChangeNothing();
};

void FramesTest::planesAreExact_data() {
    test::addDefinitionRows("interpolating");
}

static SurfaceDefinition fetched(bool shrinkFree) {
    QFETCH(int, frame);
    QFETCH(int, weight);
    QFETCH(bool, interpolating);
    SurfaceDefinition out = definitionOf(static_cast<Frame>(frame), shrinkFree, static_cast<Weight>(weight));
    out.interpolating = interpolating;
    return out;
}

/// Planes are exact (surface/README 2.4). The covariance about x is but nearly normal off the plane.
void FramesTest::planesAreExact() {
    const SurfaceDefinition definition = fetched(true);
    if (definition.frame == Frame::Covariance)
        return;
    surfel::SurfelList list = shapes::plane(12, 0.1, definition.weight == Weight::Gaussian ? 0.6 : 0.4);
    base::Random random(test::seed());
    for (surfel::Surfel& s : list.items) {
        s.position.x += static_cast<float>(random.uniform(-0.03, 0.03));
        s.position.y += static_cast<float>(random.uniform(-0.03, 0.03));
    }
    const Surface surface = shapes::surfaceOf(list, definition);
    for (int i = 0; i < 60; ++i) {
        const Vec3f at =
            base::cast<float>(Vec3d{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.15, 0.15)});
        const Vec3d x = base::cast<double>(at);
        const Evaluationd e = surface.evaluateReference(x, Need::Hessian);
        QVERIFY2(e.ok(), causeName(e.cause));
        QVERIFY2(std::abs(e.value - x.z) <= 1e-13, qPrintable(QString::number(e.value - x.z)));
        QVERIFY2(distance(e.gradient, Vec3d{0, 0, 1}) <= 1e-12,
                 qPrintable(QString::number(distance(e.gradient, {0, 0, 1}))));
        for (const auto& row : e.hessian.m)
            for (const double entry : row)
                QVERIFY2(std::abs(entry) <= 1e-9, qPrintable(QString::number(entry)));
        const Evaluationf f = surface.evaluate(at);
        QVERIFY2(f.ok() && std::abs(f.value - at.z) <= 1e-6f * 0.4f, qPrintable(QString::number(f.value - at.z)));
        QVERIFY2(distance(f.gradient, Vec3f{0, 0, 1}) <= (definition.interpolating ? 2e-4f : 2e-5f),
                 qPrintable(QString::number(distance(f.gradient, {0, 0, 1}))));
    }
}

/// All points of whole coordinates on a sphere of radius 255: exact in float, with normals scaled alike.
static surfel::SurfelList wholeSphere(float support) {
    surfel::SurfelList out;
    out.layout = shapes::layout(true, true);
    constexpr int radius = 255;
    for (int x = -radius; x <= radius; ++x)
        for (int y = -radius; y <= radius; ++y) {
            const int left = radius * radius - x * x - y * y;
            const int z = left < 0 ? -1 : static_cast<int>(std::lround(std::sqrt(left)));
            if (z < 0 || z * z != left)
                continue;
            for (const int side : {z, -z}) {
                const Vec3d p{double(x), double(y), double(side)};
                out.items.push_back(surfelAt(p, p / 256, support));
                if (z == 0)
                    break;
            }
        }
    return out;
}

/// "Exact on spheres with exact normals at any sampling" (surface/README 2.8).
void FramesTest::spheresAreExactWithApss() {
    base::Random random(test::seed());
    for (const auto& weight : weightNames()) {
        const surfel::SurfelList list = wholeSphere(weight.value == Weight::Gaussian ? 220.0f : 150.0f);
        const Surface surface = shapes::surfaceOf(list, definitionOf(Frame::Apss, true, weight.value));
        for (int i = 0; i < 50; ++i) {
            const Vec3d out = random.unitVector(), x = out * random.uniform(200, 310);
            const Evaluationd e = surface.evaluateReference(x, Need::Hessian);
            QVERIFY(e.ok());
            QVERIFY2(std::abs(e.value - (length(x) - 255)) <= 1e-10, qPrintable(QString::number(e.value)));
            QVERIFY(distance(e.gradient, out) <= 1e-11 && distance(e.normal, out) <= 1e-11);
            const Curvature c = curvatureOf(e);
            QVERIFY2(std::abs(c.k1 * length(x) - 1) <= 1e-9 && std::abs(c.k2 * length(x) - 1) <= 1e-9,
                     qPrintable(QString::number(c.k1 * length(x))));
            const Evaluationf f = surface.evaluate(base::cast<float>(x));
            QVERIFY2(std::abs(double(f.value) - e.value) <= 2e-6 * 255, qPrintable(QString::number(f.value)));
        }
    }
}

/// beta = 0: f = n.(x - c) with n = sum theta n_i, normalised, which is the definition of the normals frame at mu = 0.
void FramesTest::planesFittedByApssAreTheNormalsFrame() {
    const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.45, 0.08, 0.3), 0.02, test::seed());
    SurfaceDefinition flat = definitionOf(Frame::Apss);
    flat.apssBeta = 0;
    const Surface a = shapes::surfaceOf(list, flat), b = shapes::surfaceOf(list, definitionOf(Frame::Normals));
    for (std::size_t i = 0; i < list.size(); i += 31) {
        const Vec3d x = base::cast<double>(list.items[i].position) * 1.01;
        const Evaluationd p = a.evaluateReference(x, Need::Hessian), n = b.evaluateReference(x, Need::Hessian);
        QVERIFY(std::abs(p.value - n.value) <= 1e-14 && distance(p.gradient, n.gradient) <= 1e-12);
        QVERIFY(std::abs(trace(p.hessian) - trace(n.hessian)) <= 1e-9);
    }
}

/// f goes over into the plane's without a step or a lost digit as the fitted spheres grow: the same model, bent less
/// and less, has f - z = O(1/R), and derivatives that stay finite.
void FramesTest::flatnessIsNoSpecialCaseOfApss() {
    const double h = 0.4;
    for (double radius = 1e1; radius < 1e16; radius *= 10) {
        surfel::SurfelList list = shapes::plane(10, 0.1, h);
        for (surfel::Surfel& s : list.items) {
            const Vec3d p = base::cast<double>(s.position);
            s = surfelAt({p.x, p.y, -(p.x * p.x + p.y * p.y) / (2 * radius)},
                         base::normalized(Vec3d{p.x / radius, p.y / radius, 1}), h);
        }
        const Surface surface = shapes::surfaceOf(list, definitionOf(Frame::Apss));
        const Vec3d x{0.01, 0.02, 0.05};
        const Evaluationd e = surface.evaluateReference(x, Need::Hessian);
        QVERIFY(e.ok());
        QVERIFY2(std::abs(e.value - x.z) <= 0.01 / radius + 1e-8, qPrintable(QString::number(e.value - x.z)));
        const Curvature c = curvatureOf(e);
        QVERIFY2(std::abs(c.k1 - 1 / radius) <= 0.1 / radius + 1e-5, qPrintable(QString::number(c.k1)));
        const Evaluationf f = surface.evaluate(base::cast<float>(x));
        QVERIFY(f.ok() && std::abs(double(f.value) - e.value) <= 1e-6 * h);
    }
}

/// Two planes that meet at a right angle: one spacing beside the edge the other plane pulls f by exp(-|n - n'|^2 /
/// sigma^2) of what it would without factors (surface/README 2.9): below 1 % for a sharp sigma, below 10 % for the
/// default.
void FramesTest::refitsKeepEdges() {
    const double s = 0.1, h = 0.35;
    surfel::SurfelList list;
    list.layout = shapes::layout(true, true);
    for (int i = 0; i < 20; ++i)
        for (int j = -15; j <= 15; ++j) {
            list.items.push_back(surfelAt({-(i + 0.5) * s, j * s, 0}, {0, 0, 1}, h));
            list.items.push_back(surfelAt({0, j * s, -(i + 0.5) * s}, {1, 0, 0}, h));
        }
    const auto error = [&](float sigma, double beside) {
        SurfaceDefinition d = definitionOf(Frame::Rimls);
        d.rimlsSigma = sigma;
        const Surface surface = shapes::surfaceOf(list, d);
        const Vec3d x{-beside * s, 0.03, 0};
        const double value = surface.evaluateReference(x).value;
        const Evaluationf f = surface.evaluate(base::cast<float>(x));
        return std::abs(double(f.value) - value) > 1e-6 * h ? 1e9 : std::abs(value);
    };
    for (const double beside : {0.5, 1.0, 1.5, 2.0}) {
        const double plain = error(1e3f, beside);
        QVERIFY2(plain > 0.05 * s, qPrintable(QString::number(plain / s)));
        QVERIFY2(error(0.5f, beside) < 0.01 * plain, qPrintable(QString::number(error(0.5f, beside) / plain)));
        QVERIFY2(error(0.8f, beside) < 0.12 * plain, qPrintable(QString::number(error(0.8f, beside) / plain)));
    }
}

/// Where all normals agree with g the factors are all the same: the sum of heights, mu = 1 of surface/README 2.6.
void FramesTest::refitsOfOneNormalChangeNothing() {
    surfel::SurfelList list = shapes::plane(12, 0.1, 0.35);
    base::Random random(test::seed());
    for (surfel::Surfel& s : list.items)
        s.position.z = static_cast<float>(random.uniform(-0.02, 0.02));
    SurfaceDefinition sharp = definitionOf(Frame::Rimls), dull = sharp;
    sharp.rimlsSigma = 0.3f;
    dull.rimlsSigma = 1e4f;
    const Surface a = shapes::surfaceOf(list, sharp), b = shapes::surfaceOf(list, dull);
    for (int i = 0; i < 50; ++i) {
        const Vec3d x{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.1, 0.1)};
        QVERIFY(std::abs(a.evaluateReference(x).value - b.evaluateReference(x).value) <= 1e-14);
    }
}

void FramesTest::interpolatingWeightsPassThroughThePoints_data() {
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("weight");
    for (const auto& frame : frameNames())
        for (const auto& weight : weightNames())
            QTest::addRow("%s %s", frame.name, weight.name)
                << static_cast<int>(frame.value) << static_cast<int>(weight.value);
}

/// f(p_i) = 0 and n(p_i) = g(p_i) = n_i (surface/README 2.10), at the points and in the limit towards them. Covariances
/// of weights that grow like 1/r^2 have no limit there: what they hold depends on the way; only f goes to zero.
void FramesTest::interpolatingWeightsPassThroughThePoints() {
    QFETCH(int, frame);
    QFETCH(int, weight);
    const Frame kind = static_cast<Frame>(frame);
    SurfaceDefinition definition = definitionOf(kind, true, static_cast<Weight>(weight));
    definition.interpolating = true;
    const double h = definition.weight == Weight::Gaussian ? 0.45 : 0.3;
    const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.45, 0.085, h), 0.01, test::seed());
    const Surface surface = shapes::surfaceOf(list, definition);
    const bool limit =
        kind == Frame::Normals || kind == Frame::Hyperplanes || kind == Frame::Apss || kind == Frame::Rimls;
    base::Random random(test::seed() + 1);
    for (std::size_t i = 0; i < list.size(); i += 41) {
        const surfel::Surfel& s = list.items[i];
        const Vec3d p = base::cast<double>(s.position), n = base::normalized(base::cast<double>(s.normal));
        const Evaluationd e = surface.evaluateReference(p);
        const Evaluationf f = surface.evaluate(s.position);
        QVERIFY(e.ok() && f.ok());
        QVERIFY(e.value == 0 && f.value == 0 && e.centroid == p && f.centroid == s.position);
        QVERIFY(distance(e.normal, n) <= 1e-14 && distance(e.gradient, n) <= 1e-14);
        QVERIFY(distance(base::cast<double>(f.gradient), n) <= 1e-6);
        const Evaluationd near = surface.evaluateReference(p + random.unitVector() * (1e-4 * h));
        if (kind == Frame::CentroidGradient && !near.ok()) // c - p_i = r^2 A + O(r^3): grad c has nearly rank one
            continue;
        QVERIFY2(near.ok() && std::abs(near.value) <= 2e-4 * h, qPrintable(QString::number(near.value / h)));
        if (limit)
            QVERIFY2(distance(near.gradient, n) <= 5e-3, qPrintable(QString::number(distance(near.gradient, n))));
    }
}

/// On a sphere of radius 1 the surface through a sample bends there by sum theta_j over all others (mu = 0, frames
/// whose normal is the sample's): c - p_i = r^2 sum theta_j (p_j - p_i) / r_j^2 + O(r^3).
void FramesTest::interpolatingCurvatureAtASampleIsTheSumOfTheOthers() {
    const double h = 0.4;
    const surfel::SurfelList list = shapes::sphere(800, 1, h);
    SurfaceDefinition definition = definitionOf(Frame::Normals);
    definition.interpolating = true;
    const Surface surface = shapes::surfaceOf(list, definition);
    for (std::size_t i = 0; i < list.size(); i += 97) {
        const Vec3d p = base::cast<double>(list.items[i].position);
        double expected = 0;
        for (std::size_t j = 0; j < list.size(); ++j)
            if (const double r = distance(base::cast<double>(list.items[j].position), p) / double(float(h));
                j != i && r < 1)
                expected += std::pow(1 - r, 4) * (4 * r + 1);
        const Curvature c = curvatureOf(surface.evaluateReference(p, Need::Hessian));
        QVERIFY2(std::abs(c.k1 - expected) <= 2e-2 * expected && std::abs(c.k2 - expected) <= 2e-2 * expected,
                 qPrintable(QString("%1 %2 instead of %3").arg(c.k1).arg(c.k2).arg(expected)));
    }
}

/// Order, mirror images and copies of samples change only rounding (surface/README 1.2).
void FramesTest::orderAndMirrorsAndCopiesChangeNothing() {
    const SurfaceDefinition definition = fetched(true);
    const double h = definition.weight == Weight::Gaussian ? 0.45 : 0.3;
    const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.45, 0.085, h), 0.02, test::seed());
    surfel::SurfelList shuffled = list, mirrored = list, twice = list;
    base::Random random(test::seed() + 2);
    for (std::size_t i = list.size(); i > 1; --i)
        std::swap(shuffled.items[i - 1], shuffled.items[random.below(i)]);
    for (surfel::Surfel& s : mirrored.items)
        s.position.x = -s.position.x, s.normal.x = -s.normal.x;
    twice.items.insert(twice.items.end(), shuffled.items.begin(), shuffled.items.end());
    const Surface a = shapes::surfaceOf(list, definition), b = shapes::surfaceOf(shuffled, definition);
    const Surface c = shapes::surfaceOf(mirrored, definition), d = shapes::surfaceOf(twice, definition);
    int compared = 0;
    for (std::size_t i = 0; i < list.size(); i += 37) {
        const Vec3d x = base::cast<double>(list.items[i].position) + random.unitVector() * 0.02;
        const Evaluationd ea = a.evaluateReference(x, Need::Hessian);
        const Evaluationd others[] = {b.evaluateReference(x, Need::Hessian),
                                      c.evaluateReference({-x.x, x.y, x.z}, Need::Hessian),
                                      d.evaluateReference(x, Need::Hessian)};
        for (const Evaluationd& e : others) {
            QVERIFY2(e.status == ea.status && e.cause == ea.cause, causeName(e.cause));
            if (!ea.ok())
                continue;
            // eigenvectors amplify rounding by one over their gap, which the normal's gradient tells
            const double turn = 1 + std::abs(trace(ea.normalGradient * transposed(ea.normalGradient))) * h * h;
            QVERIFY2(std::abs(e.value - ea.value) <= 1e-13 * turn, qPrintable(QString::number(e.value - ea.value)));
            QVERIFY(std::abs(std::abs(e.gradient.x) - std::abs(ea.gradient.x)) <= 1e-11 * turn);
            QVERIFY(std::abs(e.gradient.y - ea.gradient.y) <= 1e-11 * turn);
            QVERIFY(std::abs(trace(e.hessian) - trace(ea.hessian)) <= 1e-8 * turn * turn);
            ++compared;
        }
    }
    QVERIFY2(compared > 60, qPrintable(QString::number(compared)));
}

static const test::Registered<FramesTest> registered;
#include "frames_test.moc"
