// What a tool feels of shapes in closed form: where the proxy is, and the force.
#include "core/haptics/force_law.h"
#include "haptics/solids.h"
#include "support/registry.h"
#include "surface/bounded.h"

#include <QTest>

using namespace haptics;
using namespace haptics_test;

class ProxyTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void forceIsThatOfTheClosedForm_data();
    void forceIsThatOfTheClosedForm();
    void stickEndsAtTheCoefficient_data();
    void stickEndsAtTheCoefficient();
    void slidingFeelsTheCoefficient_data();
    void slidingFeelsTheCoefficient();
    void forceFollowsTheToolWithoutJumps_data();
    void forceFollowsTheToolWithoutJumps();
    void forceFollowsTheToolOnNoise();
    void openSheetsAreFeltFromBothSides();
    void toolsSlideOffRims();
    void insideOfSolidsOnePushesOut();
    void toolsMayBeginOnTheSurface();
    void placesFarApartAreReachedWithPatience();
    void nothingIsFeltOfNothing();
    void dampingNeverPulls();
    void shadingTurnsTheForceAlone();
};

static const Solid& chosen(int i) {
    return i < 4 ? solids()[static_cast<std::size_t>(i)] : coarseSolids()[static_cast<std::size_t>(i - 4)];
}

static void addSolids(int count = 4) {
    QTest::addColumn<int>("solid");
    QTest::addColumn<double>("radius"); // in units of h
    for (int i = 0; i < count; ++i)
        for (const double radius : {0.0, 0.01, 0.5, 2.0})
            QTest::addRow("%s%s, radius %g h", i < 4 ? "" : "coarse ", chosen(i).name.c_str(), radius) << i << radius;
}

void ProxyTest::forceIsThatOfTheClosedForm_data() {
    addSolids(8);
}

void ProxyTest::forceIsThatOfTheClosedForm() {
    QFETCH(int, solid);
    QFETCH(double, radius);
    const Solid& s = chosen(solid);
    const ToolShape tool{radius * s.unit, 0};
    const ForceLaw law{250, 0, 0};
    base::Random random(test::seed());
    Proxy proxy(tool);
    Vec3d x = s.outside;
    proxy.place(s.surface, x);
    constexpr int ticks = 600; // fewer hardly reach the surface
    int contacts = 0;
    for (int i = 0; i < ticks; ++i) {
        // a walk about the surface: down to 0.6 h in it and up to 0.3 h off
        x += random.unitVector() * (random.uniform() * 0.2 * s.unit);
        const double high = std::clamp(s.distance(x) - tool.radius, -0.6 * s.unit, 0.3 * s.unit);
        x = onto(s, x) + s.outward(x) * (high + tool.radius);
        if (std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}) > s.size)
            x *= 0.9;
        proxy.move(s.surface, x);
        const double depth = tool.radius - s.distance(x);
        const Vec3d expected = s.outward(x) * (law.stiffness * std::max(0.0, depth));
        const Vec3d force = forceOn(law, proxy, s.surface, x, {});
        const std::string told = s.name + " tick " + std::to_string(i) + " seed " + std::to_string(test::seed()) +
                                 " depth/h " + std::to_string(depth / s.unit) + " off by " +
                                 std::to_string(length(force - expected) / law.stiffness / s.unit) + " h";
        QVERIFY2(length(force - expected) <= 1e-3 * length(expected) + 1e-4 * law.stiffness * s.unit, told.c_str());
        if (proxy.touches()) {
            ++contacts;
            const auto foot = nearestFoot(s.surface, proxy.position());
            QVERIFY2(foot, told.c_str());
            QVERIFY2(std::abs(distance(foot->position, proxy.position()) - tool.radius) <= 1e-4 * s.unit, told.c_str());
        }
    }
    QVERIFY(contacts > ticks / 4);
}

void ProxyTest::stickEndsAtTheCoefficient_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("friction");
    for (const double radius : {0.0, 0.5})
        for (const double friction : {0.05, 0.4, 1.5})
            QTest::addRow("radius %g h, %g", radius, friction) << radius << friction;
}

void ProxyTest::stickEndsAtTheCoefficient() {
    QFETCH(double, radius);
    QFETCH(double, friction);
    const Solid s = plane();
    const double depth = 0.3 * s.unit;
    Proxy proxy({radius * s.unit, friction});
    const double z = radius * s.unit - depth;
    proxy.place(s.surface, {0, 0, 0.3});
    proxy.move(s.surface, {0, 0, z});
    const double limit = friction * depth;
    for (const double part : {0.3, 0.7, 0.99}) {
        proxy.move(s.surface, {0, part * limit, z});
        QVERIFY(std::abs(proxy.position().y) <= 1e-5 * s.unit);
    }
    for (const double part : {1.01, 1.5, 3.0}) {
        proxy.move(s.surface, {0, part * limit, z});
        QVERIFY(std::abs(proxy.position().y - (part - 1) * limit) <= 1e-3 * limit);
    }
    // back again: it sticks until the force has turned over
    const double at = proxy.position().y;
    proxy.move(s.surface, {0, at - 0.99 * limit, z});
    QVERIFY(std::abs(proxy.position().y - at) <= 1e-5 * s.unit);
    proxy.move(s.surface, {0, at - 1.02 * limit, z});
    QVERIFY(proxy.position().y < at - 0.01 * limit);
}

void ProxyTest::slidingFeelsTheCoefficient_data() {
    addSolids();
}

void ProxyTest::slidingFeelsTheCoefficient() {
    QFETCH(int, solid);
    QFETCH(double, radius);
    const Solid& s = chosen(solid);
    const ToolShape tool{radius * s.unit, 0.4};
    Proxy proxy(tool);
    Vec3d x = s.outside;
    proxy.place(s.surface, x);
    Vec3d way = base::perpendicular(s.outward(onto(s, x)));
    for (int i = 0; i < 120; ++i) {
        const Vec3d n = s.outward(x);
        way = base::normalized(way - n * dot(way, n));
        if (i > 0 && length(x) < s.size)
            x += way * (0.05 * s.unit);
        x = onto(s, x) + s.outward(x) * (tool.radius - 0.25 * s.unit);
        proxy.move(s.surface, x);
        if (i < 20)
            continue;
        QVERIFY(proxy.touches());
        const Vec3d force = proxy.position() - x, normal = s.outward(proxy.position());
        const double along = dot(force, normal), across = length(force - normal * along);
        QVERIFY2(std::abs(across / along - tool.friction) <= 0.01 * tool.friction,
                 (s.name + " tick " + std::to_string(i) + ": " + std::to_string(across / along)).c_str());
    }
}

void ProxyTest::forceFollowsTheToolWithoutJumps_data() {
    addSolids();
}

void ProxyTest::forceFollowsTheToolWithoutJumps() {
    QFETCH(int, solid);
    QFETCH(double, radius);
    const Solid& s = chosen(solid);
    const ToolShape tool{radius * s.unit, 0.2};
    const ForceLaw law{1, 0, 0};
    const double limit = s.unit; // the force of a tool h deep
    Proxy proxy(tool);
    const Vec3d begin = s.outside, n = s.outward(begin), u = base::perpendicular(n);
    const Vec3d at = onto(s, begin) + n * tool.radius;
    proxy.place(s.surface, begin);
    Vec3d before, force;
    for (int i = 0; i < 400; ++i) { // in, about and out again, 0.01 h a tick
        const double t = i / 400.0;
        const Vec3d x = at + n * ((0.3 - std::sin(shapes::pi * t)) * 0.7 * s.unit) +
                        u * (std::sin(6 * t) * 0.4 * s.unit) + cross(n, u) * (std::sin(9 * t) * 0.3 * s.unit);
        proxy.move(s.surface, x);
        force = forceOn(law, proxy, s.surface, x, {});
        QVERIFY2(
            i == 0 || length(force - before) <= 0.02 * limit,
            (s.name + " tick " + std::to_string(i) + ": " + std::to_string(length(force - before) / limit)).c_str());
        before = force;
    }
    QVERIFY(!proxy.touches());
}

/// Grain is felt as grain: a noisy scan's normals turn from surfel to surfel, and yet a tick of 0.01 h changes the
/// force by no more than 2 % of what a tool h deep feels.
void ProxyTest::forceFollowsTheToolOnNoise() {
    const double unit = 3.5 * shapes::sphereSpacing(4000, 1), limit = unit;
    base::Random random(test::seed());
    for (const double noise : {0.05, 0.1}) { // of a spacing
        const surface::Surface surface =
            shapes::surfaceOf(shapes::jittered(shapes::sphere(4000, 1, unit), noise * unit / 3.5, 7));
        for (int walk = 0; walk < 20; ++walk) {
            const Vec3d n = random.unitVector(), u = base::perpendicular(n);
            Proxy proxy;
            proxy.place(surface, n * (1 + unit));
            Vec3d before, force;
            for (int i = 0; i < 400; ++i) { // half an h deep, and along
                const double along = 0.008 * unit * i, deep = std::min(0.5, 0.006 * i);
                const Vec3d x = base::normalized(n + u * along) * (1 + (0.1 - deep) * unit);
                proxy.move(surface, x);
                force = forceOn({1, 0, 0}, proxy, surface, x, {});
                QVERIFY2(i == 0 || length(force - before) <= 0.02 * limit,
                         qPrintable(QString("noise %1, seed %2, walk %3, tick %4: %5")
                                        .arg(noise)
                                        .arg(test::seed())
                                        .arg(walk)
                                        .arg(i)
                                        .arg(length(force - before) / limit)));
                before = force;
            }
            QVERIFY(proxy.touches());
        }
    }
}

void ProxyTest::openSheetsAreFeltFromBothSides() {
    constexpr double unit = 0.35;
    const surface::Surface sheet = shapes::surfaceOf(shapes::plane(12, 0.1, unit), shapes::bounded(0.25f));
    for (const double radius : {0.0, 0.2})
        for (const double side : {1.0, -1.0}) {
            Proxy proxy({radius, 0});
            proxy.place(sheet, {0.03, 0.04, side});
            proxy.move(sheet, {0.03, 0.04, side * (radius - 0.1)});
            QVERIFY(proxy.touches());
            QVERIFY(std::abs(proxy.position().z - side * radius) < 1e-4 * unit);
            QVERIFY(proxy.normal().z * side > 0.999);
        }
}

void ProxyTest::toolsSlideOffRims() {
    constexpr double unit = 0.35;
    const surface::Surface sheet = shapes::surfaceOf(shapes::plane(12, 0.1, unit), shapes::bounded(0.25f));
    for (const double radius : {0.0, 0.1}) {
        Proxy proxy({radius, 0});
        proxy.place(sheet, {0, 0.03, 0.5});
        double last = 0;
        for (double x = 0; x < 2; x += 0.01) {
            proxy.move(sheet, {x, 0.03, radius - 0.1});
            if (proxy.touches())
                last = x;
        }
        QVERIFY2(last > 1.1 && last < 1.2 + 0.5 * unit, std::to_string(last).c_str());
        QVERIFY(distance(proxy.position(), Vec3d{1.99, 0.03, radius - 0.1}) < 0.02);
    }
}

void ProxyTest::insideOfSolidsOnePushesOut() {
    const Solid s = sphere();
    for (const double radius : {0.0, 0.1})
        for (const double from : {0.999, 0.88, 0.4, 0.02, 0.0}) { // from its middle, too
            Proxy proxy({radius, 0});
            const Vec3d x = base::normalized(Vec3d{1, 2, 8.5}) * from;
            proxy.place(s.surface, x);
            proxy.move(s.surface, x);
            QVERIFY2(proxy.touches(), std::to_string(from).c_str());
            QVERIFY2(std::abs(proxy.depth() - (1 + radius - from)) < 0.01 * s.unit, std::to_string(from).c_str());
        }
}

void ProxyTest::toolsMayBeginOnTheSurface() {
    const Solid s = sphere();
    const surface::Surface sheet = shapes::surfaceOf(shapes::plane(12, 0.1, 0.35), shapes::bounded(0.25f));
    base::Random random(test::seed());
    for (int i = 0; i < test::effort(200); ++i) {
        const Vec3d n = random.unitVector();
        Proxy proxy;
        proxy.place(s.surface, nearestFoot(s.surface, n)->position + n * (random.uniform(-1, 1) * 1e-9));
        proxy.move(s.surface, n * 0.97);
        QVERIFY2(std::abs(length(proxy.position()) - 1) < 1e-3, std::to_string(test::seed()).c_str());
        QVERIFY(dot(proxy.normal(), n) > 0.99);
    }
    Proxy proxy;
    proxy.place(sheet, {0.02, 0.03, 0});
    proxy.move(sheet, {0.02, 0.03, 0.5});
    proxy.move(sheet, {0.02, 0.03, -0.1});
    QVERIFY(proxy.touches() || proxy.position().z < -0.09); // whichever side it began on, that one holds
}

/// Half way round a sphere in one tick, pressed: a patient proxy is there, a timely one is under way on the surface.
void ProxyTest::placesFarApartAreReachedWithPatience() {
    const Solid s = sphere();
    const Vec3d begin{0, 0, 0.9}, end{0.9 * std::sin(2.5), 0, 0.9 * std::cos(2.5)};
    for (const int steps : {Proxy::timely, Proxy::patient}) {
        Proxy proxy({0, 0}, steps);
        proxy.place(s.surface, begin);
        for (int tick = 0; tick < (steps == Proxy::timely ? 4 : 1); ++tick) {
            proxy.move(s.surface, end);
            QVERIFY(std::abs(length(proxy.position()) - 1) < 1e-3);
        }
        QVERIFY2(distance(proxy.position(), base::normalized(end)) < 1e-3 * s.unit,
                 std::to_string(distance(proxy.position(), base::normalized(end)) / s.unit).c_str());
    }
}

void ProxyTest::nothingIsFeltOfNothing() {
    Proxy proxy;
    const surface::Surface nothing;
    proxy.place(nothing, {1, 2, 3});
    proxy.move(nothing, {4, 5, 6});
    QVERIFY(!proxy.touches());
    QVERIFY(distance(proxy.position(), Vec3d{4, 5, 6}) < 1e-12);
}

void ProxyTest::dampingNeverPulls() {
    const Solid s = plane();
    Proxy proxy;
    proxy.place(s.surface, {0, 0, 0.1});
    const Vec3d x{0, 0, -0.02};
    proxy.move(s.surface, x);
    const ForceLaw law{100, 10, 0};
    QVERIFY(std::abs(forceOn(law, proxy, s.surface, x, {0, 0, -0.1}).z - 3) < 1e-6);
    QVERIFY(std::abs(forceOn(law, proxy, s.surface, x, {0, 0, 0.1}).z - 1) < 1e-6);
    QCOMPARE(forceOn(law, proxy, s.surface, x, {0, 0, 5}).z, 0.0);
}

void ProxyTest::shadingTurnsTheForceAlone() {
    const Solid s = torus();
    Proxy proxy;
    proxy.place(s.surface, {0, 0, 0.8});
    const Vec3d x{0.9, 0.1, 0.35};
    proxy.move(s.surface, x);
    const Vec3d plain = forceOn({1, 0, 0}, proxy, s.surface, x, {}),
                shaded = forceOn({1, 0, 0.5}, proxy, s.surface, x, {});
    QVERIFY(proxy.touches());
    QVERIFY(std::abs(length(shaded) - length(plain)) < 1e-3 * length(plain));
    QVERIFY(dot(shaded, plain) > 0.99 * lengthSq(plain));
}

static const test::Registered<ProxyTest> registered;
#include "proxy_test.moc"
