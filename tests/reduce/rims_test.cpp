// Where reduced sets of open surfaces end (reduce/README 4.4).
#include "core/base/parallel.h"
#include "core/reduce/rim_row.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/rims.h"
#include "reduced_models.h"
#include "support/registry.h"

#include <algorithm>
#include <QTest>

using namespace reduce;
using base::Vec3d;

class RimsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void derivativesOfARowAreThoseOfTheRim();
    void reducedSetsEndInTheSameLoops_data();
    void reducedSetsEndInTheSameLoops();
    void bittenEdgesLoseHardlyAPlace();
    void closedSurfacesKnowNoRims();
    void sameBitsAtAnyThreadCount();
};

namespace {

using test::Shape;

/// A cap of the unit sphere above z = `low`, with a round hole of that radius at the pole, points by chance.
Shape cap(std::size_t count, double low, double hole, unsigned long long seed) {
    base::Random random(seed);
    const auto inside = [&](const Vec3d& x) { return x.z > low && std::hypot(x.x, x.y) > (x.z > 0 ? hole : 0); };
    const double top = std::sqrt(1 - hole * hole), area = 2 * std::numbers::pi * (top - low);
    std::vector<std::pair<Vec3d, Vec3d>> points;
    for (const Vec3d& d : test::shakenDirections(std::size_t(double(count) * 4 * std::numbers::pi / area), 0.3, random))
        if (inside(d))
            points.push_back({d, d});
    return {test::prepared(points), [](const Vec3d& x) { return length(x) - 1; },
            std::sqrt(area / double(points.size())), 3};
}

/// A plate with rounded edges, three samples thick, that was bitten into all along them: rims with tips, bridges and
/// flaps that bend within a support of the reduced set.
surface::Surface bitten(unsigned long long seed) {
    base::Random random(seed);
    constexpr double s = 0.02, r = 0.06, wide = 0.6;
    struct Ball {
        Vec3d centre;
        double radius;
    };
    std::vector<Ball> bites;
    for (int i = 0; i < 12; ++i) {
        const double a = random.uniform(0, 2 * std::numbers::pi), d = random.uniform(0.4, 0.7);
        bites.push_back({{d * std::cos(a), d * std::sin(a), random.uniform(-r, r)}, random.uniform(0.05, 0.2)});
    }
    std::vector<std::pair<Vec3d, Vec3d>> points;
    const auto add = [&](const Vec3d& x, const Vec3d& n) {
        if (std::none_of(bites.begin(), bites.end(), [&](const Ball& b) { return length(x - b.centre) < b.radius; }))
            points.push_back({x, n});
    };
    const auto shaken = [&](int i) { return i + random.uniform(-0.3, 0.3); };
    for (const double side : {-1.0, 1.0})
        for (int i = -30; i <= 30; ++i)
            for (int k = -30; k <= 30; ++k)
                if (const Vec3d x{shaken(i) * s, shaken(k) * s, side * r}; std::hypot(x.x, x.y) < wide)
                    add(x, {0, 0, side});
    constexpr int rows = 9, columns = 207;
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < columns; ++k) {
            const double up = std::numbers::pi * ((shaken(i) + 0.5) / rows - 0.5);
            const double a = 2 * std::numbers::pi * shaken(k) / columns;
            const Vec3d n{std::cos(up) * std::cos(a), std::cos(up) * std::sin(a), std::sin(up)};
            add(Vec3d{wide * std::cos(a), wide * std::sin(a), 0} + n * r, n);
        }
    return test::prepared(points);
}

double toRims(const Vec3d& x, double low, double hole) {
    const double z = std::asin(std::clamp(x.z / length(x), -1.0, 1.0));
    const double lower = std::abs(z - std::asin(low));
    return hole > 0 ? std::min(lower, std::abs(z - std::acos(hole))) : lower;
}

} // namespace

void RimsTest::derivativesOfARowAreThoseOfTheRim() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(50); ++k) {
        std::vector<FitSite> sites;
        for (int i = 0; i < 20; ++i) {
            FitSite s;
            const double x = random.uniform(-1.2, 0.1), y = random.uniform(-1, 1);
            s.start = {x, y, 0.05 * x * x};
            s.normal0 = normalized(Vec3d{-0.1 * x, 0, 1});
            s.along[0] = perpendicular(s.normal0), s.along[1] = cross(s.normal0, s.along[0]);
            s.setShape(s.along[0] * random.uniform(0, 1.5), random.uniform(1.1, 1.8));
            sites.push_back(s);
        }
        const Vec3d place{random.uniform(0, 0.3), random.uniform(-0.3, 0.3), 0};
        std::vector<std::array<float, mostUnknowns>> d(sites.size());
        const auto row = [&](double limit) {
            std::vector<FitTerm> terms;
            for (std::size_t i = 0; i < sites.size(); ++i)
                terms.push_back({&sites[i], &d[i], {}, {}});
            return rimRow(place, {0, 0, 1}, true, limit, terms);
        };
        const auto off = [&] {
            std::vector<FitTerm> terms;
            for (std::size_t i = 0; i < sites.size(); ++i)
                terms.push_back({&sites[i], &d[i], {}, {}});
            return *offCentreAt(place, {0, 0, 1}, true, terms);
        };
        const double limit = off();
        const FitRow here = row(limit); // o = L h: the slope that it is divided by has no say
        if (!here.valid)
            continue;
        QVERIFY2(std::abs(here.residual) < 1e-12, qPrintable(QString("seed %1").arg(test::seed())));
        const auto kept = d;
        for (std::size_t i = 0; i < sites.size(); ++i)
            for (std::size_t u = 3; u < 6; ++u) {
                constexpr double step = 1e-6;
                sites[i].x[u] = step;
                const double more = row(limit).residual;
                sites[i].x[u] = -step;
                const double less = row(limit).residual;
                sites[i].x[u] = 0;
                const double differs = std::abs((more - less) / (2 * step) - double(kept[i][u]));
                QVERIFY2(differs < 1e-4, qPrintable(QString("seed %1, unknown %2: %3 by differences, %4")
                                                        .arg(test::seed())
                                                        .arg(u)
                                                        .arg((more - less) / (2 * step))
                                                        .arg(double(kept[i][u]))));
            }
    }
}

void RimsTest::reducedSetsEndInTheSameLoops_data() {
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("hole");
    QTest::addColumn<int>("shapes");
    QTest::addColumn<double>("ratio");
    QTest::newRow("half, balls") << 0.0 << 0.0 << int(Shapes::Spheres) << 0.1;
    QTest::newRow("half, ellipsoids") << 0.0 << 0.0 << int(Shapes::Ellipsoids) << 0.1;
    QTest::newRow("most of a sphere with a hole") << -0.7 << 0.5 << int(Shapes::Auto) << 0.1;
    QTest::newRow("the same, a fifth") << -0.7 << 0.5 << int(Shapes::Spheres) << 0.2;
    QTest::newRow("the same, a twentieth") << -0.7 << 0.5 << int(Shapes::Spheres) << 0.05;
}

void RimsTest::reducedSetsEndInTheSameLoops() {
    QFETCH(double, low);
    QFETCH(double, hole);
    QFETCH(int, shapes);
    QFETCH(double, ratio);
    const Shape shape = cap(std::size_t(test::effort(8000)), low, hole, test::seed());
    const auto dense = surface::findBoundaryCurves(shape.surface);
    const Reduced result = reduceByRatio(shape.surface, ratio, Shapes(shapes));
    QVERIFY(surface::knowsRims(result.surface));
    QVERIFY(result.report.holes <= shape.surface.tree().size() / 1000);
    const auto curves = surface::findBoundaryCurves(result.surface);
    const double spacing = shape.spacing / std::sqrt(ratio);
    const auto said = [&](const QString& what) {
        return qPrintable(QString("seed %1: %2; %3 curves, %4 of the model")
                              .arg(test::seed())
                              .arg(what)
                              .arg(curves.size())
                              .arg(dense.size()));
    };
    QVERIFY2(curves.size() == (hole > 0 ? 2u : 1u), said("loops"));
    for (const surface::BoundaryCurve& curve : curves) {
        QVERIFY2(curve.closed, said("open"));
        for (const surface::BoundaryPoint& p : curve.points) {
            const double off = toRims(p.position, low, hole) / spacing;
            QVERIFY2(off < 0.5, said(QString("%1 spacings from the rim").arg(off)));
        }
    }
}

void RimsTest::bittenEdgesLoseHardlyAPlace() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("minutes under a sanitizer");
#endif
    std::size_t holes = 0, samples = 0;
    for (unsigned k = 0; k < 10; ++k) {
        const surface::Surface plate = bitten(1000 * test::seed() + k);
        const Shapes shapes = k % 2 ? Shapes::Ellipsoids : Shapes::Spheres;
        holes += reduceByRatio(plate, 0.1, shapes).report.holes, samples += plate.tree().size();
    }
    // .5 to 1.1 of 1000; where all samples beside rims are fitted to them, and no denser there, more than 2.
    QVERIFY2(holes * 1000 <= samples * 3 / 2,
             qPrintable(QString("seed %1: %2 holes of %3 samples").arg(test::seed()).arg(holes).arg(samples)));
}

void RimsTest::closedSurfacesKnowNoRims() {
    const Reduced result = reduceByRatio(test::sphere(std::size_t(test::effort(5000))).surface, 0.1);
    QVERIFY(!surface::knowsRims(result.surface));
    QVERIFY(std::isinf(result.surface.definition().boundaryLimit));
}

void RimsTest::sameBitsAtAnyThreadCount() {
    const Shape shape = cap(std::size_t(test::effort(5000)), -0.2, 0.4, test::seed());
    const int threads = base::threadCount();
    std::vector<std::string> hashes;
    for (const int n : {1, 3}) {
        base::setThreadCount(n);
        hashes.push_back(reduceByRatio(shape.surface, 0.1, Shapes::Spheres).surface.tree().contentHash().text());
    }
    base::setThreadCount(threads);
    QCOMPARE(hashes[0], hashes[1]);
}

static const test::Registered<RimsTest> registered;
#include "rims_test.moc"
