// The naive marching cubes mesh the same surface with as many triangles.
#include "app/bench/naive/naive_march.h"

#include "app/bench/scene.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/process/estimation/spacing_sample.h"
#include "support/registry.h"

#include <map>
#include <QTest>

using bench::NaiveMesh;
using bench::Scene;

class NaiveMarchTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aClosedMeshLiesOnTheSurface();
};

void NaiveMarchTest::aClosedMeshLiesOnTheSurface() {
    Scene scene({4000, 0});
    const auto cell = static_cast<double>(process::typicalSpacing(scene.surface().tree()));
    const NaiveMesh naive = bench::naiveMarch(scene.naive(), cell);
    for (const base::Vec3d& v : naive.vertices) {
        const surface::Evaluationd e = scene.surface().evaluateReference(v, surface::Need::Value);
        QVERIFY(e.ok() && std::abs(e.value) < 0.05 * cell);
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : naive.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            ++edges[std::minmax(t[k], t[(k + 1) % 3])];
    for (const auto& [edge, triangles] : edges)
        QCOMPARE(triangles, 2);
    QCOMPARE(naive.vertices.size() + naive.triangles.size(), edges.size() + 2); // a sphere
    mesh::MarchingOptions options;
    options.relax = false;
    mesh::MarchingReport report;
    const auto ours = static_cast<double>(mesh::marchingCubes(scene.surface(), options, report).triangles.size());
    QVERIFY(std::abs(static_cast<double>(naive.triangles.size()) - ours) < 0.03 * ours);
}

static const test::Registered<NaiveMarchTest> registered;
#include "naive_march_test.moc"
