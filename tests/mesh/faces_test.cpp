// Faces that come in become surfels: the points spread over them, and what they carry.
#include "core/mesh/faces/open_faces.h"

#include "core/base/error.h"
#include "core/cells/labels.h"
#include "core/mesh/faces/face_spacing.h"
#include "core/mesh/faces/piece_spacings.h"
#include "face_models.h"
#include "support/registry.h"
#include "support/threads.h"

#include <algorithm>
#include <QTest>

using namespace faces;

class FacesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void largeFacesAreFlat();
    void stripsAreFlatAwayFromTheirEnds();
    void pointsLieOnTheirFaces();
    void pointsAreAsManyAsAskedForAndEven();
    void bothSidesOfAThinWallGetTheirPoints();
    void theSamePointsAtAnyThreadCount();
    void normalsKeepToTheirSideOfAnEdge();
    void tipsTiltNoNormals();
    void coloursAndAttributesFollowTheCorners();
    void evenVerticesStayAndCoarseOnesDoNot();
    void verticesOfNoFaceGo();
    void pointsWithAFewFacesStayPoints();
    void brokenFacesLendNoNormals();
    void roughVerticesAreSampled();
    void thinWallsAskForMore();
    void acuteEdgesAskForNoMore();
    void crumbsAtCornersEndNoWork();
    void tooManyAndTooFewSamplesAreRefused();
};

void FacesTest::largeFacesAreFlat() {
    // A roof of 150 degrees, smooth by its angle: flat sides all the same, rounded at the ridge alone.
    const Faces roof{{{-1, 0, 0}, {0, 0, 0.27f}, {1, 0, 0}, {-1, 2, 0}, {0, 2, 0.27f}, {1, 2, 0}},
                     {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};
    const mesh::OpenedFaces found =
        mesh::openFaces(roof.list(), roof.triangles, {}, {.use = mesh::FaceUse::Sample, .count = 20000});
    const Vec3f left = base::normalized(Vec3f{-0.27f, 0, 1});
    for (const surfel::Surfel& s : found.points.items)
        if (s.position.x < 0)
            QVERIFY(dot(s.normal, left) > 0.9995f);
}

/// A strip whose short side meets what turns by 30 degrees, as chamfers do at the corners of a part.
void FacesTest::stripsAreFlatAwayFromTheirEnds() {
    const Faces strip{
        {{0, 0, 0}, {1, 0, 0}, {1.04f, 0, -0.023f}, {0, 0.05f, 0}, {1, 0.05f, 0}, {1.04f, 0.05f, -0.023f}},
        {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};
    const mesh::OpenedFaces found =
        mesh::openFaces(strip.list(), strip.triangles, {}, {.use = mesh::FaceUse::Sample, .count = 400});
    for (const surfel::Surfel& s : found.points.items)
        if (s.position.x < 0.9f)
            QVERIFY2(s.normal.z > 0.99985f, qPrintable(QString("%1 %2").arg(s.position.x).arg(s.normal.z))); // 1 degree
}

void FacesTest::pointsLieOnTheirFaces() {
    for (int round = 0; round < test::effort(10); ++round) {
        const Faces faces = soup(test::seed() + static_cast<std::uint64_t>(round), 300);
        const FaceTopology topology = faces.topology();
        for (const FacePoint& point : spreadPoints(topology, faces.positions, 2000)) {
            QVERIFY(point.b >= 0 && point.c >= 0 && point.b + point.c <= 1.000001f);
            QVERIFY(topology.areas[point.triangle] > 0);
            const Vec3d at = placeOf(point, topology, faces.positions);
            const Vec3d corner = base::cast<double>(faces.positions[topology.triangles[point.triangle][0]]);
            QVERIFY(std::abs(dot(at - corner, topology.normals[point.triangle])) < 1e-6);
        }
    }
}

void FacesTest::pointsAreAsManyAsAskedForAndEven() {
    const Faces torus = band(60, 30, false);
    const FaceTopology topology = torus.topology();
    constexpr std::size_t wanted = 4000;
    const std::vector<Vec3f> points = placesOf(torus, topology, wanted);
    QVERIFY2(points.size() > wanted * 95 / 100 && points.size() < wanted * 102 / 100,
             qPrintable(QString::number(points.size())));
    const double spacing = std::sqrt(topology.area / wanted);
    double farthest = 0;
    for (const Vec3f& p : points) {
        double nearest = 1e9;
        for (const Vec3f& q : points)
            if (&p != &q)
                nearest = std::min(nearest, static_cast<double>(distance(p, q)));
        QVERIFY2(nearest > 0.65 * spacing, qPrintable(QString::number(nearest / spacing)));
        farthest = std::max(farthest, nearest);
    }
    QVERIFY2(farthest < 1.5 * spacing, qPrintable(QString::number(farthest / spacing)));
}

void FacesTest::bothSidesOfAThinWallGetTheirPoints() {
    const Faces plate = box({1, 1, 0.002f});
    std::size_t above = 0, below = 0;
    for (const Vec3f& p : placesOf(plate, plate.topology(), 3000)) {
        above += p.z > 0.0019f ? 1 : 0;
        below += p.z < 0.0001f ? 1 : 0;
    }
    QVERIFY(above > 1350 && below > 1350);
}

void FacesTest::theSamePointsAtAnyThreadCount() {
    const Faces faces = soup(test::seed(), 200);
    const FaceTopology topology = faces.topology();
    const auto work = [&] { return placesOf(faces, topology, 20000); };
    const std::vector<Vec3f> one = test::onThreads(1, work), four = test::onThreads(4, work);
    QVERIFY(one == four);
}

void FacesTest::normalsKeepToTheirSideOfAnEdge() {
    const mesh::OpenedFaces cube = mesh::openFaces(box({1, 2, 3}).list(), box({1, 2, 3}).triangles, {},
                                                   {.use = mesh::FaceUse::Sample, .count = 3000});
    QVERIFY(cube.sampled && cube.closed && cube.points.layout->oriented);
    for (const surfel::Surfel& s : cube.points.items) {
        QVERIFY(std::abs(s.normal.x) + std::abs(s.normal.y) + std::abs(s.normal.z) < 1.00001f); // along an axis
        const Vec3f outwards = s.position - Vec3f{0.5f, 1, 1.5f};
        QVERIFY(dot(s.normal, outwards) > 0.49f);
    }
}

/// The normals of a cone's side are those of the side as far as its tip, whose own looks along the axis.
void FacesTest::tipsTiltNoNormals() {
    for (const float height : {0.4f, 1.0f, 3.0f}) {
        constexpr std::uint32_t corners = 64;
        Faces cone{{{0, 0, height}, {0, 0, 0}}, {}};
        for (std::uint32_t i = 0; i < corners; ++i) {
            const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / corners;
            cone.positions.push_back({std::cos(a), std::sin(a), 0});
            cone.triangles.push_back({0, 2 + i, 2 + (i + 1) % corners});
            cone.triangles.push_back({1, 2 + (i + 1) % corners, 2 + i});
        }
        const mesh::OpenedFaces found =
            mesh::openFaces(cone.list(), cone.triangles, {}, {.use = mesh::FaceUse::Sample, .count = 1500});
        for (const surfel::Surfel& s : found.points.items) {
            const float r = std::hypot(s.position.x, s.position.y);
            if (s.normal.z < -0.9f || !(r > 0))
                continue;
            const Vec3f side = base::normalized(Vec3f{height * s.position.x / r, height * s.position.y / r, 1});
            QVERIFY2(dot(s.normal, side) > 0.995f, qPrintable(QString("%1 %2").arg(height).arg(dot(s.normal, side))));
        }
    }
}

void FacesTest::coloursAndAttributesFollowTheCorners() {
    const Faces square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->colours = true;
    layout->add("height", surfel::ScalarType::Float32);
    surfel::SurfelList vertices;
    vertices.layout = layout;
    for (const Vec3f& p : square.positions) {
        std::uint32_t word = 0;
        surfel::write(layout->attributes()[0], {&word, 1}, static_cast<double>(p.x));
        surfel::Surfel vertex = at(p);
        vertex.colour = surfel::rgba(p.x > 0 ? 200 : 0, 0, 0);
        vertices.append(vertex, {&word, 1});
    }
    const mesh::OpenedFaces found =
        mesh::openFaces(std::move(vertices), square.triangles, {}, {.use = mesh::FaceUse::Sample, .count = 1000});
    QVERIFY(!found.closed && found.points.size() > 900);
    for (std::size_t i = 0; i < found.points.size(); ++i) {
        const surfel::Surfel& s = found.points.items[i];
        const double height = surfel::read(found.points.layout->attributes()[0], found.points.extraOf(i));
        QVERIFY(std::abs(height - static_cast<double>(s.position.x)) < 1e-6);
        QVERIFY(std::abs(static_cast<float>(s.colour & 255u) - 200 * s.position.x) <= 0.51f);
    }
}

void FacesTest::evenVerticesStayAndCoarseOnesDoNot() {
    const Faces fine = band(400, 160, false), coarse = band(100, 40, false), cube = box({1, 1, 1});
    QVERIFY(sampleWell(fine.topology(), fine.positions));
    QVERIFY(!sampleWell(coarse.topology(), coarse.positions));
    QVERIFY(!sampleWell(cube.topology(), cube.positions));
    const mesh::OpenedFaces kept = mesh::openFaces(fine.list(), fine.triangles, {}, {});
    QVERIFY(!kept.sampled && kept.closed);
    QCOMPARE(kept.points.size(), fine.positions.size());
    for (const surfel::Surfel& s : kept.points.items) {
        const Vec3d p = base::cast<double>(s.position), ring = base::normalized(Vec3d{p.x, p.y, 0});
        QVERIFY(dot(base::cast<double>(s.normal), base::normalized(p - ring)) > 0.999);
    }
    const mesh::OpenedFaces sampled = mesh::openFaces(cube.list(), cube.triangles, {}, {});
    QVERIFY(sampled.sampled && sampled.points.size() > 95'000 && sampled.points.size() < 105'000);
    QCOMPARE(sampled.messages.size(), std::size_t(1)); // how many
    const mesh::OpenedFaces rounded = mesh::openFaces(cube.list(), cube.triangles, {}, {.creases = false});
    QCOMPARE(rounded.messages.size(), std::size_t(2)); // and what becomes of sharp edges
}

/// Remains of a decimation, say: beside the faces, without a normal. They hid where the faces end, too.
void FacesTest::verticesOfNoFaceGo() {
    base::Random random(test::seed());
    for (const bool open : {false, true}) {
        Faces faces = band(400, 160, false);
        if (open)
            faces.triangles.resize(faces.triangles.size() * 3 / 4);
        const std::size_t used = faces.positions.size() * (open ? 3 : 4) / 4; // and a ring more
        for (int k = 0; k < 700; ++k)
            faces.positions.push_back(base::cast<float>(random.unitVector() * random.uniform(0.5, 1.4)));
        const mesh::OpenedFaces found = mesh::openFaces(faces.list(), faces.triangles, {}, {});
        QVERIFY(!found.sampled);
        QVERIFY(found.points.size() >= used && found.points.size() < used + 300);
        QCOMPARE(found.rims, open);
        QVERIFY(!found.messages.empty());
        QVERIFY(mesh::openFaces(faces.list(), faces.triangles, {}, {.use = mesh::FaceUse::Vertices}).points.size() ==
                faces.positions.size());
    }
}

void FacesTest::pointsWithAFewFacesStayPoints() {
    base::Random random(test::seed());
    Faces faces;
    for (int k = 0; k < 500; ++k)
        faces.positions.push_back(base::cast<float>(random.unitVector()));
    faces.triangles = {{0, 1, 2}, {3, 4, 5}};
    const mesh::OpenedFaces found = mesh::openFaces(faces.list(), faces.triangles, {}, {});
    QVERIFY(!found.sampled && !found.closed && !found.rims);
    QCOMPARE(found.points.size(), std::size_t{500});
    QVERIFY(mesh::openFaces(faces.list(), faces.triangles, {}, {.use = mesh::FaceUse::Sample}).sampled);
}

void FacesTest::brokenFacesLendNoNormals() {
    Faces torus = band(400, 160, false);
    const std::size_t sound = torus.triangles.size();
    for (std::size_t t = 0; t < sound; t += 100)
        torus.triangles.push_back(torus.triangles[t]);
    const mesh::OpenedFaces found = mesh::openFaces(torus.list(), torus.triangles, {}, {});
    QVERIFY(!found.sampled && !found.points.layout->normals);
    QVERIFY(mesh::openFaces(torus.list(), std::span(torus.triangles).first(sound), {}, {}).points.layout->normals);
}

/// Heights that change from vertex to vertex are more than the vertices can hold.
void FacesTest::roughVerticesAreSampled() {
    base::Random random(test::seed());
    Faces rough = band(400, 160, false);
    for (Vec3f& p : rough.positions)
        p += base::cast<float>(random.unitVector() * random.uniform(0, 0.012));
    QVERIFY(!sampleWell(rough.topology(), rough.positions));
}

static mesh::PieceSpacings spacingsFor(const Faces& faces) {
    const FaceTopology topology = faces.topology();
    return mesh::pieceSpacings(topology, faces.positions, mesh::InnerPlaces(topology, faces.positions), 0);
}

void FacesTest::thinWallsAskForMore() {
    const auto spacing = [](float thickness) { return spacingsFor(box({1, 1, thickness})).spacings[0]; };
    QVERIFY2(std::abs(spacing(0.006f) - 0.006 / 3) < 3e-5, qPrintable(QString::number(spacing(0.006f))));
    const double least = std::sqrt((2 + 4 * 0.001) / 1e6); // walls get no more than 1 million
    QVERIFY2(std::abs(spacing(0.001f) - least) < 1e-6, qPrintable(QString::number(spacing(0.001f))));
}

/// Walls end in acute edges however many samples there are; what is thin beside them counts as ever.
void FacesTest::acuteEdgesAskForNoMore() {
    base::Random random(test::seed());
    for (int k = 0; k < 2; ++k) {
        const double degrees = random.uniform(5, 25), flat = random.uniform(0.2, 1);
        const auto wedge = [&](double angle) {
            const auto z = static_cast<float>(std::tan(angle * std::numbers::pi / 360));
            Faces out;
            for (const float y : {0.0f, 1.0f + 0.1f * static_cast<float>(k)})
                out.positions.insert(out.positions.end(), {{0, y, 0}, {1, y, -z}, {1, y, z}});
            out.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
            return out;
        };
        QVERIFY2(spacingsFor(wedge(degrees)).finer.empty(),
                 qPrintable(QString("%1 degrees, seed %2").arg(degrees).arg(test::seed())));
        QVERIFY2(spacingsFor(wedge(flat)).finer.size() > 2000,
                 qPrintable(QString("%1 degrees, seed %2").arg(flat).arg(test::seed())));
    }
}

/// Beside the spacing of a crumb that touches a cube the edges of the cube are endless.
void FacesTest::crumbsAtCornersEndNoWork() {
    for (const float size : {1e-5f, 1e-9f}) {
        Faces cube = box({1, 1, 1});
        const Faces crumb = box({size, size, size});
        cube.positions.insert(cube.positions.end(), crumb.positions.begin(), crumb.positions.end());
        for (const Triangle& t : crumb.triangles)
            cube.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
        const mesh::OpenedFaces found =
            mesh::openFaces(cube.list(), cube.triangles, {}, {.use = mesh::FaceUse::Sample, .count = 4000});
        const auto labels = cells::LabelLayout::of(*found.points.layout);
        QVERIFY(labels.has_value() && found.points.size() > 3800);
        std::size_t beside = 0; // an edge of the cube
        for (std::size_t i = 0; i < found.points.size(); ++i)
            beside += labels->at(found.points.extraOf(i)).meeting != cells::Meeting::None ? 1 : 0;
        QVERIFY2(beside > 1000, qPrintable(QString::number(beside)));
    }
}

void FacesTest::tooManyAndTooFewSamplesAreRefused() {
    const Faces cube = box({1, 1, 1});
    QVERIFY_EXCEPTION_THROWN(
        mesh::openFaces(cube.list(), cube.triangles, {}, {.use = mesh::FaceUse::Sample, .spacing = 1e-9}), base::Error);
    QVERIFY_EXCEPTION_THROWN(
        mesh::openFaces(cube.list(), cube.triangles, {}, {.use = mesh::FaceUse::Sample, .spacing = 100}), base::Error);
}

static const test::Registered<FacesTest> registered;
#include "faces_test.moc"
