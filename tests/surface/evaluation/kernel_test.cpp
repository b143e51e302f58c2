// The float kernel's sums against plain loops in double, and their independence of how the clusters were found.
#include "core/surface/definition_text.h"
#include "core/surface/evaluation/clusters.h"
#include "support/registry.h"
#include "surface/moving_axis.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;
using shapes::sameBits;

class KernelTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void sumsAreThoseOfPlainLoops_data();
    void sumsAreThoseOfPlainLoops();
    void denseNeighbourhoodsAreSummedInParts();
    void interpolatingWeightsStayFinite();
    void noClustersSumToNothing();
    void bitsDependOnTheSurfelsInSupportAlone();
};

namespace {

/// Weight with first and second derivatives in x, straight from the formulas of surface/README 2.1.
struct Theta {
    double v = 0, d[3] = {}, dd[6] = {};
};

struct Radial {
    double phi, first, second; ///< phi(r), phi'(r), phi''(r)
};

Radial radial(Weight weight, double r) {
    switch (weight) {
    case Weight::Wendland:
        return {std::pow(1 - r, 4) * (4 * r + 1), -20 * r * std::pow(1 - r, 3),
                -20 * std::pow(1 - r, 3) + 60 * r * std::pow(1 - r, 2)};
    case Weight::WendlandC4: {
        const double t = 1 - r, p = 35 * r * r + 18 * r + 3, p1 = 70 * r + 18;
        return {std::pow(t, 6) * p / 3, (std::pow(t, 6) * p1 - 6 * std::pow(t, 5) * p) / 3,
                (std::pow(t, 6) * 70 - 12 * std::pow(t, 5) * p1 + 30 * std::pow(t, 4) * p) / 3};
    }
    case Weight::Gaussian:
        break;
    }
    const double g = gaussianReach, phi = std::exp(-g * g * r * r);
    return {phi, -2 * g * g * r * phi, (4 * g * g * g * g * r * r - 2 * g * g) * phi};
}

/// By the chain rule over r(x), which is singular at the surfel itself: not to be asked there.
Theta thetaAt(const SumOptions& options, const Vec3d& q, double h, double factor) {
    const double distance = length(q), r = distance / h;
    if (!(r < 1))
        return {};
    Radial w = radial(options.weight, r);
    if (options.interpolating) {
        const double i = 1 / (r * r);
        w = {w.phi * i, w.first * i - 2 * w.phi * i / r, w.second * i - 4 * w.first * i / r + 6 * w.phi * i * i};
    }
    Theta out;
    out.v = w.phi * factor;
    for (std::size_t k = 0; k < 3; ++k) {
        const double rk = -q[k] / (distance * h);
        out.d[k] = w.first * rk * factor;
        for (std::size_t l = k; l < 3; ++l) {
            const double rl = -q[l] / (distance * h);
            const double rkl = ((k == l ? 1.0 : 0.0) - q[k] * q[l] / (distance * distance)) / (distance * h);
            out.dd[sym(int(k), int(l))] = (w.second * rk * rl + w.first * rkl) * factor;
        }
    }
    return out;
}

Theta absolute(Theta theta) {
    theta.v = std::abs(theta.v);
    for (double& each : theta.d)
        each = std::abs(each);
    for (double& each : theta.dd)
        each = std::abs(each);
    return theta;
}

/// The product of two with its derivatives, by Leibniz' rule.
Theta times(const Theta& a, const Theta& b) {
    Theta out;
    out.v = a.v * b.v;
    for (std::size_t k = 0; k < 3; ++k)
        out.d[k] = a.d[k] * b.v + a.v * b.d[k];
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = k; l < 3; ++l) {
            const auto kl = static_cast<std::size_t>(sym(int(k), int(l)));
            out.dd[kl] = a.dd[kl] * b.v + a.d[k] * b.d[l] + a.d[l] * b.d[k] + a.v * b.dd[kl];
        }
    return out;
}

/// t^3 (10 - 15 t + 6 t^2) of t = 1/2 + n.axis / (2 partingLimit), as the axis moves.
Theta partOf(const Vec3d& n, const Axis& axis) {
    const double rise = 0.5 / static_cast<double>(partingLimit), t = 0.5 + rise * dot(n, axis.at);
    if (t >= 1)
        return {1, {}, {}};
    const double first = 30 * t * t - 60 * t * t * t + 30 * t * t * t * t,
                 second = 60 * t - 180 * t * t + 120 * t * t * t;
    Theta out;
    out.v = 10 * t * t * t - 15 * t * t * t * t + 6 * t * t * t * t * t;
    for (std::size_t k = 0; k < 3; ++k) {
        const double tk = rise * dot(n, axis.slope[k]);
        out.d[k] = first * tk;
        for (std::size_t l = k; l < 3; ++l) {
            const auto kl = static_cast<std::size_t>(sym(int(k), int(l)));
            out.dd[kl] = second * tk * rise * dot(n, axis.slope[l]) + first * rise * dot(n, axis.bend[kl]);
        }
    }
    return out;
}

/// `size`: of the terms that theta is made of, which may cancel.
void addTo(Jet<double, 2>& sum, Jet<double, 2>& total, const Theta& theta, const Theta& size, double y) {
    sum.v += theta.v * y, total.v += std::abs(size.v * y);
    for (std::size_t k = 0; k < 3; ++k)
        sum.d[k] += theta.d[k] * y, total.d[k] += std::abs(size.d[k] * y);
    for (std::size_t k = 0; k < 6; ++k)
        sum.dd[k] += theta.dd[k] * y, total.dd[k] += std::abs(size.dd[k] * y);
}

/// All sums in one array of jets: 1, q, n, n.q, |q|^2, products of two; and the same sums of absolute values.
struct Plain {
    int samples = 0;
    double unit = 0;
    Jet<double, 2> sum[15], size[15];
};

Plain plainSums(const surfel::SurfelList& list, const Vec3f& x, const SumOptions& options) {
    Plain out;
    for (const surfel::Surfel& s : list.items) {
        const Vec3d q = base::cast<double>(s.position) - base::cast<double>(x);
        Vec3d n = base::cast<double>(s.normal);
        const double h = static_cast<double>(s.support * options.scale);
        double factor = 1;
        if (options.facing == Facing::Skip && dot(n, options.reference) <= static_cast<double>(facingLimit))
            continue;
        if (options.facing == Facing::Flip && dot(n, options.reference) < 0)
            n = -n;
        if (options.facing == Facing::Refit)
            factor = std::exp(-lengthSq(n - options.reference) / std::pow(static_cast<double>(options.sigma), 2));
        Theta theta = thetaAt(options, q, h, factor), size = absolute(theta);
        if (!(theta.v > 0))
            continue;
        if (options.facing == Facing::Part) {
            if (dot(n, options.axis->at) <= -static_cast<double>(partingLimit))
                continue;
            const Theta part = partOf(n, *options.axis);
            Theta partSize = absolute(part);
            partSize.v += 1e-3; // near its foot float knows the step's place, not its share
            theta = times(theta, part), size = times(size, partSize);
        }
        ++out.samples;
        out.unit += theta.v * (options.weight == Weight::Gaussian ? h / static_cast<double>(gaussianReach) : h);
        const Vec3d& y = options.outer == Outer::Normals ? n : q;
        const double terms[15] = {1,         q.x,       q.y,       q.z,       n.x,       n.y,       n.z,      dot(n, q),
                                  dot(q, q), y.x * y.x, y.x * y.y, y.x * y.z, y.y * y.y, y.y * y.z, y.z * y.z};
        for (int k = 0; k < 15; ++k)
            addTo(out.sum[k], out.size[k], theta, size, terms[k]);
    }
    return out;
}

template <int O>
bool near(const Jet<float, O>& a, const Jet<double, 2>& b, const Jet<double, 2>& size, double tolerance) {
    const auto close = [&](float x, double y, double s) {
        return std::abs(static_cast<double>(x) - y) <= tolerance * s + 1e-30;
    };
    bool good = close(a.v, b.v, size.v);
    if constexpr (O >= 1)
        for (std::size_t k = 0; k < 3; ++k)
            good = good && close(a.d[k], b.d[k], size.d[k]);
    if constexpr (O >= 2)
        for (std::size_t k = 0; k < 6; ++k) // the two terms of theta_,kl cancel partly: measured by their trace
            good = good && close(a.dd[k], b.dd[k], size.dd[k] + size.dd[0] + size.dd[3] + size.dd[5]);
    return good;
}

/// Name of the first sum that differs, or nothing.
template <int O>
QString difference(const Moments<float, O>& a, const Plain& b, Outer outer, double tolerance) {
    if (a.samples != b.samples)
        return QString("samples %1, not %2").arg(a.samples).arg(b.samples);
    if (std::abs(static_cast<double>(a.unit) - b.unit) > tolerance * b.unit)
        return "unit";
    const Jet<float, O>* jets[15] = {&a.one,      &a.q[0],     &a.q[1],     &a.q[2],     &a.n[0],
                                     &a.n[1],     &a.n[2],     &a.height,   &a.square,   &a.outer[0],
                                     &a.outer[1], &a.outer[2], &a.outer[3], &a.outer[4], &a.outer[5]};
    for (int k = 0; k < (outer == Outer::None ? 9 : 15); ++k)
        if (!near<O>(*jets[k], b.sum[k], b.size[k], tolerance))
            return QString("sum %1").arg(k);
    return {};
}

template <int O>
QString differenceOf(const Surface& surface, const surfel::SurfelList& list, const Vec3f& x, const SumOptions& options,
                     double tolerance) {
    const ScratchClusters clusters(surface.tree(), x, options.scale);
    Moments<float, O> sums;
    sum(clusters.span(), x, options, sums);
    return difference<O>(sums, plainSums(list, x, options), options.outer, tolerance);
}

} // namespace

void KernelTest::sumsAreThoseOfPlainLoops_data() {
    QTest::addColumn<int>("weight");
    QTest::addColumn<int>("facing");
    QTest::addColumn<bool>("interpolating");
    const char* facings[] = {"all", "skip", "flip", "refit", "part"};
    for (const auto& weight : weightNames())
        for (int facing = 0; facing < 5; ++facing)
            for (const bool interpolating : {false, true})
                QTest::addRow("%s %s%s", weight.name, facings[facing], interpolating ? " interpolating" : "")
                    << static_cast<int>(weight.value) << facing << interpolating;
}

void KernelTest::sumsAreThoseOfPlainLoops() {
    QFETCH(int, weight);
    QFETCH(int, facing);
    QFETCH(bool, interpolating);
    base::Random random(test::seed());
    const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.06, 0.21), 0.01, test::seed());
    const Surface surface = shapes::surfaceOf(list);
    for (int i = 0; i < test::effort(100); ++i) {
        SumOptions options;
        options.weight = static_cast<Weight>(weight);
        options.facing = static_cast<Facing>(facing);
        options.interpolating = interpolating;
        options.reference = random.unitVector();
        const Axis axis = test::movingAxis(options.reference, random);
        options.axis = &axis;
        options.sigma = static_cast<float>(random.uniform(0.5, 1.5));
        options.scale = i % 2 == 0 ? 1.0f : 1.7f;
        const Vec3f x = shapes::beside(list, random, 0.2);
        // Close to the rim of its support a surfel's relative weight is nothing that float knows; the others carry the
        // sums. Interpolatory weights lose a few digits to 1 / r^2.
        const double tolerance = (interpolating ? 2e-4 : 2e-5) * (options.facing == Facing::Part ? 2 : 1);
        for (const Outer outer : {Outer::None, Outer::Normals, Outer::Offsets}) {
            options.outer = outer;
            for (const QString& found : {differenceOf<0>(surface, list, x, options, tolerance),
                                         differenceOf<1>(surface, list, x, options, tolerance),
                                         differenceOf<2>(surface, list, x, options, 4 * tolerance)})
                QVERIFY2(found.isEmpty(), qPrintable(QString("%1: %2").arg(i).arg(found)));
        }
    }
}

void KernelTest::denseNeighbourhoodsAreSummedInParts() {
    base::Random random(test::seed());
    const surfel::SurfelList list = shapes::jittered(shapes::sphere(5000, 1, 0.6), 0.01, test::seed());
    const Surface surface = shapes::surfaceOf(list);
    int most = 0;
    for (int i = 0; i < test::effort(50); ++i) {
        const Vec3f x = shapes::beside(list, random, 0.4);
        SumOptions options;
        options.outer = i % 2 == 0 ? Outer::None : Outer::Offsets;
        for (const QString& found :
             {differenceOf<0>(surface, list, x, options, 2e-5), differenceOf<1>(surface, list, x, options, 2e-5),
              differenceOf<2>(surface, list, x, options, 1e-4)})
            QVERIFY2(found.isEmpty(), qPrintable(QString("%1: %2").arg(i).arg(found)));
        most = std::max(most, plainSums(list, x, options).samples);
    }
    QVERIFY(most > 3 * 128); // several parts
}

void KernelTest::interpolatingWeightsStayFinite() {
    for (const double size : {1e-6, 1.0, 1e6}) {
        surfel::SurfelList list = shapes::sphere(500, size, 0.5 * size);
        const Surface surface = shapes::surfaceOf(list);
        SumOptions options;
        options.interpolating = true;
        const Vec3f p = list.items[100].position;
        for (const double away : {0.0, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3}) {
            const Vec3f x = p + Vec3f{0, 0, static_cast<float>(away * size)};
            Moments<float, 1> sums;
            sum(ScratchClusters(surface.tree(), x).span(), x, options, sums);
            QVERIFY(std::isfinite(sums.one.v) && sums.one.v > 0);
            for (const auto& jet : {sums.one, sums.q[0], sums.n[1], sums.height, sums.square})
                QVERIFY(std::isfinite(jet.v) && std::isfinite(jet.d[0]) && std::isfinite(jet.d[1]) &&
                        std::isfinite(jet.d[2]));
            const Vec3f normal = valueOf(sums.n) / sums.one.v;
            if (away < 1e-5)
                QVERIFY(distance(normal, list.items[100].normal) < 1e-4f);
        }
    }
}

void KernelTest::noClustersSumToNothing() {
    Moments<float, 2> sums;
    sum(ClusterSpan{}, Vec3f{1, 2, 3}, SumOptions{}, sums);
    QCOMPARE(sums.samples, 0);
    QCOMPARE(sums.one.v, 0.0f);
    QCOMPARE(sums.height.dd[3], 0.0f);
}

void KernelTest::bitsDependOnTheSurfelsInSupportAlone() {
    base::Random random(test::seed());
    const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.04, 0.14), 0.01, test::seed());
    const Surface surface = shapes::surfaceOf(list);
    ClusterList all;
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int cluster = 0; cluster < block.clusterCount(); ++cluster)
            all.push_back(block.channel(cluster, surfel::X));
    });
    for (int i = 0; i < 200; ++i) {
        const Vec3f x = shapes::beside(list, random, 0.1);
        SumOptions options;
        options.facing = i % 3 == 0 ? Facing::All : i % 3 == 1 ? Facing::Skip : Facing::Part;
        options.reference = random.unitVector();
        const Axis axis = test::movingAxis(options.reference, random);
        options.axis = &axis;
        Moments<float, 1> few, many;
        sum(ScratchClusters(surface.tree(), x).span(), x, options, few);
        sum(all.span(), x, options, many);
        QVERIFY(few.samples > 0 || options.facing != Facing::All);
        QVERIFY(few.samples == many.samples && few.unit == many.unit);
        QVERIFY(sameBits(few.one, many.one) && sameBits(few.q, many.q) && sameBits(few.n, many.n) &&
                sameBits(few.height, many.height) && sameBits(few.square, many.square));
    }
}

static const test::Registered<KernelTest> registered;
#include "kernel_test.moc"
