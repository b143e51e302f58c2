// Which sharp edges of a mesh stay sharp (mesh/README 8.5).
#include "core/mesh/faces/crease_chains.h"

#include "core/mesh/faces/open_faces.h"
#include "mesh/creased_faces.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using namespace faces;

class CreaseChainsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void sharpEdgesAmongBumpsAreNoCreases();
    void facetsThatSamplesTellApartKeepTheirEdges();
    void wrinklesThatEndSoonAreNoCreases();
    void furrowsAmongBumpsAreNoCreases();
    void foldedTrianglesFaceNoOtherWay();
    void edgesOfBoxesStayBesideBumps();
};

/// A torus of few triangles whose vertices are off by chance; facing as it does.
static Faces bumpy(std::uint64_t seed) {
    Faces out = band(40, 16, false);
    base::Random random(seed);
    for (base::Vec3f& p : out.positions) // towards the middle or away from it
        p = p * static_cast<float>(1 + random.uniform(-0.035, 0.035));
    return out;
}

/// But for some by chance; who asks for them has them all.
void CreaseChainsTest::sharpEdgesAmongBumpsAreNoCreases() {
    std::size_t all = 0, left = 0;
    for (int k = 0; k < test::effort(20); ++k) {
        const Faces torus = bumpy(test::seed() + static_cast<std::uint64_t>(k));
        const mesh::FaceTopology topology = torus.topology();
        const mesh::CreaseChains clear = clearChains(topology, 0.07), asked = allChains(topology);
        QVERIFY(topology.sharpEdges.size() > 10);
        QCOMPARE(clear.edges.size() + clear.rounded.size(), topology.sharpEdges.size());
        QCOMPARE(asked.edges.size(), topology.sharpEdges.size());
        all += topology.sharpEdges.size();
        left += clear.edges.size();
    }
    const auto told = QString("seed %1: %2 of %3 are creases").arg(test::seed()).arg(left).arg(all).toUtf8();
    QVERIFY2(20 * left < all, told);
    const Faces torus = bumpy(test::seed());
    const mesh::FaceOptions options{.use = mesh::FaceUse::Sample, .count = 3000};
    const mesh::OpenedFaces open = mesh::openFaces(torus.list(), torus.triangles, {}, options);
    QVERIFY(open.messages.back().find("noise") != std::string::npos);
    QVERIFY(!labelsOf(openedFaces(torus, 3000).points).empty());
}

/// The same faces, and furrows, by how finely they are sampled: what is many spacings wide is no noise of a scan.
void CreaseChainsTest::facetsThatSamplesTellApartKeepTheirEdges() {
    const mesh::FaceTopology topology = bumpy(test::seed()).topology();
    std::size_t before = 0;
    for (const double spacing : {0.1, 0.05, 0.02, 0.005, 0.0005}) {
        const mesh::CreaseChains chains = clearChains(topology, spacing);
        QCOMPARE(chains.edges.size() + chains.rounded.size(), topology.sharpEdges.size());
        QVERIFY(chains.edges.size() >= before);
        before = chains.edges.size();
    }
    QVERIFY2(10 * before > 9 * topology.sharpEdges.size(),
             qPrintable(QString("%1 of %2, seed %3").arg(before).arg(topology.sharpEdges.size()).arg(test::seed())));
}

/// Statues have them at eyes, lips and ears, between faces that bend a little; a groove of as many edges in a plane
/// stays.
void CreaseChainsTest::wrinklesThatEndSoonAreNoCreases() {
    base::Random random(test::seed());
    for (const double bend : {0.0, 0.15}) {
        constexpr std::uint32_t n = 48;
        const int edges = bend > 0 ? 7 + static_cast<int>(random.below(6)) : 14 + static_cast<int>(random.below(6));
        Faces out;
        for (std::uint32_t i = 0; i <= n; ++i)
            for (std::uint32_t k = 0; k <= n; ++k) {
                const double x = 0.1 * (i - n / 2.0), y = 0.1 * (k - n / 2.0);
                const double deep = std::clamp((0.05 * edges + 0.3 - std::abs(x)) / 0.6, 0.0, 1.0);
                const double wave = bend * (std::sin(7 * x) + std::sin(7 * y)) / 4.9;
                out.positions.push_back(
                    base::cast<float>(Vec3d{x, y, wave - 0.6 * deep * std::max(0.0, 0.3 - std::abs(y))}));
            }
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t k = 0; k < n; ++k) {
                const std::uint32_t a = i * (n + 1) + k, b = a + n + 1;
                out.triangles.insert(out.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
            }
        const mesh::FaceTopology topology = out.topology();
        QVERIFY(!topology.sharpEdges.empty());
        QVERIFY2(mesh::clearChains(topology, 0.05).edges.size() == (bend > 0 ? 0 : topology.sharpEdges.size()),
                 qPrintable(QString("bend %1, seed %2").arg(bend).arg(test::seed())));
    }
}

/// A brain's, that hang together with hardly an end: here between blunt pyramids side by side.
void CreaseChainsTest::furrowsAmongBumpsAreNoCreases() {
    base::Random random(test::seed());
    constexpr std::uint32_t n = 36;
    Faces out;
    for (std::uint32_t i = 0; i <= n; ++i)
        for (std::uint32_t k = 0; k <= n; ++k)
            out.positions.push_back({static_cast<float>(i), static_cast<float>(k),
                                     i % 2 == 1 && k % 2 == 1 ? static_cast<float>(random.uniform(0.42, 0.52)) : 0});
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t a = i * (n + 1) + k, b = a + n + 1;
            if ((i + k) % 2 == 0) // diagonals lead to the tips
                out.triangles.insert(out.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
            else
                out.triangles.insert(out.triangles.end(), {{a, b, a + 1}, {b, b + 1, a + 1}});
        }
    const mesh::FaceTopology topology = out.topology();
    QVERIFY(topology.sharpEdges.size() > 1000);
    QVERIFY2(mesh::clearChains(topology, 0.2).edges.empty(), qPrintable(QString("seed %1").arg(test::seed())));
}

/// Decimated scans have some: a vertex beyond those around it.
void CreaseChainsTest::foldedTrianglesFaceNoOtherWay() {
    base::Random random(test::seed());
    Faces torus = band(60, 30, false);
    const auto outwards = [](const Vec3d& p) { return base::normalized(p - base::normalized(Vec3d{p.x, p.y, 0})); };
    for (int k = 0; k < 5; ++k) {
        Vec3f& p = torus.positions[random.below(torus.positions.size())];
        const Vec3d n = outwards(base::cast<double>(p)), way = base::perpendicular(n);
        p += base::cast<float>(way * random.uniform(0.12, 0.18));
    }
    QVERIFY(!torus.topology().sharpEdges.empty());
    const auto inwards = [&](std::optional<bool> creases) {
        const mesh::OpenedFaces open = mesh::openFaces(
            torus.list(), torus.triangles, {}, {.use = mesh::FaceUse::Sample, .count = 6000, .creases = creases});
        return std::pair(std::ranges::count_if(open.points.items,
                                               [&](const surfel::Surfel& s) {
                                                   return dot(base::cast<double>(s.normal),
                                                              outwards(base::cast<double>(s.position))) < 0;
                                               }),
                         open.blades);
    };
    const auto [found, blades] = inwards({});
    const auto [apart, edges] = inwards(false); // normals apart, as whoever wants that gets
    QVERIFY2(!blades && edges && found < apart,
             qPrintable(QString("%1 of %2, seed %3").arg(found).arg(apart).arg(test::seed())));
}

/// What a chain is does not depend on others.
void CreaseChainsTest::edgesOfBoxesStayBesideBumps() {
    Faces both = bumpy(test::seed());
    const Faces cube = box({1, 1, 1});
    const auto first = static_cast<std::uint32_t>(both.positions.size());
    for (const base::Vec3f& p : cube.positions)
        both.positions.push_back(p + base::Vec3f{5, 0, 0});
    for (const mesh::Triangle& t : cube.triangles)
        both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const mesh::CreaseChains clear = clearChains(both.topology(), 0.07);
    QVERIFY(clear.rounded.size() > 0);
    QCOMPARE(std::count_if(clear.edges.begin(), clear.edges.end(), [](const auto& edge) { return edge.from.x > 3; }),
             std::ptrdiff_t(12));
}

static const test::Registered<CreaseChainsTest> registered;
#include "crease_chains_test.moc"
