// Seams traced: circles where balls meet; and seams rounded by a ball, against the tori that
// it leaves.
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/cells/cell_projection.h"
#include "core/cells/seam_lines.h"
#include "core/mesh/extent/extent.h"
#include "core/solid/fillet.h"
#include "placed_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <numbers>
#include <QTest>

using base::Vec3d;
using solid::Operation;
using std::numbers::pi;
using test::shapeAt;

class SeamTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void seamsOfBallsAreTheirCircle();
    void drillsLeaveTwoSeams();
    void aCornerThatPokesIntoAFaceHasThree();
    void boxesThatCrossHaveOneClosedSeam();
    void filletsOfBallsLieOnTheirTorus_data();
    void filletsOfBallsLieOnTheirTorus();
    void chamfersAreFlatBetweenSharpEdges_data();
    void chamfersAreFlatBetweenSharpEdges();
    void aCylinderOnABoxGetsARoundFoot();
    void edgesAwayFromAFilletStaySharp();
    void otherWallsStayUnderAFillet();
    void modelsThatWereEditedKeepTheirPlaces();
    void whereNoBallFitsIsSaid();
    void threadsDoNotShow();
};

namespace {

solid::Combined combined(const surface::Surface& model, const char* id, const solid::Size& size, double spacing,
                         const solid::Pose& pose, Operation operation, double fillet = 0, double chamfer = 0) {
    const solid::PrimitiveRow& row = solid::primitive(id);
    solid::CombineOptions options;
    options.seams = true;
    options.fillet = fillet;
    options.chamfer = chamfer;
    return solid::combine(
        model, {solid::PrimitiveSide(row, size, pose), test::placed(solid::surfelsOf(row, size, spacing, {}), pose)},
        operation, options);
}

double integral(double from, double to, const std::function<double(double)>& f) {
    constexpr int steps = 20000;
    double out = 0;
    for (int i = 0; i < steps; ++i)
        out += f(from + (i + 0.5) * (to - from) / steps);
    return out * (to - from) / steps;
}

/// Two balls about 0 and (apart, 0, 0), and a ball that rolls on the outside or inside of each.
struct Rolling {
    double a, b, apart, radius, signA, signB;

    double toA() const { return a + signA * radius; }
    double toB() const { return b + signB * radius; }
    double x() const { return (toA() * toA() - toB() * toB() + apart * apart) / (2 * apart); }
    double ring() const { return std::sqrt(toA() * toA() - x() * x()); }
    /// From the surface of the torus.
    double offTorus(const Vec3d& p) const {
        return std::abs(std::hypot(p.x - x(), std::hypot(p.y, p.z) - ring()) - radius);
    }
};

std::size_t countIf(const surface::Surface& surface, const std::function<bool(const Vec3d&)>& which) {
    const surfel::SurfelList all = surface.tree().surfels();
    return static_cast<std::size_t>(std::count_if(all.items.begin(), all.items.end(), [&](const surfel::Surfel& s) {
        return which(base::cast<double>(s.position));
    }));
}

} // namespace

void SeamTest::seamsOfBallsAreTheirCircle() {
    constexpr double s = 0.05;
    base::Random random(31);
    for (int k = 0; k < 6; ++k) {
        const double apart = random.uniform(0.5, 1.5), b = random.uniform(0.6, 1);
        const Vec3d axis = random.unitVector();
        const surface::Surface one = shapeAt("ball", {1, 0, 0}, s),
                               two = shapeAt("ball", {b, 0, 0}, s, solid::poseAlong(axis * apart, axis));
        solid::CombineOptions options;
        options.seams = true;
        const solid::Combined result =
            solid::combine(one, {solid::SurfaceSide(two), two.tree().surfels()}, Operation::Union, options);
        const double along = (1 - b * b + apart * apart) / (2 * apart), radius = std::sqrt(1 - along * along);
        QCOMPARE(result.seams.size(), std::size_t(1));
        QVERIFY(result.seams[0].closed && result.seams[0].corners.empty());
        double most = 0;
        for (const solid::SeamPoint& p : result.seams[0].points) {
            const double height = dot(p.position, axis);
            most = std::max(most, std::hypot(height - along, length(p.position - axis * height) - radius));
        }
        const QByteArray told = QString("%1 apart, radius %2: %3 s").arg(apart).arg(b).arg(most / s).toUtf8();
        QVERIFY2(most < 0.1 * s, told);
        QVERIFY2(std::abs(result.seams[0].length() / (2 * pi * radius) - 1) < 2e-3, told);
    }
}

/// Two boxes in a random pose, by their surfels.
static std::vector<solid::SeamCurve> seamsOfBoxes(const solid::Size& first, const solid::Size& second,
                                                  const solid::Pose& between, base::Random& random) {
    constexpr double s = 0.07;
    const solid::Pose pose = solid::poseAlong(random.unitVector(), random.unitVector());
    const solid::Pose other{pose.turn * between.turn, pose.place(between.middle)};
    const surface::Surface model = shapeAt("box", first, s, pose), operand = shapeAt("box", second, s, other);
    solid::CombineOptions options;
    options.seams = true;
    return solid::combine(model, {solid::SurfaceSide(operand), operand.tree().surfels()}, Operation::Union, options)
        .seams;
}

void SeamTest::aCornerThatPokesIntoAFaceHasThree() {
    constexpr std::uint64_t seed = 11;
    base::Random random(seed);
    base::Mat3d down; // a cube's diagonal
    const Vec3d rows[] = {normalized(Vec3d{1, 1, -2}), normalized(Vec3d{1, -1, 0}), normalized(Vec3d{-1, -1, -1})};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            down[i][j] = rows[i][static_cast<std::size_t>(j)];
    for (int k = 0; k < 6; ++k) {
        const double depth = random.uniform(0.2, 0.4);
        const std::vector<solid::SeamCurve> seams =
            seamsOfBoxes({2, 2, 1}, {1, 1, 1}, {down, {0, 0, 0.5 - depth + 0.5 * std::sqrt(3.0)}}, random);
        const QByteArray told = QString("seed %1, pose %2, depth %3").arg(seed).arg(k).arg(depth).toUtf8();
        QVERIFY2(seams.size() == 1 && seams[0].closed && seams[0].corners.size() == 3, told);
        QCOMPARE(seams[0].pieces(), std::size_t(3));
        QVERIFY2(std::abs(seams[0].length() / (3 * std::sqrt(6.0) * depth) - 1) < 0.01, told);
    }
}

void SeamTest::boxesThatCrossHaveOneClosedSeam() {
    constexpr std::uint64_t seed = 12;
    base::Random random(seed);
    for (int k = 0; k < 6; ++k) {
        const Vec3d apart{random.uniform(0.2, 0.7), random.uniform(0.2, 0.7), random.uniform(0.2, 0.7)};
        const std::vector<solid::SeamCurve> seams =
            seamsOfBoxes({1, 1, 1}, {1, 1, 1}, {base::Mat3d::identity(), apart}, random);
        const QByteArray told = QString("seed %1, pose %2").arg(seed).arg(k).toUtf8();
        QVERIFY2(seams.size() == 1 && seams[0].closed && seams[0].corners.size() == 6, told);
        const double wanted = 2 * (3 - apart.x - apart.y - apart.z);
        QVERIFY2(std::abs(seams[0].length() / wanted - 1) < 0.01, told);
    }
}

void SeamTest::drillsLeaveTwoSeams() {
    constexpr double s = 0.05;
    const solid::Combined result = combined(shapeAt("ball", {1, 0, 0}, s), "cylinder", {0.4, 4, 0}, s,
                                            solid::poseAlong({}, {0, 0.6, 0.8}), Operation::Difference);
    QCOMPARE(result.seams.size(), std::size_t(2));
    for (const solid::SeamCurve& seam : result.seams) {
        QVERIFY(seam.closed && seam.corners.empty());
        QVERIFY(std::abs(seam.length() / (0.8 * pi) - 1) < 2e-3);
    }
}

void SeamTest::filletsOfBallsLieOnTheirTorus_data() {
    QTest::addColumn<int>("operation");
    QTest::addColumn<double>("signA");
    QTest::addColumn<double>("signB");
    QTest::newRow("union") << int(Operation::Union) << 1.0 << 1.0;
    QTest::newRow("difference") << int(Operation::Difference) << -1.0 << 1.0;
    QTest::newRow("intersection") << int(Operation::Intersection) << -1.0 << -1.0;
}

void SeamTest::filletsOfBallsLieOnTheirTorus() {
    QFETCH(int, operation);
    QFETCH(double, signA);
    QFETCH(double, signB);
    constexpr double s = 0.03, radius = 0.2;
    const Rolling roll{1, 0.8, 1.1, radius, signA, signB};
    const solid::Combined result = combined(shapeAt("ball", {1, 0, 0}, s), "ball", {0.8, 0, 0}, s,
                                            solid::poseAlong({1.1, 0, 0}, {0, 0, 1}), Operation(operation), radius);
    QVERIFY(result.rounded > 0);
    // where it touches: on the lines from the middles of both balls through the ring
    const double touchA = roll.x() / roll.toA(), touchB = 1.1 + (roll.x() - 1.1) * 0.8 / roll.toB();
    std::size_t fillet = 0;
    for (const surfel::Surfel& each : result.surface.tree().surfels().items) {
        const Vec3d p = base::cast<double>(each.position);
        const double offA = std::abs(length(p) - 1), offB = std::abs(distance(p, {1.1, 0, 0}) - 0.8);
        if (std::min(offA, offB) < 1e-5) {
            const bool onA = offA < offB; // beyond where the ball touches nothing is left
            const double to = onA ? touchA : touchB;
            const bool left = operation != int(onA ? Operation::Intersection : Operation::Union);
            QVERIFY(left ? p.x < to + 0.01 * s : p.x > to - 0.01 * s);
            continue;
        }
        ++fillet;
        QVERIFY2(roll.offTorus(p) < 0.02 * s, QByteArray::number(roll.offTorus(p) / s));
        const Vec3d out = p - Vec3d{roll.x(), 0, 0}, ring = normalized(Vec3d{0, p.y, p.z}) * roll.ring(),
                    normal = normalized(out - ring) * (operation == int(Operation::Union) ? -1 : 1);
        QVERIFY(dot(normal, base::cast<double>(each.normal)) > 0.999);
    }
    QVERIFY(fillet > result.rounded / 2); // the others stand where the ball touches
    const mesh::Extent extent = mesh::extentOf(result.surface);
    QVERIFY(extent.closed);
    const auto disc = [](double r, double x, double of) { return std::max(0.0, r * r - (x - of) * (x - of)); };
    const auto profile = [&](double x) { // square of the radius of the result about the axis
        const double a = disc(1, x, 0), b = disc(0.8, x, 1.1), arc = std::sqrt(disc(radius, x, roll.x()));
        const bool within = x > std::min(touchA, touchB) && x < std::max(touchA, touchB);
        switch (Operation(operation)) {
        case Operation::Union:
            return within ? std::pow(roll.ring() - arc, 2) : std::max(a, b);
        case Operation::Intersection:
            return within ? std::pow(roll.ring() + arc, 2) : std::min(a, b);
        default:
            return 0.0; // not a function of x: checked by the surfels
        }
    };
    if (Operation(operation) == Operation::Difference)
        return;
    const double wanted = pi * integral(-1, 1.9, profile);
    QVERIFY2(std::abs(extent.volume / wanted - 1) < 0.002, QByteArray::number(extent.volume / wanted));
}

void SeamTest::chamfersAreFlatBetweenSharpEdges_data() {
    filletsOfBallsLieOnTheirTorus_data();
}

void SeamTest::chamfersAreFlatBetweenSharpEdges() {
    QFETCH(int, operation);
    if (test::sanitized && operation != 0)
        QSKIP("seconds under a sanitizer");
    QFETCH(double, signA);
    QFETCH(double, signB);
    constexpr double s = 0.03, radius = 0.2;
    const Rolling roll{1, 0.8, 1.1, radius, signA, signB};
    const solid::Combined result = combined(shapeAt("ball", {1, 0, 0}, s), "ball", {0.8, 0, 0}, s,
                                            solid::poseAlong({1.1, 0, 0}, {0, 0, 1}), Operation(operation), 0, radius);
    QVERIFY(result.rounded > 0 && result.atSeam > 0);
    // where it touches, as (along, about the axis); a cone is between
    const double touchA = roll.x() / roll.toA(), ringA = roll.ring() / roll.toA();
    const double touchB = 1.1 + (roll.x() - 1.1) * 0.8 / roll.toB(), ringB = roll.ring() * 0.8 / roll.toB();
    std::size_t flat = 0;
    for (const surfel::Surfel& each : result.surface.tree().surfels().items) {
        const Vec3d p = base::cast<double>(each.position);
        if (std::min(std::abs(length(p) - 1), std::abs(distance(p, {1.1, 0, 0}) - 0.8)) < 1e-5)
            continue;
        ++flat;
        const double share = (p.x - touchA) / (touchB - touchA), ring = ringA + (ringB - ringA) * share;
        QVERIFY2(share > -0.01 && share < 1.01 && std::abs(std::hypot(p.y, p.z) - ring) < 0.02 * s,
                 qPrintable(QString("%1 %2").arg(share).arg(std::hypot(p.y, p.z) - ring)));
    }
    QVERIFY(flat > result.rounded / 2);
    // both edges, sharp
    std::vector<double> lengths;
    for (const cells::SeamLine& line : cells::seamLines(result.surface)) {
        QVERIFY(line.closed);
        lengths.push_back(line.length() / (2 * pi));
        for (const cells::SeamPoint& point : line.points)
            QVERIFY((point.turn < 0) == (operation == int(Operation::Union)));
    }
    QCOMPARE(lengths.size(), std::size_t(2));
    std::sort(lengths.begin(), lengths.end());
    QVERIFY2(std::abs(lengths[0] - std::min(ringA, ringB)) < 2e-3 &&
                 std::abs(lengths[1] - std::max(ringA, ringB)) < 2e-3,
             qPrintable(QString("%1 %2").arg(lengths[0]).arg(lengths[1])));
    QVERIFY(mesh::extentOf(result.surface).closed);
}

void SeamTest::aCylinderOnABoxGetsARoundFoot() {
    if (test::sanitized)
        QSKIP("ten seconds under a sanitizer");
    constexpr double s = 0.04, radius = 0.25, r = 0.4;
    const solid::Combined result = combined(shapeAt("box", {2, 2, 1}, s), "cylinder", {r, 1.6, 0}, s,
                                            solid::poseAlong({0.1, 0, 0.5}, {0, 0, 1}), Operation::Union, radius);
    QVERIFY(result.rounded > 0);
    const double ring = r + radius, z = 0.5 + radius;
    std::size_t fillet = 0;
    for (const surfel::Surfel& each : result.surface.tree().surfels().items) {
        const Vec3d p = base::cast<double>(each.position) - Vec3d{0.1, 0, 0};
        const double out = std::hypot(p.x, p.y);
        if (p.z < 0.5 + 1e-6 || out < r + 1e-6) {
            QVERIFY(p.z < 0.5 - 1e-6 || out < r + 1e-6 || out > ring - 0.01 * s);
            continue;
        }
        ++fillet;
        QVERIFY(std::abs(std::hypot(out - ring, p.z - z) - radius) < 0.02 * s);
    }
    QVERIFY2(fillet + 200 > result.rounded && fillet <= result.rounded, QByteArray::number(qulonglong(fillet)));
    const mesh::Extent extent = mesh::extentOf(result.surface);
    const double foot =
                     pi *
                     integral(0, radius,
                              [&](double h) {
                                  return std::pow(ring - std::sqrt(radius * radius - (radius - h) * (radius - h)), 2) -
                                         r * r;
                              }),
                 wanted = 4 + pi * r * r * 0.8 + foot;
    QVERIFY(extent.closed);
    QVERIFY2(std::abs(extent.volume / wanted - 1) < 0.002, QByteArray::number(extent.volume / wanted));
}

/// The underside of a thin plate is nearer to where the ball touches than the seam is.
void SeamTest::otherWallsStayUnderAFillet() {
    constexpr double s = 0.05;
    const surface::Surface plate = shapeAt("box", {2, 2, 0.3}, s);
    const solid::Combined result = combined(plate, "cylinder", {0.4, 0.8, 0}, s,
                                            solid::poseAlong({0, 0, 0.45}, {0, 0, 1}), Operation::Union, 0.25);
    const auto below = [](const Vec3d& p) { return p.z < -0.14; };
    QCOMPARE(countIf(result.surface, below), countIf(plate, below));
}

/// Blocks of a tree that was edited stand in another order than those of one that is built.
void SeamTest::modelsThatWereEditedKeepTheirPlaces() {
    constexpr double s = 0.05;
    const solid::Combined first = combined(shapeAt("box", {2, 2, 1}, s), "cylinder", {0.3, 3, 0}, s,
                                           solid::poseAlong({-0.5, 0, 0}, {0, 0, 1}), Operation::Difference);
    const solid::Combined then = combined(first.surface, "ball", {0.4, 0, 0}, s,
                                          solid::poseAlong({0.4, 0, 0.5}, {0, 0, 1}), Operation::Union, 0.1);
    const auto away = [](const Vec3d& p) { return distance(p, Vec3d{0.4, 0, 0.5}) > 0.8; };
    const auto within = [](const Vec3d& p) { return distance(p, Vec3d{0.4, 0, 0.5}) < 0.35; };
    QCOMPARE(countIf(then.surface, away), countIf(first.surface, away));
    QCOMPARE(countIf(then.surface, within), std::size_t(0));
}

void SeamTest::edgesAwayFromAFilletStaySharp() {
    constexpr double s = 0.05;
    const solid::Combined result = combined(shapeAt("box", {2, 2, 1}, s), "cylinder", {0.4, 1.6, 0}, s,
                                            solid::poseAlong({0, 0, 0.5}, {0, 0, 1}), Operation::Union, 0.2);
    const cells::CellSurface cells = *cells::CellSurface::of(result.surface);
    base::Random random(5);
    for (int k = 0; k < 40; ++k) {
        const double along = random.uniform(-0.8, 0.8), angle = random.uniform(0, 2 * pi);
        for (const auto& [x, foot] : {std::pair{Vec3d{1.02, along, 0.52}, Vec3d{1, along, 0.5}},
                                      std::pair{Vec3d{0.41 * std::cos(angle), 0.41 * std::sin(angle), 1.31},
                                                Vec3d{0.4 * std::cos(angle), 0.4 * std::sin(angle), 1.3}}}) {
            const cells::CellFoot found = cells::project(cells, x);
            QCOMPARE(found.feature, cells::Feature::Seam);
            QVERIFY(distance(found.projection.foot, foot) < 0.03 * s);
        }
    }
}

void SeamTest::whereNoBallFitsIsSaid() {
    constexpr double s = 0.06;
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, s), box = shapeAt("box", {1, 1, 1}, s);
    // on the outside of two balls a ball of any size rolls; on the inside none that is larger than the lens
    QVERIFY_EXCEPTION_THROWN(
        combined(ball, "ball", {1, 0, 0}, s, solid::poseAlong({1.5, 0, 0}, {0, 0, 1}), Operation::Intersection, 0.4),
        base::Error);
    // and along the seam at a corner of a cube none rolls on inside
    QVERIFY_EXCEPTION_THROWN(
        combined(box, "ball", {0.3, 0, 0}, s, solid::poseAlong({0.5, 0.5, 0.5}, {0, 0, 1}), Operation::Difference, 0.1),
        base::Error);
}

void SeamTest::threadsDoNotShow() {
    const surface::Surface ball = shapeAt("ball", {1, 0, 0}, 0.08);
    const auto hash = [&] {
        return combined(ball, "ball", {0.7, 0, 0}, 0.08, solid::poseAlong({0.9, 0, 0}, {0, 0, 1}), Operation::Union,
                        0.2)
            .surface.tree()
            .contentHash()
            .text();
    };
    QCOMPARE(test::onThreads(3, hash), test::onThreads(1, hash));
}

static const test::Registered<SeamTest> registered;
#include "seam_test.moc"
