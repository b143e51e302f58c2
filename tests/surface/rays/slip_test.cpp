// No ray slips through parts about as thin as the sampling is wide: what dense marching in float64 hits, is hit.
#include "support/registry.h"
#include "surface/rays/dense_march.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d;

class SlipTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void noRaySlipsThroughThinParts_data();
    void noRaySlipsThroughThinParts();
};

namespace {

constexpr double spacing = 0.05, support = 3.5 * spacing, infinity = std::numeric_limits<double>::infinity();
constexpr int half = 12; ///< extent of a part in spacings

/// Samples off the regular grid, so that no ray runs along rows of them.
class Part {
  public:
    explicit Part(std::uint64_t seed) : m_random(seed) { m_list.layout = shapes::layout(true, true); }
    double off(int i) { return (i + m_random.uniform(-0.15, 0.15)) * spacing; }
    void add(const Vec3d& p, const Vec3d& n) { m_list.items.push_back(shapes::surfelAt(p, n, support)); }
    Surface surface() const { return shapes::surfaceOf(m_list); }

  private:
    base::Random m_random;
    surfel::SurfelList m_list;
};

/// Two sheets one spacing apart, closed along their edges by a row of samples.
Surface plate(std::uint64_t seed) {
    Part part(seed);
    for (int i = -half; i <= half; ++i) {
        for (int j = -half; j <= half; ++j)
            for (const double side : {1.0, -1.0})
                part.add({part.off(i), part.off(j), 0.5 * side * spacing}, {0, 0, side});
        for (const double side : {1.0, -1.0}) {
            const double edge = side * (half + 0.5) * spacing;
            part.add({edge, part.off(i), 0}, {side, 0, 0});
            part.add({part.off(i), edge, 0}, {0, side, 0});
        }
    }
    return part.surface();
}

/// Two walls that lean towards each other by 0.35 rad, one spacing apart where they end in a row of samples.
Surface wedge(std::uint64_t seed) {
    constexpr double lean = 0.175;
    Part part(seed);
    for (int j = -half; j <= half; ++j) {
        for (int i = 0; i <= half; ++i)
            for (const double side : {1.0, -1.0}) {
                const double along = std::abs(part.off(i));
                part.add({-along * std::cos(lean), part.off(j), side * (0.5 * spacing + along * std::sin(lean))},
                         {std::sin(lean), 0, side * std::cos(lean)});
            }
        part.add({0.5 * spacing, part.off(j), 0}, {1, 0, 0});
    }
    return part.surface();
}

bool hits(const Surface& surface, const base::Rayd& ray) {
    return !dense::hits(surface, ray, 0, infinity, true).empty();
}
/// Not by a hair: the rays a little beside it hit too.
bool surelyHits(const Surface& surface, const base::Rayd& ray) {
    const Vec3d u = base::perpendicular(ray.direction), v = cross(ray.direction, u);
    for (const Vec3d& beside : {Vec3d{}, u, -u, v, -v})
        if (!hits(surface, {ray.origin + beside * (1e-3 * spacing), ray.direction}))
            return false;
    return true;
}

} // namespace

void SlipTest::noRaySlipsThroughThinParts_data() {
    QTest::addColumn<bool>("wedged");
    QTest::addColumn<bool>("grazing");
    for (const bool wedged : {false, true})
        for (const bool grazing : {false, true})
            QTest::addRow("%s, %s rays", wedged ? "wedge" : "plate", grazing ? "grazing" : "random")
                << wedged << grazing;
}

void SlipTest::noRaySlipsThroughThinParts() {
    QFETCH(bool, wedged);
    QFETCH(bool, grazing);
    const Surface surface = wedged ? wedge(test::seed()) : plate(test::seed());
    base::Random random(test::seed() + 1);
    const int count = std::max(250, qEnvironmentVariableIntValue("POINTCLAY_RAYS"));
    std::vector<base::Rayf> rays;
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(-1, wedged ? 0.05 : 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        const Vec3d target = Vec3d{x * half, y * half, z * (wedged ? 0.5 + 2 * std::abs(x) : 0.5)} * spacing;
        Vec3d d = random.unitVector();
        if (grazing)
            d.z *= 0.1 * random.uniform();
        d = base::normalized(d);
        rays.push_back({base::cast<float>(target - d * 2.0), base::normalized(base::cast<float>(d))});
    }
    std::vector<RayHit<float>> batch(rays.size());
    intersect(surface, rays, {}, batch);
    IntersectOptions robust;
    robust.robust = true;
    int hit = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const base::Rayd ray{base::cast<double>(rays[i].origin),
                             base::normalized(base::cast<double>(rays[i].direction))};
        if (!hits(surface, ray))
            continue;
        ++hit;
        const bool all = batch[i].hit && intersect(surface, rays[i], robust).hit;
        QVERIFY2(
            all || !surelyHits(surface, ray),
            qPrintable(
                QString("ray %1 slips through, fast hits: %2, seed %3").arg(i).arg(batch[i].hit).arg(test::seed())));
    }
    QVERIFY2(hit > count / 2, qPrintable(QString::number(hit)));
}

static const test::Registered<SlipTest> registered;
#include "slip_test.moc"
