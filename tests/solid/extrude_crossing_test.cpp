// Parts that are drawn or pushed through the model: told exactly where they are, and made one solid where asked for.
#include "chosen.h"
#include "core/base/random.h"
#include "core/mesh/check/topology.h"
#include "core/mesh/extent/extent.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/solid/extrude/extrude.h"
#include "meshed.h"
#include "placed_shapes.h"
#include "process/even_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <numbers>
#include <QTest>

using base::Vec3d, base::Vec3f;
using std::numbers::pi;
using test::chosen, test::meshed;

class ExtrudeCrossingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void pitsAreNoCrossingsUntilTheyComeOutBehind();
    void narrowPitsAndSpikesAreNoCrossings();
    void whatComesOutBehindBecomesABore();
    void whatMeetsAnotherPartBecomesOneWithIt();
    void wholeFacesArePushedInFlush();
    void threadsDoNotShow();
};

namespace {

/// The cap about a direction.
solid::Extruded pushed(const surface::Surface& ball, const Vec3d& axis, double angle, double length, bool merge) {
    const auto cap =
        chosen(ball.tree(), {}, [&](const Vec3d& p, const Vec3d&) { return dot(p, axis) > std::cos(angle); });
    return solid::extrudeSelected(ball, cap, {length, axis, merge, merge});
}

} // namespace

/// A cap of angle a that is pushed in by L leaves the ball where L > 2 cos a.
void ExtrudeCrossingTest::pitsAreNoCrossingsUntilTheyComeOutBehind() {
    base::Random random(test::seed());
    const surface::Surface ball = test::surfaceOf(test::spherePoints(2000));
    const double spacing = test::sphereSpacing(2000);
    for (int round = 0; round < 4; ++round) {
        const Vec3d axis = random.unitVector();
        const double angle = random.uniform(0.3, 1.1), deepest = 2 * std::cos(angle);
        for (const double length : {-deepest + 2 * spacing, -deepest - 2 * spacing, random.uniform(0.1, 3)}) {
            const solid::Extruded result = pushed(ball, axis, angle, length, false);
            QVERIFY2((result.crossings.rays > 0) == (length < -deepest),
                     qPrintable(QString("angle %1 length %2: %3 rays, seed %4")
                                    .arg(angle)
                                    .arg(length)
                                    .arg(result.crossings.rays)
                                    .arg(test::seed())));
        }
    }
}

/// Four spacings wide, and many times as deep.
void ExtrudeCrossingTest::narrowPitsAndSpikesAreNoCrossings() {
    base::Random random(test::seed() + 1);
    const surface::Surface ball = test::surfaceOf(test::spherePoints(3000));
    for (int round = 0; round < 2; ++round)
        QCOMPARE(pushed(ball, random.unitVector(), 2.5 * test::sphereSpacing(3000), round & 1 ? 1.5 : -1.5, false)
                     .crossings.rays,
                 std::size_t(0));
}

void ExtrudeCrossingTest::whatComesOutBehindBecomesABore() {
    base::Random random(test::seed() + 2);
    const Vec3d axis = random.unitVector();
    const double angle = random.uniform(0.4, 0.9);
    const std::size_t count = test::sanitized ? 2500 : 4000;
    const double bound = 80.0 / static_cast<double>(count); // knives are blunt by the area of surfels
    const surface::Surface ball = test::surfaceOf(test::spherePoints(count));
    const solid::Extruded result = pushed(ball, axis, angle, -random.uniform(2.1, 3), true);
    result.surface.tree().validate();
    mesh::MarchingReport report; // its edges are knives, at which extents take long
    const mesh::Mesh mesh = mesh::marchingCubes(result.surface, {}, report);
    const mesh::Topology topology = mesh::topologyOf(mesh.triangles, mesh.positions.size(), mesh.kinds);
    const double volume = mesh::volumeOf(mesh), wanted = 4 * pi / 3 * std::pow(std::cos(angle), 3);
    const QByteArray told =
        QString("angle %1: volume %2 of %3, seed %4").arg(angle).arg(volume).arg(wanted).arg(test::seed()).toUtf8();
    QVERIFY2(std::abs(volume / wanted - 1) < bound && result.inside > 0, told);
    QVERIFY2(topology.boundaryLoops == 0 && topology.components == 1 && topology.genus() == 1, told);
}

/// Of two balls one grows a bar into the other.
void ExtrudeCrossingTest::whatMeetsAnotherPartBecomesOneWithIt() {
    base::Random random(test::seed() + 3);
    const double angle = random.uniform(0.3, 0.7);
    surfel::SurfelList both = test::spherePoints(1000);
    for (surfel::Surfel s : test::spherePoints(1000).items) {
        s.position = s.position + Vec3f{3, 0, 0};
        both.append(s, {});
    }
    const surface::Surface pair = test::surfaceOf(both);
    const auto cap =
        chosen(pair.tree(), {}, [&](const Vec3d& p, const Vec3d&) { return p.x < 1.5 && p.x > std::cos(angle); });
    const solid::Extruded apart = solid::extrudeSelected(pair, cap, {0.8, Vec3d{1, 0, 0}, true, true});
    QCOMPARE(apart.crossings.rays, std::size_t(0));
    QCOMPARE(apart.inside, std::size_t(0));
    const solid::Extruded result = solid::extrudeSelected(pair, cap, {2, Vec3d{1, 0, 0}, true, true});
    const mesh::Extent extent = mesh::extentOf(result.surface);
    const double c = std::cos(angle), bar = pi * (1 - c * c) * (3 - 2 * c), lens = pi / 3 * (2 + c) * (1 - c) * (1 - c),
                 wanted = 8 * pi / 3 + bar - 2 * lens;
    QVERIFY2(extent.closed && std::abs(extent.volume / wanted - 1) < 0.01,
             qPrintable(QString("%1 of %2, seed %3").arg(extent.volume).arg(wanted).arg(test::seed())));
    QCOMPARE(meshed(result.surface).components, std::size_t(1));
}

/// Walls would lie on the sides: the box is lower.
void ExtrudeCrossingTest::wholeFacesArePushedInFlush() {
    base::Random random(test::seed() + 4);
    const solid::Size size{random.uniform(0.9, 1.4), random.uniform(0.9, 1.4), random.uniform(0.7, 1)};
    const double length = -random.uniform(0.2, 0.5);
    const surface::Surface box = test::shapeAt("box", size, 0.05);
    const auto face = chosen(box.tree(), {}, [](const Vec3d&, const Vec3d& n) { return n.z > 0.9; });
    QVERIFY(solid::extrudeSelected(box, face, {length, {}, true, false}).crossings.rays > 0);
    const solid::Extruded result = solid::extrudeSelected(box, face, {length, {}, true, true});
    const mesh::Extent extent = mesh::extentOf(result.surface);
    const double wanted = size[0] * size[1] * (size[2] + length);
    QVERIFY2(extent.closed && std::abs(extent.volume / wanted - 1) < 0.0005,
             qPrintable(QString("%1 of %2, seed %3").arg(extent.volume).arg(wanted).arg(test::seed())));
}

void ExtrudeCrossingTest::threadsDoNotShow() {
    const surface::Surface ball = test::surfaceOf(test::spherePoints(3000));
    const auto made = [&] { return test::hashOf(pushed(ball, {0, 0, 1}, 0.7, -2.3, true).surface); };
    QCOMPARE(test::onThreads(2, made), test::onThreads(1, made));
}

static const test::Registered<ExtrudeCrossingTest> registered;
#include "extrude_crossing_test.moc"
