// Orientation by agreement of the whole, and how much of an orientation is in doubt.
#include "core/base/cells.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/orientation/global_orientation.h"
#include "process/even_shapes.h"
#include "support/registry.h"

#include <numbers>
#include <QTest>

using namespace process;
using base::Vec3d, base::Vec3f;

class OrientationTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void spheresAndBoxesLookOutwards();
    void piecesApartAgree();
    void openPartsOfABodyAgree();
    void straysDoNotTurnTheBody();
    void bodiesThatStraysJoinLookOutwardsEach();
    void manyStraysTurnNoBodyInsideOut();
    void wedgesLookOutwards();
    void basesOfConesLookOutwards();
    void bothSidesOfLensesLookOutwards();
    void noSeamComesWhereNoneWas();
    void openSheetsStayAsNeighboursSay();
    void flippedPatchesAreInDoubt();
    void threadsDoNotShow();
};

namespace {

struct Body {
    std::vector<Vec3f> positions, outwards;
};

Body sphere(std::size_t n, const Vec3f& centre = {}, float radius = 1) {
    Body out;
    for (const surfel::Surfel& s : test::spherePoints(n).items) {
        out.positions.push_back(centre + s.position * radius);
        out.outwards.push_back(s.position);
    }
    return out;
}

/// Random points of a box's six faces, as far out along each as `half` of it.
Body box(double half, base::Random& random) {
    Body out;
    for (int k = 0; k < 12000; ++k) {
        Vec3d p{random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)}, n;
        const std::size_t axis = random.below(3);
        n[axis] = random.uniform() < 0.5 ? -1 : 1;
        p[axis] = n[axis];
        out.positions.push_back(base::cast<float>(p));
        out.outwards.push_back(base::cast<float>(n));
    }
    return out;
}

surfel::SurfelList listOf(const Body& body) {
    surfel::SurfelList out;
    for (const Vec3f& p : body.positions)
        out.items.emplace_back().position = p;
    return out;
}

/// Share of the points that look outwards after their true normals were turned by chance and oriented.
double outwardShare(const Body& body, base::Random& random) {
    const surfel::SurfelList list = listOf(body);
    const Cloud cloud(list.items);
    std::vector<Vec3f> normals(cloud.size());
    for (std::size_t i = 0; i < list.size(); ++i)
        normals[cloud.places()[i]] = random.uniform() < 0.5 ? body.outwards[i] : -body.outwards[i];
    if (!orientGlobally(cloud, nearestTable(cloud, 12), normals))
        return 0;
    double right = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
        right += dot(normals[cloud.places()[i]], body.outwards[i]) > 0;
    return right / double(list.size());
}

struct Estimate {
    bool sided;
    std::size_t inwards; ///< of the points whose normals are known
};

/// Of a cloud that begins with a body's points, strays behind them.
Estimate estimated(const Body& body, bool global = false) {
    const surfel::SurfelList list = listOf(body);
    const Cloud cloud(list.items);
    std::vector<Vec3f> normals = normalsOf(cloud);
    const NeighbourTable links = nearestTable(cloud, 12);
    Estimate out{global ? orientGlobally(cloud, links, normals) : orient(cloud, links, normals), 0};
    for (std::size_t i = 0; i < body.outwards.size(); ++i)
        out.inwards += dot(normals[cloud.places()[i]], body.outwards[i]) < 0;
    return out;
}

} // namespace

void OrientationTest::spheresAndBoxesLookOutwards() {
    base::Random random(test::seed());
    QCOMPARE(outwardShare(sphere(4000), random), 1.0);
    const double share = outwardShare(box(1, random), random);
    QVERIFY2(share > 0.999, qPrintable(QString("%1 seed %2").arg(share).arg(test::seed())));
}

/// The six faces of a box with gaps along its edges that no neighbour bridges: nothing but the whole tells their sides.
void OrientationTest::piecesApartAgree() {
    base::Random random(test::seed());
    const double share = outwardShare(box(0.8, random), random);
    QVERIFY2(share > 0.999, qPrintable(QString("%1 seed %2").arg(share).arg(test::seed())));
}

/// A sphere of which nothing is left but 14 caps.
void OrientationTest::openPartsOfABodyAgree() {
    base::Random random(test::seed());
    const Body whole = sphere(16000);
    Body caps;
    std::vector<Vec3f> middles;
    for (const float x : {-1.0f, 1.0f}) {
        middles.push_back({x, 0, 0}), middles.push_back({0, x, 0}), middles.push_back({0, 0, x});
        for (const float y : {-1.0f, 1.0f})
            for (const float z : {-1.0f, 1.0f})
                middles.push_back(base::normalized(Vec3f{x, y, z}));
    }
    for (std::size_t i = 0; i < whole.positions.size(); ++i)
        if (std::any_of(middles.begin(), middles.end(),
                        [&](const Vec3f& m) { return dot(m, whole.positions[i]) > 0.93f; })) {
            caps.positions.push_back(whole.positions[i]);
            caps.outwards.push_back(whole.outwards[i]);
        }
    const double share = outwardShare(caps, random);
    QVERIFY2(share == 1, qPrintable(QString("%1 seed %2").arg(share).arg(test::seed())));
}

/// Strays all around a body, whose normals mean nothing: they stand outermost, and do not tell which side is outside.
void OrientationTest::straysDoNotTurnTheBody() {
    base::Random random(test::seed());
    for (int k = 0; k < 12; ++k) {
        Body body = sphere(2000 + random.below(4000));
        const std::size_t whole = body.positions.size(), strays = whole * (1 + random.below(8)) / 200;
        for (std::size_t i = 0; i < strays; ++i)
            body.positions.push_back(base::cast<float>(
                Vec3d{random.uniform(-1.6, 1.6), random.uniform(-1.6, 1.6), random.uniform(-1.6, 1.6)}));
        for (const bool global : {false, true}) {
            const auto [sided, inwards] = estimated(body, global);
            QVERIFY(sided);
            QVERIFY2(inwards < whole / 100, qPrintable(QString("%1 of %2 inwards among %3 strays, global %4, seed %5")
                                                           .arg(inwards)
                                                           .arg(whole)
                                                           .arg(strays)
                                                           .arg(global)
                                                           .arg(test::seed())));
        }
    }
}

/// Noisy bodies beside each other with strays between them, by which the tree goes from one to the next: its way says
/// nothing of their sides.
void OrientationTest::bodiesThatStraysJoinLookOutwardsEach() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(10); ++k) {
        Body all;
        for (int body = 0; body < 3; ++body) {
            const std::size_t count = 1000 + random.below(2000);
            const double spacing = std::sqrt(4 * std::numbers::pi / double(count));
            const Body one = sphere(count);
            const Vec3f centre{2.3f * float(body), float(random.uniform(-0.3, 0.3)), float(random.uniform(-0.3, 0.3))};
            for (std::size_t i = 0; i < one.positions.size(); ++i) {
                const double out = 1 + random.uniform(0, 0.4) * spacing * random.normal();
                all.positions.push_back(centre + one.positions[i] * float(out));
                all.outwards.push_back(one.outwards[i]);
            }
        }
        const std::size_t whole = all.positions.size();
        for (std::size_t i = 0; i < whole / 50; ++i)
            all.positions.push_back(base::cast<float>(
                Vec3d{random.uniform(-1.5, 6.1), random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)}));
        const auto [sided, inwards] = estimated(all);
        QVERIFY(sided);
        const QString told("%1 of %2 inwards, seed %3, round %4");
        QVERIFY2(inwards < whole / 50, qPrintable(told.arg(inwards).arg(whole).arg(test::seed()).arg(k)));
    }
}

/// Among many strays some lie on a sheet of a handful by chance: these had a say about which side is outside.
void OrientationTest::manyStraysTurnNoBodyInsideOut() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(12); ++k) {
        constexpr std::size_t whole = 6000;
        const double minor = random.uniform(0.25, 0.45), spacing = 2 * std::numbers::pi * std::sqrt(minor / whole);
        Body all;
        for (std::size_t i = 0; i < whole; ++i) {
            const double a = random.uniform(0, 2 * std::numbers::pi), b = random.uniform(0, 2 * std::numbers::pi);
            const Vec3d n{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
            const Vec3d p = Vec3d{std::cos(a), std::sin(a), 0} + n * (minor + 0.3 * spacing * random.normal());
            all.positions.push_back(base::cast<float>(p));
            all.outwards.push_back(base::cast<float>(n));
        }
        for (std::size_t i = 0; i < whole / 4; ++i)
            all.positions.push_back(base::cast<float>(
                Vec3d{random.uniform(-1.7, 1.7), random.uniform(-1.7, 1.7), random.uniform(-1.7, 1.7)}));
        const std::size_t inwards = estimated(all).inwards;
        const QString told("%1 of %2 inwards, seed %3, round %4");
        QVERIFY2(inwards < whole / 50, qPrintable(told.arg(inwards).arg(whole).arg(test::seed()).arg(k)));
    }
}

/// At the tip of an acute wedge a chain of small turns leads from one flank to the other, the wrong way round.
void OrientationTest::wedgesLookOutwards() {
    base::Random random(test::seed());
    for (int k = 0; k < 12; ++k) {
        const double angle = random.uniform(0.25, 0.7), sine = std::sin(angle / 2), cosine = std::cos(angle / 2);
        const Vec3f normals[5] = {base::cast<float>(Vec3d{-sine, cosine, 0}),
                                  base::cast<float>(Vec3d{-sine, -cosine, 0}),
                                  {1, 0, 0},
                                  {0, 0, 1},
                                  {0, 0, -1}};
        const double areas[5] = {1, 1, 2 * sine, sine * cosine, sine * cosine};
        Body body;
        const double spacing = 0.02;
        base::CellMap<std::vector<Vec3d>> taken;
        for (int tries = 0; tries < 200'000; ++tries) { // no two closer than the spacing
            std::size_t face = 0;
            for (double at = random.uniform(0, 2 + 2 * sine + 2 * sine * cosine); face < 4 && at >= areas[face]; ++face)
                at -= areas[face];
            const double u = random.uniform(), v = random.uniform(), w = std::sqrt(random.uniform());
            const Vec3d flank{u * cosine, u * sine, v}, end{w * cosine, w * sine * (2 * v - 1), face == 3 ? 1.0 : 0.0};
            const Vec3d p = face == 0   ? flank
                            : face == 1 ? Vec3d{flank.x, -flank.y, flank.z}
                            : face == 2 ? Vec3d{cosine, sine * (2 * u - 1), v}
                                        : end;
            bool free = true;
            base::forCellsAround(base::cellOf(p, {}, 1 / spacing), [&](const base::Cell& cell) {
                if (const auto* found = taken.find(cell))
                    for (const Vec3d& other : *found)
                        free &= distance(p, other) > 0.8 * spacing;
            });
            if (!free)
                continue;
            taken.at(base::cellOf(p, {}, 1 / spacing)).push_back(p);
            body.positions.push_back(base::cast<float>(p));
            body.outwards.push_back(normals[face]);
        }
        const surfel::SurfelList list = listOf(body);
        const Cloud cloud(list.items);
        std::vector<Vec3f> found = normalsOf(cloud);
        QVERIFY(orient(cloud, nearestTable(cloud, 12), found));
        std::size_t inwards = 0;
        for (std::size_t i = 0; i < list.size(); ++i)
            inwards += dot(found[cloud.places()[i]], body.outwards[i]) < -0.3f;
        QVERIFY2(inwards < list.size() / 10, qPrintable(QString("%1 of %2 inwards, %3 degrees, seed %4")
                                                            .arg(inwards)
                                                            .arg(list.size())
                                                            .arg(angle * 180 / std::numbers::pi)
                                                            .arg(test::seed())));
    }
}

/// All of the way between flank and base goes over an acute edge.
void OrientationTest::basesOfConesLookOutwards() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(10); ++k) {
        const double height = random.uniform(0.8, 2.2), slant = std::hypot(1, height);
        Body body;
        for (int i = 0; i < 9000; ++i) {
            const double turn = random.uniform(0, 2 * std::numbers::pi), r = std::sqrt(random.uniform());
            const Vec3d out{std::cos(turn), std::sin(turn), 0};
            const bool base = random.uniform(0, 1 + slant) < 1;
            body.positions.push_back(base::cast<float>(base ? out * r : out * r + Vec3d{0, 0, height * (1 - r)}));
            body.outwards.push_back(
                base::cast<float>(base ? Vec3d{0, 0, -1} : (out * height + Vec3d{0, 0, 1}) / slant));
        }
        const Estimate found = estimated(body, true);
        QVERIFY(found.sided);
        QVERIFY2(
            found.inwards < body.outwards.size() / 15,
            qPrintable(QString("%1 inwards, height %2, seed %3").arg(found.inwards).arg(height).arg(test::seed())));
    }
}

/// Around the rim of a lens normals turn by so little, up to their sign, that neighbours say that both sides look the
/// same way. The winding number tells: above such a sheet it is -1, and 1 below.
void OrientationTest::bothSidesOfLensesLookOutwards() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(10); ++k) {
        const double height = random.uniform(0.07, 0.12), slant = std::hypot(1, height);
        Body body;
        for (int i = 0; i < 9000; ++i) {
            const double turn = random.uniform(0, 2 * std::numbers::pi), r = std::sqrt(random.uniform());
            const double up = random.uniform() < 0.5 ? 1 : -1;
            const Vec3d out{std::cos(turn), std::sin(turn), 0};
            body.positions.push_back(base::cast<float>(out * r + Vec3d{0, 0, up * height * (1 - r)}));
            body.outwards.push_back(base::cast<float>((out * height + Vec3d{0, 0, up}) / slant));
        }
        const Estimate found = estimated(body, true);
        QVERIFY(found.sided);
        QVERIFY2(
            found.inwards < body.outwards.size() / 5,
            qPrintable(QString("%1 inwards, height %2, seed %3").arg(found.inwards).arg(height).arg(test::seed())));
    }
}

/// Patches that are wrong in themselves, as of a box in a loose shell, make seams, which are for what has no two sides.
void OrientationTest::noSeamComesWhereNoneWas() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(6); ++k) {
        const Vec3d half{random.uniform(0.5, 0.85), random.uniform(0.5, 0.85), random.uniform(0.5, 0.85)};
        Body body;
        for (int i = 0; i < 6000; ++i) {
            const std::size_t axis = random.below(3);
            Vec3d p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
            p[axis] = p[axis] < 0 ? -1 : 1;
            body.positions.push_back(base::cast<float>(Vec3d{p.x * half.x, p.y * half.y, p.z * half.z}));
        }
        for (int i = 0; i < 600; ++i)
            body.positions.push_back(base::cast<float>(random.unitVector() * 2.0));
        QVERIFY2(estimated(body, true).sided, qPrintable(QString("seed %1 + %2").arg(test::seed()).arg(k)));
    }
}

/// Two sheets that look the same way, joined by a ramp, are no two sides of a body, though winding numbers would have
/// it.
void OrientationTest::openSheetsStayAsNeighboursSay() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(10); ++k) {
        const double high = random.uniform(0.3, 0.6), lap = random.uniform(-0.2, 0.2), length = 0.5;
        Body body;
        for (int i = 0; i < 9000; ++i) {
            const double x = random.uniform(-1, 1 + length), y = random.uniform(0, 1);
            const double t =
                std::clamp(x / length, 0.0, 1.0); // along the ramp, which may lead back below the upper sheet
            const Vec3d p{x < 0 ? x : x < length ? lap * t : x - length + lap, y, high * t};
            const Vec3d n = x < 0 || x > length ? Vec3d{0, 0, 1} : normalized(Vec3d{-high, 0, lap});
            body.positions.push_back(base::cast<float>(p));
            body.outwards.push_back(base::cast<float>(n));
        }
        const surfel::SurfelList list = listOf(body);
        const Cloud cloud(list.items);
        std::vector<Vec3f> byTrees = normalsOf(cloud), found = byTrees;
        const NeighbourTable links = nearestTable(cloud, 12);
        QVERIFY(orient(cloud, links, byTrees) && orientGlobally(cloud, links, found));
        QVERIFY2(found == byTrees, qPrintable(QString("seed %1").arg(test::seed())));
    }
}

void OrientationTest::flippedPatchesAreInDoubt() {
    const Body body = sphere(5000);
    const surfel::SurfelList list = listOf(body);
    const Cloud cloud(list.items);
    std::vector<Vec3f> normals(cloud.positions().begin(), cloud.positions().end());
    const auto doubts = [&] {
        const auto found = doubtfulSigns(cloud, nearestTable(cloud, 12), normals);
        return std::count(found.begin(), found.end(), 1);
    };
    QCOMPARE(doubts(), std::ptrdiff_t(0));
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (cloud.positions()[i].z > 0.9f)
            normals[i] = -normals[i];
    const auto rim = doubts(); // both sides of a circle of radius 0.44, a spacing of 0.05
    QVERIFY2(rim > 50 && rim < 300, qPrintable(QString::number(rim)));
}

void OrientationTest::threadsDoNotShow() {
    base::Random random(test::seed());
    const Body body = sphere(std::size_t(test::effort(5000)));
    const surfel::SurfelList list = listOf(body);
    const Cloud cloud(list.items);
    std::vector<Vec3f> one = normalsOf(cloud), two = one;
    base::setThreadCount(1);
    orientGlobally(cloud, nearestTable(cloud, 12), one);
    base::setThreadCount(2);
    orientGlobally(cloud, nearestTable(cloud, 12), two);
    base::setThreadCount(0);
    QVERIFY(one == two);
}

static const test::Registered<OrientationTest> registered;
#include "orientation_test.moc"
