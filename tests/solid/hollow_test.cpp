// Hollow solids: walls as thick as asked, sharp edges inside below those outside.
#include "core/solid/hollow.h"

#include "core/base/random.h"
#include "core/cells/labels.h"
#include "core/cells/seams.h"
#include "core/mesh/extent/extent.h"
#include "meshed.h"
#include "placed_shapes.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <numbers>
#include <QTest>

using base::Vec3d;
using std::numbers::pi;
using test::shapeAt;

class HollowTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void wallsHaveTheVolumeOfTheirThickness_data();
    void wallsHaveTheVolumeOfTheirThickness();
    void thinBoxesHaveTwelveEdgesInside();
    void belowAnEdgeInwardsTheWallGoesRound();
    void modelsWithoutLabelsGetNone();
};

namespace {

constexpr double s = 0.1;
/// Of walls, whose volume goes with s: what edges are off goes with its square.
constexpr double share = 0.1 * s;

QByteArray told(const mesh::Extent& extent, double wanted) {
    return QString("volume %1 for %2, seed %3").arg(extent.volume).arg(wanted).arg(test::seed()).toUtf8();
}

} // namespace

void HollowTest::wallsHaveTheVolumeOfTheirThickness_data() {
    QTest::addColumn<QByteArray>("shape");
    QTest::addColumn<double>("spacings");
    QTest::newRow("box") << QByteArray("box") << 2.0;
    if (!test::sanitized)
        QTest::newRow("cylinder") << QByteArray("cylinder") << 2.0;
}

void HollowTest::wallsHaveTheVolumeOfTheirThickness() {
    QFETCH(QByteArray, shape);
    QFETCH(double, spacings);
    base::Random random(test::seed());
    const double t = spacings * s;
    const bool isBox = shape == "box";
    const solid::Size outer = isBox ? solid::Size{1.1, 0.9, 1} : solid::Size{0.6, 1.1, 0},
                      inner = isBox ? solid::Size{1.1 - 2 * t, 0.9 - 2 * t, 1 - 2 * t}
                                    : solid::Size{0.6 - t, 1.1 - 2 * t, 0};
    const solid::Pose pose = solid::poseAlong(random.unitVector() * 0.3, random.unitVector());
    const solid::Combined result = solid::hollowed(shapeAt(shape, outer, s, pose), t);
    result.surface.tree().validate();
    const mesh::Topology topology = test::meshed(result.surface);
    QCOMPARE(topology.boundaryLoops, std::size_t(0));
    QCOMPARE(topology.components, std::size_t(2));
    QCOMPARE(topology.euler(), 4LL);
    if (test::sanitized)
        return; // the same again, and finer
    const mesh::Extent extent = mesh::extentOf(result.surface);
    const double wanted = solid::primitive(shape.data()).volume(outer) - solid::primitive(shape.data()).volume(inner);
    QVERIFY2(extent.closed && std::abs(extent.volume - wanted) < share * wanted, told(extent, wanted));
}

/// Its faces meet three by three, which no two sides of an edge are: each is a cell of its own.
void HollowTest::thinBoxesHaveTwelveEdgesInside() {
    base::Random random(test::seed());
    const double t = random.uniform(1.5, 3) * s;
    const auto side = [&] { return random.uniform(0.8, 1.2); };
    const solid::Size outer{side(), side(), side()}, inner{outer[0] - 2 * t, outer[1] - 2 * t, outer[2] - 2 * t};
    const solid::Pose pose = solid::poseAlong(random.unitVector() * 0.3, random.unitVector());
    const surface::Surface hollow = solid::hollowed(shapeAt("box", outer, s, pose), t).surface;
    const auto cells = cells::CellSurface::of(hollow);
    QVERIFY(cells);
    const std::vector<cells::Seam> seams = cells::traceSeams(*cells);
    QVERIFY2(seams.size() == 24 && cells::cornersOf(seams).size() == 16,
             qPrintable(QString("%1 seams, walls of %2 s, seed %3").arg(seams.size()).arg(t / s).arg(test::seed())));
    if (test::sanitized)
        return; // the volume costs as much again
    const mesh::Extent extent = mesh::extentOf(hollow);
    const solid::PrimitiveRow& box = solid::primitive("box");
    const double wanted = box.volume(outer) - box.volume(inner);
    QVERIFY2(extent.closed && std::abs(extent.volume - wanted) < 1e-4 * wanted, told(extent, wanted));
}

/// A box without a corner: below the edge that is left there the wall is part of a cylinder.
void HollowTest::belowAnEdgeInwardsTheWallGoesRound() {
    if (test::sanitized)
        QSKIP("ten seconds under a sanitizer");
    base::Random random(test::seed());
    constexpr double t = 2.2 * s, a = 1.3, b = 1.2, c = 0.5, d = 0.4, high = 0.9;
    const solid::Pose pose = solid::poseAlong(random.unitVector() * 0.3, random.unitVector());
    solid::Pose corner = pose;
    corner.middle = pose.place({a / 2, b / 2, 0});
    const solid::PrimitiveRow& box = solid::primitive("box");
    const solid::Size away{2 * c, 2 * d, 2};
    const surface::Surface part =
        solid::combine(shapeAt("box", {a, b, high}, s, pose),
                       {solid::PrimitiveSide(box, away, corner), test::placed(surfelsOf(box, away, s, {}), corner)},
                       solid::Operation::Difference)
            .surface;
    const solid::Combined result = solid::hollowed(part, t);
    QCOMPARE(test::meshed(result.surface).boundaryLoops, std::size_t(0));
    const mesh::Extent extent = mesh::extentOf(result.surface);
    const double room = ((a - 2 * t) * (b - 2 * t) - c * d + (1 - pi / 4) * t * t) * (high - 2 * t),
                 wanted = (a * b - c * d) * high - room;
    QVERIFY2(extent.closed && std::abs(extent.volume - wanted) < share * wanted, told(extent, wanted));
}

void HollowTest::modelsWithoutLabelsGetNone() {
    const solid::Combined result = solid::hollowed(shapeAt("ball", {1, 0, 0}, 0.2), 0.5);
    QVERIFY(!cells::LabelLayout::of(*result.surface.tree().layout()));
    QCOMPARE(test::meshed(result.surface).components, std::size_t(2));
}

static const test::Registered<HollowTest> registered;
#include "hollow_test.moc"
