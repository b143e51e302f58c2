// What is felt of colours and relief: a stiffness that changes from place to place, with a potential of its own.
#include "core/haptics/force_law.h"
#include "haptics/solids.h"
#include "support/registry.h"

#include <QTest>

using namespace haptics;
using namespace haptics_test;

class TextureTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void lightIsHarderThanDark();
    void ridgesAreHarderThanHollows();
    void closedLoopsGainNothing_data();
    void closedLoopsGainNothing();
    void forcesBeginAtZero();
    void deepToolsFeelNoMoreOfIt();
    void withoutColoursThereIsNoGrain();
    void forcesAreBoundedAtRimsAndThinWalls();
};

namespace {

using Paint = std::function<double(const Vec3d&)>; ///< 0 black to 1 white

surface::Surface painted(surfel::SurfelList list, const Paint& paint) {
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->colours = true;
    list.layout = layout;
    for (surfel::Surfel& each : list.items) {
        const auto grey = static_cast<unsigned>(std::lround(255 * paint(base::cast<double>(each.position))));
        each.colour = surfel::rgba(grey, grey, grey);
    }
    return shapes::surfaceOf(list);
}

Vec3d forceAt(const surface::Surface& surface, const Texture& texture, const Vec3d& above, const Vec3d& x) {
    Proxy proxy;
    proxy.place(surface, above);
    proxy.move(surface, x);
    return forceOn({1, 0, 0, texture}, proxy, surface, x, {});
}

constexpr double unit = 0.14;

surfel::SurfelList floorOf() {
    return shapes::plane(40, unit / 3.5, unit);
}

} // namespace

/// A ramp of grey: half of the stiffness comes and goes, and the tool is pushed towards what is dark.
void TextureTest::lightIsHarderThanDark() {
    const auto grey = [](const Vec3d& x) { return std::clamp(0.5 + 0.4 * x.x, 0.0, 1.0); };
    const surface::Surface floor = painted(floorOf(), grey);
    constexpr double depth = 0.05;
    for (const double x : {-0.8, 0.0, 0.8}) {
        const Vec3d f = forceAt(floor, {0, 1}, {x, 0.03, 0.3}, {x, 0.03, -depth});
        const double factor = 1 + (grey({x, 0, 0}) - 0.5);
        QVERIFY2(std::abs(f.z - depth * factor) <= 0.005 * depth, std::to_string(f.z / depth).c_str());
        QVERIFY2(std::abs(f.x + 0.5 * depth * depth * 0.4) <= 0.02 * depth * depth, std::to_string(f.x).c_str());
    }
}

/// Waves of four h in a floor.
void TextureTest::ridgesAreHarderThanHollows() {
    surfel::SurfelList list = floorOf();
    const double k = 2 * shapes::pi / (4 * unit), high = 0.1 * unit;
    for (surfel::Surfel& each : list.items) {
        const double x = static_cast<double>(each.position.x);
        each.position.z = static_cast<float>(high * std::cos(k * x));
        each.normal = base::cast<float>(base::normalized(Vec3d{high * k * std::sin(k * x), 0, 1}));
    }
    const surface::Surface waves = shapes::surfaceOf(list);
    const auto felt = [&](double x, double relief) {
        const double top = nearestFoot(waves, {x, 0.01, high * std::cos(k * x)})->position.z;
        return forceAt(waves, {relief, 0}, {x, 0.01, 0.3}, {x, 0.01, top - 0.02 * unit}).z;
    };
    const double ridge = felt(0, 1) / felt(0, 0), hollow = felt(2 * unit, 1) / felt(2 * unit, 0);
    QVERIFY2(ridge > 1.15 && hollow < 0.85, (std::to_string(ridge) + " " + std::to_string(hollow)).c_str());
    QVERIFY(std::abs(felt(0, 0.5) / felt(0, 0) - 0.5 * (1 + ridge)) < 1e-3); // by as much as is asked for
}

void TextureTest::closedLoopsGainNothing_data() {
    QTest::addColumn<double>("radius");
    for (const double radius : {0.0, 0.5})
        QTest::addRow("radius %g h", radius) << radius;
}

/// Into a painted sphere, along and out again: what the law gives back is what it took.
void TextureTest::closedLoopsGainNothing() {
    QFETCH(double, radius);
    const double support = 3.5 * shapes::sphereSpacing(8000, 1);
    const surface::Surface ball = painted(shapes::sphere(8000, 1, support), [](const Vec3d& x) {
        return 0.5 + 0.4 * std::sin(9 * x.x) * std::cos(7 * x.y);
    });
    base::Random random(test::seed());
    for (int walk = 0; walk < test::effort(4); ++walk) {
        const Vec3d n = random.unitVector(), u = base::perpendicular(n), v = cross(n, u);
        Proxy proxy({radius * support, 0});
        double work = 0, turned = 0;
        Vec3d before, force;
        constexpr int parts = 1000;
        for (int i = 0; i <= parts; ++i) {
            const double t = 2 * shapes::pi * i / parts;
            const Vec3d at = base::normalized(n + (u * std::cos(t) + v * std::sin(t)) * support);
            const Vec3d x = at * (1 + radius * support + (0.2 - 0.6 * std::sin(0.5 * t)) * support);
            if (i == 0)
                proxy.place(ball, x);
            proxy.move(ball, x);
            const Vec3d now = forceOn({1, 0, 0, {0, 1}}, proxy, ball, x, {});
            if (i > 0) {
                work += 0.5 * dot(now + force, x - before);
                turned += std::abs(0.5 * dot(now + force, x - before));
            }
            before = x;
            force = now;
        }
        QVERIFY2(std::abs(work) <= 4e-3 * turned,
                 (std::to_string(work / turned) + ", seed " + std::to_string(test::seed())).c_str());
    }
}

/// However far a hand pushes past an edge of black and white, it is not thrown aside.
void TextureTest::deepToolsFeelNoMoreOfIt() {
    const surface::Surface floor = painted(floorOf(), [](const Vec3d& x) { return x.x > 0 ? 1.0 : 0.0; });
    for (const double depth : {0.5, 2.0, 8.0}) {
        const Vec3d f = forceAt(floor, {1, 1}, {0.02, 0.03, 0.3}, {0.02, 0.03, -depth});
        QVERIFY2(std::abs(f.z / depth - 1) < 0.5 && std::hypot(f.x, f.y) < 1.6 * depth,
                 qPrintable(QString("%1: %2, %3, %4").arg(depth).arg(f.x).arg(f.y).arg(f.z)));
    }
}

void TextureTest::forcesBeginAtZero() {
    const surface::Surface floor = painted(floorOf(), [](const Vec3d& x) { return x.x > 0 ? 1.0 : 0.0; });
    for (const double depth : {1e-3, 1e-5}) // in the middle of an edge
        QVERIFY(length(forceAt(floor, {1, 1}, {0.01, 0.02, 0.3}, {0.01, 0.02, -depth})) <= 2 * depth);
}

void TextureTest::withoutColoursThereIsNoGrain() {
    const Solid s = plane();
    const Vec3d x{0.02, 0.01, -0.05};
    QCOMPARE(forceAt(s.surface, {0, 1}, {0, 0, 0.3}, x).z, forceAt(s.surface, {}, {0, 0, 0.3}, x).z);
}

/// Where feet beside the contact end at one place, or on other sheets, nothing may be read from how they differ.
void TextureTest::forcesAreBoundedAtRimsAndThinWalls() {
    base::Random random(test::seed());
    surfel::SurfelList thin = shapes::plates(12, 0.1, 0.35, 0.15), sheet = shapes::plane(12, 0.1, 0.35);
    for (surfel::SurfelList* list : {&thin, &sheet})
        for (surfel::Surfel& each : list->items)
            each.position += base::cast<float>(random.unitVector() * 0.03);
    const auto grey = [](const Vec3d& x) { return x.x > 0.2 ? 1.0 : 0.0; };
    surfel::SurfelList bounded = painted(sheet, grey).tree().surfels();
    for (const surface::Surface& model : {painted(thin, grey), shapes::surfaceOf(bounded, shapes::bounded(0.25f))}) {
        for (int i = 0; i < test::effort(200); ++i) {
            Proxy proxy;
            const Vec3d begin{random.uniform(-1.3, 1.3), random.uniform(-1.3, 1.3), 0.6};
            proxy.place(model, begin);
            for (int k = 0; k < 10; ++k) {
                const Vec3d x = begin + Vec3d{0.02 * k, 0, -0.05 * k - 0.25};
                proxy.move(model, x);
                const double depth = proxy.depth();
                const Vec3d plain = forceOn({1, 0, 0}, proxy, model, x, {}),
                            felt = forceOn({1, 0, 0, {1, 1}}, proxy, model, x, {});
                QVERIFY2(
                    length(felt - plain) <= depth * (1 + 0.5 * depth * 4 / 0.35 * 1.1),
                    (std::to_string(length(felt - plain) / depth) + " seed " + std::to_string(test::seed())).c_str());
            }
        }
    }
}

static const test::Registered<TextureTest> registered;
#include "texture_test.moc"
