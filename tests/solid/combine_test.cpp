// Solids put together: volumes against formulas, closed results for any pose, seams as creases.
#include "core/solid/combine.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/cells/labels.h"
#include "core/mesh/check/topology.h"
#include "core/mesh/extent/extent.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/solid/cut.h"
#include "placed_shapes.h"
#include "process/even_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <numbers>
#include <QTest>

using base::Vec3d;
using solid::Operation;
using std::numbers::pi;
using test::placed;
using test::shapeAt;

class CombineTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void primitivesHaveTheirVolume();
    void distancesOfPrimitivesAreHeights();
    void ballsHaveTheVolumeOfTheirLens();
    void nothingIsOpenWhateverThePose();
    void aBallDrilledThroughHasOneHandle();
    void blocksAwayFromTheSeamAreShared();
    void bothSidesOfASeamAreItsCells();
    void facesThatCoincideStayOnce();
    void stripsWithoutSurfelsGetSome();
    void halfABallHasHalfItsVolume();
    void slicesOfBallsHaveTheirArea();
    void closedModelsEndWhereTheyAreCut();
    void capsAreAsDenseAsTheModelBeside();
    void capsGoOnInTheColoursBesideThem();
    void threadsDoNotShow();
    void whatLeavesNothingIsRefused();
};

namespace {

solid::Combined with(const surface::Surface& model, const char* id, const solid::Size& size, double spacing,
                     const solid::Pose& pose, Operation operation) {
    const solid::PrimitiveRow& row = solid::primitive(id);
    return solid::combine(
        model, {solid::PrimitiveSide(row, size, pose), placed(solid::surfelsOf(row, size, spacing, {}), pose)},
        operation);
}

/// The same by the surfels alone.
solid::Combined withSurface(const surface::Surface& model, const surface::Surface& other, Operation operation) {
    return solid::combine(model, {solid::SurfaceSide(other), other.tree().surfels()}, operation);
}

double lens(double r, double d) { // of two balls of one radius
    return pi / 12 * (4 * r + d) * (2 * r - d) * (2 * r - d);
}

/// By counting places.
double volumeOnGrid(const solid::Side& a, const solid::Side& b, Operation operation) {
    constexpr int steps = 48;
    constexpr double extent = 1.9, step = 2 * extent / steps;
    int count = 0;
    for (int i = 0; i < steps * steps * steps; ++i) {
        const Vec3d x{(i % steps + 0.5) * step - extent, (i / steps % steps + 0.5) * step - extent,
                      (i / steps / steps + 0.5) * step - extent};
        const bool inA = a.at(x).value < 0, inB = b.at(x).value < 0;
        count += operation == Operation::Union        ? inA || inB
                 : operation == Operation::Difference ? inA && !inB
                                                      : inA && inB;
    }
    return count * step * step * step;
}

solid::Pose randomPose(base::Random& random, double reach) {
    return solid::poseAlong(random.unitVector() * (reach * random.uniform()), random.unitVector());
}

} // namespace

void CombineTest::primitivesHaveTheirVolume() {
    const solid::Size sizes[] = {{1, 0, 0}, {1, 1.5, 2}, {0.7, 1.8, 0}, {0.9, 1.6, 0}, {1, 0.4, 0}, {0.6, 1, 0}};
    std::size_t k = 0;
    for (const solid::PrimitiveRow& row : solid::primitiveTable()) {
        const solid::Size& size = sizes[k++];
        if (test::sanitized && k % 3 != 0)
            continue;
        const mesh::Extent extent = mesh::extentOf(shapeAt(row.id, size, 0.04));
        const double wanted = row.volume(size);
        const QByteArray told = QString("%1: %2 for %3").arg(row.id).arg(extent.volume).arg(wanted).toUtf8();
        QVERIFY2(extent.closed, told);
        // edges are round where cells are not looked at
        QVERIFY2(std::abs(extent.volume - wanted) < (row.sizeCount == 1 ? 0.002 : 0.006) * wanted, told);
    }
}

void CombineTest::distancesOfPrimitivesAreHeights() {
    base::Random random(7);
    const solid::Size size{0.8, 0.5, 0.6};
    for (const solid::PrimitiveRow& row : solid::primitiveTable())
        for (int k = 0; k < test::effort(200); ++k) {
            const solid::Pose pose = randomPose(random, 1);
            const solid::PrimitiveSide side(row, size, pose);
            const surfel::SurfelList surfels = k == 0 ? solid::surfelsOf(row, size, 0.05, {}) : surfel::SurfelList();
            for (const surfel::Surfel& s : surfels.items) {
                const solid::SideValue at = side.at(pose.place(base::cast<double>(s.position)));
                QVERIFY2(std::abs(at.value) < 1e-6, row.id);
                QVERIFY2(dot(at.gradient, pose.turn * base::cast<double>(s.normal)) > 0.999, row.id);
            }
            const Vec3d x = random.unitVector() * random.uniform(0, 2), y = x + random.unitVector() * 0.05;
            QVERIFY2(std::abs(side.at(x).value - side.at(y).value) <= 0.05 * (1 + 1e-9), row.id); // no steeper than 1
        }
}

void CombineTest::ballsHaveTheVolumeOfTheirLens() {
    if (test::sanitized)
        QSKIP("ten seconds under a sanitizer");
    constexpr double s = 0.04, apart = 0.9;
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, s);
    const solid::Pose pose = solid::poseAlong(Vec3d{0.6, 0.64, 0.48} * apart, {0, 0, 1});
    const surface::Surface other = shapeAt("ball", {1, 0, 0}, s, pose);
    const double one = 4 * pi / 3, common = lens(1, apart);
    const std::pair<Operation, double> cases[] = {
        {Operation::Union, 2 * one - common}, {Operation::Difference, one - common}, {Operation::Intersection, common}};
    for (const auto& [operation, wanted] : cases)
        for (const bool bySurfels : {false, true}) {
            if (test::sanitized && bySurfels != (operation == Operation::Difference))
                continue;
            const solid::Combined result =
                bySurfels ? withSurface(ball, other, operation) : with(ball, "ball", {1, 0, 0}, s, pose, operation);
            result.surface.tree().validate();
            const mesh::Extent extent = mesh::extentOf(result.surface);
            const QByteArray told =
                QString("%1: %2 for %3").arg(int(operation)).arg(extent.volume).arg(wanted).toUtf8();
            QVERIFY2(extent.closed, told);
            QVERIFY2(std::abs(extent.volume - wanted) < 0.004 * wanted, told);
        }
}

void CombineTest::nothingIsOpenWhateverThePose() {
    const int poses = test::sanitized ? 2 : 8;
    constexpr std::uint64_t seed = 20;
    base::Random random(seed);
    const char* const shapes[] = {"ball", "box", "torus"};
    const solid::Size sizes[] = {{0.6, 0, 0}, {0.9, 0.8, 0.7}, {0.55, 0.25, 0}};
    constexpr double s = 0.09;
    for (int k = 0; k < poses; ++k) {
        const std::size_t i = random.below(3), j = random.below(3);
        const surface::Surface model = shapeAt(shapes[i], sizes[i], s);
        const auto operation = static_cast<Operation>(random.below(3));
        const solid::Pose pose = randomPose(random, 0.7);
        solid::Combined result;
        try {
            result = with(model, shapes[j], sizes[j], s, pose, operation);
        } catch (const base::Error&) {
            continue; // the one within the other
        }
        mesh::MarchingReport report;
        const mesh::Mesh mesh = mesh::marchingCubes(result.surface, {}, report);
        const mesh::Topology topology = mesh::topologyOf(mesh.triangles, mesh.positions.size());
        const double wanted =
                         volumeOnGrid(solid::PrimitiveSide(solid::primitive(shapes[i]), sizes[i], {}),
                                      solid::PrimitiveSide(solid::primitive(shapes[j]), sizes[j], pose), operation),
                     whole = solid::primitive(shapes[i]).volume(sizes[i]), found = mesh::volumeOf(mesh);
        const QByteArray told = QString("seed %1, pose %2: %3 and %4, operation %5: volume %6 for %7")
                                    .arg(seed)
                                    .arg(k)
                                    .arg(shapes[i])
                                    .arg(shapes[j])
                                    .arg(int(operation))
                                    .arg(found)
                                    .arg(wanted)
                                    .toUtf8();
        QVERIFY2(topology.boundaryLoops == 0 && topology.manifold(), told);
        QVERIFY2(std::abs(found - wanted) < 0.06 * whole, told); // seams are round to what cells are not looked at by
    }
}

void CombineTest::aBallDrilledThroughHasOneHandle() {
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, 0.05);
    const solid::Combined result =
        with(ball, "cylinder", {0.35, 3, 0}, 0.05, solid::poseAlong({0.1, 0, 0}, normalized(Vec3d{1, 2, 2})),
             Operation::Difference);
    mesh::MarchingReport report;
    const mesh::Mesh mesh = mesh::marchingCubes(result.surface, {}, report);
    const mesh::Topology topology = mesh::topologyOf(mesh.triangles, mesh.positions.size());
    QCOMPARE(topology.boundaryEdges, std::size_t(0));
    QCOMPARE(topology.components, std::size_t(1));
    QCOMPARE(topology.euler(), 0LL);
}

void CombineTest::blocksAwayFromTheSeamAreShared() {
    surface::Surface ball = shapeAt("ball", {1, 0, 0}, 0.02);
    ball = with(ball, "ball", {0.2, 0, 0}, 0.02, solid::poseAlong({0, 0, 1}, {0, 0, 1}), Operation::Union).surface;
    const surface::Surface twice =
        with(ball, "ball", {0.2, 0, 0}, 0.02, solid::poseAlong({1, 0, 0}, {0, 0, 1}), Operation::Union).surface;
    QVERIFY(tree::unsharedBytes(twice.tree(), ball.tree()) < ball.tree().bytes() / 4);
}

void CombineTest::bothSidesOfASeamAreItsCells() {
    constexpr double s = 0.05;
    const solid::Combined result = with(shapeAt("ball", {1, 0, 0}, s), "ball", {0.7, 0, 0}, s,
                                        solid::poseAlong({0.8, 0, 0}, {0, 0, 1}), Operation::Union);
    const surfel::SurfelList all = result.surface.tree().surfels();
    const auto layout = cells::LabelLayout::of(*all.layout);
    QVERIFY(layout.has_value());
    const double plane = (1 + 0.64 - 0.49) / 1.6, radius = std::sqrt(1 - plane * plane);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const cells::Label label = layout->at(all.extraOf(i));
        const Vec3d p = base::cast<double>(all.items[i].position);
        QCOMPARE(label.cell, std::abs(length(p) - 1) < 1e-5 ? 0U : 1U);
        const double toSeam = std::hypot(p.x - plane, std::hypot(p.y, p.z) - radius);
        if (toSeam < 1.5 * s)
            QVERIFY(label.partner == 1 - label.cell && label.meeting == cells::Meeting::Concave);
        if (toSeam > 2.2 * s)
            QVERIFY(label.partner == label.cell && label.meeting == cells::Meeting::None);
    }
}

void CombineTest::facesThatCoincideStayOnce() {
    constexpr double s = 0.05;
    const solid::Size cube{1, 1, 1};
    const surface::Surface model = shapeAt("box", cube, s);
    const solid::Pose beside = solid::poseAlong({1, 0, 0}, {0, 0, 1}), same;
    const auto atFace = [](const surface::Surface& surface) {
        std::size_t out = 0;
        for (const surfel::Surfel& each : surface.tree().surfels().items)
            out += std::abs(each.position.x - 0.5F) < 1e-5F && std::abs(each.normal.x) > 0.9F;
        return out;
    };
    const std::size_t once = atFace(model);
    QCOMPARE(atFace(with(model, "box", cube, s, beside, Operation::Union).surface), std::size_t(0));
    QCOMPARE(atFace(with(model, "box", cube, s, beside, Operation::Difference).surface), once);
    QCOMPARE(atFace(with(model, "box", cube, s, same, Operation::Union).surface), once);
    QCOMPARE(atFace(with(model, "box", cube, s, same, Operation::Intersection).surface), once);
}

/// A slope leaves so little of the top of a box that no surfel stays there: the slope must not go on to the wall
/// behind.
void CombineTest::stripsWithoutSurfelsGetSome() {
    constexpr double s = 0.05;
    const surface::Surface box = shapeAt("box", {1, 1, 1}, s);
    for (const double strip : {0.2, 0.4}) {
        const Vec3d edge{-0.5 + strip * s, 0, 0.5}, slope = normalized(Vec3d{1, 0, 1});
        const solid::Combined cut =
            with(box, "box", {4, 4, 4}, s, solid::poseAlong(edge - slope * 2, slope), Operation::Intersection);
        mesh::MarchingReport report;
        double highest = 0;
        for (const Vec3d& p : mesh::marchingCubes(cut.surface, {}, report).positions)
            highest = std::max(highest, p.z - 0.5);
        const QByteArray told = QString("strip of %1 s: %2 s above").arg(strip).arg(highest / s).toUtf8();
        QVERIFY2(highest < 0.25 * strip * s, told);
    }
}

void CombineTest::halfABallHasHalfItsVolume() {
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, 0.04);
    for (const double offset : {0.4, 0.0}) {
        if (test::sanitized && offset == 0)
            continue;
        const solid::Combined half = solid::cutByPlane(ball, {normalized(Vec3d{1, -2, 0.5}), offset});
        const mesh::Extent extent = mesh::extentOf(half.surface);
        const double height = 1 - offset, wanted = pi * height * height * (3 - height) / 3;
        QVERIFY(extent.closed);
        QVERIFY2(std::abs(extent.volume - wanted) < 0.006 * wanted, QByteArray::number(extent.volume / wanted));
    }
    solid::CutOptions open;
    open.cap = false;
    const solid::Combined cup = solid::cutByPlane(ball, {{0, 0, 1}, 0.1}, open);
    QCOMPARE(cup.inserted, std::size_t(0));
    QVERIFY(std::isfinite(cup.surface.definition().boundaryLimit));
}

/// The smooth surface has gaps at acute edges, which meshes bridge; what bridges them comes to the edge as well. What
/// is told of the error is of the size of the true one, not that of strips beside the edge.
void CombineTest::slicesOfBallsHaveTheirArea() {
    base::Random random(test::seed());
    for (const double offset : {0.2, 0.5, 0.8}) { // edges of 78, 60, 37 degrees
        const double s = test::sanitized ? 0.09 : 0.05;
        const Vec3d normal = random.unitVector();
        const mesh::Extent extent =
            mesh::extentOf(solid::cutByPlane(shapeAt("ball", {1, 0, 0}, s), {normal, offset}).surface);
        const double height = 1 - offset, wanted = 2 * pi * height + pi * (1 - offset * offset),
                     volume = pi * height * height * (3 - height) / 3;
        const QByteArray told = QString("offset %1: area %2 +- %3 for %4, volume %5 +- %6 for %7, seed %8")
                                    .arg(offset)
                                    .arg(extent.area)
                                    .arg(extent.areaError)
                                    .arg(wanted)
                                    .arg(extent.volume)
                                    .arg(extent.volumeError)
                                    .arg(volume)
                                    .arg(test::seed())
                                    .toUtf8();
        const double share = test::sanitized ? 0.015 : 0.005;
        QVERIFY2(extent.closed && std::abs(extent.area - wanted) < share * wanted, told);
        QVERIFY2(extent.areaError < share * wanted, told);
        QVERIFY2(std::abs(extent.volume - volume) < 0.5 * share * volume, told);
    }
}

void CombineTest::closedModelsEndWhereTheyAreCut() {
    surface::SurfaceDefinition closed;
    closed.boundary = surface::Boundary::None;
    const surface::Surface box(shapeAt("box", {2, 1, 1}, 0.06).tree(), closed);
    const surface::SurfaceDefinition before = box.definition();
    const solid::Combined half = solid::cutByPlane(box, {{1, 0, 0}, 0}, {false});
    QVERIFY(half.surface.definition().boundary == surface::Boundary::Auto);
    const mesh::Extent extent = mesh::extentOf(half.surface);
    QVERIFY(!extent.closed);
    QVERIFY2(std::abs(extent.area - 5) < 0.1 * 5, QByteArray::number(extent.area)); // without the plane's share
    // nothing was parted: as it was
    const solid::Combined whole = solid::cutByPlane(box, {{1, 0, 0}, -2}, {false});
    QVERIFY(whole.surface.definition() == before);
}

void CombineTest::capsGoOnInTheColoursBesideThem() {
    surfel::SurfelList ball = test::spherePoints(3000);
    auto layout = std::make_shared<surfel::AttributeLayout>(*ball.layout);
    layout->colours = true;
    ball.layout = layout;
    for (surfel::Surfel& each : ball.items)
        each.colour = each.position.x > 0 ? surfel::rgba(200, 0, 0) : surfel::rgba(0, 200, 0);
    const solid::Combined cut = solid::cutByPlane(test::surfaceOf(ball), {{0, 0, 1}, 0});
    QVERIFY(cut.inserted > 100);
    for (const surfel::Surfel& each : cut.surface.tree().surfels().items)
        if (std::abs(each.position.x) > 0.2F)
            QVERIFY(each.colour == (each.position.x > 0 ? surfel::rgba(200, 0, 0) : surfel::rgba(0, 200, 0)));
}

void CombineTest::capsAreAsDenseAsTheModelBeside() {
    // a tube whose points lie four times closer at one end
    surfel::SurfelList tube;
    tube.layout = test::orientedLayout();
    for (double z = -2; z < 2;) {
        const double s = 0.03 * std::pow(4, (z + 2) / 4);
        const int count = static_cast<int>(2 * pi / s);
        for (int k = 0; k < count; ++k) {
            const double a = 2 * pi * (k + 0.618 * std::floor(z / s)) / count;
            tube.append(test::surfelAt({std::cos(a), std::sin(a), z}, {std::cos(a), std::sin(a), 0}, s), {});
        }
        z += s;
    }
    const surface::Surface model = test::surfaceOf(tube);
    const solid::Combined cut = solid::cutByPlane(model, {normalized(Vec3d{0.8, 0, -0.6}), 0});
    std::size_t fine = 0, coarse = 0;
    for (const surfel::Surfel& each : cut.surface.tree().surfels().items) {
        if (std::abs(0.8F * each.position.x - 0.6F * each.position.z) > 1e-4F)
            continue;
        (each.position.z < -0.8F  ? fine
         : each.position.z > 0.8F ? coarse
                                  : fine) += each.position.z < -0.8F || each.position.z > 0.8F;
    }
    QVERIFY2(fine > 2 * coarse, QByteArray::number(double(fine) / double(coarse)));
    QVERIFY(coarse > 0);
}

void CombineTest::threadsDoNotShow() {
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, 0.08);
    const auto hash = [&] {
        return with(ball, "box", {1, 1, 1}, 0.08, solid::poseAlong({0.7, 0, 0}, {0, 0.6, 0.8}), Operation::Difference)
            .surface.tree()
            .contentHash()
            .text();
    };
    QCOMPARE(test::onThreads(3, hash), test::onThreads(1, hash));
}

void CombineTest::whatLeavesNothingIsRefused() {
    const surface::Surface ball = shapeAt("ball", {0.3, 0, 0}, 0.05);
    QVERIFY_EXCEPTION_THROWN(with(ball, "box", {1, 1, 1}, 0.05, {}, Operation::Difference), base::Error);
    for (const bool cap : {false, true})
        try {
            solid::cutByPlane(ball, {{0, 0, 1}, 1}, {cap});
            QFAIL("nothing is left, and nobody says so");
        } catch (const base::Error& error) {
            QVERIFY2(std::string(error.what()).find("the other side") != std::string::npos, error.what());
        }
    QVERIFY_EXCEPTION_THROWN(solid::primitive("teapot"), base::Error);
}

static const test::Registered<CombineTest> registered;
#include "combine_test.moc"
