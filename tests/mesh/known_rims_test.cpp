// Open meshes know where they end: nowhere else, however sharp or folded they are.
#include "core/base/parallel.h"
#include "core/mesh/check/self_intersections.h"
#include "core/mesh/check/topology.h"
#include "core/mesh/faces/open_faces.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/rims.h"
#include "face_models.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using namespace faces;

class KnownRimsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void samplesBesideTheBoundaryKnowIt();
    void smallHolesAndClosedFacesHaveNone();
    void foldedOpenFacesMeshWithTheirOwnLoops_data();
    void foldedOpenFacesMeshWithTheirOwnLoops();
    void deepCupsAreOpen();
    void facesEndWhereTheirBordersAre();
};

namespace {

constexpr double pi = std::numbers::pi;

mesh::OpenedFaces opened(const Faces& faces, std::size_t count) {
    return mesh::openFaces(faces.list(), faces.triangles, {}, {.use = mesh::FaceUse::Sample, .count = count});
}

surface::Surface surfaceOf(mesh::OpenedFaces found) {
    surface::SurfaceDefinition definition;
    definition.knownRims = found.rims;
    surface::Surface out(tree::SurfelTree::build(found.points), definition);
    definition.boundaryLimit = process::automaticBoundaryLimit(out);
    return {out.tree(), definition};
}

/// Lathed about z: (radius, height) from one end to the other, outwards where heights fall.
Faces lathed(const std::vector<std::pair<double, double>>& profile, std::uint32_t around = 48) {
    Faces out;
    const auto rings = static_cast<std::uint32_t>(profile.size());
    for (std::uint32_t i = 0; i < around; ++i)
        for (const auto& [r, z] : profile)
            out.positions.push_back(
                base::cast<float>(Vec3d{r * std::cos(2 * pi * i / around), r * std::sin(2 * pi * i / around), z}));
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t k = 0; k + 1 < rings; ++k) {
            const std::uint32_t a = i * rings + k, b = (i + 1) % around * rings + k;
            out.triangles.push_back({a, a + 1, b + 1});
            out.triangles.push_back({a, b + 1, b});
        }
    return out;
}

void turn(Faces& faces, base::Random& random) {
    const Vec3d x = random.unitVector(), y = base::perpendicular(x), z = cross(x, y);
    for (Vec3f& p : faces.positions) {
        const Vec3d q = base::cast<double>(p);
        p = base::cast<float>(x * q.x + y * q.y + z * q.z);
    }
}

/// A cone of that angle at its tip, open below.
Faces horn(double angle) {
    const double wide = std::tan(angle / 2);
    return lathed({{0, 1}, {0.3 * wide, 0.7}, {wide, 0}});
}

/// Two flanks that meet in a ridge at that angle, with steep ends, open below.
Faces blade(double angle) {
    const auto w = static_cast<float>(std::tan(angle / 2));
    return {{{-w, 0, 0}, {w, 0, 0}, {w, 1.5f, 0}, {-w, 1.5f, 0}, {0, 0.2f, 1}, {0, 1.3f, 1}},
            {{0, 1, 4}, {1, 2, 5}, {1, 5, 4}, {2, 3, 5}, {3, 0, 4}, {3, 4, 5}}};
}

/// A ball with a fold under its equator, like a lid over an eye, open at the bottom.
Faces lid(double gap) {
    std::vector<std::pair<double, double>> profile;
    for (double a = 0; a <= 0.5 * pi + 1e-9; a += pi / 40)
        profile.emplace_back(std::sin(a), std::cos(a));
    profile.emplace_back(0.7, -0.02);
    profile.emplace_back(0.7, -0.02 - gap);
    for (double a = 0.5 * pi + 0.05; a <= 0.85 * pi; a += pi / 40)
        profile.emplace_back(std::sin(a), std::cos(a) - gap);
    return lathed(profile);
}

} // namespace

void KnownRimsTest::samplesBesideTheBoundaryKnowIt() {
    // A square with a notch: rims all around it, told by the distance to its edges.
    Faces flat{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}}, {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}}};
    base::Random random(test::seed());
    turn(flat, random);
    const mesh::OpenedFaces found = opened(flat, test::sanitized ? 1000 : 4000);
    QVERIFY(found.rims);
    const surfel::Attribute& rim = *found.points.layout->find(surface::rimName);
    const auto border = flat.topology().borderEdges;
    QCOMPARE(border.size(), std::size_t{5});
    for (std::size_t i = 0; i < found.points.size(); ++i) {
        const surfel::Surfel& s = found.points.items[i];
        const Vec3d p = base::cast<double>(s.position);
        double away = 1e300;
        for (const mesh::BorderEdge& edge : border) {
            const Vec3d along = edge.to - edge.from;
            const double t = std::clamp(dot(p - edge.from, along) / dot(along, along), 0.0, 1.0);
            away = std::min(away, distance(p, edge.from + along * t));
        }
        const double reach = double(surface::rimReach) * double(s.support);
        if (std::abs(away - reach) > 0.03 * reach)
            QCOMPARE(surfel::read(rim, found.points.extraOf(i)) != 0, away < reach);
    }
}

void KnownRimsTest::smallHolesAndClosedFacesHaveNone() {
    QVERIFY(!opened(box({1, 1, 1}), 2000).rims);
    Faces torn = band(40, 20, false); // without one of its faces
    torn.triangles.pop_back();
    mesh::OpenedFaces found = opened(torn, 3000);
    QVERIFY(found.rims && !found.closed);
    QVERIFY(std::isinf(surfaceOf(found).definition().boundaryLimit)); // supports reach across the hole
    QVERIFY(!surface::hasRim(surfaceOf(std::move(found)).tree()));
}

void KnownRimsTest::foldedOpenFacesMeshWithTheirOwnLoops_data() {
    base::Random random(test::seed());
    QTest::addColumn<QString>("shape");
    QTest::addColumn<double>("size");
    for (const char* shape : {"horn", "blade", "lid"})
        for (int round = 0; round < test::effort(2); ++round) {
            const double size = shape == QString("lid") ? random.uniform(0.01, 0.06) : random.uniform(0.25, 0.9);
            QTest::addRow("%s %.3f", shape, size) << QString(shape) << size;
        }
}

void KnownRimsTest::foldedOpenFacesMeshWithTheirOwnLoops() {
    QFETCH(QString, shape);
    QFETCH(double, size);
    base::Random random(test::seed());
    Faces faces = shape == "horn" ? horn(size) : shape == "blade" ? blade(size) : lid(size);
    turn(faces, random);
    const surface::Surface surface = surfaceOf(opened(faces, test::sanitized ? 2500 : 8000));
    QVERIFY(std::isfinite(surface.definition().boundaryLimit));
    mesh::MarchingReport report;
    const mesh::Mesh found = mesh::marchingCubes(surface, {}, report);
    const mesh::Topology topology = mesh::topologyOf(found.triangles, found.positions.size(), found.kinds);
    QCOMPARE(topology.boundaryLoops, std::size_t{1});
    QCOMPARE(topology.components, std::size_t{1});
    QCOMPARE(topology.euler(), 1LL);
    QCOMPARE(mesh::selfIntersections(found).size(), std::size_t{0});
}

void KnownRimsTest::deepCupsAreOpen() {
    base::Random random(test::seed());
    const double wide = random.uniform(0.12, 0.3);
    Faces cup = lathed({{0, 0}, {wide, 0}, {wide, 0.3}, {wide, 1}});
    turn(cup, random);
    const surface::Surface surface = surfaceOf(opened(cup, 4000));
    QVERIFY(std::isfinite(surface.definition().boundaryLimit));
}

/// Rims were nibbled by up to a spacing where the outermost samples lay by chance (mesh/README 8.3).
void KnownRimsTest::facesEndWhereTheirBordersAre() {
    base::Random random(test::seed());
    // A bent sheet around a star of three to seven points, which has corners outwards and inwards.
    const auto points = 3 + static_cast<std::uint32_t>(random.uniform(0, 5));
    Faces sheet{{{0, 0, 0}}, {}};
    const double deep = random.uniform(0.6, 0.9), bend = random.uniform(0, 0.4);
    for (std::uint32_t i = 0; i < 2 * points; ++i) {
        const double a = pi * i / points, r = i % 2 == 0 ? 1 : deep;
        sheet.positions.push_back(
            base::cast<float>(Vec3d{r * std::cos(a), r * std::sin(a), bend * r * r * std::cos(2 * a)}));
        sheet.triangles.push_back({0, i + 1, (i + 1) % (2 * points) + 1});
    }
    turn(sheet, random);
    const mesh::FaceTopology topology = sheet.topology();
    const std::size_t count = test::sanitized ? 2500 : 10000;
    const surface::Surface surface = surfaceOf(opened(sheet, count));
    const std::vector<surface::BoundaryCurve> rims = surface::findBoundaryCurves(surface);
    QCOMPARE(rims.size(), std::size_t{1});
    QVERIFY(rims[0].closed);
    const double spacing = std::sqrt(topology.area / static_cast<double>(count));
    std::size_t far = 0, all = 0;
    for (const surface::BoundaryPoint& p : rims[0].points) {
        double away = 1e300, toCorner = 1e300;
        for (const mesh::BorderEdge& edge : topology.borderEdges) {
            const Vec3d along = edge.to - edge.from;
            const double t = std::clamp(dot(p.position - edge.from, along) / dot(along, along), 0.0, 1.0);
            away = std::min(away, distance(p.position, edge.from + along * t));
            toCorner = std::min(toCorner, distance(p.position, edge.from));
        }
        if (toCorner < 3 * spacing) // rounded by a third of a support
            continue;
        ++all;
        far += away > 0.25 * spacing ? 1 : 0;
    }
    QVERIFY(all > 50);
    QVERIFY2(20 * far < all, qPrintable(QString("%1 of %2 points of the rim").arg(far).arg(all)));
}

static const test::Registered<KnownRimsTest> registered;
#include "known_rims_test.moc"
