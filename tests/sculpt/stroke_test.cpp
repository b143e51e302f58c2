#include "core/sculpt/stroke/stroke.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/sculpt/contact.h"
#include "sculpt/stroke_samples.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using namespace sculpt;
using test::dabsOf, test::settingsOf;

class StrokeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void dabsAreSpacedAlongTheSurface();
    void dabsAreSpacedOnSteepSlopesToo();
    void manySamplesMakeTheSameNumberOfDabsAsFew();
    void aPointerThatRestsMakesOneDab();
    void raysThatMissMakeNoDab();
    void aHoleInAnOpenModelMakesNoDab();
    void aJumpInDepthMakesNoPileOfDabs();
    void noStrokeLaysMoreDabsThanItsPathHasSteps();
    void aCancelledStrokeEndsBeforeItsNextDab();
    void aRidgeHasTheHeightThatDrawPromises();
    void invertGoesTheOtherWay();
    void pressureScalesTheStrength();
    void mirroredStrokesMirrorAtTheFilesPlanes();
    void onTheMirrorPlaneTheStrengthIsShared();
    void aFarOriginMovesNoDab();
    void aDragPutsItsPlateauUnderThePointer();
    void aDragOutAndBackLeavesTheSphere();
    void contactsLieOnTheSphere();
    void settingsOutOfRangeAreRefusedInClearSentences();
    void brokenSamplesAreRefused();
    void longStrokesLeaveNoHoles();
    void stretchedMatterIsFilled();
};

static constexpr double s = 0.02;

static StrokeSample down(float x, float y, float pressure = 1) {
    return {{{x, y, 5}, {0, 0, -1}}, pressure, 0};
}

void StrokeTest::dabsAreSpacedAlongTheSurface() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, s));
    StrokeSettings settings = settingsOf("smooth", 0.2f); // leaves a plane as it is
    for (const float spacing : {0.05f, 0.1f, 0.33f}) {
        settings.spacing = spacing;
        const int dabs = dabsOf(plane, settings, {down(-0.5f, 0), down(0.5f, 0.1f)});
        const float expected = std::hypot(1.0f, 0.1f) / (spacing * settings.radius) + 1;
        QVERIFY2(std::abs(float(dabs) - expected) <= 1 + 0.02f * expected, qPrintable(QString::number(dabs)));
    }
}

void StrokeTest::dabsAreSpacedOnSteepSlopesToo() {
    // From the pole to 80 degrees the arc is 1.396 long, its shadow 0.985.
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(20000));
    StrokeSettings settings = settingsOf("smooth", 0.3f);
    const int dabs = dabsOf(sphere, settings, {down(0, 0), down(std::sin(1.396f), 0)});
    QVERIFY2(std::abs(dabs - (1 + 1.396 / 0.03)) < 3, qPrintable(QString::number(dabs)));
}

void StrokeTest::manySamplesMakeTheSameNumberOfDabsAsFew() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, s));
    std::vector<StrokeSample> many;
    for (int k = 0; k <= 1000; ++k)
        many.push_back(down(-0.5f + 0.001f * float(k), 0));
    const StrokeSettings settings = settingsOf("smooth", 0.2f);
    const int few = dabsOf(plane, settings, {down(-0.5f, 0), down(0.5f, 0)});
    QVERIFY(std::abs(dabsOf(plane, settings, many) - few) <= 2);
}

void StrokeTest::aPointerThatRestsMakesOneDab() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, s));
    QCOMPARE(dabsOf(plane, settingsOf("draw", 0.2f), std::vector<StrokeSample>(20, down(0, 0))), 1);
}

void StrokeTest::raysThatMissMakeNoDab() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(5000));
    Stroke stroke(sphere, settingsOf("draw", 0.2f));
    QVERIFY(!stroke.add(down(2, 0)));
    QVERIFY(!stroke.add(down(2, 1)));
    stroke.finish();
    QCOMPARE(stroke.dabs(), 0);
    QVERIFY(stroke.surface().tree() == sphere.tree());
}

void StrokeTest::aHoleInAnOpenModelMakesNoDab() {
    surfel::SurfelList points = test::planePoints(80, s);
    std::erase_if(points.items, [](const surfel::Surfel& each) { return length(each.position) < 0.25f; });
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.25f;
    const surface::Surface open(tree::SurfelTree::build(points), definition);
    QCOMPARE(dabsOf(open, settingsOf("draw", 0.1f), {down(0, 0), down(0.1f, 0), down(-0.1f, 0.05f)}), 0);
    // Across the hole: dabs on both sides of it, none within.
    const int across = dabsOf(open, settingsOf("smooth", 0.1f), {down(-0.6f, 0), down(0.6f, 0)});
    QVERIFY2(across >= 68 && across <= 76, qPrintable(QString::number(across)));
}

void StrokeTest::aJumpInDepthMakesNoPileOfDabs() {
    // Two plates, the upper one over x < 0; the pointer crosses its edge.
    surfel::SurfelList points = test::planePoints(80, s), upper = points;
    for (const surfel::Surfel& each : upper.items)
        if (each.position.x < 0) {
            surfel::Surfel raised = each;
            raised.position.z = 3;
            points.append(raised, {});
        }
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.25f;
    const surface::Surface plates(tree::SurfelTree::build(points), definition);
    const int dabs = dabsOf(plates, settingsOf("smooth", 0.2f), {down(-0.3f, 0), down(0.3f, 0)});
    QVERIFY2(std::abs(dabs - 31) <= 3, qPrintable(QString::number(dabs)));
}

/// The way of the contacts on `surface`, in steps; seen from above.
static float stepsAlong(const surface::Surface& surface, const StrokeSettings& settings, float from, float to) {
    float way = 0;
    std::optional<Contact> last;
    for (int k = 0; k <= 400; ++k) {
        const auto here = contact(surface, down(from + (to - from) * float(k) / 400, 0).ray);
        if (here && last)
            way += distance(here->position, last->position);
        if (here)
            last = here;
    }
    return way / (settings.spacing * settings.radius);
}

/// Dabs that move the surface along the ray by more than a step do not call for the next one at once.
void StrokeTest::noStrokeLaysMoreDabsThanItsPathHasSteps() {
    surfel::SurfelList relief = test::planePoints(100, s);
    base::Random random(test::seed());
    for (surfel::Surfel& each : relief.items)
        each.position.z = each.position.x < 0.05f ? 0.3f * std::sin(9 * each.position.x) * std::sin(7 * each.position.y)
                                                  : 0.01f * float(random.uniform());
    const surface::Surface start = test::surfaceOf(relief);
    for (const ToolRow& row : toolTable().first(toolTable().size() / (test::sanitized ? 5 : 1))) {
        StrokeSettings settings = settingsOf(row.id, 0.3f);
        settings.spacing = 0.01f;
        settings.strength = 1;
        for (const ToolParameter& parameter : row.parameters)
            if (std::string_view(parameter.id) == "x") // clone: what stands beside
                settings.parameters["x"] = -0.6;
        Stroke stroke(start, settings);
        stroke.add(down(0.1f, 0));
        stroke.add(down(0.7f, 0));
        stroke.finish();
        const float steps =
            std::max(stepsAlong(start, settings, 0.1f, 0.7f), stepsAlong(stroke.surface(), settings, 0.1f, 0.7f));
        if (!holds(row))
            QVERIFY2(float(stroke.dabs()) <= 2 + 2 * steps, qPrintable(QString("%1: %2 dabs, %3 steps, seed %4")
                                                                           .arg(row.id)
                                                                           .arg(stroke.dabs())
                                                                           .arg(double(steps))
                                                                           .arg(test::seed())));
    }
}

void StrokeTest::aCancelledStrokeEndsBeforeItsNextDab() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, s));
    for (const ToolRow& row : toolTable())
        for (const MethodRow& method : methodTable()) {
            std::atomic<bool> cancel = false;
            Stroke stroke(plane, settingsOf(row.id, 0.2f, method.value), {}, {}, &cancel);
            stroke.add(down(-0.3f, 0));
            const int dabs = stroke.dabs();
            cancel = true;
            StrokeSample far = down(0.5f, 0.1f);
            far.seconds = 1;
            bool ended = false;
            try {
                stroke.add(far);
            } catch (const base::Cancelled&) {
                ended = true;
            }
            QVERIFY2(ended || row.motion == Motion::Turn, row.id); // nothing turned
            QVERIFY(stroke.dabs() <= dabs);
            QVERIFY_EXCEPTION_THROWN(stroke.finish(), base::Cancelled);
        }
}

void StrokeTest::aRidgeHasTheHeightThatDrawPromises() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(100, s));
    StrokeSettings settings = settingsOf("draw", 0.2f);
    settings.strength = 0.5f;
    const float top = test::stroked(plane, settings, {down(-0.5f, 0), down(0.5f, 0)}).tree().bounds().hi.z;
    QVERIFY2(top > 0.2f * settings.radius && top < 0.3f * settings.radius, qPrintable(QString::number(double(top))));
    // Denser dabs share the strength.
    settings.spacing = 0.03f;
    const float dense = test::stroked(plane, settings, {down(-0.5f, 0), down(0.5f, 0)}).tree().bounds().hi.z;
    QVERIFY2(std::abs(dense - top) < 0.1f * top, qPrintable(QString::number(double(dense / top))));
}

void StrokeTest::invertGoesTheOtherWay() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, s));
    for (const char* tool : {"draw", "clay"}) {
        StrokeSettings settings = settingsOf(tool, 0.2f);
        settings.invert = true;
        const base::Box3f box = test::stroked(plane, settings, {down(0, 0), down(0.1f, 0)}).tree().bounds();
        QVERIFY(box.lo.z < -0.004f && box.hi.z < 1e-6f);
    }
}

void StrokeTest::pressureScalesTheStrength() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, s));
    const StrokeSettings settings = settingsOf("draw", 0.2f);
    const float full = test::stroked(plane, settings, {down(0, 0, 1)}).tree().bounds().hi.z;
    const float third = test::stroked(plane, settings, {down(0, 0, 1.0f / 3)}).tree().bounds().hi.z;
    QVERIFY(full > 0 && std::abs(third * 3 - full) < 1e-6f);
}

void StrokeTest::mirroredStrokesMirrorAtTheFilesPlanes() {
    // Stored coordinates are the file's minus the origin, so that the file's x = 0 lies at -origin.
    const base::Vec3d origin{0.25, 0, 0};
    const surface::Surface plane = test::surfaceOf(test::planePoints(90, s));
    StrokeSettings settings = settingsOf("draw", 0.1f);
    settings.symmetry.planes.x = true;
    const surface::Surface after = test::stroked(plane, settings, {down(0.1f, 0.05f)}, origin);
    std::vector<float> peaks;
    for (const surfel::Surfel& each : after.tree().surfels().items)
        if (each.position.z > 0) {
            const base::Vec3f here{each.position.x, each.position.y, 0};
            const float one = distance(here, {0.1f, 0.05f, 0}), two = distance(here, {-0.6f, 0.05f, 0});
            QVERIFY(std::min(one, two) <= 0.1f + 1e-6f);
            peaks.push_back(one < two ? 1.0f : 2.0f);
        }
    QVERIFY(std::count(peaks.begin(), peaks.end(), 1.0f) > 20);
    QVERIFY(std::count(peaks.begin(), peaks.end(), 2.0f) > 20);
}

void StrokeTest::onTheMirrorPlaneTheStrengthIsShared() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, s));
    StrokeSettings settings = settingsOf("draw", 0.2f);
    const float single = test::stroked(plane, settings, {down(0, 0.1f)}).tree().bounds().hi.z;
    settings.symmetry.planes.x = true;
    const float mirrored = test::stroked(plane, settings, {down(0, 0.1f)}).tree().bounds().hi.z;
    QVERIFY(std::abs(mirrored - single) < 1e-3f * single);
}

/// The dab's own ray is not taken to the mirror planes and back, which would round it.
void StrokeTest::aFarOriginMovesNoDab() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(60, s));
    for (const char* tool : {"draw", "grab"})
        for (const StrokeMethod method : {StrokeMethod::Space, StrokeMethod::Dots, StrokeMethod::Line}) {
            const StrokeSettings settings = settingsOf(tool, 0.15f, method);
            Stroke here(plane, settings), there(plane, settings, {4.1e6, -5.3e6, 371.7});
            for (const StrokeSample& sample : {down(-0.2f, 0), down(0.1f, 0.05f), down(0.2f, 0.2f)})
                here.add(sample), there.add(sample);
            here.finish(), there.finish();
            QVERIFY2(here.dabs() > 1 || method == StrokeMethod::Line, tool);
            QVERIFY2(here.surface().tree().contentHash().text() == there.surface().tree().contentHash().text(), tool);
        }
}

void StrokeTest::aDragPutsItsPlateauUnderThePointer() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, s));
    StrokeSettings settings = settingsOf("grab", 0.3f);
    settings.strength = 1;
    // Seen from the side the plane is an edge; seen at an angle the pointer moves up and along.
    const base::Vec3f view = normalized(base::Vec3f{0, 1, -1});
    const auto ray = [&](const base::Vec3f& p) { return StrokeSample{{p - view * 5, view}, 1, 0}; };
    const base::Vec3f to{0.1f, 0.1f, 0.1f}; // in the plane through the origin that faces the viewer: to.view = 0
    const surface::Surface after = test::stroked(plane, settings, {ray({0, 0, 0}), ray(to * 0.3f), ray(to)});
    std::vector<tree::Neighbour> found;
    after.tree().nearest(to, 1, found);
    QVERIFY2(std::sqrt(found[0].distanceSq) < 0.6f * float(s),
             qPrintable(QString::number(double(std::sqrt(found[0].distanceSq)) / s)));
    const auto hit = contact(after, {{to.x, to.y, 5}, {0, 0, -1}});
    QVERIFY(hit && std::abs(hit->position.z - to.z) < 0.05f * float(s));
}

void StrokeTest::aDragOutAndBackLeavesTheSphere() {
    constexpr std::size_t count = 8000;
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(count));
    StrokeSettings settings = settingsOf("grab", 0.4f);
    settings.strength = 1;
    std::vector<StrokeSample> samples{{{{5, 0, 0.96f}, {-1, 0, 0}}, 1, 0}};
    for (const float height : {0.1f, 0.2f, 0.3f, 0.2f, 0.1f, 0.0f})
        samples.push_back({{{5, 0, 0.96f + height}, {-1, 0, 0}}, 1, 0});
    const surface::Surface after = test::stroked(sphere, settings, samples);
    QVERIFY(test::hashOf(after) != test::hashOf(sphere));
    for (const surfel::Surfel& each : after.tree().surfels().items)
        QVERIFY2(std::abs(length(each.position) - 1) < 0.06f * float(test::sphereSpacing(count)),
                 qPrintable(QString::number(double(length(each.position)))));
}

void StrokeTest::contactsLieOnTheSphere() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(20000));
    base::Random random(test::seed());
    for (int k = 0; k < 200; ++k) {
        const base::Vec3d d = random.unitVector(), target = random.unitVector() * 0.7;
        const base::Vec3f from = base::cast<float>(target - d * 4.0);
        const auto hit = contact(sphere, {from, base::cast<float>(d)});
        QVERIFY(hit.has_value());
        QVERIFY(std::abs(length(hit->position) - 1) < 1e-5f);
        QVERIFY(dot(hit->normal, base::cast<float>(d)) < 0);
        QVERIFY(length(hit->normal - hit->position) < 2e-3f);
        const Area area = areaAround(sphere, *hit, 0.1f);
        QVERIFY(length(area.normal - hit->position) < 1.5e-2f);
        QVERIFY(distance(area.centre, hit->position) < 1.5e-2f); // half a spacing: few surfels make the means
    }
}

void StrokeTest::settingsOutOfRangeAreRefusedInClearSentences() {
    const auto refused = [](auto change, const char* named) {
        StrokeSettings settings = settingsOf("clay", 0.2f);
        change(settings);
        try {
            check(settings);
        } catch (const base::Error& e) {
            const bool names = e.message().find(named) != std::string::npos;
            if (!names)
                qWarning("%s", e.what());
            return names;
        }
        return false;
    };
    check(settingsOf("clay", 0.2f));
    const float nan = std::nanf("");
    QVERIFY(refused([](StrokeSettings& x) { x.tool = "shovel"; }, "shovel"));
    QVERIFY(refused([](StrokeSettings& x) { x.radius = 0; }, "radius"));
    QVERIFY(refused([](StrokeSettings& x) { x.radius = -1; }, "radius"));
    QVERIFY(refused([&](StrokeSettings& x) { x.radius = nan; }, "radius"));
    QVERIFY(refused([](StrokeSettings& x) { x.strength = 1.5f; }, "strength"));
    QVERIFY(refused([](StrokeSettings& x) { x.strength = -0.1f; }, "strength"));
    QVERIFY(refused([&](StrokeSettings& x) { x.strength = nan; }, "strength"));
    QVERIFY(refused([](StrokeSettings& x) { x.spacing = 0; }, "spacing"));
    QVERIFY(refused([](StrokeSettings& x) { x.parameters["colour"] = 1; }, "colour"));
    QVERIFY(refused([](StrokeSettings& x) { x.parameters["offset"] = 7; }, "offset"));
    const surface::Surface plane = test::surfaceOf(test::planePoints(20, s));
    QVERIFY_THROWS_EXCEPTION(base::Error, Stroke(plane, settingsOf("draw", 0)));
}

void StrokeTest::brokenSamplesAreRefused() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(20, s));
    Stroke stroke(plane, settingsOf("draw", 0.1f));
    const float nan = std::nanf("");
    QVERIFY_THROWS_EXCEPTION(base::Error, stroke.add({{{0, 0, 5}, {0, 0, 0}}, 1, 0}));
    QVERIFY_THROWS_EXCEPTION(base::Error, stroke.add({{{0, nan, 5}, {0, 0, -1}}, 1, 0}));
    QVERIFY_THROWS_EXCEPTION(base::Error, stroke.add({{{0, 0, 5}, {0, nan, -1}}, 1, 0}));
    QVERIFY_THROWS_EXCEPTION(base::Error, stroke.add({{{0, 0, 5}, {0, 0, -1}}, nan, 0}));
    QVERIFY(stroke.add({{{0, 0, 5}, {0, 0, -20}}, 1, 0})); // any length will do
}

/// Random places near surfels all find a surface with at least 6 surfels in support.
static void verifyNoHoles(const surface::Surface& surface, double spacing) {
    base::Random random(test::seed());
    const auto items = surface.tree().surfels().items;
    for (int k = 0; k < 3000; ++k) {
        const surfel::Surfel& near = items[random.below(items.size())];
        const base::Vec3d aside = random.unitVector() * (spacing * random.uniform());
        const auto foot = surface::project(surface, near.position + base::cast<float>(aside), {});
        QVERIFY2(foot.ok() && foot.at.samples >= 6, surface::statusName(foot.status));
    }
}

void StrokeTest::longStrokesLeaveNoHoles() {
    constexpr std::size_t count = test::effort(20) == 20 ? 12000 : 6000;
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(count));
    for (const char* tool : {"draw", "clay"}) {
        StrokeSettings settings = settingsOf(tool, 0.3f);
        settings.strength = 1;
        std::vector<StrokeSample> samples;
        for (int pass = 0; pass < 6; ++pass)
            for (int k = 0; k <= 10; ++k)
                samples.push_back(down((pass % 2 ? 0.5f : -0.5f) * (1 - 0.2f * float(k)), 0));
        const surface::Surface after = test::stroked(sphere, settings, samples);
        QVERIFY(after.tree().bounds().hi.z > 1.3f);
        verifyNoHoles(after, test::sphereSpacing(count));
        const process::Summary spacing = test::spacingOfSheets(after, test::sphereSpacing(count));
        QVERIFY2(spacing.min >= 0.6f && spacing.max <= 1.6f,
                 qPrintable(QString("%1: %2 to %3").arg(tool).arg(spacing.min).arg(spacing.max)));
    }
}

void StrokeTest::stretchedMatterIsFilled() {
    constexpr std::size_t count = 12000;
    const double spacing = test::sphereSpacing(count);
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(count));
    StrokeSettings settings = settingsOf("grab", float(10 * spacing));
    settings.strength = 1;
    const std::vector<StrokeSample> samples{{{{5, 0, 0.95f}, {-1, 0, 0}}, 1, 0},
                                            {{{5, 0, 0.95f + 5 * settings.radius}, {-1, 0, 0}}, 1, 0}};
    const surface::Surface after = test::stroked(sphere, settings, samples);
    QVERIFY(after.tree().bounds().hi.z > 0.95f + 5 * settings.radius);
    verifyNoHoles(after, spacing);
    const process::Summary range = test::spacingOver(after, spacing);
    QVERIFY2(range.min >= 0.6f && range.max <= 1.6f, qPrintable(QString("%1 to %2").arg(range.min).arg(range.max)));
    // And without resampling the same pull tears.
    settings.resample = false;
    QVERIFY(test::spacingOver(test::stroked(sphere, settings, samples), spacing).max > 2.5f);
}

static const test::Registered<StrokeTest> registered;
#include "stroke_test.moc"
