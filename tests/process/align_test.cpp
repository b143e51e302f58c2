// Scans find each other: near their places by their surfaces, anywhere by what these look like.
#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "core/process/registering/align.h"
#include "core/process/registering/features.h"
#include "core/process/registering/find_place.h"
#include "core/process/registering/place_all.h"
#include "process/even_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using namespace process;
using base::Vec3d, base::Vec3f;

class AlignTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void motionsAreRigid();
    void twoScansMeet();
    void loopsClose();
    void scansAreFoundAnywhere();
    void placesThatCoverMoreDoNotHideTheTrueOne();
    void whatSlidesIsTold();
    void placesThatAreAlikeAreTold();
    void strangersAreRefused();
    void threadsDoNotShow();
    void featuresCanBeCancelledWhileTheyAreSorted();
};

namespace {

/// A lumpy body without symmetry.
double radiusAt(const Vec3d& d) {
    return 1 + 0.2 * std::sin(3 * d.x + 1) * std::cos(2.5 * d.y) + 0.15 * std::sin(4 * d.z + 0.5 * d.x) +
           0.1 * std::cos(5 * d.y - 2 * d.z) + 0.05 * std::sin(9 * d.x + 3 * d.z) * std::cos(7 * d.y);
}

/// What a scanner sees of it from `eye`, moved by `motion`.
surface::Surface scan(const Vec3d& eye, std::size_t count, double noise, const Rigid& motion, base::Random& random) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    while (out.size() < count) {
        const Vec3d d = random.unitVector();
        const auto at = [](const Vec3d& e) { return base::normalized(e) * radiusAt(base::normalized(e)); };
        const Vec3d u = base::perpendicular(d), v = cross(d, u), p = at(d);
        const Vec3d n = base::normalized(cross(at(d + u * 1e-5) - p, at(d + v * 1e-5) - p));
        if (dot(n, base::normalized(eye - p)) < 0.3)
            continue;
        surfel::Surfel s;
        s.position = base::cast<float>(motion(p + n * (noise * random.normal())));
        s.normal = base::cast<float>(motion.turn(n));
        out.append(s, {});
    }
    return prepare(out, {});
}

/// By up to so many radians and so far.
Rigid disturbance(double angle, double shift, base::Random& random) {
    return motionOf(random.unitVector() * angle, random.unitVector() * shift);
}

/// The farthest that a point of the body is from its place.
double error(const Rigid& pose, const Rigid& motion) {
    double out = 0;
    for (const Vec3d& x : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}, Vec3d{}})
        out = std::max(out, distance(pose(motion(x)), x));
    return out;
}

QByteArray told(double value) {
    return QByteArray::number(value) + ", seed " + QByteArray::number(test::seed());
}

} // namespace

void AlignTest::motionsAreRigid() {
    base::Random random(test::seed());
    const Rigid m = disturbance(2.5, 3, random), n = disturbance(1, 1, random);
    std::vector<Vec3d> from, to;
    for (int k = 0; k < 10; ++k) {
        from.push_back(random.unitVector() * random.uniform(0, 3));
        to.push_back(m(from.back()));
        QVERIFY(distance(m.inverse()(to.back()), from.back()) < 1e-14);
        QVERIFY(distance((m * n)(from.back()), m(n(from.back()))) < 1e-14);
    }
    Rigid found;
    QVERIFY(bestMotion(from.data(), to.data(), from.size(), found));
    for (std::size_t k = 0; k < from.size(); ++k)
        QVERIFY(distance(found(from[k]), to[k]) < 1e-13);
    const Vec3d line[3] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    QVERIFY(!bestMotion(line, line, 3, found));
}

void AlignTest::twoScansMeet() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(2); ++k) {
        const Rigid motion = disturbance(0.17, 0.1, random);
        std::vector<Placed> models{{scan({3, 0, 0}, 4000, 0.002, {}, random), {}},
                                   {scan({2, 2.5, 0}, 4000, 0.002, motion, random), {}}};
        const Alignment found = align(models);
        QVERIFY2(found.settled, told(found.rounds));
        QVERIFY2(error(models[1].pose, motion) < 0.004, told(error(models[1].pose, motion)));
        QVERIFY2(models[1].overlap > 0.3 && models[1].overlap < 0.9, told(models[1].overlap));
        QVERIFY2(models[1].rms < 0.004, told(models[1].rms));
        QVERIFY2(models[1].held && models[1].unique, told(models[1].rms));
    }
}

/// Four scans from all around, each disturbed: the last one meets the first.
void AlignTest::loopsClose() {
    if (test::sanitized)
        QSKIP("ten seconds under a sanitizer");
    base::Random random(test::seed());
    std::vector<Placed> models;
    std::vector<Rigid> motions;
    for (int k = 0; k < 4; ++k) {
        const double angle = k * 2 * std::numbers::pi / 4;
        motions.push_back(k == 0 ? Rigid{} : disturbance(0.1, 0.05, random));
        models.push_back(
            {scan({3 * std::cos(angle), 3 * std::sin(angle), 0.5}, 2000, 0.002, motions.back(), random), {}});
    }
    AlignOptions options;
    options.points = 400;
    align(models, options);
    for (std::size_t m = 1; m < models.size(); ++m)
        QVERIFY2(error(models[m].pose, motions[m]) < 0.015, // a third of the spacing
                 told(error(models[m].pose, motions[m])));
}

void AlignTest::scansAreFoundAnywhere() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(2); ++k) {
        const Rigid motion = disturbance(random.uniform(0.5, 3), 5, random);
        std::vector<Placed> models{{scan({3, 0, 0}, 6000, 0.001, {}, random), {}},
                                   {scan({1.5, 2.8, 0}, 6000, 0.001, motion, random), {}}};
        const float spacing = 0.06f;
        const Features fixed = featuresOf(models[0].surface, spacing), moving = featuresOf(models[1].surface, spacing);
        const FoundPlace place = findPlaces(moving, fixed, spacing, 1).at(0);
        QVERIFY2(error(place.pose, motion) < 0.1, told(place.share));
        models[1].pose = place.pose;
        AlignOptions options;
        options.reach = 0.2;
        align(models, options);
        QVERIFY2(error(models[1].pose, motion) < 0.005, told(error(models[1].pose, motion)));
    }
}

namespace {

/// More than the half of an egg with waves, denser on one side. Turned about, one half lies on all of the other to a
/// few hundredths; where it belongs, on half of it.
surface::Surface halfEgg(double side, const Rigid& motion, base::Random& random) {
    const auto at = [](const Vec3d& e) {
        const Vec3d d = base::normalized(e);
        const double r = 1 + 0.08 * std::sin(10 * d.x) * std::cos(8 * d.y) + 0.15 * d.z * d.z * d.z;
        return Vec3d{d.x * r, 1.4 * d.y * r, 0.8 * d.z * r};
    };
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    while (out.size() < 8000) {
        const Vec3d d = random.unitVector(), u = base::perpendicular(d), v = cross(d, u), p = at(d);
        if (side * p.y < -0.4 || random.uniform() > std::exp(1.5 * (d.x - 1)))
            continue;
        const Vec3d n = base::normalized(cross(at(d + u * 1e-5) - p, at(d + v * 1e-5) - p));
        surfel::Surfel s;
        s.position = base::cast<float>(motion(p + n * (0.003 * random.normal())));
        s.normal = base::cast<float>(motion.turn(n));
        out.append(s, {});
    }
    return prepare(out, {});
}

} // namespace

void AlignTest::placesThatCoverMoreDoNotHideTheTrueOne() {
    base::Random random(test::seed());
    const Rigid motion = disturbance(random.uniform(0.5, 3), 3, random);
    std::vector<Placed> models{{halfEgg(1, {}, random), {}}, {halfEgg(-1, motion, random), {}}};
    const std::vector<std::string> names{"a", "b"};
    placeAll(models, names);
    AlignOptions options;
    options.reach = 0.2;
    align(models, options);
    QVERIFY2(error(models[1].pose, motion) < 0.02, told(error(models[1].pose, motion)));
}

namespace {

/// Random points of a shape that slides along itself (a ball, a round bar, a plate), or of a cube's faces.
surface::Surface simpleScan(int shape, double noise, const Rigid& motion, base::Random& random) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    while (out.size() < 3000) {
        const Vec3d d = random.unitVector();
        const Vec3d across = base::normalized(Vec3d{d.x, d.y, 0});
        const double u = random.uniform(-1, 1), v = random.uniform(-1, 1);
        Vec3d p = d, n = d; // the ball
        if (shape == 1)
            p = across * 0.5 + Vec3d{0, 0, u}, n = across;
        if (shape == 2)
            p = {u, v, 0}, n = {0, 0, 1};
        if (shape == 3) {
            const std::size_t axis = random.below(3);
            n = {}, n[axis] = random.uniform() < 0.5 ? -1 : 1;
            p = {u, v, random.uniform(-1, 1)}, p[axis] = n[axis];
        }
        surfel::Surfel s;
        s.position = base::cast<float>(motion(p + n * (noise * random.normal())));
        s.normal = base::cast<float>(motion.turn(n));
        out.append(s, {});
    }
    return prepare(out, {});
}

} // namespace

/// One place is as good as the next on what slides along itself: the residual is small, and says nothing.
void AlignTest::whatSlidesIsTold() {
    base::Random random(test::seed());
    for (int shape = test::sanitized ? 2 : 0; shape < 4; ++shape) {
        const double noise = random.uniform(0, 0.01); // a fifth of the spacing and less
        std::vector<Placed> models{{simpleScan(shape, noise, {}, random), {}},
                                   {simpleScan(shape, noise, disturbance(0.05, 0.03, random), random), {}}};
        const Alignment found = align(models);
        QVERIFY2(models[1].held == (shape == 3), told(shape));
        QVERIFY(found.slide > 0.1 && models[0].held);
    }
}

/// A cube found anywhere may be any of its 24 turns; the lumpy body has one place.
void AlignTest::placesThatAreAlikeAreTold() {
    if (test::sanitized)
        QSKIP("ten seconds under a sanitizer");
    base::Random random(test::seed());
    for (const bool cube : {true, false}) {
        const Rigid motion = disturbance(random.uniform(0.5, 3), 5, random);
        std::vector<Placed> models;
        for (const Rigid& each : {Rigid{}, motion})
            models.push_back(
                {cube ? simpleScan(3, 0.002, each, random)
                      : scan(each == motion ? Vec3d{1.5, 2.8, 0} : Vec3d{3, 0, 0}, 3000, 0.002, each, random),
                 {}});
        const std::string names[] = {"a", "b"};
        placeAll(models, names);
        QVERIFY2(models[1].unique != cube, told(cube));
        QVERIFY2(cube || error(models[1].pose, motion) < 0.03, told(error(models[1].pose, motion)));
    }
}

void AlignTest::strangersAreRefused() {
    base::Random random(test::seed());
    std::vector<Placed> models{{scan({3, 0, 0}, 1000, 0, {}, random), {}},
                               {scan({3, 0, 0}, 1000, 0, motionOf({}, {50, 0, 0}), random), {}}};
    QVERIFY_EXCEPTION_THROWN(align(models), base::Error);
}

void AlignTest::threadsDoNotShow() {
    base::Random random(test::seed());
    const std::vector<Placed> models{{scan({3, 0, 0}, 1500, 0.002, {}, random), {}},
                                     {scan({2, 2.5, 0}, 1500, 0.002, disturbance(0.1, 0.05, random), random), {}}};
    std::vector<Placed> one = models, two = models;
    base::setThreadCount(1);
    align(one);
    base::setThreadCount(2);
    align(two);
    base::setThreadCount(0);
    QVERIFY(one[1].pose.translation == two[1].pose.translation && one[1].rms == two[1].rms);
}

/// Nothing is looked for, so that only the library's own loop is left to stop.
void AlignTest::featuresCanBeCancelledWhileTheyAreSorted() {
    base::Random random(test::seed());
    Features to;
    to.feature.resize(20000);
    for (Feature& each : to.feature)
        for (float& value : each)
            value = static_cast<float>(random.uniform());
    const std::atomic<bool> stop = true;
    const base::CancelScope scope(&stop);
    QVERIFY_EXCEPTION_THROWN(mostAlike({}, to), base::Cancelled);
}

static const test::Registered<AlignTest> registered;
#include "align_test.moc"
