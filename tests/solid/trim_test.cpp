// Models cut along drawn outlines: what stays and what goes make the whole, both closed, whatever is drawn.
#include "core/solid/trim.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/cells/labels.h"
#include "core/mesh/check/topology.h"
#include "core/mesh/extent/extent.h"
#include "core/mesh/marching/marching_cubes.h"
#include "placed_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <numbers>
#include <QTest>

using base::Point2;
using base::Vec3d;
using solid::OutlineSide;
using solid::Trim;
using std::numbers::pi;
using test::shapeAt;

class TrimTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void heightsAreThoseOfTheWalls();
    void whatStaysAndWhatGoesMakeTheWhole();
    void squaresLeaveTheirEdgesSharp();
    void roundsHaveNoEdgesAlong();
    void nothingIsOpenWhateverIsDrawn();
    void withoutWallsTheModelEndsThere();
    void threadsDoNotShow();
    void plainOutlinesAreTheSame();
    void whatLeavesNothingIsRefused();
    void anEyeWithinTheModelCutsFromThereOn();
};

namespace {

/// Of a picture of the origin from somewhere.
solid::PictureFrame frameAt(base::Random& random, bool parallel) {
    solid::PictureFrame out;
    out.parallel = parallel;
    out.forward = random.unitVector();
    out.right = base::perpendicular(out.forward);
    out.upright = cross(out.right, out.forward);
    out.eye = out.forward * -5.0;
    return out;
}

/// About a place of the picture, with turns that no corner count makes sharp; `reach` in the plane through the origin.
std::vector<Point2> starOutline(base::Random& random, const solid::PictureFrame& frame, int corners, double reach) {
    std::vector<Point2> out;
    const double unit = frame.parallel ? 1 : 0.2, u = random.uniform(-0.3, 0.3), v = random.uniform(-0.3, 0.3);
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * pi * k / corners, r = reach * random.uniform(1 - 2.0 / corners, 1);
        out.push_back({unit * (u + r * std::cos(angle)), unit * (v + r * std::sin(angle))});
    }
    return out;
}

std::vector<Point2> circle(double radius, int corners) {
    std::vector<Point2> out;
    for (int k = 0; k < corners; ++k)
        out.push_back({radius * std::cos(2 * pi * k / corners), radius * std::sin(2 * pi * k / corners)});
    return out;
}

const solid::PictureFrame fromAbove{{0, 0, 5}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, true};

} // namespace

void TrimTest::heightsAreThoseOfTheWalls() {
    constexpr std::uint64_t seed = 5;
    base::Random random(seed);
    for (int k = 0; k < test::effort(40); ++k) {
        const solid::PictureFrame frame = frameAt(random, k % 2 == 0);
        const OutlineSide side(frame, starOutline(random, frame, 3 + 7 * (k % 9), 1));
        const Vec3d x = random.unitVector() * random.uniform(0, 2);
        // the walls by many places, ten times as far as x may be
        double least = std::numeric_limits<double>::infinity();
        const auto p = side.corners();
        const double depth = frame.depth(x);
        const int steps = 1200 / static_cast<int>(p.size());
        for (std::size_t i = 0; i < p.size(); ++i)
            for (int a = 0; a <= steps; ++a)
                for (int b = -100; b <= 100; ++b) {
                    const double share = static_cast<double>(a) / steps,
                                 u = std::lerp(p[i].x, p[(i + 1) % p.size()].x, share),
                                 v = std::lerp(p[i].y, p[(i + 1) % p.size()].y, share);
                    least = std::min(least, distance(x, frame.place({u, v}, depth + 0.02 * b)));
                }
        const solid::SideValue at = side.at(x);
        QVERIFY2(std::abs(std::abs(at.value) - least) < 0.015, QByteArray::number(k));
        QCOMPARE(at.value < 0, side.holds(x));
        QVERIFY(std::abs(length(at.gradient) - 1) < 1e-9);
        // the height falls to zero along the gradient
        const Vec3d on = x - at.gradient * at.value;
        QVERIFY2(std::abs(side.at(on).value) < 1e-9, QByteArray::number(k));
        QVERIFY(dot(side.at(on).gradient, at.gradient) > -1e-6);
    }
}

void TrimTest::whatStaysAndWhatGoesMakeTheWhole() {
    constexpr std::uint64_t seed = 11;
    base::Random random(seed);
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, 0.07);
    for (int k = 0; k < (test::sanitized ? 1 : 3); ++k) {
        const solid::PictureFrame frame = frameAt(random, k % 2 == 0);
        const OutlineSide side(frame, starOutline(random, frame, 5 + k, 0.6));
        double volume = 0;
        for (const Trim trim : {Trim::Away, Trim::Keep}) {
            const solid::Combined part = solid::trimmed(ball, side, trim);
            part.surface.tree().validate();
            const mesh::Extent extent = mesh::extentOf(part.surface);
            QVERIFY2(extent.closed, QByteArray::number(k));
            volume += extent.volume;
        }
        QVERIFY2(std::abs(volume - 4 * pi / 3) < 0.006 * 4 * pi / 3, QByteArray::number(volume));
    }
}

void TrimTest::squaresLeaveTheirEdgesSharp() {
    // a square hole through a box: its volume is exact, and four edges inside are creases as those at both ends
    constexpr double s = 0.05, a = 0.4;
    const surface::Surface box = shapeAt("box", {2, 2, 1}, s);
    const OutlineSide side(fromAbove, {{-a, -a}, {a, -a}, {a, a}, {-a, a}});
    const solid::Combined holed = solid::trimmed(box, side, Trim::Away);
    const mesh::Extent extent = mesh::extentOf(holed.surface);
    QVERIFY(extent.closed);
    QVERIFY2(std::abs(extent.volume - (4 - 4 * a * a)) < 0.006 * 4, QByteArray::number(extent.volume));
    const cells::CellSurface cells = *cells::CellSurface::of(holed.surface);
    // inside an edge of the hole, where walls at right angles meet, their planes go on
    const cells::CellValue at = cells::evaluate(cells, {a + 0.02, a + 0.02, 0.1}, surface::Need::Value);
    QVERIFY(at.mixed);
    QVERIFY2(std::abs(std::abs(at.at.value) - 0.02) < 1e-4, QByteArray::number(at.at.value));
}

void TrimTest::roundsHaveNoEdgesAlong() {
    // drawn in many steps: a round wall in one piece, as a drill's
    constexpr double s = 0.05, r = 0.5;
    const surface::Surface box = shapeAt("box", {2, 2, 1}, s);
    const solid::Combined holed = solid::trimmed(box, OutlineSide(fromAbove, circle(r, 90)), Trim::Away);
    const mesh::Extent extent = mesh::extentOf(holed.surface);
    QVERIFY(extent.closed);
    QVERIFY2(std::abs(extent.volume - (4 - pi * r * r)) < 0.006 * 4, QByteArray::number(extent.volume));
    const auto layout = cells::LabelLayout::of(*holed.surface.tree().layout());
    QVERIFY(layout);
    holed.surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const base::Vec3f p = block.position(slot), n = block.normal(slot);
            if (std::abs(p.z) > 0.5F - 3 * static_cast<float>(s) || std::hypot(p.x, p.y) > 0.6F)
                continue;
            QCOMPARE(layout->at(block, slot).partner, layout->at(block, slot).cell);
            QVERIFY(n.x * p.x + n.y * p.y < -0.99F * std::hypot(p.x, p.y)); // into the hole
        }
    });
}

void TrimTest::nothingIsOpenWhateverIsDrawn() {
    constexpr std::uint64_t seed = 23;
    base::Random random(seed);
    const char* const shapes[] = {"ball", "box", "torus"};
    const solid::Size sizes[] = {{0.8, 0, 0}, {1.1, 1, 0.9}, {0.7, 0.3, 0}};
    for (int k = 0; k < (test::sanitized ? 1 : 6); ++k) {
        const std::size_t i = random.below(3);
        const surface::Surface model = shapeAt(shapes[i], sizes[i], 0.09);
        const solid::PictureFrame frame = frameAt(random, k % 2 == 0);
        const OutlineSide side(frame, starOutline(random, frame, 3 + k % 5, 0.8));
        solid::Combined result;
        try {
            result = solid::trimmed(model, side, k % 3 == 0 ? Trim::Keep : Trim::Away);
        } catch (const base::Error&) {
            continue; // all of it, or nothing
        }
        mesh::MarchingOptions options;
        options.cell = 0.06;
        mesh::MarchingReport report;
        const mesh::Mesh made = mesh::marchingCubes(result.surface, options, report);
        const mesh::Topology topology = mesh::topologyOf(made.triangles, made.positions.size());
        QVERIFY2(topology.boundaryLoops == 0, QByteArray::number(k));
    }
}

void TrimTest::withoutWallsTheModelEndsThere() {
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, 0.06);
    solid::CutOptions open;
    open.cap = false;
    const OutlineSide side(fromAbove, circle(0.5, 40));
    const solid::Combined tube = solid::trimmed(ball, side, Trim::Away, open);
    QCOMPARE(tube.inserted, std::size_t(0));
    QVERIFY(std::isfinite(tube.surface.definition().boundaryLimit));
    for (const surfel::Surfel& s : tube.surface.tree().surfels().items)
        QVERIFY(std::hypot(s.position.x, s.position.y) > 0.49F);
}

void TrimTest::threadsDoNotShow() {
    base::Random random(3);
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, 0.08);
    const solid::PictureFrame frame = frameAt(random, false);
    const OutlineSide side(frame, starOutline(random, frame, 7, 0.6));
    const auto hash = [&] { return solid::trimmed(ball, side, Trim::Away).surface.tree().contentHash().text(); };
    QCOMPARE(test::onThreads(3, hash), test::onThreads(1, hash));
}

void TrimTest::plainOutlinesAreTheSame() {
    base::Random random(9);
    for (int k = 0; k < 20; ++k) {
        const std::vector<Point2> corners = starOutline(random, fromAbove, 4 + k % 6, 1);
        std::vector<Point2> drawn;
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (int step = 0; step < 30; ++step) {
                const Point2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
                drawn.push_back({std::lerp(a.x, b.x, step / 30.0), std::lerp(a.y, b.y, step / 30.0)});
            }
        std::vector<Point2> plain = solid::plainOutline(drawn), wanted = corners;
        std::ranges::sort(plain);
        std::ranges::sort(wanted);
        QVERIFY(plain == wanted);
    }
    QCOMPARE(solid::plainOutline({{1, 1}, {1, 1}, {1, 1}}).size(), std::size_t(1));
}

void TrimTest::whatLeavesNothingIsRefused() {
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, 0.1);
    const OutlineSide all(fromAbove, circle(2, 20)), beside(fromAbove, {{3, 3}, {4, 3}, {4, 4}});
    QVERIFY_THROWS_EXCEPTION(base::Error, solid::trimmed(ball, all, Trim::Away));
    QVERIFY_THROWS_EXCEPTION(base::Error, solid::trimmed(ball, all, Trim::Keep));
    QVERIFY_THROWS_EXCEPTION(base::Error, solid::trimmed(ball, beside, Trim::Away));
    QVERIFY_THROWS_EXCEPTION(base::Error, solid::trimmed(ball, beside, Trim::Keep));
}

void TrimTest::anEyeWithinTheModelCutsFromThereOn() {
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, test::sanitized ? 0.08 : 0.05);
    const solid::PictureFrame frame{{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, false};
    const OutlineSide side(frame, {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
    const mesh::Extent extent = mesh::extentOf(solid::trimmed(ball, side, Trim::Away).surface);
    // a pyramid's solid angle, of the ball's volume
    const double angle = 4 * std::atan(0.25 / std::sqrt(1 + 0.5)), wanted = (4 * pi - angle) / 3;
    QVERIFY(extent.closed);
    QVERIFY2(std::abs(extent.volume - wanted) < 0.008 * wanted, QByteArray::number(extent.volume / wanted));
}

static const test::Registered<TrimTest> registered;
#include "trim_test.moc"
