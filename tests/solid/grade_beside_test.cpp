// Solids that are sampled many times as coarsely as what they are put together with.
#include "core/base/random.h"
#include "core/mesh/extent/extent.h"
#include "meshed.h"
#include "placed_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <array>
#include <numbers>
#include <QTest>
#include <set>

using base::Vec3d;
using solid::Operation;

class GradeBesideTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void noCrumbsStandBesideFinerSurfels_data();
    void noCrumbsStandBesideFinerSurfels();
    void whatIsFineEnoughKeepsEveryBit();
    void whatIsFarFromTheSeamKeepsEveryBit();
    void threadsDoNotShow();
};

namespace {

struct Ball {
    double radius, spacing;
    Vec3d middle;
    surface::Surface surface() const {
        return test::shapeAt("ball", {radius, 0, 0}, spacing, solid::poseAlong(middle, {0, 0, 1}));
    }
};

surface::Surface together(const Ball& a, const Ball& b, Operation operation) {
    const surface::Surface other = b.surface();
    return solid::combine(a.surface(), {solid::SurfaceSide(other), other.tree().surfels()}, operation).surface;
}

double volume(double r) {
    return 4 * std::numbers::pi / 3 * r * r * r;
}
double lens(double r, double q, double d) {
    const double h = r + q - d;
    return std::numbers::pi * h * h * (d * d + 2 * d * (r + q) - 3 * (r - q) * (r - q)) / (12 * d);
}

/// Two balls that cross, their spacings in a ratio; either may be the finer one.
std::pair<Ball, Ball> crossing(base::Random& random, double ratio) {
    constexpr double fine = 0.02;
    Ball a{random.uniform(0.2, 0.3), fine, {}}, b{random.uniform(0.6, 0.8), fine * ratio, {}};
    b.middle = random.unitVector() * (b.radius + random.uniform(-0.5, 0.5) * a.radius);
    if (random.below(2) == 0)
        std::swap(a, b);
    return {a, b};
}

using Place = std::array<float, 3>;
std::set<Place> placesOf(const surface::Surface& surface) {
    std::set<Place> out;
    for (const surfel::Surfel& s : surface.tree().surfels().items)
        out.insert({s.position.x, s.position.y, s.position.z});
    return out;
}

} // namespace

void GradeBesideTest::noCrumbsStandBesideFinerSurfels_data() {
    QTest::addColumn<int>("operation");
    for (const solid::OperationRow& row : solid::operationTable())
        if (!test::sanitized || static_cast<std::size_t>(row.operation) == test::seed() % 3)
            QTest::newRow(row.id) << static_cast<int>(row.operation);
}

void GradeBesideTest::noCrumbsStandBesideFinerSurfels() {
    QFETCH(int, operation);
    base::Random random(test::seed() * 3 + static_cast<unsigned long long>(operation));
    const auto [a, b] = crossing(random, random.uniform(6, 9));
    const double d = length(b.middle - a.middle), both = lens(a.radius, b.radius, d);
    const std::array<double, 3> exact = {volume(a.radius) + volume(b.radius) - both, volume(a.radius) - both, both};
    const surface::Surface result = together(a, b, static_cast<Operation>(operation));
    const mesh::Topology topology = test::meshed(result);
    const double found = mesh::extentOf(result).volume, wanted = exact[static_cast<std::size_t>(operation)];
    // a fiftieth of the coarse spacing, all over where the smaller ball is cut
    const double r = std::min(a.radius, b.radius);
    const double most = std::numbers::pi * r * r * std::max(a.spacing, b.spacing) / 50;
    QVERIFY2(topology.components == 1 && topology.boundaryLoops == 0 && std::abs(found - wanted) < most,
             qPrintable(QString("%1 pieces, %2 loops, %3 for %4, spacings %5 and %6, seed %7")
                            .arg(topology.components)
                            .arg(topology.boundaryLoops)
                            .arg(found)
                            .arg(wanted)
                            .arg(a.spacing)
                            .arg(b.spacing)
                            .arg(test::seed())));
}

/// At twice the spacing nothing comes but what either had.
void GradeBesideTest::whatIsFineEnoughKeepsEveryBit() {
    base::Random random(test::seed());
    const auto [a, b] = crossing(random, 2);
    std::set<Place> before = placesOf(a.surface());
    before.merge(placesOf(b.surface()));
    for (const Place& place : placesOf(together(a, b, Operation::Union)))
        QVERIFY2(before.contains(place), qPrintable(QString("seed %1").arg(test::seed())));
}

void GradeBesideTest::whatIsFarFromTheSeamKeepsEveryBit() {
    const Ball coarse{1, 0.06, {}}, fine{0.2, 0.01, {1, 0, 0}};
    const std::set<Place> after = placesOf(together(coarse, fine, Operation::Union));
    std::size_t far = 0;
    for (const Place& place : placesOf(coarse.surface()))
        if (place[0] < 0) {
            ++far;
            QVERIFY(after.contains(place));
        }
    QVERIFY(far > 1000);
}

void GradeBesideTest::threadsDoNotShow() {
    const Ball coarse{0.6, 0.1, {}}, fine{0.3, 0.015, {0.5, 0.1, 0}};
    const auto hash = [&] { return together(coarse, fine, Operation::Difference).tree().contentHash().text(); };
    QCOMPARE(test::onThreads(3, hash), test::onThreads(1, hash));
}

static const test::Registered<GradeBesideTest> registered;
#include "grade_beside_test.moc"
