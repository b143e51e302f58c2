// Ellipsoidal supports: sums against plain loops, balls as ellipsoids, float beside the reference, and derivatives
// against differences.
#include "core/surface/evaluation/self.h"
#include "core/surface/evaluation/weights.h"
#include "support/registry.h"
#include "surface/definition_rows.h"
#include "surface/ellipsoids.h"
#include "surface/moving_axis.h"

#include <hwy/targets.h>
#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f, base::Mat3d;
using shapes::sameBits;

class EllipsoidsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void ballsAsEllipsoidsHaveTheSameBits_data() { test::addDefinitionRows("oriented"); }
    void ballsAsEllipsoidsHaveTheSameBits();
    void selfEvaluationOfBallsHasTheSameBits();
    void sumsAreThoseOfPlainLoops_data();
    void sumsAreThoseOfPlainLoops();
    void weightsAreThoseOfTheSums();
    void gradientsAndHessiansAreDerivatives_data() { test::addDefinitionRows("oriented"); }
    void gradientsAndHessiansAreDerivatives();
    void floatIsTheReferenceRounded_data() { test::addDefinitionRows("oriented"); }
    void floatIsTheReferenceRounded();
    void selfEvaluationIsEvaluation();
    void instructionSetsGiveTheSameBits();
    void positionsAreSummedWhateverIsAround();
};

namespace {

SurfaceDefinition definitionOf(int frame, int weight, bool interpolating = false) {
    SurfaceDefinition out;
    out.frame = static_cast<Frame>(frame);
    out.weight = static_cast<Weight>(weight);
    out.interpolating = interpolating;
    return out;
}

surfel::SurfelList torus(double aspect, bool gaussian = false) {
    return shapes::ellipsoids(shapes::jittered(shapes::torus(1, 0.4, 0.08, gaussian ? 0.45 : 0.26), 0.01, test::seed()),
                              aspect, test::seed() + 1);
}

surfel::SurfelList unoriented(surfel::SurfelList list) {
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->oriented = false;
    list.layout = layout;
    return list;
}

template <class T>
bool same(const Evaluation<T>& a, const Evaluation<T>& b) {
    return a.status == b.status && a.cause == b.cause && a.samples == b.samples && sameBits(a.value, b.value) &&
           sameBits(a.unit, b.unit) && sameBits(a.offCentre, b.offCentre) && a.agreement == b.agreement &&
           sameBits(a.normal, b.normal) && sameBits(a.gradient, b.gradient) && sameBits(a.hessian, b.hessian) &&
           sameBits(a.centroid, b.centroid) && sameBits(a.normalGradient, b.normalGradient);
}

/// phi, phi' and phi'' of the three weights, by r = distance / support.
struct Radial {
    double v, d, dd;
};
Radial radial(Weight weight, double r) {
    const double t = 1 - r, k = double(gaussianReach) * double(gaussianReach);
    if (weight == Weight::Wendland)
        return {std::pow(t, 4) * (4 * r + 1), -20 * r * std::pow(t, 3), 20 * t * t * (4 * r - 1)};
    if (weight == Weight::WendlandC4)
        return {std::pow(t, 6) * (35 * r * r + 18 * r + 3) / 3, -56.0 / 3 * r * std::pow(t, 5) * (5 * r + 1),
                -56.0 / 3 * std::pow(t, 4) * (1 + 4 * r - 35 * r * r)};
    const double v = std::exp(-k * r * r);
    return {v, -2 * k * r * v, (4 * k * k * r * r - 2 * k) * v};
}

struct PlainSums {
    int samples = 0;
    double unit = 0, value[9] = {}, slope[9][3] = {}, bend[9][6] = {};
    double sizeV[9] = {}, sizeD[9] = {}, sizeDD[9] = {}; ///< of what was added
};

/// A loop over all surfels with the metric as a matrix: r = |M^1/2 q| / h by the chain rule.
PlainSums plainSums(const surfel::SurfelList& list, const Vec3f& x, Weight weight, double scale) {
    PlainSums out;
    const std::size_t word = surfel::shapeWord(*list.layout);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const surfel::Surfel& s = list.items[i];
        const Vec3d b = base::cast<double>(surfel::shapeIn(list.extraOf(i), word)), n = base::cast<double>(s.normal);
        const Vec3d q = base::cast<double>(s.position) - base::cast<double>(x);
        const double h = scale * double(s.support);
        const Mat3d m = (Mat3d::identity() + base::outer(b, b)) * (1 / (h * h));
        const Vec3d mq = m * q;
        const double r = std::sqrt(dot(q, mq));
        if (!(r < 1))
            continue;
        const Radial w = radial(weight, r);
        if (!(w.v > 0))
            continue;
        ++out.samples;
        const double unit = h * std::pow(1 + lengthSq(b), -0.25);
        out.unit += w.v * (weight == Weight::Gaussian ? unit / double(gaussianReach) : unit);
        const double terms[9] = {1, q.x, q.y, q.z, n.x, n.y, n.z, dot(n, q), lengthSq(q)};
        for (std::size_t t = 0; t < 9; ++t) {
            out.value[t] += w.v * terms[t], out.sizeV[t] += std::abs(w.v * terms[t]);
            for (std::size_t k = 0; k < 3; ++k) {
                const double rk = -mq[k] / r;
                out.slope[t][k] += w.d * rk * terms[t];
                out.sizeD[t] += std::abs(w.d * terms[t]) / h * (1 + lengthSq(b));
                for (std::size_t l = k; l < 3; ++l) {
                    const double rl = -mq[l] / r, rkl = (m.m[k][l] - rk * rl) / r;
                    const auto kl = static_cast<std::size_t>(sym(int(k), int(l)));
                    out.bend[t][kl] += (w.dd * rk * rl + w.d * rkl) * terms[t];
                }
            }
            out.sizeDD[t] += std::abs(terms[t]) * (std::abs(w.dd) + std::abs(w.d / r)) / (h * h) * (1 + lengthSq(b));
        }
    }
    return out;
}

template <class T>
QString difference(const Moments<T, 2>& a, const PlainSums& b, double tolerance) {
    if (a.samples != b.samples)
        return QString("samples %1, not %2").arg(a.samples).arg(b.samples);
    if (std::abs(double(a.unit) - b.unit) > tolerance * b.unit)
        return "unit";
    const Jet<T, 2>* jets[9] = {&a.one, &a.q[0], &a.q[1], &a.q[2], &a.n[0], &a.n[1], &a.n[2], &a.height, &a.square};
    for (std::size_t t = 0; t < 9; ++t) {
        bool good = std::abs(double(jets[t]->v) - b.value[t]) <= tolerance * b.sizeV[t] + 1e-30;
        for (std::size_t k = 0; k < 3; ++k)
            good &= std::abs(double(jets[t]->d[k]) - b.slope[t][k]) <= tolerance * b.sizeD[t] + 1e-30;
        for (std::size_t k = 0; k < 6; ++k)
            good &= std::abs(double(jets[t]->dd[k]) - b.bend[t][k]) <= tolerance * b.sizeDD[t] + 1e-30;
        if (!good)
            return QString("sum %1").arg(t);
    }
    return {};
}

} // namespace

void EllipsoidsTest::ballsAsEllipsoidsHaveTheSameBits() {
    QFETCH(int, frame);
    QFETCH(int, weight);
    QFETCH(bool, oriented);
    surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.08, 0.28), 0.01, test::seed());
    if (!oriented)
        list = unoriented(std::move(list));
    base::Random random(test::seed());
    for (const bool interpolating : {false, true}) {
        const SurfaceDefinition definition = definitionOf(frame, weight, interpolating);
        const Surface plain = shapes::surfaceOf(list, definition);
        const Surface shaped = shapes::surfaceOf(shapes::balls(list), definition);
        for (int i = 0; i < test::effort(40); ++i) {
            const Vec3f x = shapes::beside(list, random, 0.15);
            for (const Need need : {Need::Value, Need::Gradient, Need::Hessian}) {
                QVERIFY(same(plain.evaluate(x, need), shaped.evaluate(x, need)));
                QVERIFY(same(plain.evaluateReference(base::cast<double>(x), need),
                             shaped.evaluateReference(base::cast<double>(x), need)));
            }
        }
    }
}

void EllipsoidsTest::selfEvaluationOfBallsHasTheSameBits() {
    for (const Weight weight : {Weight::Wendland, Weight::WendlandC4, Weight::Gaussian}) {
        const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.08, 0.28), 0.01, test::seed());
        const Surface plain = shapes::surfaceOf(list, definitionOf(0, int(weight)));
        const Surface shaped = shapes::surfaceOf(shapes::balls(list), definitionOf(0, int(weight)));
        const auto all = [](const Surface& surface) {
            std::vector<std::vector<float>> out(surface.tree().blockCount());
            evaluateSelf(surface, Need::Gradient,
                         [&](std::uint32_t number, const surfel::SurfelBlock& block, std::span<const SelfLanes> at) {
                             for (int slot = 0; slot < block.size(); ++slot) {
                                 const SelfLanes& lanes = at[std::size_t(slot) / 16];
                                 const int lane = slot % 16;
                                 for (const float v : {lanes.value[lane], lanes.unit[lane], lanes.gradient[0][lane],
                                                       lanes.gradient[1][lane], lanes.gradient[2][lane]})
                                     out[number].push_back(v);
                             }
                         });
            return out;
        };
        QVERIFY(all(plain) == all(shaped));
    }
}

void EllipsoidsTest::sumsAreThoseOfPlainLoops_data() {
    QTest::addColumn<int>("weight");
    for (const auto& weight : weightNames())
        QTest::addRow("%s", weight.name) << static_cast<int>(weight.value);
}

void EllipsoidsTest::sumsAreThoseOfPlainLoops() {
    QFETCH(int, weight);
    base::Random random(test::seed());
    for (const double support : {0.26, 0.9}) { // the second fills several parts
        const surfel::SurfelList list = shapes::ellipsoids(
            shapes::jittered(shapes::torus(1, 0.4, 0.08, support), 0.01, test::seed()), 3.3, test::seed());
        const Surface surface = shapes::surfaceOf(list);
        for (int i = 0; i < test::effort(60); ++i) {
            SumOptions options;
            options.weight = static_cast<Weight>(weight);
            options.scale = i % 2 == 0 ? 1.0f : 1.7f;
            options.shape = surfel::shapeChannel(*list.layout);
            const Vec3f x = shapes::beside(list, random, 0.2);
            const PlainSums plain = plainSums(list, x, options.weight, double(options.scale));
            const ScratchClusters clusters(surface.tree(), x, options.scale);
            Moments<float, 0> values;
            Moments<float, 2> lanes;
            Moments<double, 2> exact;
            sum(clusters.span(), x, options, values);
            sum(clusters.span(), x, options, lanes);
            sum(clusters.span(), base::cast<double>(x), options, exact);
            for (const QString& found : {difference(lanes, plain, 4e-5), difference(exact, plain, 1e-11)})
                QVERIFY2(found.isEmpty(), qPrintable(QString("%1: %2").arg(i).arg(found)));
            QCOMPARE(values.samples, plain.samples);
            QVERIFY(std::abs(double(values.height.v) - plain.value[7]) <= 2e-5 * plain.sizeV[7]);
            QVERIFY(std::abs(double(values.unit) - plain.unit) <= 2e-5 * plain.unit);
        }
    }
}

void EllipsoidsTest::weightsAreThoseOfTheSums() {
    base::Random random(test::seed());
    const surfel::SurfelList list = torus(3.3);
    const Surface surface = shapes::surfaceOf(list);
    for (int i = 0; i < 200; ++i) {
        const Vec3f x = shapes::beside(list, random, 0.2);
        double sum = 0;
        int count = 0;
        forWeights(surface, x, [&](const surfel::SurfelBlock&, int, float theta) { sum += double(theta), ++count; });
        const PlainSums plain = plainSums(list, x, Weight::Wendland, 1);
        QCOMPARE(count, plain.samples);
        QVERIFY(std::abs(sum - plain.value[0]) <= 1e-5 * plain.value[0] + 1e-30);
    }
}

void EllipsoidsTest::gradientsAndHessiansAreDerivatives() {
    QFETCH(int, frame);
    QFETCH(int, weight);
    QFETCH(bool, oriented);
    if (static_cast<Frame>(frame) == Frame::Rimls || static_cast<Weight>(weight) == Weight::Gaussian)
        return; // factors are held still; steps at the cut: sums have been compared above
    surfel::SurfelList list = torus(2.5);
    if (!oriented)
        list = unoriented(std::move(list));
    const Surface surface = shapes::surfaceOf(list, definitionOf(frame, weight));
    base::Random random(test::seed());
    int compared = 0;
    for (int i = 0; i < test::effort(40); ++i) {
        const Vec3d x = base::cast<double>(shapes::beside(list, random, 0.05));
        const Evaluationd at = surface.evaluateReference(x, Need::Hessian);
        if (!at.ok() || at.agreement < 0.95)
            continue;
        const OrientationHint hint{base::cast<float>(at.normal)};
        const Evaluationd here = surface.evaluateReference(x, Need::Hessian, hint);
        const double step = 1e-4 * at.unit;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto moved = [&](double by) {
                Vec3d y = x;
                y[k] += by;
                return surface.evaluateReference(y, Need::Gradient, hint);
            };
            const Evaluationd a = moved(step), b = moved(-step), c = moved(2 * step), d = moved(-2 * step);
            const double f = (8 * (a.value - b.value) - (c.value - d.value)) / (12 * step);
            QVERIFY2(std::abs(f - here.gradient[k]) < 2e-7, qPrintable(QString::number(f - here.gradient[k])));
            const Vec3d g = (a.gradient - b.gradient) / (2 * step);
            if (static_cast<Frame>(frame) != Frame::CentroidGradient)
                for (std::size_t l = 0; l < 3; ++l)
                    QVERIFY2(std::abs(g[l] - here.hessian.m[l][k]) < 2e-3 / at.unit,
                             qPrintable(QString::number((g[l] - here.hessian.m[l][k]) * at.unit)));
        }
        ++compared;
    }
    QVERIFY(compared > 0);
}

void EllipsoidsTest::floatIsTheReferenceRounded() {
    QFETCH(int, frame);
    QFETCH(int, weight);
    QFETCH(bool, oriented);
    surfel::SurfelList list = torus(3, static_cast<Weight>(weight) == Weight::Gaussian);
    if (!oriented)
        list = unoriented(std::move(list));
    const Surface surface = shapes::surfaceOf(list, definitionOf(frame, weight));
    base::Random random(test::seed());
    int compared = 0;
    for (int i = 0; i < test::effort(60); ++i) {
        const Vec3f x = shapes::beside(list, random, 0.05);
        const Evaluationd exact = surface.evaluateReference(base::cast<double>(x), Need::Gradient);
        if (!exact.ok() || exact.agreement < 0.95)
            continue;
        const OrientationHint hint{base::cast<float>(exact.normal)};
        for (const Need need : {Need::Value, Need::Gradient, Need::Hessian}) {
            const Evaluationf e = surface.evaluate(x, need, hint);
            QCOMPARE(e.status, exact.status);
            QVERIFY(std::abs(double(e.value) - exact.value) < 2e-4 * exact.unit);
            QVERIFY(std::abs(double(e.unit) - exact.unit) < 1e-4 * exact.unit);
            QVERIFY(distance(base::cast<double>(e.centroid), exact.centroid) < 2e-4 * exact.unit);
            if (need != Need::Value)
                QVERIFY(distance(base::cast<double>(e.gradient), exact.gradient) < 5e-3);
        }
        ++compared;
    }
    QVERIFY(compared > 0);
}

void EllipsoidsTest::selfEvaluationIsEvaluation() {
    for (const Weight weight : {Weight::Wendland, Weight::WendlandC4, Weight::Gaussian}) {
        const surfel::SurfelList list = torus(3, weight == Weight::Gaussian);
        const Surface surface = shapes::surfaceOf(list, definitionOf(0, int(weight)));
        evaluateSelf(surface, Need::Gradient,
                     [&](std::uint32_t, const surfel::SurfelBlock& block, std::span<const SelfLanes> at) {
                         for (int slot = 0; slot < block.size(); ++slot) {
                             const SelfLanes& lanes = at[std::size_t(slot) / 16];
                             const int lane = slot % 16;
                             const Evaluationf e =
                                 surface.evaluate(block.position(slot), Need::Gradient, {block.normal(slot)});
                             if (lanes.status[lane] != e.status)
                                 qFatal("status");
                             if (!e.ok())
                                 continue;
                             if (!(std::abs(lanes.value[lane] - e.value) < 1e-5f * e.unit &&
                                   std::abs(lanes.unit[lane] - e.unit) < 1e-5f * e.unit &&
                                   distance(lanes.gradientAt(lane), e.gradient) < 1e-4f))
                                 qFatal("value or gradient");
                         }
                     });
    }
}

void EllipsoidsTest::instructionSetsGiveTheSameBits() {
    if ((hwy::SupportedTargets() & HWY_AVX3) == 0 || (hwy::SupportedTargets() & HWY_AVX2) == 0)
        QSKIP("this machine has no AVX-512");
    base::Random random(test::seed());
    for (const Weight weight : {Weight::Wendland, Weight::WendlandC4, Weight::Gaussian}) {
        const surfel::SurfelList list = torus(3, weight == Weight::Gaussian);
        const Surface surface = shapes::surfaceOf(list, definitionOf(0, int(weight)));
        std::vector<Vec3f> x;
        for (int i = 0; i < 100; ++i)
            x.push_back(shapes::beside(list, random, 0.1));
        const auto all = [&] {
            std::vector<Evaluationf> out;
            for (const Need need : {Need::Value, Need::Gradient, Need::Hessian})
                for (const Vec3f& each : x)
                    out.push_back(surface.evaluate(each, need));
            evaluateSelf(surface, Need::Gradient,
                         [&](std::uint32_t number, const surfel::SurfelBlock&, std::span<const SelfLanes> at) {
                             if (number == 0) {
                                 out.emplace_back();
                                 out.back().value = at[0].value[3];
                                 out.back().gradient = at[0].gradientAt(3);
                             }
                         });
            return out;
        };
        const auto wide = all();
        hwy::DisableTargets(HWY_AVX3 | HWY_AVX3_DL);
        hwy::GetChosenTarget().DeInit();
        const auto narrow = all();
        hwy::DisableTargets(0);
        hwy::GetChosenTarget().DeInit();
        for (std::size_t i = 0; i < wide.size(); ++i)
            QVERIFY(same(wide[i], narrow[i]));
    }
}

void EllipsoidsTest::positionsAreSummedWhateverIsAround() {
    base::Random random(test::seed());
    const surfel::SurfelList list = torus(3.3);
    const Surface surface = shapes::surfaceOf(list);
    std::vector<Vec3f> x;
    for (int i = 0; i < 300; ++i)
        x.push_back(shapes::beside(list, random, 0.1));
    std::vector<Evaluationf> batch(x.size());
    surface.evaluate(x, Need::Gradient, batch);
    for (std::size_t i = 0; i < x.size(); ++i)
        QVERIFY(same(batch[i], surface.evaluate(x[i], Need::Gradient)));
}

static const test::Registered<EllipsoidsTest> registered;
#include "ellipsoids_test.moc"
