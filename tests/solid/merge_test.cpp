// Parts of one model pushed into each other become one solid: what lies inside goes, seams are sharp.
#include "core/solid/merge.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/cells/cell_projection.h"
#include "core/mesh/check/topology.h"
#include "core/mesh/extent/extent.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/solid/tube.h"
#include "placed_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <numbers>
#include <QTest>

using base::Vec3d;
using std::numbers::pi;
using test::placed;
using test::shapeAt;

class MergeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void ballsAreTheirUnion_data();
    void ballsAreTheirUnion();
    void whatGoesIsInsideOfAnother();
    void aPartMayCrossItself();
    void facesThatLieOnEachOtherGo();
    void soundModelsStayAsTheyAre();
    void threadsDoNotShow();
    void modelsWithoutSidesAreRefused();
};

namespace {

struct Part {
    const char* id;
    solid::Size size;
    solid::Pose pose;
};

surfel::SurfelList orientedList() {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    return out;
}

surface::Surface together(const std::vector<Part>& parts, double spacing) {
    surfel::SurfelList out = orientedList();
    for (const Part& part : parts) {
        const surfel::SurfelList more =
            placed(solid::surfelsOf(solid::primitive(part.id), part.size, spacing, {}), part.pose);
        for (const surfel::Surfel& s : more.items)
            out.append(s, {});
    }
    return {tree::SurfelTree::build(out), {}};
}

solid::Pose at(const Vec3d& middle, const Vec3d& axis = {0, 0, 1}) {
    return solid::poseAlong(middle, normalized(axis));
}

/// A tube along an eight that lies in a plane, whose two ways go through each other in the middle.
surface::Surface eight(double radius, double spacing, solid::TubeSide& side) {
    std::vector<Vec3d> line;
    constexpr int steps = 400;
    const auto place = [](double t) { return Vec3d{1.2 * std::sin(t), std::sin(t) * std::cos(t), 0}; };
    for (int k = 0; k <= steps; ++k)
        line.push_back(place(2 * pi * (k % steps) / steps));
    side = solid::TubeSide(line, radius);
    surfel::SurfelList out = orientedList();
    double way = 0, next = 0;
    int row = 0;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const Vec3d along = line[k + 1] - line[k], forth = normalized(along);
        for (const double end = way + length(along); next < end; next += 0.93 * spacing, ++row) {
            const Vec3d middle = line[k] + forth * (next - way), v = cross(forth, Vec3d{0, 0, 1});
            const auto count = static_cast<int>(std::round(2 * pi * radius / (1.07 * spacing)));
            for (int j = 0; j < count; ++j) {
                const double angle = 2 * pi * (j + 0.5 * (row & 1)) / count;
                const Vec3d away = v * std::cos(angle) + Vec3d{0, 0, std::sin(angle)};
                surfel::Surfel s;
                s.position = base::cast<float>(middle + away * radius);
                s.normal = base::cast<float>(away);
                s.support = static_cast<float>(3.5 * spacing);
                out.append(s, {});
            }
        }
        way += length(along);
    }
    return {tree::SurfelTree::build(out), {}};
}

} // namespace

void MergeTest::ballsAreTheirUnion_data() {
    QTest::addColumn<double>("apart");
    for (const double apart : {0.4, 1.0, 1.6})
        QTest::addRow("%g", apart) << apart;
}

void MergeTest::ballsAreTheirUnion() {
    QFETCH(double, apart);
    constexpr double s = 0.06;
    const solid::Combined both =
        solid::merged(together({{"ball", {1, 0, 0}, at({})}, {"ball", {1, 0, 0}, at({apart, 0, 0})}}, s));
    both.surface.tree().validate();
    QVERIFY(both.removed > 0 && both.atSeam > 0 && both.inserted == 0);
    const mesh::Extent extent = mesh::extentOf(both.surface);
    QVERIFY(extent.closed);
    const double lens = pi / 12 * (4 + apart) * (2 - apart) * (2 - apart), wanted = 8 * pi / 3 - lens;
    QVERIFY2(std::abs(extent.volume - wanted) < 0.002 * wanted, QByteArray::number(extent.volume / wanted));
    // the seam is a circle, and sharp
    const std::optional<cells::CellSurface> cells = cells::CellSurface::of(both.surface);
    QVERIFY(cells);
    const double radius = std::sqrt(1 - 0.25 * apart * apart);
    for (int k = 0; k < 40; ++k) {
        const double angle = 2 * pi * k / 40;
        const Vec3d on{0.5 * apart, radius * std::cos(angle), radius * std::sin(angle)},
            out{0, std::cos(angle), std::sin(angle)};
        const cells::CellFoot foot = cells::project(*cells, on + out * (0.1 * s), {});
        QVERIFY(foot.projection.ok());
        QVERIFY2(distance(foot.projection.foot, on) < 0.15 * s,
                 QByteArray::number(distance(foot.projection.foot, on) / s));
    }
}

void MergeTest::whatGoesIsInsideOfAnother() {
    base::Random random(test::seed());
    constexpr double s = 0.05;
    const std::pair<const char*, solid::Size> shapes[] = {
        {"ball", {0.6, 0, 0}}, {"box", {0.9, 0.7, 0.8}}, {"cylinder", {0.4, 1, 0}}, {"torus", {0.6, 0.25, 0}}};
    for (int round = 0; round < (test::sanitized ? 1 : 6); ++round) {
        std::vector<Part> parts;
        for (std::size_t k = 0; k < 2 + random.below(3); ++k) {
            const auto& [id, size] = shapes[random.below(4)];
            parts.push_back({id, size, at(random.unitVector() * 0.45, random.unitVector())});
        }
        const surface::Surface model = together(parts, s);
        const tree::SurfelTree left = solid::merged(model).surface.tree();
        std::vector<tree::Neighbour> near;
        std::size_t odd = 0;
        model.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot) {
                const Vec3d x = base::cast<double>(block.position(slot));
                double deepest = s, most = 0.4 * s; // in another one; its own is 0
                for (const Part& part : parts) {
                    const solid::PrimitiveSide side(solid::primitive(part.id), part.size, part.pose);
                    if (const solid::SideValue in = side.at(x); in.value < deepest) {
                        deepest = in.value;
                        // the flatter they cross, the more both go on as one
                        const double facing = dot(in.gradient, base::cast<double>(block.normal(slot)));
                        most = (facing > 0.866 ? 1.5 : facing > 0.5 ? 1 : 0.4) * s;
                    }
                }
                left.nearest(block.position(slot), 1, near);
                const bool stays = near[0].block->position(near[0].slot) == block.position(slot);
                odd += stays ? deepest < -most : deepest > 0.1 * s;
            }
        });
        QVERIFY2(1000 * odd <= model.tree().size(),
                 qPrintable(QString("seed %1 round %2: %3").arg(test::seed()).arg(round).arg(odd)));
    }
}

void MergeTest::aPartMayCrossItself() {
    constexpr double radius = 0.2, s = 0.03;
    solid::TubeSide side({{}, {1, 0, 0}}, radius);
    const surface::Surface crossing = eight(radius, s, side);
    const solid::Combined one = solid::merged(crossing);
    QVERIFY(one.removed > 0);
    mesh::MarchingReport report;
    const mesh::Mesh mesh = mesh::marchingCubes(one.surface, {}, report);
    const mesh::Topology topology = mesh::topologyOf(mesh.triangles, mesh.positions.size(), mesh.kinds);
    QCOMPARE(topology.boundaryEdges, std::size_t(0));
    QCOMPARE(topology.euler(), -2LL); // two handles
    double deepest = 0;
    for (const Vec3d& p : mesh.positions)
        deepest = std::max(deepest, std::abs(side.at(p).value));
    QVERIFY2(deepest < 0.3 * s, QByteArray::number(deepest / s)); // also at the seam, where it is sharp
}

void MergeTest::facesThatLieOnEachOtherGo() {
    const surface::Surface model = together({{"box", {1, 1, 1}, at({})}, {"box", {1, 1, 1}, at({1, 0, 0})}}, 0.05);
    const solid::Combined one = solid::merged(model, false);
    one.surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            QVERIFY(std::abs(block.position(slot).x - 0.5f) > 0.01f || std::abs(block.position(slot).y) > 0.45f ||
                    std::abs(block.position(slot).z) > 0.45f);
    });
}

void MergeTest::soundModelsStayAsTheyAre() {
    constexpr double s = 0.05;
    const double gap = 0.3 * s;
    const surface::Surface models[] = {
        shapeAt("torus", {1, 0.3, 0}, s), shapeAt("box", {1, 0.5, 1}, s), shapeAt("box", {1, 1, 0.3 * s}, s),
        together({{"box", {1, 1, 0.5}, at({})}, {"box", {1, 1, 0.5}, at({0, 0, 0.5 + gap})}}, s)};
    for (const surface::Surface& model : models) {
        const solid::Combined same = solid::merged(model);
        QCOMPARE(same.removed, std::size_t(0));
        QVERIFY(same.surface.tree() == model.tree());
    }
}

void MergeTest::threadsDoNotShow() {
    const surface::Surface model =
        together({{"ball", {1, 0, 0}, at({})}, {"box", {1, 1, 2}, at({0.3, 0.2, 0}, {1, 2, 3})}}, 0.1);
    const auto hash = [&] { return solid::merged(model).surface.tree().contentHash().text(); };
    QCOMPARE(test::onThreads(3, hash), test::onThreads(1, hash));
}

void MergeTest::modelsWithoutSidesAreRefused() {
    surfel::SurfelList bare = solid::surfelsOf(solid::primitive("ball"), {1, 0, 0}, 0.2, {});
    auto layout = std::make_shared<surfel::AttributeLayout>(*bare.layout);
    layout->oriented = false;
    bare.layout = layout;
    QVERIFY_THROWS_EXCEPTION(base::Error, solid::merged({tree::SurfelTree::build(bare), {}}));
}

static const test::Registered<MergeTest> registered;
#include "merge_test.moc"
