// Holes in faces have rims and nothing in them: no crumbs of zeros beyond the last surfels.
#include "core/mesh/check/topology.h"
#include "core/mesh/delaunay/delaunay.h"
#include "core/mesh/faces/open_faces.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/process/estimation/prepare.h"
#include "mesh/soups.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <map>
#include <numeric>
#include <QTest>

using faces::Faces;
using mesh::Triangle;

class CrumbsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void facesWithHolesHaveNoPiecesInThem_data();
    void facesWithHolesHaveNoPiecesInThem();
    void whatIsSmallAndAloneStays();
    void nothingFloatsBeyondAcuteEdges();
};

namespace {

/// A ball of uneven facets, bumpy, of which a tenth is lacking.
Faces gappyBall(base::Random& random) {
    constexpr std::uint32_t around = 18, across = 11;
    Faces out;
    for (std::uint32_t row = 0; row < across; ++row)
        for (std::uint32_t k = 0; k < around; ++k) {
            const double a = 2 * std::numbers::pi * (k + 0.5 * (row & 1) + random.uniform(-0.25, 0.25)) / around,
                         b = std::numbers::pi * (row + 0.5 + random.uniform(-0.25, 0.25)) / across;
            const base::Vec3d n{std::sin(b) * std::cos(a), std::cos(b), std::sin(b) * std::sin(a)};
            out.positions.push_back(base::cast<float>(n * (1 + 0.12 * std::sin(5 * n.x) * std::cos(4 * n.y))));
        }
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (random.uniform() > 0.1)
            out.triangles.push_back({a, b, c});
    };
    for (std::uint32_t row = 0; row + 1 < across; ++row)
        for (std::uint32_t k = 0; k < around; ++k) {
            const std::uint32_t next = (k + 1) % around, a = row * around + k, b = row * around + next;
            const std::uint32_t c = a + around, d = b + around;
            if (row & 1)
                add(a, b, d), add(a, d, c);
            else
                add(a, b, c), add(b, d, c);
        }
    return out;
}

/// That hang together by edges.
std::size_t piecesOf(const Faces& faces) {
    std::vector<std::size_t> of(faces.triangles.size());
    std::iota(of.begin(), of.end(), std::size_t(0));
    const auto root = [&](std::size_t t) {
        while (of[t] != t)
            t = of[t];
        return t;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> seen;
    std::size_t out = of.size();
    for (std::size_t t = 0; t < faces.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto ends = std::minmax(faces.triangles[t][k], faces.triangles[t][(k + 1) % 3]);
            const auto [other, fresh] = seen.emplace(ends, t);
            if (!fresh && root(other->second) != root(t))
                of[root(t)] = root(other->second), --out;
        }
    return out;
}

mesh::Mesh meshOf(const surface::Surface& surface, const std::string& method) {
    if (method == "delaunay") {
        mesh::DelaunayReport report;
        return mesh::restrictedDelaunay(surface, {}, report);
    }
    mesh::MarchingReport report;
    return mesh::marchingCubes(surface, {}, report);
}

/// Bare random points of a star of six points with edges of 48 degrees, two of it high.
surfel::SurfelList star(std::size_t n, base::Random& random) {
    constexpr double wide = 0.5, high = 0.4;
    const auto rim = [](std::size_t k) {
        const double turn = std::numbers::pi * static_cast<double>(k % 12) / 6, r = k % 2 == 0 ? 1 : wide;
        return base::Vec3d{r * std::cos(turn), r * std::sin(turn), 0};
    };
    const double flank = length(rim(1) - rim(0)) * high, face = wide / 4; // areas of one, and a twelfth of a face
    surfel::SurfelList out;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = random.below(12);
        double u = random.uniform(), v = random.uniform();
        base::Vec3d x;
        if (random.uniform(0, flank + 2 * face) < flank) {
            x = rim(k) * (1 - u) + rim(k + 1) * u + base::Vec3d{0, 0, high * v};
        } else {
            if (u + v > 1)
                u = 1 - u, v = 1 - v;
            x = rim(k) * u + rim(k + 1) * v + base::Vec3d{0, 0, random.uniform() < 0.5 ? 0 : high};
        }
        out.items.emplace_back().position = base::cast<float>(x);
    }
    return out;
}

} // namespace

void CrumbsTest::facesWithHolesHaveNoPiecesInThem_data() {
    QTest::addColumn<QString>("method");
    QTest::newRow("marching cubes") << "marching-cubes";
    QTest::newRow("Delaunay") << "delaunay";
}

void CrumbsTest::facesWithHolesHaveNoPiecesInThem() {
    QFETCH(QString, method);
    for (int round = 0; round < test::effort(3); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        const Faces faces = gappyBall(random);
        // So many that a hole, a tenth as wide as the ball, is wider than the supports, which bridge what is narrower.
        const mesh::OpenedFaces found =
            mesh::openFaces(faces.list(), faces.triangles, {}, {.use = mesh::FaceUse::Sample, .count = 20000});
        surface::SurfaceDefinition definition;
        definition.boundaryLimit = 0.15f;
        definition.oneSheet = !found.apart;
        const mesh::Mesh m = meshOf({tree::SurfelTree::build(found.points), definition}, method.toStdString());
        const mesh::Topology t = mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
        QVERIFY2(t.components <= piecesOf(faces), qPrintable(QString("seed %1: %2").arg(seed).arg(t.components)));
        QVERIFY2(t.boundaryLoops > 10, qPrintable(QString("seed %1: %2 loops").arg(seed).arg(t.boundaryLoops)));
        QVERIFY2(t.manifold() && t.unused == 0, qPrintable(QString("seed %1").arg(seed)));
    }
}

/// A sheet of four surfels is a crumb beside others, and a model by itself.
void CrumbsTest::whatIsSmallAndAloneStays() {
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    surfel::SurfelList list;
    list.layout = layout;
    for (int k = 0; k < 4; ++k)
        list.append({{0.1f * float(k & 1), 0.1f * float(k >> 1), 0}, {0, 0, 1}, 0.35f}, {});
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.15f;
    definition.support = 0.35f;
    mesh::MarchingReport report;
    mesh::MarchingOptions options;
    options.cell = 0.03;
    QVERIFY(!mesh::marchingCubes({tree::SurfelTree::build(list), definition}, options, report).triangles.empty());
    QCOMPARE(report.pieces, std::size_t(1));
    for (int k = 0; k < 400; ++k)
        list.append({{3 + 0.1f * float(k % 20), 0.1f * float(k / 20), 0}, {0, 0, 1}, 0.35f}, {});
    const mesh::Mesh m = mesh::marchingCubes({tree::SurfelTree::build(list), definition}, options, report);
    QCOMPARE(report.pieces, std::size_t(1));
    for (const base::Vec3d& x : m.positions)
        QVERIFY(x.x > 2);
}

/// Off tips f has small closed zeros, on which no surfels lie.
void CrumbsTest::nothingFloatsBeyondAcuteEdges() {
    for (int round = 0; round < test::effort(2); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        const mesh::Mesh m = meshOf(process::prepare(star(7000, random), {}), "marching-cubes");
        const mesh::Topology t = mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
        QVERIFY2(t.components == 1, qPrintable(QString("seed %1: %2 pieces").arg(seed).arg(t.components)));
    }
}

static const test::Registered<CrumbsTest> registered;
#include "crumbs_test.moc"
