// Vertices that are kept beside faces so large that they leave them empty: how somebody closed the holes of a scan.
#include "core/base/random.h"
#include "core/mesh/faces/open_faces.h"
#include "face_models.h"
#include "support/registry.h"

#include <algorithm>
#include <map>
#include <QTest>

using namespace faces;

class LargeFacesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void largeFacesAmongVerticesAreFilled();
    void flapsGetNoPoints();
};

namespace {

using Side = std::array<std::uint32_t, 2>;

/// A torus of many vertices, of which a disc is missing, and the sides of the hole, as triangles that close it have
/// them.
struct CutTorus {
    Faces faces = band(300, 120, false);
    std::vector<Side> hole;

    CutTorus() {
        const Vec3f middle{1.4f, 0, 0};
        std::vector<std::uint32_t> kept;
        std::vector<Vec3f> positions;
        for (const Vec3f& p : faces.positions) {
            kept.push_back(distance(p, middle) < 0.25f ? ~0u : static_cast<std::uint32_t>(positions.size()));
            if (kept.back() != ~0u)
                positions.push_back(p);
        }
        faces.positions = positions;
        for (Triangle& t : faces.triangles)
            t = {kept[t[0]], kept[t[1]], kept[t[2]]};
        std::erase_if(faces.triangles, [](const Triangle& t) { return std::ranges::find(t, ~0u) != t.end(); });
        std::map<Side, bool> sides;
        for (const Triangle& t : faces.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                sides[{t[k], t[(k + 1) % 3]}] = true;
        for (const auto& [side, there] : sides)
            if (!sides.contains({side[1], side[0]}))
                hole.push_back({side[1], side[0]});
    }
    std::uint32_t add(const Vec3f& p) {
        faces.positions.push_back(p);
        return static_cast<std::uint32_t>(faces.positions.size() - 1);
    }
};

Vec3d outwardsAt(const Vec3d& p) {
    return base::normalized(p - base::normalized(Vec3d{p.x, p.y, 0}));
}

} // namespace

void LargeFacesTest::largeFacesAmongVerticesAreFilled() {
    CutTorus torus;
    const std::size_t around = torus.faces.triangles.size();
    const std::uint32_t first = torus.hole.front()[0]; // a fan from one vertex of the rim
    for (const Side& s : torus.hole)
        if (s[0] != first && s[1] != first)
            torus.faces.triangles.push_back({s[0], s[1], first});
    const Faces& faces = torus.faces;
    const FaceTopology topology = faces.topology();
    QVERIFY(topology.closed());
    mesh::FaceOptions options;
    const mesh::OpenedFaces opened = mesh::openFaces(faces.list(), faces.triangles, {}, options);
    QVERIFY(!opened.sampled);
    QVERIFY(opened.points.size() > faces.positions.size() + 100);
    options.use = mesh::FaceUse::Vertices;
    QCOMPARE(mesh::openFaces(faces.list(), faces.triangles, {}, options).points.size(), faces.positions.size());
    float worst = 0; // of places in the disc, to the nearest surfel
    for (std::size_t t = around; t < topology.triangles.size(); ++t) {
        Vec3f place;
        for (const std::uint32_t v : topology.triangles[t])
            place += faces.positions[v] / 3.0f;
        float nearest = 9;
        for (const surfel::Surfel& s : opened.points.items)
            nearest = std::min(nearest, distance(s.position, place));
        worst = std::max(worst, nearest);
    }
    const auto spacing = static_cast<float>(std::sqrt(topology.area / static_cast<double>(faces.positions.size())));
    QVERIFY2(worst < 1.5f * spacing, qPrintable(QString::number(double(worst / spacing))));
}

/// In a fan about the middle, triangles are divided at places that lie beyond their own sides.
void LargeFacesTest::flapsGetNoPoints() {
    base::Random random(test::seed());
    for (int round = 0; round < 2; ++round) {
        CutTorus torus;
        const std::uint32_t middle = torus.add({1.38f, 0, 0});
        std::size_t flaps = 0;
        for (std::size_t i = 0; i < torus.hole.size(); ++i) {
            const auto [a, b] = torus.hole[i];
            if (i % 8 != 0) {
                torus.faces.triangles.push_back({a, b, middle});
                continue;
            }
            const Vec3f p = torus.faces.positions[a], q = torus.faces.positions[b], m = torus.faces.positions[middle];
            const float along = random.uniform(0.3f, 0.7f);
            const std::uint32_t d = torus.add(m + (p - m) * along + (p - q) * random.uniform(0.5f, 2.0f));
            for (const Triangle& t : {Triangle{a, b, d}, Triangle{b, middle, d}, Triangle{middle, a, d}})
                torus.faces.triangles.push_back(t);
            ++flaps;
        }
        QVERIFY(torus.faces.topology().closed() && flaps > 3);
        const mesh::OpenedFaces opened = mesh::openFaces(torus.faces.list(), torus.faces.triangles, {}, {});
        QVERIFY(!opened.sampled && opened.points.size() > torus.faces.positions.size() + 100);
        for (const surfel::Surfel& s : opened.points.items) {
            const Vec3d p = base::cast<double>(s.position);
            QVERIFY2(lengthSq(s.normal) == 0 || dot(base::cast<double>(s.normal), outwardsAt(p)) > 0,
                     qPrintable(QString("%1 %2 %3, seed %4").arg(p.x).arg(p.y).arg(p.z).arg(test::seed())));
        }
    }
}

static const test::Registered<LargeFacesTest> registered;
#include "large_faces_test.moc"
