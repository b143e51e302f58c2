// Faces of solids that were put together of parts open as the solid that all of them are.
#include "mesh/soups.h"

#include "core/mesh/check/topology.h"
#include "core/mesh/faces/inner_places.h"
#include "core/mesh/faces/open_faces.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/process/estimation/prepare.h"
#include "core/surface/surface.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using namespace soups;
using faces::FaceTopology, mesh::OpenedFaces;

class SoupsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void sharedWallsAreInside();
    void tiltedWallsAreInside();
    void crossingPartsKeepTheirOuterSides();
    void unionsMeshClosed_data();
    void unionsMeshClosed();
    void partsOnTopOfEachOtherAreOne();
    void whatLiesApartStays();
    void smallPartsOfLargeScenesAreJudgedByThemselves();
    void whatIsBuriedInAnAssemblyGoes();
};

namespace {

OpenedFaces sampled(const Faces& faces, std::size_t count) {
    return mesh::openFaces(faces.list(), faces.triangles, {}, {.use = mesh::FaceUse::Sample, .count = count});
}

Vec3d at(const surfel::Surfel& s) {
    return base::cast<double>(s.position);
}

/// Places on the boxes' faces that are farther than `apart` from edges and from other boxes.
std::vector<Vec3d> clearPlaces(const std::vector<Box>& boxes, double apart, std::size_t count, base::Random& random) {
    std::vector<Vec3d> out;
    for (std::size_t tries = 0; out.size() < count && tries < 100 * count; ++tries) {
        const Box& b = boxes[random.below(boxes.size())];
        const std::size_t k = random.below(3);
        Vec3d local;
        for (std::size_t i = 0; i < 3; ++i)
            local[i] = i == k ? (random.below(2) == 0 ? -1 : 1) * b.half[i]
                              : random.uniform(-1, 1) * std::max(0.0, b.half[i] - apart);
        const Vec3d place = b.centre + b.axes[0] * local[0] + b.axes[1] * local[1] + b.axes[2] * local[2];
        if (std::all_of(boxes.begin(), boxes.end(), [&](const Box& o) { return &o == &b || o.height(place) > apart; }))
            out.push_back(place);
    }
    return out;
}

/// From a place to a triangle.
double distanceTo(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const auto toSide = [&](const Vec3d& u, const Vec3d& v) {
        const double t = dot(p - u, v - u) / std::max(1e-300, lengthSq(v - u));
        return distance(p, u + (v - u) * std::clamp(t, 0.0, 1.0));
    };
    const Vec3d n = base::normalized(cross(b - a, c - a));
    const bool over =
        dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 && dot(cross(a - c, p - c), n) >= 0;
    return over ? std::abs(dot(p - a, n)) : std::min({toSide(a, b), toSide(b, c), toSide(c, a)});
}

/// Bars from corner to corner of a polygon, each past its ends; closed: a frame with a hole, else a row.
std::vector<Box> bars(base::Random& random, int corners, bool closed) {
    std::vector<Box> out;
    const Vec3d up = random.unitVector(), u = base::perpendicular(up), v = cross(up, u);
    for (int k = 0; k < corners - (closed ? 0 : 1); ++k) {
        const auto corner = [&](int i) {
            const double a = 2 * std::numbers::pi * i / corners;
            return u * std::cos(a) + v * std::sin(a);
        };
        const Vec3d from = corner(k), to = corner(k + 1), along = base::normalized(to - from);
        const double thick = random.uniform(0.12, 0.18);
        out.push_back({(from + to) / 2,
                       {distance(from, to) / 2 + 0.1, thick, random.uniform(0.15, 0.25)},
                       {along, cross(up, along), up}});
    }
    return out;
}

} // namespace

/// Bricks with their walls once or twice, cut into needles, turned by chance and with corners of their own: closed, as
/// large as their outside, which all of it faces.
void SoupsTest::sharedWallsAreInside() {
    for (int round = 0; round < test::effort(60); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        const Bricks made = bricks(random, 2 + random.below(12));
        Faces faces = facesOf(made, 1 + round % 2);
        halveSome(faces, random, round % 3 == 0 ? 0 : 40);
        turnSome(faces, random, round % 4 < 2 ? 0 : 0.3);
        const Faces soup = shuffled(faces, random);
        const FaceTopology found = soup.topology();
        const QByteArray told = QString("round %1, seed %2").arg(round).arg(seed).toUtf8();
        QVERIFY2(found.closed() && !found.oneSided, told);
        QVERIFY2(std::abs(found.area - made.area()) < 1e-5, told);
        double volume = 0;
        for (std::size_t t = 0; t < found.triangles.size(); ++t) {
            Vec3d middle;
            for (const std::uint32_t v : found.triangles[t])
                middle += base::cast<double>(soup.positions[v]) / 3;
            volume += dot(middle, found.normals[t]) * found.areas[t] / 3;
        }
        QVERIFY2(std::abs(volume - made.volume()) < 1e-4, told);
    }
}

/// Parts that were exported each for itself share corners, but not diagonals; turned, their four corners are not in one
/// plane to the last bit.
void SoupsTest::tiltedWallsAreInside() {
    for (int round = 0; round < test::effort(40); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        const Bricks made = bricks(random, 2 + random.below(8));
        Faces faces = facesOf(made, 2);
        for (std::size_t t = 0; t + 1 < faces.triangles.size(); t += 2) { // two of a square
            Triangle &a = faces.triangles[t], &b = faces.triangles[t + 1];
            if (a[0] == b[0] && a[2] == b[1] && random.below(2) == 0)
                a = {a[0], a[1], b[2]}, b = {a[1], b[1], b[2]};
        }
        const base::Vec3d u = random.unitVector(), v = base::perpendicular(u), w = cross(u, v);
        const Vec3d shift = random.unitVector() * 100;
        for (base::Vec3f& p : faces.positions) {
            const Vec3d at = base::cast<double>(p);
            p = base::cast<float>(shift + u * at.x + v * at.y + w * at.z);
        }
        const FaceTopology found = shuffled(faces, random).topology();
        const QByteArray told = QString("round %1, seed %2").arg(round).arg(seed).toUtf8();
        QVERIFY2(found.closed() && !found.oneSided, told);
        QVERIFY2(std::abs(found.area - made.area()) < 1e-3, told);
    }
}

/// Nothing is sampled in another part, and nothing on the outside is left out.
void SoupsTest::crossingPartsKeepTheirOuterSides() {
    for (int round = 0; round < test::effort(8); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        std::vector<Box> boxes(2 + random.below(20));
        for (Box& b : boxes)
            b = tilted(random, 0.4, 0.1, 0.5);
        Faces faces = together(boxes);
        for (std::size_t b = 0; b < boxes.size() && round % 2 == 1; ++b) { // less than half of each
            Triangle& t = faces.triangles[12 * b + random.below(12)];
            std::swap(t[1], t[2]);
        }
        const OpenedFaces found = sampled(shuffled(faces, random), 8000);
        const QByteArray told = QString("seed %1").arg(seed).toUtf8();
        QVERIFY2(found.closed, told);
        QVERIFY2(found.points.size() > 7200 && found.points.size() < 8400,
                 told + QByteArray::number(found.points.size()));
        std::size_t deep = 0;
        for (const surfel::Surfel& s : found.points.items) {
            double out = 1e9, on = 1e9;
            for (const Box& b : boxes) {
                out = std::min(out, b.height(at(s)));
                on = std::min(on, std::abs(b.height(at(s))));
            }
            deep += out < -1e-4 ? 1 : 0;
            QVERIFY2(on < 1e-5, told);
            const Vec3d before = at(s) + base::cast<double>(s.normal) * 1e-4;
            QVERIFY2(out < -1e-4 || std::any_of(boxes.begin(), boxes.end(),
                                                [&](const Box& b) {
                                                    return std::abs(b.height(at(s))) < 1e-5 && b.height(before) > 0;
                                                }),
                     told);
        }
        // A box that is wholly in another one stays, and so may little that no probe has found.
        std::size_t nested = 0;
        for (const Box& b : boxes)
            nested += std::any_of(boxes.begin(), boxes.end(), [&](const Box& o) {
                bool in = &o != &b;
                for (const base::Vec3f& p : b.faces().positions)
                    in &= o.height(base::cast<double>(p)) < 0;
                return in;
            });
        QVERIFY2(nested > 0 || deep < 20, told + " " + QByteArray::number(qulonglong(deep)));
        std::size_t bare = 0;
        for (const Vec3d& p : clearPlaces(boxes, 0, 300, random)) {
            double nearest = 1e9; // over the spacing there
            for (const surfel::Surfel& s : found.points.items)
                nearest = std::min(nearest, 3.478 * distance(at(s), p) / double(s.support));
            bare += nearest > 1.5 ? 1 : 0;
        }
        QVERIFY2(bare == 0, told + " " + QByteArray::number(qulonglong(bare)));
    }
}

void SoupsTest::unionsMeshClosed_data() {
    QTest::addColumn<int>("corners");
    QTest::addColumn<bool>("closed");
    QTest::newRow("two bars") << 3 << false;
    QTest::newRow("a triangle") << 3 << true;
    if (test::sanitized)
        return;
    QTest::newRow("a row") << 5 << false;
    QTest::newRow("a hexagon") << 6 << true;
}

void SoupsTest::unionsMeshClosed() {
    QFETCH(int, corners);
    QFETCH(bool, closed);
    for (int round = 0; round < test::effort(2); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        const std::vector<Box> boxes = bars(random, corners, closed);
        surface::SurfaceDefinition definition;
        const OpenedFaces found = sampled(together(boxes), 9000);
        const QByteArray told = QString("seed %1").arg(seed).toUtf8();
        QVERIFY2(found.closed, told);
        definition.boundary = surface::Boundary::None;
        definition.boundaryLimit = std::numeric_limits<float>::infinity();
        definition.oneSheet = !found.apart;
        const double spacing = double(found.points.items[0].support) / 3.478;
        mesh::MarchingReport report;
        mesh::MarchingOptions options;
        options.cell = spacing;
        const mesh::Mesh m = mesh::marchingCubes({tree::SurfelTree::build(found.points), definition}, options, report);
        const mesh::Topology t = mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
        QVERIFY2(t.manifold() && t.boundaryEdges == 0, told);
        QVERIFY2(t.components == 1, told + " " + QByteArray::number(qulonglong(t.components)));
        QVERIFY2(t.genus() == (closed ? 1 : 0), told);
        for (const Vec3d& p : clearPlaces(boxes, 4 * spacing, 200, random)) {
            double nearest = 1e9;
            for (const mesh::Triangle& f : m.triangles)
                nearest = std::min(nearest, distanceTo(p, base::cast<double>(m.positions[f[0]]),
                                                       base::cast<double>(m.positions[f[1]]),
                                                       base::cast<double>(m.positions[f[2]])));
            QVERIFY2(nearest < 0.6 * spacing, told + " " + QByteArray::number(nearest / spacing));
        }
    }
}

/// Boxes whose sides lie in one plane: against each other, where both are inside, or facing alike, where one stays.
void SoupsTest::partsOnTopOfEachOtherAreOne() {
    const auto areaOf = [](const OpenedFaces& found) { // from the spacing that was reached
        const double spacing = double(found.points.items[0].support) / 3.478;
        return spacing * spacing * double(found.points.size());
    };
    Faces against = aligned({0, 0, 0}, {1, 1, 1}).faces(), alike = against;
    append(against, aligned({1, 0.2, 0.3}, {1.8, 0.7, 0.6}).faces());
    append(alike, aligned({0.5, 0.25, 0.5}, {1.5, 0.75, 1}).faces());
    QVERIFY(std::abs(areaOf(sampled(against, 20000)) - (6 + 2 * 0.8 * 0.8)) < 0.08);
    const OpenedFaces low = sampled(alike, 20000);
    std::size_t inside = 0, onTop = 0;
    for (const surfel::Surfel& s : low.points.items) {
        const Vec3d p = at(s);
        inside += p.x > 0.51 && p.x < 0.99 && p.y > 0.24 && p.y < 0.76 && p.z > 0.49 && p.z < 0.99;
        onTop += p.x > 0.5 && p.x < 1 && p.y > 0.25 && p.y < 0.75 && p.z > 0.999;
    }
    QCOMPARE(inside, std::size_t(0));
    const double spacing = double(low.points.items[0].support) / 3.478;
    QVERIFY(std::abs(double(onTop) * spacing * spacing / 0.25 - 1) < 0.15); // as dense as elsewhere
}

/// A hole in a solid, and a solid in a solid that it does not touch.
void SoupsTest::whatLiesApartStays() {
    const Box outer = aligned({0, 0, 0}, {1, 1, 1}), inner = aligned({0.3, 0.3, 0.3}, {0.6, 0.6, 0.6});
    for (const bool hole : {true, false}) {
        Faces faces = outer.faces();
        Faces in = inner.faces();
        if (hole)
            for (Triangle& t : in.triangles)
                std::swap(t[1], t[2]);
        append(faces, in);
        std::size_t count = 0;
        const OpenedFaces found =
            mesh::openFaces(faces.list(), faces.triangles, {}, {.use = mesh::FaceUse::Sample, .spacing = 0.0256});
        for (const surfel::Surfel& s : found.points.items)
            if (std::abs(inner.height(at(s))) < 1e-5) {
                ++count;
                QVERIFY((inner.height(at(s) + base::cast<double>(s.normal) * 1e-3) > 0) != hole);
            }
        const double share = 0.09 / 1.09;
        QVERIFY(std::abs(double(count) / double(found.points.size()) - share) < 0.1 * share);
        QVERIFY(found.closed);
    }
}

/// However large what is beside them; in whichever part of it they stand.
void SoupsTest::smallPartsOfLargeScenesAreJudgedByThemselves() {
    for (int round = 0; round < test::effort(6); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        const double size = std::pow(10, random.uniform(-4, 0));
        std::vector<Box> boxes(round % 2 == 0 ? 12 : 200);
        for (Box& b : boxes) {
            b = tilted(random, 0.4, 0.1, 0.5);
            b.centre *= size;
            b.half *= size;
        }
        Faces faces = together(boxes);
        append(faces, aligned({-500, -500, -200}, {500, 500, -100}).faces());
        const FaceTopology topology = faces.topology();
        const mesh::InnerPlaces inside(topology, faces.positions);
        std::size_t wrong = 0, deep = 0, asked = 0;
        for (std::uint32_t t = 0; t < topology.triangles.size(); ++t) {
            const std::size_t own = topology.sources[t] / 12;
            double depth = 1e9; // below zero: in another box
            Vec3d place;
            double rest = 1;
            for (std::size_t k = 0; k < 3; ++k) {
                const double w = k == 2 ? rest : random.uniform(0, rest);
                rest -= w;
                place += base::cast<double>(faces.positions[topology.triangles[t][k]]) * w;
            }
            for (std::size_t b = 0; b < boxes.size(); ++b)
                if (b != own)
                    depth = std::min(depth, boxes[b].height(place));
            bool nested = own >= boxes.size(); // wholly in one other, or nothing is known of it
            for (std::size_t b = 0; b < boxes.size() && !nested; ++b) {
                nested = b != own;
                for (const base::Vec3f& p : boxes[own].faces().positions)
                    nested = nested && boxes[b].height(base::cast<double>(p)) < 1e-3 * size;
            }
            if (std::abs(depth) < 1e-4 * size || nested)
                continue;
            ++asked;
            deep += depth < 0;
            wrong += inside.has(place, t) != (depth < 0);
        }
        // A body that is inside of others by a part that no probe has met counts as wholly outside.
        QVERIFY2(asked > 50 && deep > 20 && 100 * wrong <= asked,
                 QString("size %1, %2 of %3, seed %4").arg(size).arg(wrong).arg(asked).arg(seed).toUtf8());
    }
}

/// In what two crossing boxes have in common nobody put anything; dolls in dolls were put there.
void SoupsTest::whatIsBuriedInAnAssemblyGoes() {
    const Box inner = aligned({0.85, 0.4, 0.4}, {0.95, 0.6, 0.6});
    const auto samplesOn = [&](const OpenedFaces& found) {
        return std::count_if(found.points.items.begin(), found.points.items.end(),
                             [&](const surfel::Surfel& s) { return std::abs(inner.height(at(s))) < 1e-5; });
    };
    Faces buried = aligned({0, 0, 0}, {1, 1, 1}).faces(), doll = buried;
    append(buried, aligned({0.8, 0.1, 0.1}, {2, 0.9, 0.9}).faces());
    append(doll, aligned({0.8, 0.1, 0.1}, {0.99, 0.9, 0.9}).faces());
    append(buried, inner.faces());
    append(doll, inner.faces());
    QCOMPARE(samplesOn(sampled(buried, 20000)), 0);
    QVERIFY(samplesOn(sampled(doll, 20000)) > 100);
}

static const test::Registered<SoupsTest> registered;
#include "soups_test.moc"
