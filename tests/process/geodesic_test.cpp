// Shortest ways along surfaces: as long as analysis says on spheres, tori, cylinders and planes with holes, however
// uneven, noisy or far from zero the points are.
#include "core/process/measuring/geodesic.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "process/even_shapes.h"
#include "process/uneven_sphere.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <functional>
#include <QTest>
#include <queue>

using namespace process;
using base::Vec3d, base::Vec3f;

class GeodesicTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void greatCirclesOfUnevenSpheres();
    void toriFromEveryDirection();
    void cylindersUnroll();
    void holesAreGoneAround();
    void waysLieOnTheSurfaceAndBendOnlyWithIt();
    void noiseLengthensNothing();
    void straysAndCoincidentPointsChangeNothing();
    void theShorterWayRoundIsTaken();
    void rowsFarApartHangTogether();
    void piecesApartAreToldApart();
    void samePlacesAreNoWayApart();
    void threadsDoNotShow();
    void cancels();
};

namespace {

constexpr double pi = std::numbers::pi;

QByteArray told(double is, double wanted) {
    return QByteArray::number(is, 'g', 8) + " for " + QByteArray::number(wanted, 'g', 8) + ", " +
           QByteArray::number(100 * (is / wanted - 1), 'g', 3) + " %, seed " + QByteArray::number(test::seed());
}

/// Random points of a parametrised surface, by area, up to `ratio` times as far apart at one end of z as at the other.
surface::Surface sampled(std::size_t count, double ratio, base::Random& random,
                         const std::function<std::pair<Vec3d, Vec3d>(base::Random&)>& at, double noise = 0) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    while (out.size() < count) {
        const auto [p, n] = at(random);
        if (random.uniform() > std::pow(ratio * ratio, -0.5 - 0.5 * std::clamp(p.z, -1.0, 1.0)))
            continue;
        surfel::Surfel s;
        s.position = base::cast<float>(p + n * (noise * random.normal()));
        s.normal = base::cast<float>(n);
        out.append(s, {});
    }
    return prepare(out, {});
}

constexpr double ring = 1, tube = 0.4;

Vec3d torusAt(double u, double v) {
    return {(ring + tube * std::cos(v)) * std::cos(u), (ring + tube * std::cos(v)) * std::sin(u), tube * std::sin(v)};
}

surface::Surface torus(std::size_t count, double ratio, base::Random& random, double noise = 0) {
    return sampled(
        count, ratio, random,
        [](base::Random& r) {
            for (;;) {
                const double u = r.uniform(0, 2 * pi), v = r.uniform(0, 2 * pi);
                if (r.uniform(0, ring + tube) < ring + tube * std::cos(v))
                    return std::pair{torusAt(u, v),
                                     Vec3d{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)}};
            }
        },
        noise);
}

/// Where the geodesic of the torus that leaves (0, v) at an angle to the meridian is after a length, by Clairaut's
/// equations u'' = 2 sin v tube / r u' v', v'' = -r sin v / tube u'^2 (Runge-Kutta); and its length by quadrature.
struct TorusWay {
    double u, v;
};
TorusWay shot(double v0, double angle, double far) {
    using State = std::array<double, 4>; // u, v, u', v'
    const auto rate = [](const State& s) {
        const double r = ring + tube * std::cos(s[1]);
        return State{s[2], s[3], 2 * tube * std::sin(s[1]) / r * s[2] * s[3], -r * std::sin(s[1]) / tube * s[2] * s[2]};
    };
    const auto plus = [](State s, const State& d, double h) {
        for (std::size_t k = 0; k < 4; ++k)
            s[k] += h * d[k];
        return s;
    };
    State s{0, v0, std::sin(angle) / (ring + tube * std::cos(v0)), std::cos(angle) / tube};
    constexpr int steps = 2000;
    const double h = far / steps;
    for (int k = 0; k < steps; ++k) {
        const State a = rate(s), b = rate(plus(s, a, h / 2)), c = rate(plus(s, b, h / 2)), d = rate(plus(s, c, h));
        for (std::size_t j = 0; j < 4; ++j)
            s[j] += h / 6 * (a[j] + 2 * b[j] + 2 * c[j] + d[j]);
    }
    return {s[0], s[1]};
}

/// The distance on the torus between two places by brute force: walks over a dense grid with long links, each link
/// measured in the metric at its middle, half a per cent too long at most.
double torusDistance(TorusWay a, TorusWay b) {
    constexpr int n = 360, m = 240, far = 7;
    std::vector<double> out(n * m, 1e9);
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> waiting;
    const auto number = [&](TorusWay w) {
        const int i = int(std::lround(w.u / (2 * pi) * n)), j = int(std::lround(w.v / (2 * pi) * m));
        return ((i % n + n) % n) * m + (j % m + m) % m;
    };
    out[std::size_t(number(a))] = 0;
    waiting.push({0, number(a)});
    while (!waiting.empty()) {
        const auto [d, at] = waiting.top();
        waiting.pop();
        if (d > out[std::size_t(at)])
            continue;
        if (at == number(b))
            return d;
        for (int di = -far; di <= far; ++di)
            for (int dj = -far; dj <= far; ++dj) {
                if (std::gcd(di, dj) != 1)
                    continue;
                const int i = ((at / m + di) % n + n) % n, j = ((at % m + dj) % m + m) % m;
                const double v = (at % m + 0.5 * dj) * 2 * pi / m, du = di * 2 * pi / n, dv = dj * 2 * pi / m;
                const double next = d + std::hypot((ring + tube * std::cos(v)) * du, tube * dv);
                if (next < out[std::size_t(i * m + j)])
                    out[std::size_t(i * m + j)] = next, waiting.push({next, i * m + j});
            }
    }
    return 1e9;
}

/// A plane sheet of side 2 with a round hole, random and uneven.
surface::Surface holed(double radius, base::Random& random) {
    return sampled(14000, 6, random, [&](base::Random& r) {
        for (;;)
            if (const Vec3d p{r.uniform(-1, 1), 0, r.uniform(-1, 1)}; std::hypot(p.x, p.z) > radius)
                return std::pair{p, Vec3d{0, 1, 0}};
    });
}

} // namespace

void GeodesicTest::greatCirclesOfUnevenSpheres() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(3); ++k) {
        const surface::Surface sphere = prepare(shapes::unevenSphere(40000, random), {}); // h is 0.5 at its sparse end
        for (int pair = 0; pair < test::effort(4); ++pair) {
            const Vec3d a = random.unitVector(), b = random.unitVector();
            const double wanted = std::atan2(length(cross(a, b)), dot(a, b));
            const Geodesic found = geodesic(sphere, a, b);
            QVERIFY2(std::abs(found.length - wanted) < 0.003 * wanted + 1e-4, told(found.length, wanted));
        }
    }
}

void GeodesicTest::toriFromEveryDirection() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(3); ++k) {
        const surface::Surface surface = torus(9000, k % 2 ? 20 : 1, random);
        for (int pair = 0; pair < test::effort(3); ++pair) {
            const TorusWay a{0, random.uniform(0, 2 * pi)};
            const double far = random.uniform(0.3, 2.5);
            const TorusWay b = shot(a.v, random.uniform(0, 2 * pi), far);
            const double grid = torusDistance(a, b); // shots need not be shortest
            const Geodesic found = geodesic(surface, torusAt(a.u, a.v), torusAt(b.u, b.v));
            QVERIFY2(found.length < 1.005 * far, told(found.length, far));
            QVERIFY2(found.length > 0.98 * grid - 0.03 && found.length < 1.01 * grid + 0.03, told(found.length, grid));
            if (far < 0.5) // no other way is shorter
                QVERIFY2(std::abs(found.length - far) < 0.005 * far, told(found.length, far));
        }
    }
}

void GeodesicTest::cylindersUnroll() {
    base::Random random(test::seed());
    const surface::Surface cylinder = sampled(9000, 5, random, [](base::Random& r) {
        const double u = r.uniform(0, 2 * pi);
        const Vec3d n{std::cos(u), std::sin(u), 0};
        return std::pair{n + Vec3d{0, 0, r.uniform(-1.2, 1.2)}, n};
    });
    for (int k = 0; k < test::effort(6); ++k) {
        const double u = random.uniform(-3, 3), z = random.uniform(-0.9, 0.9), y = random.uniform(-0.9, 0.9);
        const double wanted = std::hypot(u, z - y);
        const Geodesic found = geodesic(cylinder, {1, 0, y}, {std::cos(u), std::sin(u), z});
        QVERIFY2(std::abs(found.length - wanted) < 0.003 * wanted, told(found.length, wanted));
    }
}

void GeodesicTest::holesAreGoneAround() {
    if (test::sanitized)
        QSKIP("ten seconds under a sanitizer");
    base::Random random(test::seed());
    for (const double radius : {0.3, 0.5}) {
        const surface::Surface sheet = holed(radius, random);
        QVERIFY(std::isfinite(sheet.definition().boundaryLimit));
        for (int k = 0; k < test::effort(3); ++k) {
            const double a = random.uniform(0.7, 0.85), b = random.uniform(0.7, 0.85);
            const double c = random.uniform(0, 2 * pi), d = c + pi + random.uniform(-0.4, 0.4);
            const Vec3d p{a * std::cos(c), 0, a * std::sin(c)}, q{b * std::cos(d), 0, b * std::sin(d)};
            const double angle = std::min(std::abs(d - c), 2 * pi - std::abs(d - c));
            // tangents from both places and the arc between them
            const double wanted = std::sqrt(a * a - radius * radius) + std::sqrt(b * b - radius * radius) +
                                  radius * (angle - std::acos(radius / a) - std::acos(radius / b));
            const Geodesic found = geodesic(sheet, p, q);
            // the rim of the surface lies within a part of a spacing of the circle
            QVERIFY2(std::abs(found.length - wanted) < 0.02 * wanted, told(found.length, wanted));
            QVERIFY(
                std::any_of(found.points.begin(), found.points.end(), [](const GeodesicPoint& g) { return g.rim; }));
        }
        if (test::sanitized)
            break;
    }
}

void GeodesicTest::waysLieOnTheSurfaceAndBendOnlyWithIt() {
    base::Random random(test::seed());
    const surface::Surface surface = torus(9000, 10, random);
    for (int k = 0; k < test::effort(3); ++k) {
        const Geodesic found = geodesic(surface, torusAt(random.uniform(0, 6), random.uniform(0, 6)),
                                        torusAt(random.uniform(0, 6), random.uniform(0, 6)));
        for (std::size_t i = 1; i + 1 < found.points.size(); ++i) {
            const GeodesicPoint& at = found.points[i];
            const auto value = surface.evaluateReference(at.position);
            QVERIFY2(std::abs(value.value) < 1e-6 * at.unit, told(value.value, at.unit));
            const Vec3d in = base::normalized(at.position - found.points[i - 1].position);
            const Vec3d out = base::normalized(found.points[i + 1].position - at.position);
            const double aside = std::abs(dot(out - in, base::normalized(cross(at.normal, in))));
            QVERIFY2(aside < 2e-3, told(aside, 0));
        }
    }
}

void GeodesicTest::noiseLengthensNothing() {
    base::Random random(test::seed());
    const double spacing = test::sphereSpacing(8000);
    const surface::Surface sphere = sampled(
        8000, 1, random,
        [](base::Random& r) {
            const Vec3d d = r.unitVector();
            return std::pair{d, d};
        },
        0.15 * spacing);
    for (int k = 0; k < test::effort(4); ++k) {
        const Vec3d a = random.unitVector(), b = random.unitVector();
        const double wanted = std::atan2(length(cross(a, b)), dot(a, b));
        const Geodesic found = geodesic(sphere, a, b);
        QVERIFY2(std::abs(found.length - wanted) < 0.01 * wanted + 0.1 * spacing, told(found.length, wanted));
    }
}

void GeodesicTest::straysAndCoincidentPointsChangeNothing() {
    base::Random random(test::seed());
    surfel::SurfelList points;
    for (int k = 0; k < 8000; ++k) {
        surfel::Surfel s = shapes::at(random.unitVector());
        for (int times = 0; times < (k % 10 == 0 ? 3 : 1); ++times)
            points.items.push_back(s);
    }
    for (int k = 0; k < 40; ++k)
        points.items.push_back(shapes::at(random.unitVector() * random.uniform(1.5, 2.5)));
    const surface::Surface sphere = prepare(points, {});
    for (int k = 0; k < test::effort(6); ++k) {
        const Vec3d a = random.unitVector(), b = random.unitVector();
        const double wanted = std::atan2(length(cross(a, b)), dot(a, b));
        const Geodesic found = geodesic(sphere, a, b);
        QVERIFY2(std::abs(found.length - wanted) < 0.01 * wanted, told(found.length, wanted));
    }
}

void GeodesicTest::theShorterWayRoundIsTaken() {
    base::Random random(test::seed());
    const surface::Surface surface = torus(9000, 20, random);
    // Across the ring's inside and around either side: the walks of both differ by less than a walk is wrong by.
    for (const double off : {-0.06, 0.06}) {
        const double u = pi + off, inner = ring - tube;
        const Geodesic found = geodesic(surface, torusAt(0, pi), torusAt(u, pi));
        const double wanted = inner * (pi - std::abs(off));
        QVERIFY2(std::abs(found.length - wanted) < 0.005 * wanted, told(found.length, wanted));
        const Vec3d middle = found.points[found.points.size() / 2].position;
        QVERIFY(middle.y * (off < 0 ? 1 : -1) > 0);
    }
}

void GeodesicTest::rowsFarApartHangTogether() {
    surfel::SurfelList rows; // lines of a scanner: 20 times as dense along them as across
    rows.layout = test::orientedLayout();
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 400; ++j)
            rows.append(test::surfelAt({j * 0.0025, i * 0.05, 0}, {0, 0, 1}, 0.05), {});
    const Geodesic found = geodesic({tree::SurfelTree::build(rows), {}}, {0.1, 0.13, 0}, {0.9, 0.87, 0});
    const double wanted = std::hypot(0.8, 0.74);
    QVERIFY2(std::abs(found.length - wanted) < 0.001 * wanted, told(found.length, wanted));
}

void GeodesicTest::piecesApartAreToldApart() {
    surfel::SurfelList two = test::spherePoints(1500);
    for (surfel::Surfel s : test::spherePoints(1500).items) {
        s.position.x += 2.5f;
        two.append(s, {});
    }
    const surface::Surface surface = test::surfaceOf(two);
    QVERIFY_THROWS_EXCEPTION(base::Error, geodesic(surface, {-1, 0, 0}, {3.5, 0, 0}));
    QVERIFY(std::abs(geodesic(surface, {1.5, 0, 0}, {3.5, 0, 0}).length - pi) < 0.002);
}

void GeodesicTest::samePlacesAreNoWayApart() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(2000));
    QCOMPARE(geodesic(sphere, {0, 0, 1}, {0, 0, 1}).length, 0.0);
    const double close = geodesic(sphere, {0, 0, 1}, {1e-3, 0, 1}).length;
    QVERIFY2(std::abs(close - 1e-3) < 1e-6, told(close, 1e-3));
}

void GeodesicTest::threadsDoNotShow() {
    base::Random random(test::seed());
    const surface::Surface surface = torus(5000, 10, random);
    const auto work = [&] { return geodesic(surface, torusAt(0, 1), torusAt(3, 4)); };
    const Geodesic one = test::onThreads(1, work), two = test::onThreads(2, work);
    QVERIFY(one.length == two.length && one.points.size() == two.points.size());
    for (std::size_t i = 0; i < one.points.size(); ++i)
        QVERIFY(one.points[i].position == two.points[i].position);
}

void GeodesicTest::cancels() {
    const std::atomic<bool> cancel = true;
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(2000));
    QVERIFY_THROWS_EXCEPTION(base::Cancelled, geodesic(sphere, {0, 0, 1}, {0, 0, -1}, {{}, &cancel}));
}

static const test::Registered<GeodesicTest> registered;
#include "geodesic_test.moc"
