// Bridges between boundary loops: sheets against the surfaces that they complete, and what is refused.
#include "core/solid/loops/bridge.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/process/registering/rigid.h"
#include "core/surface/curves/boundary_curves.h"
#include "meshed.h"
#include "placed_shapes.h"
#include "process/even_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <numbers>
#include <QTest>

using base::Vec3d;
using std::numbers::pi;
using test::meshed;

class BridgeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void coaxialTubesBecomeOneCylinder();
    void tubesOfDifferentRadiiMeetTheirTangentPlanes();
    void aTorusWithAPieceMissingIsATorusAgain_data();
    void aTorusWithAPieceMissingIsATorusAgain();
    void aBallWithTwoHolesBecomesATorus();
    void largeSheetsAreAsDenseAsSmallOnes();
    void surfelsAroundKeepEveryBitAndThreadsDoNotShow();
    void attributesGoOverFromOneSideToTheOther();
    void sidesThatDoNotAgreeAreRefused();
    void whatCannotBeBridgedIsRefused();
};

namespace {

process::Rigid anyPose(base::Random& random) {
    return process::motionOf(random.unitVector() * random.uniform(0, 2 * pi), random.unitVector() * 3.0);
}

surfel::SurfelList placed(surfel::SurfelList list, const process::Rigid& pose) {
    for (surfel::Surfel& s : list.items) {
        s.position = base::cast<float>(pose(base::cast<double>(s.position)));
        s.normal = base::cast<float>(pose.turn(base::cast<double>(s.normal)));
    }
    return list;
}

surface::Surface limited(const surfel::SurfelList& points) {
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.3F;
    return {tree::SurfelTree::build(points), definition};
}

/// About the z axis, outwards; rows turned by chance.
void addTube(surfel::SurfelList& out, double radius, double from, double to, double s, base::Random& random) {
    const int around = std::max(8, int(std::lround(2 * pi * radius / s * 0.93)));
    const int rows = std::max(2, int(std::lround((to - from) / s * 0.93 / 0.866)));
    for (int row = 0; row < rows; ++row) {
        const double z = from + (to - from) * (row + 0.5) / rows, turn = random.uniform(0, 1);
        for (int k = 0; k < around; ++k) {
            const double a = 2 * pi * (k + turn) / around;
            const Vec3d n{std::cos(a), std::sin(a), 0};
            out.append(test::surfelAt(n * radius + Vec3d{0, 0, z}, n, s), {});
        }
    }
}

surfel::SurfelList twoTubes(double radius, double other, double gap, double s, base::Random& random) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    addTube(out, radius, -0.5 * gap - 12 * s, -0.5 * gap, s, random);
    addTube(out, other, 0.5 * gap, 0.5 * gap + 12 * s, s, random);
    return out;
}

/// The two loops about the gap: those whose middles are nearest to a place.
std::array<std::size_t, 2> loopsAbout(const surface::Surface& surface, const Vec3d& place) {
    std::vector<std::pair<double, std::size_t>> found;
    const auto curves = surface::findBoundaryCurves(surface);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        Vec3d middle;
        for (const auto& p : curves[i].points)
            middle += p.position / double(curves[i].points.size());
        found.emplace_back(distance(middle, place), i);
    }
    std::sort(found.begin(), found.end());
    return {found.at(0).second, found.at(1).second};
}

struct Off {
    double distance = 0, normal = 0; ///< largest; of normals in radians
};

/// Of what was added, by fn(place in the model's own frame) -> signed distance and outward normal.
template <class Fn>
Off worst(const surface::Surface& before, const surface::Surface& after, const process::Rigid& pose, const Fn& fn) {
    Off out;
    const process::Rigid back = pose.inverse();
    for (const surfel::Surfel& s : test::without(after, before)) {
        const Vec3d p = back(base::cast<double>(s.position)), n = back.turn(base::cast<double>(s.normal));
        const auto [d, m] = fn(p);
        out.distance = std::max(out.distance, std::abs(d));
        out.normal = std::max(out.normal, std::acos(std::clamp(dot(n, m), -1.0, 1.0)));
    }
    return out;
}

} // namespace

void BridgeTest::coaxialTubesBecomeOneCylinder() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(test::sanitized ? 5 : 8); ++round) {
        const double s = random.uniform(0.03, 0.12), gap = random.uniform(0.3, 6);
        const process::Rigid pose = anyPose(random);
        const surface::Surface open = limited(placed(twoTubes(1, 1, gap, s, random), pose));
        const solid::Bridged result = solid::bridge(open, loopsAbout(open, pose({})));
        result.surface.tree().validate();
        const Off off = worst(open, result.surface, pose, [](const Vec3d& p) {
            const Vec3d flat{p.x, p.y, 0};
            return std::pair(length(flat) - 1, normalized(flat));
        });
        const QByteArray told = QString("s %1 gap %2: %3 off, normals %4, seed %5")
                                    .arg(s)
                                    .arg(gap)
                                    .arg(off.distance)
                                    .arg(off.normal)
                                    .arg(test::seed())
                                    .toUtf8();
        qInfo("%s", told.constData());
        QVERIFY2(result.surfels > 0 && off.distance < 0.05 * s + 0.002 && off.normal < 0.05, told);
        QCOMPARE(surface::findBoundaryCurves(result.surface).size(), std::size_t(2));
        const double wanted = 2 * pi * gap / (s * s);
        QVERIFY2(std::abs(double(result.surfels) - wanted) < 0.15 * wanted + 2 * 2 * pi / s,
                 qPrintable(QString("%1 of %2; ").arg(result.surfels).arg(wanted) + told));
    }
}

void BridgeTest::tubesOfDifferentRadiiMeetTheirTangentPlanes() {
    base::Random random(test::seed() + 1);
    for (const double other : {0.6, 1.5}) {
        const double s = 0.06, gap = 1.5;
        const surface::Surface open = limited(twoTubes(1, other, gap, s, random));
        const solid::Bridged result = solid::bridge(open, loopsAbout(open, {}));
        double beside = 0, over = 0;
        for (const surfel::Surfel& each : test::without(result.surface, open)) {
            const Vec3d p = base::cast<double>(each.position), n = base::cast<double>(each.normal);
            const double r = std::hypot(p.x, p.y), low = std::min(1.0, other), high = std::max(1.0, other);
            over = std::max({over, low - r, r - high});
            if (std::abs(std::abs(p.z) - 0.5 * gap) < 2 * s)
                beside = std::max(beside, std::abs(n.z));
        }
        QVERIFY2(over < 0.01 && beside < 0.3, qPrintable(QString("%1 %2").arg(over).arg(beside)));
    }
}

void BridgeTest::aTorusWithAPieceMissingIsATorusAgain_data() {
    QTest::addColumn<double>("degrees");
    for (const double degrees : {30.0, 60.0, 90.0, 120.0})
        QTest::addRow("%g", degrees) << degrees;
}

void BridgeTest::aTorusWithAPieceMissingIsATorusAgain() {
    QFETCH(double, degrees);
    base::Random random(test::seed() + std::uint64_t(degrees));
    const double minor = random.uniform(0.25, 0.45), s = minor * random.uniform(0.1, 0.17);
    const process::Rigid pose = anyPose(random);
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (const surfel::Surfel& each : solid::surfelsOf(solid::primitive("torus"), {1, minor, 0}, s, {}).items)
        if (std::abs(std::atan2(each.position.y, each.position.x)) > 0.5 * degrees * pi / 180)
            points.append(each, {});
    const surface::Surface open = limited(placed(points, pose));
    const solid::Bridged result = solid::bridge(open, {});
    const Off off = worst(open, result.surface, pose, [&](const Vec3d& p) {
        const Vec3d ring = normalized(Vec3d{p.x, p.y, 0}), away = p - ring;
        return std::pair(length(away) - minor, normalized(away));
    });
    const QByteArray told = QString("%1 degrees, s %2, minor %3: %4 off, normals %5, seed %6")
                                .arg(degrees)
                                .arg(s)
                                .arg(minor)
                                .arg(off.distance)
                                .arg(off.normal)
                                .arg(test::seed())
                                .toUtf8();
    QVERIFY2(off.distance < 0.015 * 2 * std::sin(0.5 * degrees * pi / 180) + 0.1 * s, told);
    QVERIFY2(off.normal < 0.12, told);
    QVERIFY2(surface::findBoundaryCurves(result.surface).empty(), told);
    const mesh::Topology topology = meshed(result.surface);
    QVERIFY2(topology.boundaryLoops == 0 && topology.components == 1 && topology.genus() == 1, told);
    const process::Summary spacing = test::spacingOver(result.surface, s);
    QVERIFY2(spacing.min > 0.6F && spacing.max < 1.6F,
             qPrintable(QString("%1 to %2").arg(spacing.min).arg(spacing.max)));
}

/// Through it, as a drilled ball.
void BridgeTest::aBallWithTwoHolesBecomesATorus() {
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (const surfel::Surfel& each : test::spherePoints(6000).items)
        if (std::abs(each.position.z) < 0.85F)
            points.append(each, {});
    const solid::Bridged result = solid::bridge(limited(points), {});
    QVERIFY(surface::findBoundaryCurves(result.surface).empty());
    const mesh::Topology topology = meshed(result.surface);
    QVERIFY(topology.boundaryLoops == 0 && topology.components == 1);
    QCOMPARE(topology.genus(), std::optional(1LL));
}

void BridgeTest::largeSheetsAreAsDenseAsSmallOnes() {
    if (test::sanitized)
        QSKIP("many surfels under a sanitizer");
    base::Random random(test::seed() + 2);
    const double s = 0.02, gap = 2.5; // some 40,000: shaped coarser
    const surface::Surface open = limited(twoTubes(1, 1, gap, s, random));
    const solid::Bridged result = solid::bridge(open, loopsAbout(open, {}));
    const Off off = worst(open, result.surface, {}, [](const Vec3d& p) {
        const Vec3d flat{p.x, p.y, 0};
        return std::pair(length(flat) - 1, normalized(flat));
    });
    const double wanted = 2 * pi * gap / (s * s);
    const QByteArray told = QString("%1 surfels of %2, %3 off, normals %4")
                                .arg(result.surfels)
                                .arg(wanted)
                                .arg(off.distance)
                                .arg(off.normal)
                                .toUtf8();
    QVERIFY2(std::abs(double(result.surfels) - wanted) < 0.15 * wanted, told);
    QVERIFY2(off.distance < 0.1 * s && off.normal < 0.05, told);
    QCOMPARE(surface::findBoundaryCurves(result.surface).size(), std::size_t(2));
}

void BridgeTest::surfelsAroundKeepEveryBitAndThreadsDoNotShow() {
    base::Random random(3);
    const surface::Surface open = limited(twoTubes(1, 0.8, 1, 0.1, random));
    const auto loops = loopsAbout(open, {});
    const auto made = [&] { return solid::bridge(open, loops).surface; };
    const surface::Surface one = test::onThreads(1, made), two = test::onThreads(2, made);
    QCOMPARE(one.tree().contentHash().text(), two.tree().contentHash().text());
    QCOMPARE(test::without(open, one).size(), std::size_t(0));
}

void BridgeTest::attributesGoOverFromOneSideToTheOther() {
    base::Random random(5);
    surfel::SurfelList points = twoTubes(1, 1, 2, 0.1, random);
    auto layout = std::make_shared<surfel::AttributeLayout>(*points.layout);
    layout->colours = true;
    points.layout = layout;
    for (surfel::Surfel& s : points.items)
        s.colour = s.position.z < 0 ? 0xff000000u : 0xffffffffu;
    const surface::Surface open = limited(points);
    for (const surfel::Surfel& s : test::without(solid::bridge(open, loopsAbout(open, {})).surface, open)) {
        const double red = double(s.colour & 255u) / 255, wanted = 0.5 + 0.5 * double(s.position.z);
        QVERIFY2(std::abs(red - wanted) < 0.15, qPrintable(QString("%1 at %2").arg(red).arg(s.position.z)));
    }
}

void BridgeTest::sidesThatDoNotAgreeAreRefused() {
    base::Random random(6);
    surfel::SurfelList points = twoTubes(1, 1, 1, 0.1, random);
    const surface::Surface good = limited(points);
    for (surfel::Surfel& s : points.items)
        if (s.position.z > 0)
            s.normal = -s.normal;
    const surface::Surface bad = limited(points);
    QVERIFY_EXCEPTION_THROWN(solid::bridge(bad, loopsAbout(bad, {})), base::Error);
    auto layout = std::make_shared<surfel::AttributeLayout>(*points.layout);
    layout->oriented = false; // without sides both are right
    points.layout = layout;
    const surface::Surface sideless = limited(points);
    const double wanted = double(solid::bridge(good, loopsAbout(good, {})).surfels);
    const double made = double(solid::bridge(sideless, loopsAbout(sideless, {})).surfels);
    QVERIFY2(std::abs(made - wanted) < 0.1 * wanted, qPrintable(QString("%1 of %2").arg(made).arg(wanted)));
}

void BridgeTest::whatCannotBeBridgedIsRefused() {
    base::Random random(7);
    const auto refusal = [](const surface::Surface& surface, const auto& loops) -> std::string {
        try {
            solid::bridge(surface, loops);
        } catch (const base::Error& error) {
            return error.what();
        }
        return {};
    };
    using Loops = std::optional<std::array<std::size_t, 2>>;
    const auto says = [&](const surface::Surface& surface, const Loops& loops, const char* what) {
        const std::string told = refusal(surface, loops);
        if (told.find(what) == std::string::npos)
            qWarning("%s", told.c_str());
        return told.find(what) != std::string::npos;
    };
    QVERIFY(says(test::surfaceOf(test::spherePoints(500)), {}, "no boundary"));
    const surface::Surface open = limited(twoTubes(1, 1, 1, 0.15, random));
    QVERIFY(says(open, {}, "which two"));
    QVERIFY(says(open, Loops({0, 9}), "number 9"));
    QVERIFY(says(open, Loops({1, 1}), "with itself"));
    surfel::SurfelList plate, half;
    plate.layout = half.layout = test::orientedLayout();
    for (const surfel::Surfel& s : test::planePoints(60, 1).items)
        if (length(s.position - base::Vec3f{15, 0, 0}) > 8 && length(s.position + base::Vec3f{15, 0, 0}) > 8)
            plate.append(s, {});
    QVERIFY(says(limited(plate), Loops({1, 2}), "fold")); // side by side
    for (const surfel::Surfel& s : test::spherePoints(2000).items)
        if (s.position.z < 0.5F)
            half.append(s, {});
    QVERIFY(says(limited(half), {}, "needs two"));
    surfel::SurfelList blocked = twoTubes(1, 1, 3, 0.15, random);
    for (int i = -20; i <= 20; ++i) // a plate between them
        for (int j = -20; j <= 20; ++j)
            blocked.append(test::surfelAt({0.15 * i, 0.15 * j, 0}, {0, 0, 1}, 0.15), {});
    const surface::Surface between = limited(blocked);
    const auto curves = surface::findBoundaryCurves(between);
    std::vector<std::size_t> facing;
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (std::abs(curves[i].points[0].position.z) > 1 && std::abs(curves[i].points[0].position.z) < 2)
            facing.push_back(i);
    QCOMPARE(facing.size(), std::size_t(2));
    QVERIFY(says(between, Loops({facing[0], facing[1]}), "run into"));
}

static const test::Registered<BridgeTest> registered;
#include "bridge_test.moc"
