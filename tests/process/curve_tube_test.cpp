// The tube in which a curve is shown: where its surfels lie, what radius it has, what it is made of.
#include "core/process/curve_tube.h"

#include "core/base/parallel.h"
#include "core/process/estimation/prepare.h"
#include "core/process/samples/samples.h"
#include "core/surface/curves/curve.h"
#include "support/registry.h"

#include <QTest>

using surface::Manifold;

class CurveTubeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void surfelsStandAtTheirRadiusFromTheCurve();
    void normalsLookAwayFromTheCurve();
    void tubeIsASurfaceWithoutHoles();
    void sameBitsAtAnyThreadCount();
    void openCurvesEndWhereTheirPointsDo();
    void surfacesAreShownAsTheyAre();
};

static surface::Surface coil(std::size_t count = 1500) {
    process::PrepareOptions options;
    options.definition.manifold = Manifold::Curve;
    return process::prepare(process::sample("coil").make(count, 1), options);
}

/// The radius that the sample was given, back from the angle around its ring.
static double radiusAt(const base::Vec3d& p) {
    return 0.03 + 0.015 * std::cos(std::atan2(p.z, p.x));
}

void CurveTubeTest::surfelsStandAtTheirRadiusFromTheCurve() {
    const surface::Surface curve = coil(), tube = process::tubeAround(curve);
    const auto list = tube.tree().surfels();
    QVERIFY(list.size() > 16 * 1500);
    for (std::size_t i = 0; i < list.size(); i += 37) {
        const base::Vec3d p = base::cast<double>(list.items[i].position);
        const auto foot = projectOnCurve(curve, p);
        QVERIFY(foot.ok());
        QVERIFY2(std::abs(distance(p, foot.foot) - radiusAt(foot.foot)) < 3e-4,
                 qPrintable(QString("%1 for %2").arg(distance(p, foot.foot)).arg(radiusAt(foot.foot))));
    }
}

void CurveTubeTest::normalsLookAwayFromTheCurve() {
    const surface::Surface curve = coil();
    const auto list = process::tubeAround(curve).tree().surfels();
    for (std::size_t i = 0; i < list.size(); i += 37) {
        const base::Vec3d p = base::cast<double>(list.items[i].position);
        const base::Vec3d away = base::normalized(p - projectOnCurve(curve, p).foot);
        QVERIFY(dot(away, base::cast<double>(list.items[i].normal)) > 0.99);
    }
}

void CurveTubeTest::tubeIsASurfaceWithoutHoles() {
    const surface::Surface curve = coil(), tube = process::tubeAround(curve);
    base::Random random(test::seed());
    const auto points = curve.tree().surfels();
    for (int i = 0; i < 2000; ++i) {
        const base::Vec3d on = base::cast<double>(points.items[random.below(points.size())].position);
        const auto foot = projectOnCurve(curve, on);
        const base::Vec3d u = base::perpendicular(foot.at.tangent), v = cross(foot.at.tangent, u);
        const double angle = random.uniform(0, 6.28);
        const base::Vec3d p = foot.foot + (u * std::cos(angle) + v * std::sin(angle)) * radiusAt(foot.foot);
        const auto e = tube.evaluate(base::cast<float>(p));
        QVERIFY2(e.ok() && e.samples >= 6, qPrintable(QString("%1 samples").arg(e.samples)));
        QVERIFY2(std::abs(e.value) < 5e-4f, qPrintable(QString::number(double(e.value))));
    }
}

void CurveTubeTest::sameBitsAtAnyThreadCount() {
    const surface::Surface curve = coil();
    base::setThreadCount(1);
    const auto one = process::tubeAround(curve).tree().contentHash();
    base::setThreadCount(2);
    QVERIFY(process::tubeAround(curve).tree().contentHash() == one);
}

void CurveTubeTest::openCurvesEndWhereTheirPointsDo() {
    surfel::SurfelList line;
    for (int i = 0; i <= 100; ++i) {
        surfel::Surfel s;
        s.position = {0.01f * float(i), 0, 0};
        line.items.push_back(s);
    }
    process::PrepareOptions options;
    options.definition.manifold = Manifold::Curve;
    const surface::Surface tube = process::tubeAround(process::prepare(line, options));
    const base::Box3f box = tube.tree().bounds();
    QVERIFY2(box.lo.x > -0.006f && box.lo.x < 0.006f, qPrintable(QString::number(double(box.lo.x))));
    QVERIFY2(box.hi.x > 0.994f && box.hi.x < 1.006f, qPrintable(QString::number(double(box.hi.x))));
    QVERIFY(tube.tree().layout()->normals);
}

void CurveTubeTest::surfacesAreShownAsTheyAre() {
    const surface::Surface sphere = process::prepare(process::sample("sphere").make(1000, 1), {});
    QVERIFY(process::shownAs(sphere).tree() == sphere.tree());
}

static const test::Registered<CurveTubeTest> registered;
#include "curve_tube_test.moc"
