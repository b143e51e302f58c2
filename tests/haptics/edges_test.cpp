// Where surfaces meet: over edges, in grooves and in slits.
#include "core/haptics/force_law.h"
#include "haptics/solids.h"
#include "support/registry.h"
#include "surface/bounded.h"

#include <QTest>

using namespace haptics;
using namespace haptics_test;

class EdgesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void edgesTurnTheForceWithoutJumps_data();
    void edgesTurnTheForceWithoutJumps();
    void wideToolsRestOnBothWalls();
    void slitsTooNarrowForTheToolPushNoHarderThanItsSpring();
};

void EdgesTest::edgesTurnTheForceWithoutJumps_data() {
    QTest::addColumn<double>("radius"); // in units of h
    for (const double radius : {0.3, 0.5, 1.5})
        QTest::addRow("radius %g h", radius) << radius;
}

/// Pressed a tenth of h into a sharp edge of 90 degrees, over the top, around and down: the normal turns by all of it,
/// and the force never by more than what the tool moved and two per cent.
void EdgesTest::edgesTurnTheForceWithoutJumps() {
    QFETCH(double, radius);
    constexpr double spacing = 0.04, unit = 3.5 * spacing, depth = 0.1 * unit, tick = 0.01 * unit;
    base::Random random(test::seed());
    surfel::SurfelList list;
    list.layout = shapes::layout(true, true);
    const double shift = random.uniform(0, spacing); // of one flank's samples along the edge
    for (int i = 0; i < 30; ++i)
        for (int j = -25; j <= 25; ++j) {
            const double d = (i + 0.5) * spacing;
            list.items.push_back(shapes::surfelAt({-d, j * spacing, 0}, {0, 0, 1}, unit));
            list.items.push_back(shapes::surfelAt({0, j * spacing + shift, -d}, {1, 0, 0}, unit));
        }
    const surface::Surface surface = shapes::surfaceOf(list);
    const double around = radius * unit - depth; // of the tool's centre about the edge
    Proxy proxy({radius * unit, 0});
    proxy.place(surface, {-0.5, 0, 0.5});
    Vec3d x{-0.4, random.uniform(-0.1, 0.1), radius * unit}, before, force, first;
    const double flat = 0.4, all = 2 * flat + 0.5 * shapes::pi * around;
    for (double way = -depth; way < all; way += tick) {
        const double angle = std::clamp((way - flat) / around, 0.0, 0.5 * shapes::pi);
        x.x = std::min(way, flat) - flat + around * std::sin(angle);
        x.z = around * std::cos(angle) - std::max(0.0, way - (all - flat));
        if (way < 0)
            x = {-flat, x.y, radius * unit - depth - way};
        proxy.move(surface, x);
        force = forceOn({1, 0, 0}, proxy, surface, x, {});
        QVERIFY2(distance(force, before) <= tick + 0.02 * unit,
                 qPrintable(QString("%1 h, seed %2").arg(distance(force, before) / unit).arg(test::seed())));
        if (way > 0.1 * flat && first == Vec3d{})
            first = force;
        before = force;
    }
    QVERIFY(distance(first, Vec3d{0, 0, depth}) < 0.01 * depth);
    QVERIFY(distance(force, Vec3d{depth, 0, 0}) < 0.01 * depth);
}

/// A tool wider than a groove of 90 degrees rests on both of its walls.
void EdgesTest::wideToolsRestOnBothWalls() {
    constexpr double spacing = 0.04, unit = 3.5 * spacing;
    surfel::SurfelList list;
    list.layout = shapes::layout(true, true);
    const Vec3d a = base::normalized(Vec3d{1, 0, 1}), b = base::normalized(Vec3d{-1, 0, 1});
    for (int i = 1; i < 40; ++i)
        for (int j = -25; j <= 25; ++j) { // walls z = |x|; their normals face each other
            const double d = (i - 0.5) * spacing / std::sqrt(2.0);
            list.items.push_back(shapes::surfelAt({-d, j * spacing, d}, a, unit));
            list.items.push_back(shapes::surfelAt({d, j * spacing, d}, b, unit));
        }
    const surface::Surface surface = shapes::surfaceOf(list);
    constexpr double radius = 0.4;
    const double rest = radius * std::sqrt(2.0);
    Proxy proxy({radius, 0});
    proxy.place(surface, {0.02, 0, 1.2});
    for (double z = 1.2; z > rest - 0.1; z -= 0.01)
        proxy.move(surface, {0.02, 0, z});
    for (int i = 0; i < 20; ++i)
        proxy.move(surface, {0.02, 0, rest - 0.1});
    QVERIFY2(distance(proxy.position(), Vec3d{0, 0, rest}) < 0.01 * unit,
             std::to_string(distance(proxy.position(), Vec3d{0, 0, rest}) / unit).c_str());
    QVERIFY(proxy.touches());
    // along the groove it moves freely
    proxy.move(surface, {0.02, 0.1, rest - 0.1});
    QVERIFY(std::abs(proxy.position().y - 0.1) < 0.01 * unit);
}

/// Walls that nearly face each other have a place in common, too, far away: nobody is to be thrown there.
void EdgesTest::slitsTooNarrowForTheToolPushNoHarderThanItsSpring() {
    constexpr double spacing = 0.1, unit = 0.35, radius = 0.3;
    base::Random random(test::seed());
    for (const double lean : {0.0, 0.002, 0.02, 0.1}) { // as slopes
        surfel::SurfelList list;
        list.layout = shapes::layout(true, true);
        for (int i = -14; i <= 14; ++i)
            for (int j = -14; j <= 14; ++j)
                for (const double side : {1.0, -1.0}) { // floor and ceiling, 1.3 radii apart
                    const double x = i * spacing, half = 0.65 * radius + lean * x;
                    const Vec3d n = base::normalized(Vec3d{lean, 0, -1});
                    list.items.push_back(shapes::surfelAt({x, j * spacing, side * half}, {n.x, 0, side * n.z}, unit));
                }
        const surface::Surface slit = shapes::surfaceOf(list, shapes::bounded(0.25f));
        for (int walk = 0; walk < test::effort(20); ++walk) {
            Proxy proxy({radius, 0.3 * static_cast<double>(walk % 2)});
            Vec3d x{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.1, 0.1)};
            proxy.place(slit, x);
            for (int i = 0; i < 40; ++i) {
                x += random.unitVector() * (0.1 * unit);
                proxy.move(slit, x);
                const double apart = distance(proxy.position(), x);
                QVERIFY2(proxy.depth() <= apart * (1 + 1e-9) && apart < 2.5, // the slit is 2.8 long
                         qPrintable(QString("depth %1, apart %2, lean %3, seed %4")
                                        .arg(proxy.depth())
                                        .arg(apart)
                                        .arg(lean)
                                        .arg(test::seed())));
            }
        }
    }
}

static const test::Registered<EdgesTest> registered;
#include "edges_test.moc"
