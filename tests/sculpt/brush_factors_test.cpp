// What multiplies a dab for every tool alike: stamp, connected only, front-facing only.
#include "core/sculpt/brush_factors.h"

#include "core/base/random.h"
#include "core/sculpt/brush_connected.h"
#include "core/sculpt/brush_stamp.h"
#include "sculpt/shapes.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;
using base::Vec3f;

class BrushFactorsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void stampsAreTheirImageWithExactSlopes();
    void halvedStampsKeepTheirMean();
    void connectedIsTheWholeBrushOnOneSheet();
    void connectedStopsAtTheOtherSideOfAThinPlate();
    void connectedIsTheSameFromBothSidesOfAnUnorientedSheet();
    void connectedStrokesLeaveTheOtherSideBitIdentical();
    void frontFacingFadesWithTheAngle();
    void frontFacingLeavesWhatFacesAwayUntouched();
    void stampedNormalsFollowTheDisplacement();
};

static constexpr double s = 0.02;

static BrushStamp randomStamp(base::Random& random, int width, int height) {
    std::vector<float> values;
    for (int k = 0; k < width * height; ++k)
        values.push_back(float(random.uniform()));
    return {width, height, values};
}

void BrushFactorsTest::stampsAreTheirImageWithExactSlopes() {
    base::Random random(test::seed());
    const BrushStamp flat(9, 9, std::vector<float>(81, 0.5f));
    QVERIFY(std::abs(flat.at(0.3f, -0.2f).value - 0.5f) < 1e-6f);
    QCOMPARE(flat.at(3, 0).value, 0.0f);
    // White above, black below: v points up.
    const BrushStamp half(2, 2, {1, 1, 0, 0});
    QVERIFY(half.at(0, 0.5f).value > 0.7f && half.at(0, -0.5f).value < 0.3f && half.at(0, 0).dv > 0);
    const BrushStamp stamp = randomStamp(random, 7, 5);
    for (int k = 0; k < 500; ++k) {
        const float u = float(random.uniform(-1.2, 1.2)), v = float(random.uniform(-1.2, 1.2)), e = 1e-3f;
        const int level = int(random.below(2));
        const BrushStamp::Value at = stamp.at(u, v, level);
        const float du = (stamp.at(u + e, v, level).value - stamp.at(u - e, v, level).value) / (2 * e),
                    dv = (stamp.at(u, v + e, level).value - stamp.at(u, v - e, level).value) / (2 * e);
        QVERIFY2(std::abs(du - at.du) < 0.03f && std::abs(dv - at.dv) < 0.03f,
                 qPrintable(QString("seed %1: %2 %3, %4 %5").arg(test::seed()).arg(du).arg(at.du).arg(dv).arg(at.dv)));
        QVERIFY(at.value >= -1e-6f && at.value <= 1 + 1e-6f);
    }
}

void BrushFactorsTest::halvedStampsKeepTheirMean() {
    base::Random random(test::seed());
    const BrushStamp stamp = randomStamp(random, 64, 64);
    QCOMPARE(stamp.levels(), 7);
    for (int level = 0; level < 6; ++level) {
        double sum = 0;
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                sum += double(stamp.at((x + 0.5f) / 64 - 2, (y + 0.5f) / 64 - 2, level).value);
        QVERIFY2(std::abs(sum * 4 / (128 * 128) / 4 - 0.5) < 0.02, qPrintable(QString::number(sum / 128 / 128)));
    }
    QCOMPARE(stamp.levelFor(0), 0);
    QCOMPARE(stamp.levelFor(2.0f / 64), 0);
    QCOMPARE(stamp.levelFor(2.5f / 64), 1);
    QCOMPARE(stamp.levelFor(100), 6);
}

static std::size_t inBall(const surface::Surface& surface, const Vec3f& centre, float radius) {
    std::size_t count = 0;
    for (const surfel::Surfel& each : surface.tree().surfels().items)
        count += distance(each.position, centre) < radius;
    return count;
}

void BrushFactorsTest::connectedIsTheWholeBrushOnOneSheet() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(12000));
    const auto at = contact(sphere, {{0.1f, 0.2f, 5}, {0, 0, -1}});
    const Connected all(sphere.tree(), *at, 0.4f, 2.2f * float(test::sphereSpacing(12000)));
    QCOMPARE(all.count(), inBall(sphere, at->position, 0.4f));
    QVERIFY(all.count() > 300);
}

/// Two sheets of one plate, `gap` apart, the lower one facing down.
static surfel::SurfelList plate(float gap, bool oriented) {
    surfel::SurfelList out = test::planePoints(60, s), upper = out;
    for (surfel::Surfel lower : upper.items) {
        lower.position.z = -gap;
        lower.normal = oriented ? Vec3f{0, 0, -1} : Vec3f{0, 0, 1};
        out.append(lower, {});
    }
    if (!oriented) {
        auto layout = std::make_shared<surfel::AttributeLayout>();
        layout->normals = true;
        out.layout = layout;
    }
    return out;
}

void BrushFactorsTest::connectedStopsAtTheOtherSideOfAThinPlate() {
    for (const float gap : {0.2f, 0.5f, 1.5f}) { // spacings
        const tree::SurfelTree tree = tree::SurfelTree::build(plate(gap * float(s), true));
        const Contact top{{0.01f, 0.02f, 0}, {0, 0, 1}, 1};
        const Connected all(tree, top, 0.2f, 2.2f * float(s));
        std::size_t upper = 0;
        tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot) {
                const bool is = all.slotsOf(number) && all.slotsOf(number)->test(std::size_t(slot));
                const Vec3f p = block.position(slot);
                QCOMPARE(is, p.z == 0 && distance(p, top.position) < 0.2f);
                upper += is;
            }
        });
        QCOMPARE(upper, all.count());
    }
}

void BrushFactorsTest::connectedIsTheSameFromBothSidesOfAnUnorientedSheet() {
    const tree::SurfelTree tree = tree::SurfelTree::build(plate(3 * float(s), false));
    const Connected above(tree, {{0, 0, 0}, {0, 0, 1}, 1}, 0.2f, 2.2f * float(s)),
        below(tree, {{0, 0, 0}, {0, 0, -1}, 1}, 0.2f, 2.2f * float(s));
    QVERIFY(above.count() > 100);
    QCOMPARE(above.count(), below.count());
}

void BrushFactorsTest::connectedStrokesLeaveTheOtherSideBitIdentical() {
    const float gap = 1.5f * float(s);
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.25f;
    const surface::Surface thin(tree::SurfelTree::build(plate(gap, true)), definition);
    const auto movedBelow = [&](bool connected) {
        StrokeSettings settings;
        settings.radius = 0.15f;
        settings.connected = connected;
        settings.resample = false;
        const surface::Surface after =
            test::stroked(thin, settings, {{{{-0.1f, 0, 5}, {0, 0, -1}}, 1, 0}, {{{0.1f, 0, 5}, {0, 0, -1}}, 1, 0.1f}});
        std::size_t below = 0, above = 0;
        for (const surfel::Surfel& each : after.tree().surfels().items)
            if (each.normal.z < 0)
                below += each.position.z != -gap;
            else
                above += each.position.z != 0;
        return std::pair(below, above);
    };
    QVERIFY(movedBelow(false).first > 50);
    const auto [below, above] = movedBelow(true);
    QCOMPARE(below, std::size_t(0));
    QVERIFY(above > 50);
}

void BrushFactorsTest::frontFacingFadesWithTheAngle() {
    const tree::SurfelTree sphere = tree::SurfelTree::build(test::spherePoints(20000));
    Dab dab;
    dab.view = {0, 0, -1};
    dab.radius = 1;
    dab.frontFacing = true;
    const BrushFactors factors(dab);
    FactorLanes lanes;
    double worst = 0;
    sphere.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            if (slot % surfel::clusterSize == 0)
                factors.fill(number, block, slot / surfel::clusterSize, lanes);
            const auto i = std::size_t(slot % surfel::clusterSize);
            const Vec3f n = block.normal(slot);
            if (n.z <= 0)
                QCOMPARE(lanes.value[i], 0.0f);
            if (n.z >= 0.342f)
                QCOMPARE(lanes.value[i], 1.0f);
            // On the unit sphere the factor is a function of z: its gradient along the surface is known.
            const float t = std::clamp(n.z / 0.342f, 0.0f, 1.0f), slope = 6 * t * (1 - t) / 0.342f;
            const Vec3f exact = (Vec3f{0, 0, 1} - n * n.z) * slope, found{lanes.gx[i], lanes.gy[i], lanes.gz[i]};
            if (t > 0.25f && t < 0.75f) // where a cluster lies within the band
                worst = std::max(worst, double(length(found - exact)));
        }
    });
    QVERIFY2(worst < 1.5, qPrintable(QString::number(worst))); // of 4.4
}

void BrushFactorsTest::frontFacingLeavesWhatFacesAwayUntouched() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(12000));
    StrokeSettings settings;
    settings.radius = 0.6f;
    settings.frontFacing = true;
    settings.resample = false;
    // Near the outline: half of the brush lies behind it.
    const surface::Surface after = test::stroked(sphere, settings, {{{{0.97f, 0, 5}, {0, 0, -1}}, 1, 0}});
    std::size_t moved = 0;
    for (const surfel::Surfel& each : test::without(after, sphere)) {
        QVERIFY(each.position.z > -1e-3f);
        ++moved;
    }
    QVERIFY(moved > 100);
}

void BrushFactorsTest::stampedNormalsFollowTheDisplacement() {
    base::Random random(test::seed());
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, s));
    const auto stamp = std::make_shared<BrushStamp>(randomStamp(random, 4, 4));
    StrokeSettings settings;
    settings.radius = 0.4f;
    settings.strength = 1;
    settings.resample = false;
    settings.stamp = "random";
    Stroke stroke(plane, settings, {}, stamp);
    stroke.add({{{0, 0, 5}, {0, 0, -1}}, 1, 0});
    stroke.finish();
    // Upright as seen: x to the right, y up. A height field's normal is (-dh/dx, -dh/dy, 1).
    const auto height = [&](float x, float y) {
        return 0.05f * 0.4f * weight(Falloff::Smooth, std::hypot(x, y) / 0.4f) * stamp->at(x / 0.4f, y / 0.4f).value;
    };
    for (const surfel::Surfel& each : stroke.surface().tree().surfels().items) {
        const float x = each.position.x, y = each.position.y, e = 1e-3f;
        QVERIFY(std::abs(each.position.z - height(x, y)) < 1e-5f);
        const Vec3f exact = normalized(Vec3f{-(height(x + e, y) - height(x - e, y)) / (2 * e),
                                             -(height(x, y + e) - height(x, y - e)) / (2 * e), 1});
        QVERIFY2(length(each.normal - exact) < 2e-3f, qPrintable(QString("seed %1").arg(test::seed())));
    }
    QVERIFY(stroke.surface().tree().bounds().hi.z > 0.003f);
}

static const test::Registered<BrushFactorsTest> registered;
#include "brush_factors_test.moc"
