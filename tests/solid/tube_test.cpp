// Tubes along curves: heights by brute force, volumes by formulas, nothing open however they wind.
#include "core/solid/tube.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/segment.h"
#include "core/mesh/extent/extent.h"
#include "core/solid/combine.h"
#include "placed_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <numbers>
#include <QTest>

using base::Vec3d;
using solid::TubeSide;
using std::numbers::pi;

class TubeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void curvesGoThroughTheirPlaces();
    void heightsAreThoseOfAllPieces();
    void surfelsLieEvenlyOnTheSurface_data();
    void surfelsLieEvenlyOnTheSurface();
    void volumesAreThoseOfTheFormulas();
    void aHandleIsAHandle();
};

namespace {

std::vector<Vec3d> circle(double radius, int places) {
    std::vector<Vec3d> out;
    for (int k = 0; k < places; ++k)
        out.push_back(Vec3d{std::cos(2 * pi * k / places), std::sin(2 * pi * k / places), 0} * radius);
    out.push_back(out.front());
    return out;
}

std::vector<Vec3d> walk(base::Random& random, int places) {
    std::vector<Vec3d> out;
    Vec3d way = random.unitVector();
    for (int k = 0; k < places; ++k) {
        out.push_back(out.empty() ? Vec3d() : out.back() + way * random.uniform(0.5, 1));
        way = normalized(way + random.unitVector() * 0.8);
    }
    return out;
}

surface::Surface tubeOf(const TubeSide& side, double spacing) {
    return {tree::SurfelTree::build(solid::surfelsOf(side, spacing, {})), {}};
}

} // namespace

void TubeTest::curvesGoThroughTheirPlaces() {
    base::Random random(4);
    for (int round = 0; round < 20; ++round) {
        const std::vector<Vec3d> places = walk(random, 3 + round % 6);
        const std::vector<Vec3d> line = solid::curveThrough(places, 0.1);
        for (const Vec3d& p : places)
            QVERIFY(std::ranges::any_of(line, [&](const Vec3d& q) { return distance(p, q) < 1e-12; }));
        for (std::size_t k = 1; k + 1 < line.size(); ++k) // smooth: from piece to piece it turns little
            QVERIFY(dot(normalized(line[k] - line[k - 1]), normalized(line[k + 1] - line[k])) > 0.8);
        QVERIFY(solid::curveThrough(places, 0.1, false) == places);
    }
    for (const Vec3d& p : solid::curveThrough(circle(2, 24), 0.1))
        QVERIFY(std::abs(length(p) - 2) < 1e-3);
    QCOMPARE(solid::curveThrough(std::vector<Vec3d>(5, Vec3d{1, 2, 3}), 0.1).size(), std::size_t(1));
}

void TubeTest::heightsAreThoseOfAllPieces() {
    constexpr std::uint64_t seed = 6;
    base::Random random(seed);
    for (int round = 0; round < 20; ++round) {
        const TubeSide side(solid::curveThrough(walk(random, 12), 0.2), 0.2);
        for (int k = 0; k < 50; ++k) {
            const Vec3d x = side.line()[random.below(side.line().size())] + random.unitVector() * random.uniform(0, 2);
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i + 1 < side.line().size(); ++i)
                least = std::min(least, distance(x, nearestOnSegment(side.line()[i], side.line()[i + 1], x)));
            QCOMPARE(side.at(x).value, least - 0.2);
            QVERIFY(least < 0.2 || std::abs(side.at(side.foot(x).foot).value) < 1e-9);
        }
    }
}

void TubeTest::surfelsLieEvenlyOnTheSurface_data() {
    QTest::addColumn<bool>("smooth");
    QTest::newRow("bent") << true;
    QTest::newRow("with corners") << false;
}

void TubeTest::surfelsLieEvenlyOnTheSurface() {
    QFETCH(bool, smooth);
    constexpr std::uint64_t seed = 8;
    constexpr double s = 0.05, radius = 0.25;
    base::Random random(seed);
    for (int round = 0; round < (test::sanitized ? 1 : 4); ++round) {
        const TubeSide side(solid::curveThrough(walk(random, 6), radius, smooth), radius);
        const tree::SurfelTree tree = tree::SurfelTree::build(solid::surfelsOf(side, s, {}));
        std::vector<tree::Neighbour> near;
        std::size_t others = 0; // where two parts are as near, at corners
        tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot) {
                const Vec3d x = base::cast<double>(block.position(slot));
                QVERIFY(std::abs(side.at(x).value) < 0.02 * s);
                others += dot(side.at(x).gradient, base::cast<double>(block.normal(slot))) < 0.99;
                tree.nearest(block.position(slot), 2, near);
                const double apart = distance(x, base::cast<double>(near[1].block->position(near[1].slot)));
                QVERIFY2(apart > 0.64 * s && apart < 1.5 * s, QByteArray::number(apart / s));
            }
        });
        QVERIFY2(others < (smooth ? 1 : tree.size() / 100), QByteArray::number(qulonglong(others)));
        for (int k = 0; k < 2000; ++k) { // no place of the surface is far from all
            const Vec3d from = side.line()[random.below(side.line().size())] + random.unitVector() * 0.3;
            const Vec3d x = side.foot(from).foot;
            if (std::abs(side.at(x).value) > 1e-6)
                continue;
            tree.nearest(base::cast<float>(x), 1, near);
            const double apart = distance(x, base::cast<double>(near[0].block->position(near[0].slot)));
            QVERIFY2(apart < 1.15 * s, QByteArray::number(apart / s) + " round " + QByteArray::number(round));
        }
    }
}

void TubeTest::volumesAreThoseOfTheFormulas() {
    // a straight one is a capsule, a closed round one a torus
    constexpr double r = 0.3;
    const TubeSide straight({{0, 0, 0}, {0.8, 0, 0}, {1.2, 0, 0}}, r), round(solid::curveThrough(circle(1, 16), r), r);
    const TubeSide thereAndBack({{0, 0, 0}, {1.2, 0, 0}, {0, 0, 0}}, r);
    const std::pair<const TubeSide*, double> cases[] = {{&thereAndBack, pi * r * r * 1.2 + 4 * pi / 3 * r * r * r},
                                                        {&straight, pi * r * r * 1.2 + 4 * pi / 3 * r * r * r},
                                                        {&round, 2 * pi * pi * r * r}};
    for (const auto& [side, wanted] : cases) {
        const mesh::Extent extent = mesh::extentOf(tubeOf(*side, 0.05));
        QVERIFY(extent.closed);
        QVERIFY2(std::abs(extent.volume - wanted) < 0.005 * wanted, QByteArray::number(extent.volume / wanted));
    }
}

void TubeTest::aHandleIsAHandle() {
    const surface::Surface ball = test::shapeAt("ball", {1, 0, 0}, 0.08);
    const std::vector<Vec3d> places{{0.9, 0, -0.5}, {1.5, 0, -0.3}, {1.5, 0, 0.3}, {0.9, 0, 0.5}};
    const TubeSide side(solid::curveThrough(places, 0.15), 0.15);
    const auto joined = [&] {
        return solid::combine(ball, {side, solid::surfelsOf(side, 0.06, {})}, solid::Operation::Union);
    };
    const solid::Combined cup = joined();
    const mesh::Extent extent = mesh::extentOf(cup.surface);
    QVERIFY(extent.closed);
    QVERIFY(extent.volume > 4 * pi / 3 + 0.05 && extent.volume < 4 * pi / 3 + 0.15);
    base::setThreadCount(1);
    const std::string one = joined().surface.tree().contentHash().text();
    base::setThreadCount(0);
    QCOMPARE(one, cup.surface.tree().contentHash().text());
}

static const test::Registered<TubeTest> registered;
#include "tube_test.moc"
