// What the tools that mask, colour, delete and copy do.
#include "core/sculpt/stroke/stroke.h"
#include "sculpt/dabs.h"
#include "sculpt/random_ball.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;
using test::applied;
using test::dabOf;

class ChannelToolsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void maskAddsItsWeightAndSwitchesTheLayout();
    void paintMixesByItsWeightAndSwitchesTheLayout();
    void faintPaintAddsUp();
    void smearCarriesColoursWithTheStroke();
    void eraseTakesWhatIsUnderTheBrush();
    void eraseLeavesTheLastSurfels();
    void eraseDoesNotDigOnThroughItsHole();
    void aHoleStaysOpenUnderLaterStrokes();
    void cloneCopiesAKnownBump();
    void clonedReliefComesOnce();
    void whatMovesNothingIsNotSmoothed();
};

constexpr double s = 0.02;

void ChannelToolsTest::maskAddsItsWeightAndSwitchesTheLayout() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(60, s));
    const Dab dab = dabOf(tool("mask"), {}, 0.3f, 0.6f);
    const surface::Surface once = applied(tool("mask"), plane, dab);
    QVERIFY(!plane.tree().layout()->masks && once.tree().layout()->masks && once.tree().layout()->oriented);
    for (const surfel::Surfel& each : once.tree().surfels().items)
        QVERIFY(std::abs(each.mask - 0.3f * weight(Falloff::Smooth, length(each.position) / 0.3f)) < 1e-6f);
    surface::Surface now = once;
    for (int k = 0; k < 20; ++k)
        now = applied(tool("mask"), now, dab);
    QCOMPARE(test::without(now, once).empty(), false);
    for (const surfel::Surfel& each : now.tree().surfels().items)
        QVERIFY(each.mask <= 1 && (length(each.position) > 0.15f || each.mask == 1));
    Dab back = dab;
    back.strength = -1;
    for (int k = 0; k < 400; ++k)
        now = applied(tool("mask"), now, back);
    for (const surfel::Surfel& each : now.tree().surfels().items)
        QVERIFY(each.mask == 0 || length(each.position) > 0.28f);
}

void ChannelToolsTest::paintMixesByItsWeightAndSwitchesTheLayout() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(60, s));
    Dab dab = dabOf(tool("paint"), {}, 0.3f, 0.8f);
    dab.parameters["colour"] = 0x2040c0, dab.parameters["colour2"] = 0x000000;
    for (const bool second : {false, true}) {
        dab.strength = second ? -0.8f : 0.8f;
        const surface::Surface after = applied(tool("paint"), plane, dab);
        QVERIFY(!plane.tree().layout()->colours && after.tree().layout()->colours);
        const double target[3] = {second ? 0.0 : 0x20, second ? 0.0 : 0x40, second ? 0.0 : 0xc0};
        double bias = 0;
        for (const surfel::Surfel& each : after.tree().surfels().items)
            for (unsigned c = 0; c < 3; ++c) {
                const double w = 0.8 * double(weight(Falloff::Smooth, length(each.position) / 0.3f));
                const double off = double(each.colour >> (8 * c) & 255u) - (255 + (target[c] - 255) * w);
                QVERIFY(std::abs(off) < 1.001);
                bias += off / double(after.tree().size());
            }
        QVERIFY2(std::abs(bias) < 0.1, qPrintable(QString::number(bias)));
    }
}

void ChannelToolsTest::faintPaintAddsUp() {
    surface::Surface now = test::surfaceOf(test::planePoints(40, s));
    Dab dab = dabOf(tool("paint"), {}, 0.3f, 0.001f); // a quarter of a byte each
    dab.parameters["colour"] = 0;
    for (int k = 0; k < 400; ++k) {
        dab.centre.x = 1e-6f * float(k); // the threshold is the place's, not the dab's
        now = applied(tool("paint"), now, dab);
    }
    double mean = 0, n = 0;
    for (const surfel::Surfel& each : now.tree().surfels().items)
        if (length(each.position) < 0.03f)
            mean += double(each.colour & 255u), ++n;
    QVERIFY2(mean / n < 235, qPrintable(QString::number(mean / n)));
}

void ChannelToolsTest::smearCarriesColoursWithTheStroke() {
    surfel::SurfelList points = test::planePoints(60, s);
    auto layout = std::make_shared<surfel::AttributeLayout>(*points.layout);
    layout->colours = true;
    points.layout = layout;
    for (surfel::Surfel& each : points.items)
        each.colour = each.position.x < 0 ? surfel::rgba(0, 0, 0) : surfel::rgba(255, 255, 255);
    const surface::Surface start = test::surfaceOf(points);
    const auto darkness = [](const surface::Surface& surface) {
        double sum = 0;
        for (const surfel::Surfel& each : surface.tree().surfels().items)
            sum += each.position.x > 0 ? 255 - double(each.colour & 255u) : 0.0;
        return sum;
    };
    for (const float strength : {1.0f, -1.0f}) {
        surface::Surface now = start;
        for (int k = 0; k < 10; ++k) {
            Dab dab = dabOf(tool("smear"), {-0.1f + 0.03f * float(k), 0, 0}, 0.2f, strength);
            dab.travel = {0.03f, 0, 0};
            now = applied(tool("smear"), now, dab);
        }
        const QByteArray told = QByteArray::number(darkness(now) / 255);
        if (strength > 0)
            QVERIFY2(darkness(now) > 255 * 30, told);
        else
            QVERIFY2(darkness(now) < 255 * 12, told); // the blur of the averages alone
    }
    const surface::Surface plain = test::surfaceOf(test::planePoints(60, s));
    Dab dab = dabOf(tool("smear"), {}, 0.2f, 1);
    dab.travel = {0.03f, 0, 0};
    QVERIFY(tool("smear").apply(plain, dab).empty());
}

void ChannelToolsTest::eraseTakesWhatIsUnderTheBrush() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(60, s));
    for (const float strength : {1.0f, 0.5f}) {
        const surface::Surface after = applied(tool("erase"), plane, dabOf(tool("erase"), {}, 0.3f, strength));
        after.tree().validate();
        for (const surfel::Surfel& each : test::without(plane, after))
            QVERIFY(length(each.position) < (strength == 1 ? 0.3f : 0.15f));
        for (const surfel::Surfel& each : after.tree().surfels().items)
            QVERIFY(length(each.position) >= (strength == 1 ? 0.3f : 0.15f) - 1e-6f);
        QVERIFY(test::without(after, plane).empty());
    }
}

void ChannelToolsTest::eraseLeavesTheLastSurfels() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(8, s));
    QVERIFY(tool("erase").apply(plane, dabOf(tool("erase"), {}, 5, 1)).empty());
}

void ChannelToolsTest::eraseDoesNotDigOnThroughItsHole() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(8000));
    StrokeSettings settings;
    settings.tool = "erase", settings.radius = 0.2f, settings.strength = 1;
    std::vector<StrokeSample> round;
    for (int k = 0; k <= 60; ++k) // to and fro over the same place
        round.push_back({{{0.2f * std::sin(0.3f * float(k)), 0, 5}, {0, 0, -1}}, 1, 0});
    const surface::Surface after = test::stroked(sphere, settings, round);
    QVERIFY(after.tree().size() < sphere.tree().size());
    for (const surfel::Surfel& each : test::without(sphere, after))
        QVERIFY(each.position.z > 0);
}

void ChannelToolsTest::aHoleStaysOpenUnderLaterStrokes() {
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.25f;
    const surface::Surface plane(tree::SurfelTree::build(test::planePoints(60, s)), definition);
    StrokeSettings settings;
    settings.tool = "erase", settings.radius = 0.12f, settings.strength = 1;
    const surface::Surface holed = test::stroked(plane, settings, {{{{0, 0, 5}, {0, 0, -1}}, 1, 0}});
    settings.tool = "draw", settings.radius = 0.2f, settings.strength = 0.5f;
    std::vector<StrokeSample> round;
    for (int k = 0; k <= 40; ++k)
        round.push_back(
            {{{0.18f * std::cos(0.16f * float(k)), 0.18f * std::sin(0.16f * float(k)), 5}, {0, 0, -1}}, 1, 0});
    const surface::Surface after = test::stroked(holed, settings, round);
    QVERIFY(test::hashOf(after) != test::hashOf(holed));
    for (const surfel::Surfel& each : after.tree().surfels().items)
        QVERIFY(std::hypot(each.position.x, each.position.y) > 0.12f - 0.5f * float(s));
}

/// A plane with a round bump at (-0.5, 0): 0.05 high, 0.2 in radius.
static surfel::SurfelList bumpyPlane() {
    surfel::SurfelList out = test::planePoints(120, s);
    for (surfel::Surfel& each : out.items) {
        const double x = double(each.position.x) + 0.5, y = double(each.position.y), r = std::hypot(x, y) / 0.2;
        if (r >= 1)
            continue;
        const double t = 1 - r * r;
        each.position.z = float(0.05 * t * t);
        each.normal = base::cast<float>(normalized(base::Vec3d{0.05 * 4 * t * x / 0.04, 0.05 * 4 * t * y / 0.04, 1}));
    }
    return out;
}

void ChannelToolsTest::cloneCopiesAKnownBump() {
    const surface::Surface start = test::surfaceOf(bumpyPlane());
    for (const float strength : {1.0f, -1.0f}) {
        Dab dab = dabOf(tool("clone"), {0.5f, 0, 0}, 0.35f, strength);
        dab.parameters["x"] = -1.0;
        dab.falloff = Falloff::Constant; // the whole copy, at once
        const surface::Surface after = applied(tool("clone"), start, dab);
        int copied = 0;
        for (const surfel::Surfel& each : after.tree().surfels().items) {
            const double x = double(each.position.x) - 0.5, y = double(each.position.y), r = std::hypot(x, y) / 0.2;
            if (r >= 1.5)
                continue;
            const double t = std::max(0.0, 1 - r * r), sign = double(strength);
            const base::Vec3d n = normalized(base::Vec3d{sign * 5 * t * x, sign * 5 * t * y, 1});
            // What the surface of the bump's surfels is: within a few hundredths of the spacing.
            QVERIFY2(std::abs(double(each.position.z) - sign * 0.05 * t * t) < 0.06 * s,
                     qPrintable(QString::number(double(each.position.z) - sign * 0.05 * t * t)));
            QVERIFY2(length(n - base::cast<double>(each.normal)) < 0.04,
                     qPrintable(QString("%1 at %2").arg(length(n - base::cast<double>(each.normal))).arg(r)));
            ++copied;
        }
        QVERIFY(copied > 500);
    }
}

void ChannelToolsTest::clonedReliefComesOnce() {
    const surface::Surface start = test::surfaceOf(bumpyPlane());
    surface::Surface now = start;
    Dab dab = dabOf(tool("clone"), {0.5f, 0, 0}, 0.35f, 1);
    dab.parameters["x"] = -1.0;
    dab.first = &start;
    for (int k = 0; k < 12; ++k)
        now = applied(tool("clone"), now, dab);
    QVERIFY2(now.tree().bounds().hi.z < 0.0505f, qPrintable(QString::number(double(now.tree().bounds().hi.z))));
    std::vector<tree::Neighbour> top;
    now.tree().nearest({0.5f, 0, 0.05f}, 1, top);
    QVERIFY(std::sqrt(top[0].distanceSq) < float(s));
}

/// Auto-smooth has a say with tools that move surfaces alone.
void ChannelToolsTest::whatMovesNothingIsNotSmoothed() {
    base::Random random(test::seed());
    const surface::Surface ball = test::randomBall(random, 3000, 0.05, 0.01);
    for (const ToolRow& row : toolTable()) {
        StrokeSettings settings;
        settings.tool = row.id;
        settings.radius = 0.4f;
        settings.autoSmooth = 1;
        const std::vector<StrokeSample> path{{{{4, 0, 0}, {-1, 0, 0}}, 1, 0}, {{{4, 0.3f, 0}, {-1, 0, 0}}, 1, 1}};
        const auto with = test::stroked(ball, settings, path).tree().contentHash();
        settings.autoSmooth = 0;
        const auto without = test::stroked(ball, settings, path).tree().contentHash();
        QVERIFY2(with == without || movesSurfaces(row), row.id);
    }
}

static const test::Registered<ChannelToolsTest> registered;
#include "channel_tools_test.moc"
