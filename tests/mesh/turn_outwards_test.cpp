// Closed pieces of faces look outwards, whatever the file says.
#include "core/mesh/faces/turn_outwards.h"

#include "core/mesh/faces/open_faces.h"
#include "face_models.h"
#include "support/registry.h"

#include <QTest>

using namespace faces;

class TurnOutwardsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void closedPiecesLookOutwards();
    void holesStayHoles();
    void bodiesInBodiesStayBodies();
    void nestedBoxesKeepTheirSidesAmongThemselves();
    void openPiecesKeepTheirSide();
    void aTinyHoleDoesNotHideTheInside();
    void ownNormalsAreTurnedToo();
};

static void invert(Faces& faces, std::size_t from = 0) {
    for (std::size_t t = from; t < faces.triangles.size(); ++t)
        std::swap(faces.triangles[t][1], faces.triangles[t][2]);
}

static void moveBy(Faces& faces, const Vec3f& offset) {
    for (Vec3f& p : faces.positions)
        p += offset;
}

static void append(Faces& faces, const Faces& more) {
    const auto first = static_cast<std::uint32_t>(faces.positions.size());
    faces.positions.insert(faces.positions.end(), more.positions.begin(), more.positions.end());
    for (const Triangle& t : more.triangles)
        faces.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// A box of that size about the origin.
static Faces centred(float size) {
    Faces out = box({size, size, size});
    moveBy(out, Vec3f{-size / 2, -size / 2, -size / 2});
    return out;
}

static double volume(const FaceTopology& topology, const std::vector<Vec3f>& positions, std::size_t from = 0,
                     std::size_t count = ~std::size_t(0)) {
    double out = 0;
    for (std::size_t t = from; t < std::min(topology.triangles.size(), from + count); ++t) {
        const Triangle& f = topology.triangles[t];
        out += dot(base::cast<double>(positions[f[0]]),
                   cross(base::cast<double>(positions[f[1]]), base::cast<double>(positions[f[2]]))) /
               6;
    }
    return out;
}

void TurnOutwardsTest::closedPiecesLookOutwards() {
    base::Random random(test::seed());
    for (Faces faces : {box({1, 1, 1}), box({4, 1, 0.01f}), band(40, 20, false)}) {
        const double expected = std::abs(volume(faces.topology(), faces.positions));
        for (int round = 0; round < 3; ++round) { // as it is, all turned, some turned
            const FaceTopology found = faces.topology();
            QVERIFY2(std::abs(volume(found, faces.positions) - expected) < 1e-6 * expected,
                     qPrintable(QString("seed %1").arg(test::seed())));
            for (std::size_t t = 0; t < found.triangles.size(); ++t) {
                const auto p = [&](std::size_t k) {
                    return base::cast<double>(faces.positions[found.triangles[t][k]]);
                };
                QVERIFY(dot(found.normals[t], cross(p(1) - p(0), p(2) - p(0))) > 0);
            }
            invert(faces, round == 0 ? 0 : faces.triangles.size() * 3 / 5);
        }
    }
}

void TurnOutwardsTest::holesStayHoles() {
    Faces hollow = centred(2), hole = centred(1);
    invert(hole);
    append(hollow, hole);
    for (int round = 0; round < 2; ++round) {
        const FaceTopology found = hollow.topology();
        QCOMPARE(volume(found, hollow.positions), 7.0);
        QCOMPARE(found.turnedOut, std::size_t(round == 0 ? 0 : 2));
        invert(hollow);
    }
}

void TurnOutwardsTest::bodiesInBodiesStayBodies() {
    Faces both = centred(2);
    append(both, centred(1));
    QCOMPARE(volume(both.topology(), both.positions), 9.0);
    invert(both);
    QCOMPARE(volume(both.topology(), both.positions), 9.0);
}

/// Rows of boxes in boxes, each outermost one with all that is in it turned by chance.
void TurnOutwardsTest::nestedBoxesKeepTheirSidesAmongThemselves() {
    for (int round = 0; round < test::effort(30); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        Faces all;
        double expected = 0;
        const Vec3d turn = random.unitVector();
        for (int row = 0; row < 6; ++row) {
            Faces nest;
            double inNest = 0;
            const auto deep = static_cast<int>(1 + random.below(4));
            for (int depth = 0; depth < deep; ++depth) {
                const float size = std::pow(0.6f, static_cast<float>(depth));
                const bool hole = depth > 0 && random.below(2) == 0;
                Faces one = centred(size);
                if (hole)
                    invert(one);
                inNest += (hole ? -1.0 : 1.0) * static_cast<double>(size * size * size);
                append(nest, one);
            }
            if (random.below(2) == 0)
                invert(nest);
            moveBy(nest, {1.001f * static_cast<float>(row), 0, 0}); // side by side
            append(all, nest);
            expected += inNest;
        }
        for (Vec3f& p : all.positions) { // askew
            const Vec3d v = base::cast<double>(p);
            p = base::cast<float>(v * std::cos(0.7) + cross(turn, v) * std::sin(0.7) +
                                  turn * (dot(turn, v) * (1 - std::cos(0.7))));
        }
        QVERIFY2(std::abs(volume(all.topology(), all.positions) - expected) < 1e-4,
                 qPrintable(QString("seed %1").arg(seed)));
    }
}

void TurnOutwardsTest::openPiecesKeepTheirSide() {
    Faces open = box({1, 1, 1});
    open.triangles.resize(10);
    for (int round = 0; round < 2; ++round) {
        QCOMPARE(open.topology().turnedOut, std::size_t(0));
        QCOMPARE(open.topology().triangles, open.triangles);
        invert(open);
    }
    Faces strip = band(40, 6, true);
    QCOMPARE(strip.topology().turnedOut, std::size_t(0));
}

void TurnOutwardsTest::aTinyHoleDoesNotHideTheInside() {
    Faces torus = band(120, 60, false);
    const double before = volume(torus.topology(), torus.positions);
    torus.triangles.erase(torus.triangles.begin() + 77);
    invert(torus);
    QVERIFY(volume(torus.topology(), torus.positions) > 0.99 * before);
}

void TurnOutwardsTest::ownNormalsAreTurnedToo() {
    Faces torus = band(90, 40, false);
    if (torus.topology().turnedOut > 0)
        invert(torus);
    for (int facesTurned = 0; facesTurned < 2; ++facesTurned) {
        for (const float side : {1.0f, -1.0f}) {
            surfel::SurfelList list = torus.list();
            auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
            layout->normals = layout->oriented = true;
            list.layout = layout;
            const auto outwards = [](const Vec3f& p) { return normalized(p - normalized(Vec3f{p.x, p.y, 0})); };
            for (surfel::Surfel& s : list.items)
                s.normal = outwards(s.position) * side;
            mesh::FaceOptions options;
            options.use = mesh::FaceUse::Vertices;
            const mesh::OpenedFaces opened = mesh::openFaces(list, torus.triangles, {}, options);
            for (const surfel::Surfel& s : opened.points.items)
                QVERIFY(dot(s.normal, outwards(s.position)) > 0.9f);
            QCOMPARE(opened.messages.empty(), facesTurned == 0 && side > 0);
        }
        invert(torus);
    }
}

static const test::Registered<TurnOutwardsTest> registered;
#include "turn_outwards_test.moc"
