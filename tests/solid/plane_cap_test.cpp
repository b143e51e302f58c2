// Flat fills of what a plane cut off: in the plane, with a sharp edge, and nothing left open.
#include "core/base/random.h"
#include "core/cells/labels.h"
#include "core/cells/seam_lines.h"
#include "core/process/estimation/known_rims.h"
#include "core/process/estimation/prepare.h"
#include "core/solid/loops/fill.h"
#include "core/solid/loops/plane_cap.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/rims.h"
#include "process/even_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using base::Vec3d;

class PlaneCapTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatAPlaneCutOpenIsCappedInThePlane_data();
    void whatAPlaneCutOpenIsCappedInThePlane();
    void floorsOfPitsMeetTheirWallsInGrooves();
    void endsOfPipesAreRings();
    void withoutCreasesThereAreNoCells();
    void rimsThatAreKnownAreKnownOfWhatIsLeft();
    void whatTellsOfNoPlaneHasNoCap();
};

namespace {

enum class Drawn { Even, ByChance, Uneven };

/// A ball with a bump, above a plane.
struct CutBall {
    Vec3d bump, normal;
    double high, offset;

    explicit CutBall(base::Random& random)
        : bump(random.unitVector()), normal(random.unitVector()), high(random.uniform(0, 0.3)),
          offset(random.uniform(-0.4, 0.3)) {}
    Vec3d at(const Vec3d& d) const { return d * (1 + high * std::exp((dot(d, bump) - 1) / 0.2)); }
    Vec3d normalAt(const Vec3d& d) const {
        const Vec3d u = normalized(cross(d, std::abs(d.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0})), v = cross(d, u);
        constexpr double step = 1e-5;
        const Vec3d along = at(normalized(d + u * step)) - at(normalized(d - u * step)),
                    across = at(normalized(d + v * step)) - at(normalized(d - v * step));
        return normalized(cross(along, across));
    }
    double above(const Vec3d& x) const { return dot(x, normal) - offset; }
};

surface::Surface opened(const CutBall& ball, Drawn drawn, std::size_t count, base::Random& random) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    for (const surfel::Surfel& even : test::spherePoints(drawn == Drawn::Uneven ? 3 * count : count).items) {
        const Vec3d d = drawn == Drawn::Even ? base::cast<double>(even.position) : random.unitVector();
        if (drawn == Drawn::Uneven && random.uniform() > std::pow(5.0, d.z - 1)) // 25 times as many, 5 times as dense
            continue;
        if (const Vec3d x = ball.at(d); ball.above(x) > 0)
            out.append(test::surfelAt(x, ball.normalAt(d), 1), {});
    }
    return process::prepare(out, {.definition = {}, .keepSupports = false});
}

std::vector<surfel::Surfel> fresh(const surface::Surface& before, const surface::Surface& after) {
    std::vector<surfel::Surfel> out;
    std::vector<tree::Neighbour> near;
    for (const surfel::Surfel& s : after.tree().surfels().items) {
        before.tree().nearest(s.position, 1, near);
        if (near[0].distanceSq > 0)
            out.push_back(s);
    }
    return out;
}

/// A tube about the z axis from z = 0 to 2, whose normals look outwards, or inwards.
surfel::SurfelList tube(double outwards, double radius = 1) {
    const int around = static_cast<int>(72 * radius);
    const double s = 2 * std::numbers::pi / 72;
    const int rows = static_cast<int>(2 / (s * 0.866));
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    for (int row = 0; row < rows; ++row)
        for (int k = 0; k < around; ++k) {
            const double turn = 2 * std::numbers::pi * (k + 0.5 * (row % 2)) / around;
            const Vec3d n{std::cos(turn), std::sin(turn), 0};
            out.append(test::surfelAt(n * radius + Vec3d{0, 0, 2.0 * (row + 0.5) / rows}, n * outwards, s * 0.93), {});
        }
    return out;
}

surface::Surface opened(const surfel::SurfelList& points) {
    return process::prepare(points, {.definition = {}, .keepSupports = false});
}

/// The loop about z = 0.
std::size_t lowest(const surface::Surface& surface) {
    const auto curves = findBoundaryCurves(surface);
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (std::abs(curves[i].points[0].position.z) < 0.3)
            return i;
    return curves.size();
}

} // namespace

void PlaneCapTest::whatAPlaneCutOpenIsCappedInThePlane_data() {
    QTest::addColumn<int>("drawn");
    QTest::newRow("even") << int(Drawn::Even);
    QTest::newRow("by chance") << int(Drawn::ByChance);
    QTest::newRow("1:5") << int(Drawn::Uneven);
}

/// Boundary curves of points by chance lie 1 to 2 spacings beyond where a plane cut them, and patches held by them did.
void PlaneCapTest::whatAPlaneCutOpenIsCappedInThePlane() {
    QFETCH(int, drawn);
    constexpr std::size_t count = test::sanitized ? 1500 : 3000;
    constexpr double within = 0.6; // of the mean spacing
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(1); ++round) {
        const CutBall ball(random);
        const surface::Surface open = opened(ball, Drawn(drawn), count, random);
        const solid::Filled result = solid::fillHoles(open, {.shape = solid::Shape::Flat, .only = {}});
        const double s = test::sphereSpacing(count);
        double most = 0;
        std::size_t came = 0;
        bool faces = true;
        for (const surfel::Surfel& each : fresh(open, result.surface)) {
            most = std::max(most, std::abs(ball.above(base::cast<double>(each.position))));
            faces = faces && dot(base::cast<double>(each.normal), ball.normal) < -0.99;
            ++came;
        }
        const std::vector<cells::SeamLine> seams = cells::seamLines(result.surface);
        const QByteArray told = QString("round %1: %2 points, %3 s off, %4 seams, seed %5")
                                    .arg(round)
                                    .arg(came)
                                    .arg(most / s)
                                    .arg(seams.size())
                                    .arg(test::seed())
                                    .toUtf8();
        QVERIFY2(faces && came > 100 && most < within * s, told);
        QVERIFY2(seams.size() == 1 && seams[0].closed, told);
        for (const cells::SeamPoint& p : seams[0].points)
            QVERIFY2(std::abs(ball.above(p.position)) < within * s && p.turn > 0, told);
        QVERIFY2(std::isinf(result.surface.definition().boundaryLimit), told);
    }
}

void PlaneCapTest::floorsOfPitsMeetTheirWallsInGrooves() {
    for (const double outwards : {1.0, -1.0}) {
        const surface::Surface open = opened(tube(outwards));
        const solid::Filled result = solid::fillHoles(open, {.shape = solid::Shape::Flat, .only = lowest(open)});
        for (const surfel::Surfel& each : fresh(open, result.surface))
            QVERIFY(each.normal.z * outwards < -0.99 && std::abs(each.position.z) < 0.05);
        const std::vector<cells::SeamLine> seams = cells::seamLines(result.surface);
        QCOMPARE(seams.size(), std::size_t(1));
        QVERIFY(seams[0].closed && std::abs(seams[0].length() - 2 * std::numbers::pi) < 0.02);
        for (const cells::SeamPoint& p : seams[0].points)
            QVERIFY(p.turn * outwards > 80);
        QCOMPARE(findBoundaryCurves(result.surface).size(), std::size_t(1));
    }
}

/// The bore stays open, and a rod within it is capped by itself.
void PlaneCapTest::endsOfPipesAreRings() {
    surfel::SurfelList points = tube(1);
    for (const auto& [outwards, radius] : {std::pair(-1.0, 0.75), std::pair(1.0, 0.25)})
        for (const surfel::Surfel& each : tube(outwards, radius).items)
            points.append(each, {});
    const surface::Surface open = opened(points);
    const solid::Filled result = solid::fillHoles(open, {.shape = solid::Shape::Flat, .only = {}});
    QCOMPARE(result.loops.size(), std::size_t(6));
    for (const solid::LoopFate& fate : result.loops)
        QVERIFY2(fate.filled && fate.why[0] == 0, fate.why);
    QVERIFY(std::isinf(result.surface.definition().boundaryLimit));
    for (const surfel::Surfel& each : fresh(open, result.surface)) {
        const double r = std::hypot(each.position.x, each.position.y);
        QVERIFY2(r < 0.3 || r > 0.7, qPrintable(QString::number(r)));
        QVERIFY(std::abs(each.normal.z) > 0.99F && each.normal.z * (each.position.z - 1) > 0);
    }
    double length = 0;
    for (const cells::SeamLine& line : cells::seamLines(result.surface)) {
        QVERIFY(line.closed);
        length += line.length();
    }
    QVERIFY2(std::abs(length / (2 * 2 * std::numbers::pi * (1 + 0.75 + 0.25)) - 1) < 0.01,
             qPrintable(QString::number(length)));
}

void PlaneCapTest::withoutCreasesThereAreNoCells() {
    const surface::Surface open = opened(tube(1));
    const solid::Filled result = solid::fillHoles(open, {.shape = solid::Shape::Flat, .creases = false, .only = {}});
    QVERIFY(!cells::LabelLayout::of(*result.surface.tree().layout()));
    for (const surfel::Surfel& each : fresh(open, result.surface))
        QVERIFY(std::abs(each.normal.z) > 0.99F);
}

void PlaneCapTest::rimsThatAreKnownAreKnownOfWhatIsLeft() {
    const surface::Surface open = opened(tube(1));
    std::vector<Vec3d> rims;
    for (const auto& curve : findBoundaryCurves(open))
        for (const auto& p : curve.points)
            rims.push_back(p.position);
    const surface::Surface known = process::endingAt(open, rims);
    QVERIFY(surface::knowsRims(known));
    const solid::Filled result = solid::fillHoles(known, {.shape = solid::Shape::Flat, .only = lowest(known)});
    QVERIFY(surface::knowsRims(result.surface));
    const auto left = findBoundaryCurves(result.surface);
    QVERIFY(left.size() == 1 && left[0].closed && std::abs(left[0].points[0].position.z - 2) < 0.3);
    const surface::Surface whole = solid::fillHoles(known, {.shape = solid::Shape::Flat, .only = {}}).surface;
    QVERIFY(std::isinf(whole.definition().boundaryLimit));
    QVERIFY(surface::knowsRims(whole) && !surface::hasRim(whole.tree())); // and learns where it is cut next
}

/// Left to patches, instead of an error or of places that are no numbers.
void PlaneCapTest::whatTellsOfNoPlaneHasNoCap() {
    const surface::Surface open = opened(tube(1));
    const surface::BoundaryCurve curve = findBoundaryCurves(open)[lowest(open)];
    float row = std::numeric_limits<float>::infinity();
    for (const surfel::Surfel& each : open.tree().surfels().items)
        row = std::min(row, each.position.z);
    const auto loopAt = [&](double z) {
        solid::Loop out = solid::edgeOf(open, solid::evenLoop(open, curve));
        for (solid::LoopPoint& p : out.points)
            p.position.z = z;
        return out;
    };
    solid::Loop loop = loopAt(static_cast<double>(row));
    QVERIFY(solid::PlaneCap::over(open, {&loop, 1}).has_value());
    loop.points[0].spacing *= 0.002; // places as dense as that, all over, are too many
    QVERIFY(!solid::PlaneCap::over(open, {&loop, 1}).has_value());
    loop = loopAt(-0.05);
    for (solid::LoopPoint& p : loop.points)
        p.spacing *= 0.1; // no surfel is near
    QVERIFY(!solid::PlaneCap::over(open, {&loop, 1}).has_value());
}

static const test::Registered<PlaneCapTest> registered;
#include "plane_cap_test.moc"
