// Nothing falls through: random ticks of tools that go anywhere, in one go as far as a hand can, against solids, thin
// walls, sheets, noise, uneven density, surfels without a common sign, and surfaces that change under the tool.
// POINTCLAY_HAPTIC_TICKS asks for more ticks than the suite has time for.
#include "core/haptics/proxy.h"
#include "haptics/solids.h"
#include "support/registry.h"
#include "surface/bounded.h"

#include <QTest>

using namespace haptics;
using namespace haptics_test;

class FallingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void solidsKeepToolsOut_data();
    void solidsKeepToolsOut();
    void thinWallsKeepToolsOnTheirSide_data();
    void thinWallsKeepToolsOnTheirSide();
    void sheetsKeepToolsOnTheirSide();
    void unevenDensityHolds();
    void noiseHolds();
    void surfelsWithoutASignHold();
    void versionsTakeToolsAlong_data();
    void versionsTakeToolsAlong();
};

namespace {

/// Shared out over the tests that ask for a part.
int ticks(double part) {
    const int asked = qEnvironmentVariableIntValue("POINTCLAY_HAPTIC_TICKS");
    return static_cast<int>((asked > 0 ? asked : test::effort(test::effort(100000))) * part);
}

std::string told(const char* what, int tick, double by) {
    return std::string(what) + " in tick " + std::to_string(tick) + " by " + std::to_string(by) + " h, seed " +
           std::to_string(test::seed());
}

/// A walk in a box: short steps, and now and then one of up to a millimetre where h is one.
class Walk {
  public:
    Walk(base::Random& random, const Vec3d& begin, const Vec3d& half, double unit)
        : m_random(random), m_at(begin), m_half(half), m_unit(unit) {}
    const Vec3d& next() {
        const double far = m_random.below(4) == 0 ? 2.0 : 0.2;
        m_at += m_random.unitVector() * (far * m_unit * m_random.uniform());
        for (std::size_t k = 0; k < 3; ++k)
            m_at[k] = std::clamp(m_at[k], -m_half[k], m_half[k]);
        return m_at;
    }

  private:
    base::Random& m_random;
    Vec3d m_at, m_half;
    double m_unit;
};

ToolShape anyTool(base::Random& random, double unit) {
    constexpr double radii[] = {0, 0, 0.02, 0.3, 1.5};
    constexpr double frictions[] = {0, 0.3, 1};
    return {radii[random.below(5)] * unit, frictions[random.below(3)]};
}

/// Random tools walk about a solid of which `surface` is made, put down where `begin` says; none comes deeper into it
/// than `most` of h.
void walkAbout(
    const Solid& s, const surface::Surface& surface, const char* name, int ticks, double most, base::Random& random,
    const std::function<Vec3d(const Vec3d&)>& begin = [](const Vec3d& x) { return x; }) {
    Proxy proxy;
    Walk walk(random, s.outside, Vec3d{1, 1, 1} * s.size, s.unit);
    for (int i = 0; i < ticks; ++i) {
        const Vec3d x = walk.next();
        if (i % 500 == 0) {
            proxy = Proxy(anyTool(random, s.unit));
            proxy.place(surface, begin(x));
        }
        proxy.move(surface, x);
        const double in = (proxy.tool().radius - s.distance(proxy.position())) / s.unit;
        QVERIFY2(in < most, told(name, i, in).c_str());
    }
}

} // namespace

void FallingTest::solidsKeepToolsOut_data() {
    QTest::addColumn<int>("solid");
    for (const int i : {1, 2})
        QTest::newRow(solids()[static_cast<std::size_t>(i)].name.c_str()) << i;
}

void FallingTest::solidsKeepToolsOut() {
    QFETCH(int, solid);
    const Solid s = solid == 1 ? sphere(1500) : torus(0.06);
    base::Random random(test::seed());
    walkAbout(s, s.surface, s.name.c_str(), ticks(0.2), 0.02, random);
}

void FallingTest::thinWallsKeepToolsOnTheirSide_data() {
    QTest::addColumn<double>("thickness");
    for (const double t : {1.5, 2.5})
        QTest::addRow("%g spacings", t) << t;
}

void FallingTest::thinWallsKeepToolsOnTheirSide() {
    QFETCH(double, thickness);
    constexpr double spacing = 0.1, unit = 0.35;
    const surface::Surface wall = shapes::surfaceOf(shapes::plates(24, spacing, unit, thickness * spacing));
    base::Random random(test::seed());
    const int all = ticks(0.1);
    Proxy proxy;
    Walk walk(random, {0, 0, 0.5}, {1.2, 1.2, 1}, unit);
    for (int i = 0; i < all; ++i) {
        const Vec3d x = walk.next();
        if (i % 500 == 0) { // always on top
            proxy = Proxy(anyTool(random, unit));
            proxy.place(wall, {x.x, x.y, 1.2});
        }
        proxy.move(wall, x);
        const double in = (proxy.tool().radius + 0.5 * thickness * spacing - proxy.position().z) / unit;
        QVERIFY2(in < 0.01, told("the wall", i, in).c_str());
    }
}

void FallingTest::sheetsKeepToolsOnTheirSide() {
    constexpr double unit = 0.35;
    const surface::Surface sheet = shapes::surfaceOf(shapes::plane(24, 0.1, unit), shapes::bounded(0.25f));
    base::Random random(test::seed());
    const int all = ticks(0.1);
    Proxy proxy;
    double side = 1;
    Walk walk(random, {0, 0, 0.5}, {1.2, 1.2, 1}, unit);
    for (int i = 0; i < all; ++i) {
        const Vec3d x = walk.next();
        if (i % 500 == 0) {
            side = random.below(2) == 0 ? 1 : -1;
            proxy = Proxy(anyTool(random, unit));
            proxy.place(sheet, {x.x, x.y, side * 1.2});
        }
        proxy.move(sheet, x);
        const double in = (proxy.tool().radius - side * proxy.position().z) / unit;
        QVERIFY2(in < 0.01, told("the sheet", i, in).c_str());
    }
}

/// From one spacing to twenty times that, within a few units.
void FallingTest::unevenDensityHolds() {
    surfel::SurfelList list;
    list.layout = shapes::layout(true, true);
    constexpr double finest = 0.02, width = 1.2;
    const auto spacingAt = [](double x) { return finest * (1 + 19 * std::clamp(x / 3, 0.0, 1.0)); };
    for (double x = -0.5; x < 6; x += spacingAt(x))
        for (double y = -width; y <= width; y += spacingAt(x))
            list.items.push_back(shapes::surfelAt({x, y, 0}, {0, 0, 1}, 3.5 * spacingAt(x)));
    const surface::Surface surface = shapes::surfaceOf(list);
    base::Random random(test::seed());
    const int all = ticks(0.1);
    Proxy proxy;
    Vec3d x{1, 0, 0.1};
    for (int i = 0; i < all; ++i) {
        const double s = spacingAt(x.x);
        x += random.unitVector() * (random.below(4) == 0 ? 7 * s : 0.5 * s) * random.uniform();
        x = {std::clamp(x.x, 0.0, 4.0), std::clamp(x.y, -0.4, 0.4), std::clamp(x.z, -6 * s, 6 * s)};
        if (i % 500 == 0) {
            proxy = Proxy(anyTool(random, 3.5 * s));
            proxy.place(surface, {x.x, x.y, 4});
        }
        proxy.move(surface, x);
        const double in = (proxy.tool().radius - proxy.position().z) / s / 3.5;
        QVERIFY2(in < 0.01, told("the plane", i, in).c_str());
    }
}

void FallingTest::noiseHolds() {
    const Solid s = sphere(1500);
    const double noise = 0.1 * s.unit / 3.5;
    const surface::Surface surface = shapes::surfaceOf(shapes::jittered(shapes::sphere(1500, 1, s.unit), noise, 7));
    base::Random random(test::seed());
    walkAbout(s, surface, "the noisy sphere", ticks(0.1), 0.15, random);
}

void FallingTest::surfelsWithoutASignHold() {
    surfel::SurfelList list = shapes::sphere(1500, 1, 3.5 * shapes::sphereSpacing(1500, 1));
    const Solid s = sphere(1500);
    base::Random random(test::seed());
    for (surfel::Surfel& each : list.items)
        each.normal = random.below(2) == 0 ? each.normal : -each.normal;
    list.layout = shapes::layout(true, false);
    const surface::Surface surface = shapes::surfaceOf(list);
    walkAbout(s, surface, "the sphere", ticks(0.1), 0.05, random,
              [](const Vec3d& x) { return base::normalized(x) * 3.0; });
}

void FallingTest::versionsTakeToolsAlong_data() {
    QTest::addColumn<double>("most"); // of h, between two versions
    for (const double most : {0.02, 0.4, 3.0})
        QTest::addRow("by %g h", most) << most;
}

/// A floor that waves up and down under tools that touch it, hover or press.
void FallingTest::versionsTakeToolsAlong() {
    QFETCH(double, most);
    constexpr double spacing = 0.1, unit = 0.35;
    const surfel::SurfelList flat = shapes::plane(14, spacing, unit);
    const auto floorAt = [&](double height) {
        surfel::SurfelList list = flat;
        for (surfel::Surfel& each : list.items)
            each.position.z = static_cast<float>(height);
        return shapes::surfaceOf(list);
    };
    base::Random random(test::seed());
    const int all = ticks(0.02);
    double height = 0;
    surface::Surface now = floorAt(height);
    Proxy proxy;
    for (int i = 0; i < all; ++i) {
        const Vec3d x{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), height + random.uniform(-2, 3) * unit};
        if (i % 50 == 0) {
            proxy = Proxy({random.below(2) == 0 ? 0.0 : 0.3 * unit, 0.3});
            proxy.place(now, {0, 0, height + 4 * unit});
        }
        proxy.move(now, x);
        if (i % 3 == 0) {
            height += random.uniform(-most, most) * unit;
            height = std::clamp(height, -5 * unit, 5 * unit);
            const surface::Surface next = floorAt(height);
            proxy.follow(now, next);
            now = next;
        }
        const double in = (height + proxy.tool().radius - proxy.position().z) / unit;
        QVERIFY2(in < 0.01, told("the floor", i, in).c_str());
    }
}

static const test::Registered<FallingTest> registered;
#include "falling_test.moc"
