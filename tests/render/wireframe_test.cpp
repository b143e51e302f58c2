#include "core/render/overlay/wireframe.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using namespace render;
using base::Vec3d;

class WireframeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void edgeIsDrawnWhereItsEndsProject();
    void hiddenEdgesAreNotDrawn();
    void rimsHaveTheirOwnColours();
    void clippedTrianglesAreLeftOut();
    void sameBitsAtAnyThreadCount();
};

namespace {

Camera small(bool parallel = false) {
    Camera camera;
    camera.width = 200, camera.height = 150;
    camera.orthoHeight = parallel ? 2 : 0;
    return camera;
}

/// A square of two triangles across z, with its corners on the diagonals.
void addSquare(mesh::Mesh& out, double half, double z) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    out.positions.insert(out.positions.end(), {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
    out.triangles.push_back({first, first + 1, first + 2});
    out.triangles.push_back({first, first + 2, first + 3});
}

Image drawn(const mesh::Mesh& mesh, const Camera& camera, const WireColours& colours = {}) {
    Image out;
    drawWires(wiresOf(std::make_shared<mesh::Mesh>(mesh)), camera, colours, out);
    return out;
}

surfel::Colour pixelAt(const Image& image, const Vec3d& place) {
    return image.colour[static_cast<std::size_t>(place.y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(place.x)];
}

} // namespace

void WireframeTest::edgeIsDrawnWhereItsEndsProject() {
    base::Random random(test::seed());
    for (int k = 0; k < 20; ++k) {
        mesh::Mesh mesh;
        const auto corner = [&] {
            return Vec3d{random.uniform(-0.8, 0.8), random.uniform(-0.6, 0.6), random.uniform(-0.5, 0.5)};
        };
        mesh.positions = {corner(), corner(), corner()};
        mesh.triangles = {{0, 1, 2}};
        const Camera camera = small(k % 2 == 1);
        const Image image = drawn(mesh, camera);
        for (std::size_t e = 0; e < 3; ++e)
            for (const double part : {0.2, 0.5, 0.8}) {
                // In the image a straight line stays one.
                const Vec3d a = camera.project(mesh.positions[e]), b = camera.project(mesh.positions[(e + 1) % 3]);
                const Vec3d at = a + (b - a) * part;
                unsigned most = 0;
                for (const double dx : {-1.0, 0.0, 1.0})
                    for (const double dy : {-1.0, 0.0, 1.0})
                        most = std::max(most, pixelAt(image, at + Vec3d{dx, dy, 0}) >> 24);
                QVERIFY2(most > 100, qPrintable(QString("seed %1").arg(test::seed())));
            }
    }
}

void WireframeTest::hiddenEdgesAreNotDrawn() {
    for (const bool parallel : {false, true}) {
        const Camera camera = small(parallel);
        mesh::Mesh behind;
        addSquare(behind, 0.3, -0.5);
        mesh::Mesh both = behind;
        addSquare(both, 0.6, 0.2);
        const Vec3d side = camera.project({0.3, 0.05, -0.5});
        QVERIFY(pixelAt(drawn(behind, camera), side) >> 24 > 100);
        QCOMPARE(pixelAt(drawn(both, camera), side) >> 24, 0u);
    }
}

void WireframeTest::rimsHaveTheirOwnColours() {
    const Camera camera = small();
    mesh::Mesh mesh;
    addSquare(mesh, 0.5, 0);
    const WireColours colours;
    const auto rgb = [](surfel::Colour c) { return c & 0xffffffu; };
    const Vec3d rim = camera.project({0.5, 0.1, 0}), inner = camera.project({0.2, 0.2, 0});
    QCOMPARE(rgb(pixelAt(drawn(mesh, camera), rim)), rgb(colours.limit));
    QCOMPARE(rgb(pixelAt(drawn(mesh, camera), inner)), rgb(colours.edge));
    mesh.kinds.assign(4, mesh::VertexKind::Fold);
    QCOMPARE(rgb(pixelAt(drawn(mesh, camera), rim)), rgb(colours.fold));
}

void WireframeTest::clippedTrianglesAreLeftOut() {
    Camera camera = small();
    mesh::Mesh mesh;
    addSquare(mesh, 0.5, 0);
    camera.clips.add({{0, 0, -1}, 0.5}); // keeps z <= -0.5
    const Image image = drawn(mesh, camera);
    QVERIFY(std::all_of(image.colour.begin(), image.colour.end(), [](surfel::Colour c) { return c == 0; }));
}

void WireframeTest::sameBitsAtAnyThreadCount() {
    base::Random random(test::seed());
    mesh::Mesh mesh;
    for (int k = 0; k < 200; ++k)
        addSquare(mesh, random.uniform(0.01, 0.4), random.uniform(-1.0, 1.0));
    base::setThreadCount(1);
    const Image one = drawn(mesh, small());
    base::setThreadCount(0);
    QVERIFY(drawn(mesh, small()).colour == one.colour);
}

static const test::Registered<WireframeTest> registered;
#include "wireframe_test.moc"
