// Files of several bodies: each is sampled, meshed and measured by its own size, whatever stands beside it.
#include "core/base/parallel.h"
#include "core/cells/labels.h"
#include "core/mesh/check/topology.h"
#include "core/mesh/extent/extent.h"
#include "core/mesh/faces/open_faces.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/mesh/surface_parts.h"
#include "core/surface/surface.h"
#include "mesh/soups.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/thread_counts.h"

#include <QTest>

using namespace soups;
using mesh::OpenedFaces;

class ScenesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyBodyGetsItsSamples();
    void densityFollowsTouchingBodies();
    void edgesHaveTheirSurfelsAtAnyDensity();
    void aCountIsSharedOut();
    void oneSpacingThatWasAskedForHolds();
    void bodiesMeshAsIfAlone();
    void bodiesAreMeasuredTogether();
    void threadsDoNotShow();
};

namespace {

OpenedFaces opened(const Faces& faces, std::size_t count = 0) {
    return mesh::openFaces(faces.list(), faces.triangles, {}, {.use = mesh::FaceUse::Sample, .count = count});
}

/// Boxes apart, each of the next ones up to 1000 times smaller.
std::vector<Box> scene(base::Random& random, std::size_t count, double ratio, double offset = 0) {
    std::vector<Box> out;
    for (std::size_t i = 0; i < count; ++i) {
        const double size = i == 0 ? 1 : i == 1 ? 1 / ratio : std::pow(ratio, -random.uniform());
        Box box = tilted(random, 0, 0.3 * size, size);
        box.centre = Vec3d{4.0 * double(i), random.uniform(-1, 1), random.uniform(-1, 1)} + Vec3d{1, -1, 1} * offset;
        out.push_back(box);
    }
    return out;
}

std::size_t boxOf(const std::vector<Box>& boxes, const Vec3d& p) {
    std::size_t out = 0;
    for (std::size_t i = 1; i < boxes.size(); ++i)
        if (std::abs(boxes[i].height(p)) < std::abs(boxes[out].height(p)))
            out = i;
    return out;
}

surface::Surface surfaceOf(const OpenedFaces& found) {
    surface::SurfaceDefinition definition;
    definition.boundary = surface::Boundary::None;
    definition.boundaryLimit = std::numeric_limits<float>::infinity();
    definition.oneSheet = !found.apart;
    return {tree::SurfelTree::build(found.points), definition};
}

QByteArray toldSeed(std::uint64_t seed) {
    return "seed " + QByteArray::number(qulonglong(seed));
}

} // namespace

void ScenesTest::everyBodyGetsItsSamples() {
    for (int round = 0; round < test::effort(test::sanitized ? 1 : 3); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        const std::vector<Box> boxes = scene(random, 2 + random.below(8), 1000);
        Faces faces = together(boxes);
        const OpenedFaces found = opened(shuffled(faces, random));
        std::vector<std::size_t> counts(boxes.size());
        for (const surfel::Surfel& s : found.points.items)
            ++counts[boxOf(boxes, base::cast<double>(s.position))];
        for (std::size_t i = 0; i < boxes.size(); ++i)
            QVERIFY2(counts[i] > 1900, toldSeed(seed) + ": " + QByteArray::number(qulonglong(counts[i])));
        QVERIFY2(found.points.size() < 150'000, toldSeed(seed));
    }
}

/// A small box that stands in a large one's side: nowhere do supports differ by more than half the distance, so that
/// neither is lost in those of the other, and away from the small one the large one is as sparse as ever.
void ScenesTest::densityFollowsTouchingBodies() {
    for (int round = 0; round < test::effort(test::sanitized ? 1 : 3); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        const double size = std::pow(10, random.uniform(-2.5, -1));
        Box small = tilted(random, 0, 0.4 * size, size);
        small.centre = {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1};
        const std::vector<Box> boxes{aligned({-1, -1, -1}, {1, 1, 1}), small};
        const OpenedFaces found = opened(together(boxes), test::sanitized ? 12000 : 30000);
        const auto& items = found.points.items;
        double least = 1e9, most = 0;
        for (const surfel::Surfel& s : items) {
            least = std::min(least, double(s.support));
            most = std::max(most, double(s.support));
        }
        QVERIFY2(most > 5 * least * std::pow(0.1 / size, 0.9) / 3, toldSeed(seed));
        for (std::size_t i = 0; i < items.size(); i += 7)
            for (std::size_t k = i % 5; k < items.size(); k += 5) {
                const double apart = double(distance(items[i].position, items[k].position));
                QVERIFY2(std::abs(double(items[i].support - items[k].support)) <= 0.53 * apart + 1e-4 * most,
                         toldSeed(seed));
            }
        // The density is what supports tell: some 38 neighbours in each, half as many at edges.
        for (std::size_t i = 0; i < items.size(); i += items.size() / 200) {
            std::size_t near = 0;
            for (const surfel::Surfel& s : items)
                near += distance(s.position, items[i].position) < items[i].support;
            QVERIFY2(near > 18 && near < 90, toldSeed(seed) + ": " + QByteArray::number(qulonglong(near)));
        }
    }
}

/// Of bodies that touch, the edges of the large one belong to its sparse surfels, two of their own spacings away.
void ScenesTest::edgesHaveTheirSurfelsAtAnyDensity() {
    if (test::sanitized) // half a minute there
        return;
    base::Random random(test::seed());
    std::vector<Box> boxes{aligned({-1, -1, -1}, {1, 1, 1})};
    for (int i = 0; i < 36; ++i) { // so that most surfels of the large one are about them
        const Vec3d at{0.12 * (i % 6) - 0.3, 0.12 * (i / 6) - 0.3, 1};
        boxes.push_back(aligned(at, at + Vec3d{0.004, 0.004, 0.006}));
    }
    const OpenedFaces found = opened(together(boxes), 60000);
    const auto layout = cells::LabelLayout::of(*found.points.layout);
    QVERIFY(layout);
    int beside = 0;
    for (std::size_t i = 0; i < found.points.size(); ++i) {
        const surfel::Surfel& s = found.points.items[i];
        std::array<double, 3> far{std::abs(s.position.x), std::abs(s.position.y), std::abs(s.position.z)};
        std::sort(far.begin(), far.end());
        const double spacing = double(s.support) / 3.5;
        if (std::abs(far[2] - 1) > 1e-6 || 1 - far[1] > 1.2 * spacing)
            continue;
        ++beside;
        const cells::Label label = layout->at(found.points.extraOf(i));
        QVERIFY2(label.partner != label.cell && label.meeting == cells::Meeting::Convex,
                 toldSeed(test::seed()) + ": " + QByteArray::number((1 - far[1]) / spacing) + " spacings");
    }
    QVERIFY(beside > 500);
}

void ScenesTest::aCountIsSharedOut() {
    base::Random random(test::seed());
    const std::vector<Box> boxes = scene(random, 5, 200);
    const OpenedFaces found = opened(together(boxes), 12000);
    QVERIFY2(found.points.size() > 11200 && found.points.size() < 12400,
             toldSeed(test::seed()) + ": " + QByteArray::number(qulonglong(found.points.size())));
    std::vector<std::size_t> counts(boxes.size());
    for (const surfel::Surfel& s : found.points.items)
        ++counts[boxOf(boxes, base::cast<double>(s.position))];
    QVERIFY2(*std::min_element(counts.begin(), counts.end()) > 600, toldSeed(test::seed()));
}

void ScenesTest::oneSpacingThatWasAskedForHolds() {
    base::Random random(test::seed());
    const Faces faces = together(scene(random, 3, 4));
    const OpenedFaces found =
        mesh::openFaces(faces.list(), faces.triangles, {}, {.use = mesh::FaceUse::Sample, .spacing = 0.05});
    for (const surfel::Surfel& s : found.points.items)
        QVERIFY(s.support == found.points.items[0].support);
}

void ScenesTest::bodiesMeshAsIfAlone() {
    if (test::sanitized)
        QSKIP("half a minute under a sanitizer");
    for (int round = 0; round < test::effort(2); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        const std::vector<Box> boxes = scene(random, 4, 1000, round % 2 == 0 ? 0 : 3e4);
        std::vector<Box> moved = boxes; // as files come in: relative to an origin of their own
        for (Box& each : moved)
            each.centre = each.centre - boxes[0].centre;
        const surface::Surface surface = surfaceOf(opened(together(moved), 10000));
        mesh::MarchingReport report;
        const mesh::Mesh m = mesh::marchingCubes(surface, {}, report);
        const mesh::Topology t = mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
        QVERIFY2(t.manifold() && t.boundaryEdges == 0 && t.genus() == 0 && t.components == boxes.size(),
                 toldSeed(seed) + ": " + QByteArray::number(qulonglong(t.components)) + " pieces");
        for (std::size_t i = 0; i < moved.size(); ++i) {
            mesh::Mesh own = m;
            std::erase_if(own.triangles, [&](const mesh::Triangle& f) { return boxOf(moved, m.positions[f[0]]) != i; });
            const Vec3d h = moved[i].half;
            const double volume = std::abs(mesh::volumeOf(own)) / (8 * h.x * h.y * h.z);
            QVERIFY2(std::abs(volume - 1) < 0.01, toldSeed(seed) + ": volume " + QByteArray::number(volume));
        }
    }
}

void ScenesTest::bodiesAreMeasuredTogether() {
    base::Random random(test::seed());
    const std::vector<Box> boxes = scene(random, 3, 3);
    const surface::Surface surface = surfaceOf(opened(together(boxes), 6000));
    QVERIFY(mesh::partsOf(surface).size() > 1);
    const mesh::Extent all = mesh::extentOf(surface);
    double area = 0, volume = 0;
    for (const Box& each : boxes) {
        const Vec3d h = each.half;
        area += 8 * (h.x * h.y + h.y * h.z + h.z * h.x);
        volume += 8 * h.x * h.y * h.z;
    }
    QVERIFY2(all.closed && std::abs(all.volume / volume - 1) < 1e-3 && std::abs(all.area / area - 1) < 1e-3,
             toldSeed(test::seed()) + ": " + QByteArray::number(all.volume / volume));
}

void ScenesTest::threadsDoNotShow() {
    base::Random random(test::seed());
    const Faces faces = together(scene(random, 4, 100));
    const int threads = base::threadCount();
    std::vector<OpenedFaces> found;
    std::vector<std::vector<Vec3d>> places;
    for (const int count : test::comparedThreads({2})) {
        base::setThreadCount(count);
        found.push_back(opened(faces, 8000));
        mesh::MarchingReport report;
        places.push_back(mesh::marchingCubes(surfaceOf(found.back()), {}, report).positions);
    }
    base::setThreadCount(threads);
    const surfel::SurfelList &one = found.front().points, &two = found.back().points;
    QVERIFY(one.items == two.items && one.extra == two.extra);
    QVERIFY(places.front() == places.back());
}

static const test::Registered<ScenesTest> registered;
#include "scenes_test.moc"
