// Matter drawn out: volumes by formulas, closed models that stay closed, edges that are sharp, walls along loops.
#include "core/solid/extrude/extrude.h"

#include "chosen.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/mesh/extent/extent.h"
#include "core/process/estimation/prepare.h"
#include "core/process/registering/rigid.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/rims.h"
#include "meshed.h"
#include "placed_shapes.h"
#include "process/even_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <numbers>
#include <QTest>

using base::Vec3d, base::Vec3f;
using std::numbers::pi;
using test::chosen, test::meshed;

class ExtrudeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void capsOfBallsComeOutAsCylinders();
    void capsOfPointsByChanceStayClosed();
    void openModelsByChanceEndWhereTheyEnded();
    void facesOfBoxesComeOut_data();
    void facesOfBoxesComeOut();
    void theDirectionIsTheOneGiven();
    void whatStaysKeepsItsPlacesAndWhatMovesItsShape();
    void threadsDoNotShow();
    void loopsGetWallsAsHighAsAsked();
    void rimsOfWallsAreAsHighAsAsked_data();
    void rimsOfWallsAreAsHighAsAsked();
    void wallsGoOnFromTheSurface();
    void modelsThatKnowTheirRimsGetTheSameWalls();
    void whatCannotBeExtrudedIsRefused();
};

namespace {

process::Rigid anyPose(base::Random& random) {
    return process::motionOf(random.unitVector() * random.uniform(0, 2 * pi), random.unitVector() * 3.0);
}

surface::Surface placed(surfel::SurfelList list, const process::Rigid& pose, double noise = 0,
                        base::Random* random = nullptr) {
    for (surfel::Surfel& s : list.items) {
        const Vec3d off = random ? random->unitVector() * (noise * random->uniform()) : Vec3d();
        s.position = base::cast<float>(pose(base::cast<double>(s.position)) + off);
        s.normal = base::cast<float>(pose.turn(base::cast<double>(s.normal)));
    }
    return test::surfaceOf(list);
}

std::string refusal(const auto& work) {
    try {
        work();
    } catch (const base::Error& error) {
        return error.what();
    }
    return {};
}

} // namespace

/// Outwards and inwards: the volume grows by length times the area seen along the direction.
void ExtrudeTest::capsOfBallsComeOutAsCylinders() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(test::sanitized ? 5 : 4); ++round) {
        const process::Rigid pose = anyPose(random);
        const bool in = round & 1; // where edges are knives meshes take long
        const double angle = random.uniform(0.35, in ? 0.6 : 1.2), length = random.uniform(0.3, 0.9) * (in ? -0.5 : 1);
        const surface::Surface ball = placed(test::spherePoints(test::sanitized ? 2500 : 5000), pose);
        const auto part =
            chosen(ball.tree(), pose, [&](const Vec3d& p, const Vec3d&) { return p.z > std::cos(angle); });
        const solid::Extruded result = solid::extrudeSelected(ball, part, {length, {}, round == 0});
        result.surface.tree().validate();
        const mesh::Extent extent = mesh::extentOf(result.surface);
        const double wanted = 4 * pi / 3 + length * pi * std::sin(angle) * std::sin(angle);
        const QByteArray told = QString("angle %1 length %2: volume %3 of %4, seed %5")
                                    .arg(angle)
                                    .arg(length)
                                    .arg(extent.volume)
                                    .arg(wanted)
                                    .arg(test::seed())
                                    .toUtf8();
        QVERIFY2(extent.closed && std::abs(extent.volume / wanted - 1) < 0.005, told);
        QVERIFY2(result.walls > 0 && (result.atEdge > 0) == (round == 0), told);
        if (round == 0) {
            const mesh::Topology topology = meshed(result.surface);
            QVERIFY2(topology.boundaryLoops == 0 && topology.components == 1 && topology.genus() == 0, told);
        }
    }
}

void ExtrudeTest::capsOfPointsByChanceStayClosed() {
    base::Random random(test::seed() + 1);
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    constexpr std::size_t count = 3500;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d n = random.unitVector();
        points.append(test::surfelAt(n, n, test::sphereSpacing(count)), {});
    }
    const surface::Surface ball = process::prepare(points, {.definition = {}, .keepSupports = false});
    for (const double length : {0.5, -0.3}) {
        const auto part = chosen(ball.tree(), {}, [](const Vec3d& p, const Vec3d&) { return p.z > 0.6; });
        const solid::Extruded result = solid::extrudeSelected(ball, part, {length, {}, false});
        const mesh::Extent extent = mesh::extentOf(result.surface);
        const double wanted = 4 * pi / 3 + length * pi * (1 - 0.36);
        QVERIFY2(extent.closed && std::abs(extent.volume / wanted - 1) < 0.02,
                 qPrintable(QString("%1 of %2, seed %3").arg(extent.volume).arg(wanted).arg(test::seed())));
    }
}

/// The foot of a wall counted as rims wherever points lay to one side there.
void ExtrudeTest::openModelsByChanceEndWhereTheyEnded() {
    base::Random random(test::seed());
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    constexpr int count = test::sanitized ? 1500 : 3000;
    for (int i = 0; i < count; ++i)
        points.append(test::surfelAt({random.uniform(-1, 1), random.uniform(-1, 1), 0}, {0, 0, 1}, 1), {});
    const surface::Surface sheet = process::prepare(points, {.definition = {}, .keepSupports = false});
    QCOMPARE(findBoundaryCurves(sheet).size(), std::size_t(1));
    const auto half = chosen(sheet.tree(), {}, [](const Vec3d& p, const Vec3d&) { return p.x > 0.2; });
    const surface::Surface stepped = solid::extrudeSelected(sheet, half, {0.3, {}, true}).surface;
    QVERIFY(surface::knowsRims(stepped));
    for (const surface::BoundaryCurve& curve : findBoundaryCurves(stepped))
        for (const surface::BoundaryPoint& p : curve.points) {
            const Vec3d& x = p.position;
            QVERIFY2(std::max(std::abs(x.x), std::abs(x.y)) > 0.8,
                     qPrintable(QString("%1 %2 %3, seed %4").arg(x.x).arg(x.y).arg(x.z).arg(test::seed())));
        }
    const surface::Surface walled = solid::extrudeLoop(sheet, {}, {0.3, Vec3d{0, 0, 1}, true}).surface;
    const auto wall = findBoundaryCurves(walled);
    QCOMPARE(wall.size(), std::size_t(1));
    for (const surface::BoundaryPoint& p : wall[0].points)
        QVERIFY(p.position.z > 0.2);
}

void ExtrudeTest::facesOfBoxesComeOut_data() {
    QTest::addColumn<double>("length");
    for (const double length : {0.5, -0.3})
        QTest::addRow("%g", length) << length;
}

/// A whole face ends in sharp corners, as the box does.
void ExtrudeTest::facesOfBoxesComeOut() {
    QFETCH(double, length);
    base::Random random(test::seed() + 2);
    { // a face, and a disc in it
        const bool whole = length > 0;
        const solid::Size size{random.uniform(0.9, 1.4), random.uniform(0.9, 1.4), random.uniform(0.7, 1)};
        const surface::Surface box = test::shapeAt("box", size, 0.04);
        const auto part = chosen(box.tree(), {}, [&](const Vec3d& p, const Vec3d& n) {
            return n.z > 0.9 && (whole || std::hypot(p.x, p.y) < 0.3);
        });
        const solid::Extruded result = solid::extrudeSelected(box, part, {length, {}, true});
        const mesh::Extent extent = mesh::extentOf(result.surface);
        const double base = size[0] * size[1], wanted = base * size[2] + length * (whole ? base : pi * 0.09);
        const QByteArray told = QString("%1 %2: volume %3 of %4, seed %5")
                                    .arg(whole)
                                    .arg(length)
                                    .arg(extent.volume)
                                    .arg(wanted)
                                    .arg(test::seed())
                                    .toUtf8();
        QVERIFY2(extent.closed && std::abs(extent.volume / wanted - 1) < (whole ? 0.0005 : 0.005), told);
    }
}

void ExtrudeTest::theDirectionIsTheOneGiven() {
    const surface::Surface ball = test::surfaceOf(test::spherePoints(6000));
    const auto part = chosen(ball.tree(), {}, [](const Vec3d& p, const Vec3d&) { return p.z > 0.7; });
    const Vec3d direction = normalized(Vec3d{0.4, 0, 1});
    const solid::Extruded result = solid::extrudeSelected(ball, part, {0.6, direction, true});
    const mesh::Extent extent = mesh::extentOf(result.surface);
    const double wanted = 4 * pi / 3 + 0.6 * direction.z * pi * (1 - 0.49);
    QVERIFY2(extent.closed && std::abs(extent.volume / wanted - 1) < 0.005,
             qPrintable(QString("%1 of %2").arg(extent.volume).arg(wanted)));
}

void ExtrudeTest::whatStaysKeepsItsPlacesAndWhatMovesItsShape() {
    const surface::Surface ball = test::surfaceOf(test::spherePoints(4000));
    const auto part = chosen(ball.tree(), {}, [](const Vec3d& p, const Vec3d&) { return p.z > 0.7; });
    const solid::Extruded result = solid::extrudeSelected(ball, part, {0.5, Vec3d{0, 0, 1}, false});
    QCOMPARE(result.surface.tree().size(), ball.tree().size() + result.walls);
    QCOMPARE(test::without(ball, result.surface).size(), result.moved);
    std::size_t found = 0;
    std::vector<tree::Neighbour> near;
    for (const surfel::Surfel& s : test::without(ball, result.surface)) {
        result.surface.tree().nearest(s.position + Vec3f{0, 0, 0.5F}, 1, near);
        found += near[0].distanceSq < 1e-12F && near[0].block->normal(near[0].slot) == s.normal &&
                 near[0].block->support(near[0].slot) == s.support;
    }
    QCOMPARE(found, result.moved);
}

void ExtrudeTest::threadsDoNotShow() {
    const surface::Surface ball = test::surfaceOf(test::spherePoints(3000));
    const auto part = chosen(ball.tree(), {}, [](const Vec3d& p, const Vec3d&) { return p.z > 0.7; });
    const auto made = [&] { return test::hashOf(solid::extrudeSelected(ball, part, {0.5, {}, true}).surface); };
    QCOMPARE(test::onThreads(2, made), test::onThreads(1, made));
}

/// On the rim of a disc, straight up, and slanting: the area that comes is the rim's length times the height.
void ExtrudeTest::loopsGetWallsAsHighAsAsked() {
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (const surfel::Surfel& s : test::planePoints(90, 0.05).items)
        if (length(s.position) < 1.5F)
            points.append(s, {});
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.3F;
    const surface::Surface disc{tree::SurfelTree::build(points), definition};
    const auto curves = surface::findBoundaryCurves(disc);
    QCOMPARE(curves.size(), std::size_t(1));
    for (const bool creases : {true, false}) {
        const solid::Extruded result = solid::extrudeLoop(disc, {}, {0.6, {}, creases});
        QCOMPARE(surface::findBoundaryCurves(result.surface).size(), std::size_t(1));
        double highest = 0, inwards = 1;
        for (const surfel::Surfel& s : test::without(result.surface, disc))
            if (s.position.z > 0.01F) {
                highest = std::max(highest, double(s.position.z));
                const Vec3d p = base::cast<double>(s.position), in = -normalized(Vec3d{p.x, p.y, 0});
                inwards = std::min(inwards, dot(in, base::cast<double>(s.normal)));
            }
        QVERIFY2(highest < 0.6 && highest > 0.55 && inwards > 0.95,
                 qPrintable(QString("%1 %2").arg(highest).arg(inwards)));
        const double wanted = curves[0].length() * 0.6 / (0.05 * 0.05);
        QVERIFY2(std::abs(double(result.walls) / wanted - 1) < 0.15,
                 qPrintable(QString("%1 of %2").arg(result.walls).arg(wanted)));
    }
    const solid::Extruded slanting = solid::extrudeLoop(disc, 0, {0.6, normalized(Vec3d{0.4, 0, 1}), true});
    QCOMPARE(surface::findBoundaryCurves(slanting.surface).size(), std::size_t(1));
}

void ExtrudeTest::rimsOfWallsAreAsHighAsAsked_data() {
    QTest::addColumn<double>("limit");
    for (const double limit : {0.15, 0.18, 0.21, 0.26, 0.3})
        QTest::addRow("%g", limit) << limit;
}

namespace {

surface::Surface openTube(double limit, double s) {
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    const int around = int(std::lround(2 * pi / s * 0.93));
    for (int row = 0; row < 30; ++row)
        for (int k = 0; k < around; ++k) {
            const double a = 2 * pi * (k + 0.5 * (row & 1)) / around;
            const Vec3d n{std::cos(a), std::sin(a), 0};
            points.append(test::surfelAt(n + Vec3d{0, 0, row * s * 0.93}, n, s), {});
        }
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = float(limit);
    return {tree::SurfelTree::build(points), definition};
}

/// Mean heights of its rims, the lower one first.
std::vector<double> rimsOf(const surface::Surface& tube) {
    std::vector<double> out;
    for (const surface::BoundaryCurve& curve : surface::findBoundaryCurves(tube)) {
        double sum = 0;
        for (const surface::BoundaryPoint& p : curve.points)
            sum += p.position.z;
        out.push_back(sum / double(curve.points.size()));
    }
    std::ranges::sort(out);
    return out;
}

} // namespace

/// Wherever the limit draws them.
void ExtrudeTest::rimsOfWallsAreAsHighAsAsked() {
    QFETCH(double, limit);
    const double s = 0.07;
    const surface::Surface tube = openTube(limit, s);
    const std::vector<double> before = rimsOf(tube);
    QCOMPARE(before.size(), std::size_t(2));
    const auto curves = surface::findBoundaryCurves(tube);
    const std::size_t upper = curves[0].points[0].position.z > 0.5 ? 0 : 1;
    const std::vector<double> after = rimsOf(solid::extrudeLoop(tube, upper, {0.6, Vec3d{0, 0, 1}, true}).surface);
    QVERIFY2(after.size() == 2 && std::abs(after[1] - before[1] - 0.6) < 0.12 * s,
             qPrintable(QString::number((after.back() - before[1] - 0.6) / s)));
}

/// Along the axis of an open tube: the tube goes on.
void ExtrudeTest::wallsGoOnFromTheSurface() {
    const surface::Surface tube = openTube(0.3, 0.06);
    const auto curves = surface::findBoundaryCurves(tube);
    const std::size_t upper = curves.at(0).points[0].position.z > 0.5 ? 0 : 1;
    const solid::Extruded result = solid::extrudeLoop(tube, upper, {0.8, Vec3d{0, 0, 1}, true});
    QCOMPARE(result.atEdge, std::size_t(0)); // flat
    QCOMPARE(surface::findBoundaryCurves(result.surface).size(), std::size_t(2));
    for (const surfel::Surfel& each : test::without(result.surface, tube)) {
        const Vec3d p = base::cast<double>(each.position), flat{p.x, p.y, 0};
        QVERIFY(std::abs(length(flat) - 1) < 0.01 && dot(normalized(flat), base::cast<double>(each.normal)) > 0.99);
    }
}

namespace {

/// Round, of radius 1.5; its surfels tell where it ends, or its limit does.
surface::Surface openDisc(bool known) {
    auto layout = std::make_shared<surfel::AttributeLayout>(*test::orientedLayout());
    layout->add(surface::rimName, surfel::ScalarType::UInt8);
    surfel::SurfelList points;
    points.layout = layout;
    for (const surfel::Surfel& s : test::planePoints(90, 0.05).items)
        if (length(s.position) < 1.5F) {
            const std::uint32_t rim = 1.5F - length(s.position) < surface::rimReach * s.support ? 1 : 0;
            points.append(s, {&rim, 1});
        }
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.3F;
    definition.knownRims = known;
    return {tree::SurfelTree::build(points), definition};
}

} // namespace

void ExtrudeTest::modelsThatKnowTheirRimsGetTheSameWalls() {
    std::vector<std::size_t> walls, curves;
    for (const bool known : {false, true}) {
        const surface::Surface disc = openDisc(known);
        const auto part = chosen(disc.tree(), {}, [](const Vec3d& p, const Vec3d&) { return length(p) < 0.7; });
        for (const solid::Extruded& result :
             {solid::extrudeLoop(disc, {}, {0.6, {}, true}), solid::extrudeSelected(disc, part, {0.5, {}, true})}) {
            walls.push_back(result.walls);
            curves.push_back(surface::findBoundaryCurves(result.surface).size());
        }
    }
    QVERIFY(walls[0] > 0 && walls[1] > 0);
    QCOMPARE(walls[2], walls[0]);
    QCOMPARE(walls[3], walls[1]);
    QCOMPARE(curves, std::vector<std::size_t>(4, 1));
}

void ExtrudeTest::whatCannotBeExtrudedIsRefused() {
    const surface::Surface ball = test::surfaceOf(test::spherePoints(2000));
    const auto says = [&](const auto& work, const char* what) {
        const std::string told = refusal(work);
        if (told.find(what) == std::string::npos)
            qWarning("%s", told.c_str());
        return told.find(what) != std::string::npos;
    };
    const auto above = [&](double z) {
        return chosen(ball.tree(), {}, [z](const Vec3d& p, const Vec3d&) { return p.z > z; });
    };
    QVERIFY(says([&] { solid::extrudeSelected(ball, above(0.5), {0, {}, true}); }, "length of 0"));
    QVERIFY(says([&] { solid::extrudeSelected(ball, above(-2), {1, {}, true}); }, "left beside"));
    QVERIFY(says([&] { solid::extrudeSelected(ball, above(0.9999), {1, {}, true}); }, "selected"));
    QVERIFY(says([&] { solid::extrudeSelected(ball, above(-0.98), {1, {}, true}); }, "all ways"));
    QVERIFY(says([&] { solid::extrudeLoop(ball, {}, {1, {}, true}); }, "no boundary"));
    surfel::SurfelList two = test::spherePoints(1000); // one of two balls
    for (surfel::Surfel s : test::spherePoints(1000).items) {
        s.position = s.position + Vec3f{5, 0, 0};
        two.append(s, {});
    }
    const surface::Surface pair = test::surfaceOf(two);
    const auto one = chosen(pair.tree(), {}, [](const Vec3d& p, const Vec3d&) { return p.x > 2; });
    QVERIFY(says([&] { solid::extrudeSelected(pair, one, {1, Vec3d{1, 0, 0}, true}); }, "no border"));
}

static const test::Registered<ExtrudeTest> registered;
#include "extrude_test.moc"
