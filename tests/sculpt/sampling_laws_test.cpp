// What resampling owes every stroke, however heavy: even sampling, no holes, masked and untouched surfels as they were.
#include "core/sculpt/contact.h"
#include "core/sculpt/sampling.h"
#include "core/sculpt/tools/gather_in.h"
#include "sculpt/dabs.h"
#include "support/registry.h"

#include <QTest>
#include <span>

using namespace sculpt;
using base::Vec3d;
using base::Vec3f;

class SamplingLawsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aHundredHeavyStrokesStayWellSampled();
    void aHornIsWellSampledToItsTip_data();
    void aHornIsWellSampledToItsTip();
    void pinchingStopsBeforeAFoldCloses();
    void strokesKeepTheGrading_data();
    void strokesKeepTheGrading();
};

constexpr std::size_t count = 12000;

namespace {

/// A stroke of full strength from a random place in a random direction, seen from outside.
std::vector<StrokeSample> randomStroke(base::Random& random, float radius) {
    const Vec3d from = random.unitVector(), along = base::perpendicular(from);
    const double angle = random.uniform(0, 6.28);
    const Vec3d way = (along * std::cos(angle) + cross(from, along) * std::sin(angle)) * double(radius);
    std::vector<StrokeSample> out;
    for (int k = 0; k <= 4; ++k) {
        const Vec3d over = from * 4.0 + way * (0.25 * k);
        out.push_back({{base::cast<float>(over), base::cast<float>(-from)}, 1, 0});
    }
    return out;
}

/// Random places near surfels that are `among`: how many find no surface, and the fewest surfels in support.
struct Holes {
    int outside = 0;
    int least = 1000;
};
template <class Among>
Holes holesOf(const surface::Surface& surface, double spacing, int points, const Among& among) {
    base::Random random(test::seed());
    const auto items = surface.tree().surfels().items;
    Holes out;
    for (int k = 0; k < points;) {
        const surfel::Surfel& near = items[random.below(items.size())];
        if (!among(near))
            continue;
        const Vec3d aside = random.unitVector() * (0.7 * spacing);
        const auto foot = surface::project(surface, near.position + base::cast<float>(aside), {});
        out.outside += foot.status == surface::Status::Outside || foot.status == surface::Status::Degenerate ? 1 : 0;
        out.least = foot.ok() ? std::min(out.least, foot.at.samples) : out.least;
        ++k;
    }
    return out;
}

} // namespace

void SamplingLawsTest::aHundredHeavyStrokesStayWellSampled() {
    const double s = test::sphereSpacing(count);
    surfel::SurfelList points = test::spherePoints(count);
    for (surfel::Surfel& each : points.items)
        each.mask = each.position.z < -0.6f ? 1.0f : 0.0f;
    const surface::Surface start = test::surfaceOf(points);
    surface::Surface now = start;
    base::Random random(test::seed());
    constexpr const char* tools[] = {"draw",  "clay",  "clay-strips", "inflate",    "blob",    "grab",
                                     "nudge", "twist", "smooth",      "snake-hook", "flatten", "layer"};
    const int strokes = test::effort(100);
    for (int k = 0; k < strokes; ++k) {
        StrokeSettings settings;
        settings.tool = tools[random.below(std::size(tools))];
        settings.radius = float(random.uniform(6, 12) * s);
        settings.strength = 1;
        settings.invert = random.uniform() < 0.4;
        now = test::stroked(now, settings, randomStroke(random, settings.radius));
    }
    now.tree().validate();
    // At the rim of a hard mask what moves is torn from what stays: no law holds there but the mask's.
    const auto open = [](const surfel::Surfel& each) { return each.position.z > -0.3f; };
    const process::Summary spacing = test::spacingOfSheets(now, s, open);
    const Holes holes = holesOf(now, s, 2000, [&](const surfel::Surfel& each) {
        return open(each) && now.evaluate(each.position, surface::Need::Value).agreement > 0.6f; // no closing fold
    });
    const QString told = QString("spacing %1 to %2, %3 outside, %4 in support at least, %5 surfels, seed %6")
                             .arg(spacing.min)
                             .arg(spacing.max)
                             .arg(holes.outside)
                             .arg(holes.least)
                             .arg(now.tree().size())
                             .arg(test::seed());
    qInfo("%s", qPrintable(told));
    QVERIFY2(spacing.min >= 0.6f && spacing.max <= 1.6f, qPrintable(told));
    QVERIFY2(holes.outside == 0 && holes.least >= 6, qPrintable(told));
    for (const surfel::Surfel& gone : test::without(start, now))
        QVERIFY(gone.mask == 0);
    QVERIFY2(300 * test::without(start, now).size() > std::size_t(strokes) * count, qPrintable(told));
}

void SamplingLawsTest::aHornIsWellSampledToItsTip_data() {
    QTest::addColumn<QString>("tool");
    QTest::addColumn<float>("reach"); // in radii, at least
    QTest::newRow("snake-hook") << "snake-hook" << 7.0f;
    QTest::newRow("elastic-grab") << "elastic-grab" << 0.5f; // slips before it becomes a thread
}

void SamplingLawsTest::aHornIsWellSampledToItsTip() {
    QFETCH(QString, tool);
    QFETCH(float, reach);
    const double s = test::sphereSpacing(count);
    const double radii[] = {6, 8, 12};
    for (const double spacings : std::span(radii).first(std::size_t(test::effort(3)))) {
        StrokeSettings settings;
        settings.tool = tool.toStdString();
        settings.radius = float(spacings * s);
        settings.strength = 1;
        const float r = settings.radius;
        std::vector<StrokeSample> samples; // from the side of the ball, ten radii outwards, waving
        for (float x = 0.8f; x < 0.8f + 10 * r; x += 0.3f * r)
            samples.push_back({{{x, 0.3f * std::sin(3 * x), 4}, {0, 0, -1}}, 1, 0});
        const surface::Surface horn = test::stroked(test::surfaceOf(test::spherePoints(count)), settings, samples);
        const auto ofHorn = [](const surfel::Surfel& each) { return length(each.position) > 1.03f; };
        const auto items = horn.tree().surfels().items;
        QVERIFY(std::any_of(items.begin(), items.end(), ofHorn));
        const process::Summary even = test::spacingOfSheets(horn, s, ofHorn);
        const Holes holes = holesOf(horn, s, 4000, ofHorn);
        const QString told = QString("radius %1 s: to %2, spacing %3 to %4, %5 outside, %6 in support at least")
                                 .arg(spacings)
                                 .arg(horn.tree().bounds().hi.x)
                                 .arg(even.min)
                                 .arg(even.max)
                                 .arg(holes.outside)
                                 .arg(holes.least);
        qInfo("%s", qPrintable(told));
        QVERIFY2(horn.tree().bounds().hi.x > 0.8f + reach * r, qPrintable(told));
        // Where a thread thins out to a few surfels around, single ones stand farther apart.
        QVERIFY2(even.min >= 0.6f && even.max <= 3 && holes.outside == 0 && holes.least >= 5, qPrintable(told));
    }
}

/// A groove along x, then the same dab of pinch a hundred times to and fro along it. `braked`: the tool; else its
/// formula without the stop.
static surface::Surface pinched(bool braked) {
    constexpr double spacing = 0.02;
    const float radius = 10 * float(spacing);
    surface::Surface now = test::surfaceOf(test::planePoints(90, spacing));
    Sampling sampling;
    sampling.start(now, {});
    const auto apply = [&](const tree::Edit& edit, const Dab& dab) {
        sampling.note(now.tree(), edit, dab);
        now = {now.tree().apply(edit), now.definition()};
        if (sampling.due())
            now = sampling.resampleDue(now);
    };
    const auto dabAt = [&](const char* id, float x, float strength) {
        Dab dab = test::dabOf(tool(id), {}, radius, strength);
        if (const auto at = contact(now, {{x, 0, 5}, {0, 0, -1}}))
            dab.centre = dab.areaCentre = at->position;
        dab.travel = {0.1f * radius, 0, 0};
        return dab;
    };
    for (int k = 0; k < 60; ++k) {
        const Dab dab = dabAt("draw", 0.02f * float(k % 20) - 0.2f, -1);
        apply(tool("draw").apply(now, dab), dab);
    }
    for (int k = 0; k < 100; ++k) {
        const Dab dab = dabAt("pinch", 0.02f * float(k % 20) - 0.2f, 1.2f); // 12 % of the way
        const Brush brush(dab);
        apply(braked ? tool("pinch").apply(now, dab) : deform(now.tree(), brush, GatherIn(brush, dab, {}, -0.12f)),
              dab);
    }
    return sampling.pending() ? sampling.resample(now) : now;
}

/// The smallest |m|/w at the surfels of the groove, all sheets together.
static float agreementIn(const surface::Surface& surface) {
    surface::SurfaceDefinition definition = surface.definition();
    definition.oneSheet = false;
    const surface::Surface mixed(surface.tree(), definition);
    float least = 1;
    for (const surfel::Surfel& each : surface.tree().surfels().items)
        if (std::abs(each.position.x) < 0.4f && std::abs(each.position.y) < 0.3f)
            least = std::min(least, mixed.evaluate(each.position, surface::Need::Value).agreement);
    return least;
}

void SamplingLawsTest::pinchingStopsBeforeAFoldCloses() {
    constexpr double spacing = 0.02;
    const surface::Surface braked = pinched(true), unbraked = pinched(false);
    const auto within = [](const surfel::Surfel& each) {
        return std::abs(each.position.x) < 0.4f && std::abs(each.position.y) < 0.3f;
    };
    const process::Summary even = test::spacingOfSheets(braked, spacing, within);
    const Holes holes = holesOf(braked, spacing, 1000, within);
    const QString told = QString("agreement %1, without the stop %2; spacing %3 to %4, %5 outside, depth %6 and %7")
                             .arg(agreementIn(braked))
                             .arg(agreementIn(unbraked))
                             .arg(even.min)
                             .arg(even.max)
                             .arg(holes.outside)
                             .arg(braked.tree().bounds().lo.z)
                             .arg(unbraked.tree().bounds().lo.z);
    qInfo("%s", qPrintable(told));
    QVERIFY2(agreementIn(braked) > 0.5f, qPrintable(told));
    QVERIFY2(agreementIn(unbraked) < 0.4f, qPrintable(told));
    QVERIFY2(even.min >= 0.6f && even.max <= 1.6f && holes.outside == 0 && holes.least >= 6, qPrintable(told));
}

void SamplingLawsTest::strokesKeepTheGrading_data() {
    QTest::addColumn<bool>("graded");
    QTest::newRow("kept") << false;
    QTest::newRow("graded") << true;
}

void SamplingLawsTest::strokesKeepTheGrading() {
    QFETCH(bool, graded);
    // A ball whose spacing grows from pole to pole.
    const double s = test::sphereSpacing(6000);
    const surfel::SurfelList points = test::spherePoints(6000);
    std::vector<float> targets;
    for (const surfel::Surfel& each : points.items)
        targets.push_back(float(s * (1.2 - 0.5 * double(each.position.y))));
    auto field = std::make_shared<const process::SpacingField>(points, targets);
    process::ResampleOptions options;
    options.field = field;
    options.spacing = field->coarsest();
    surface::Surface start = test::surfaceOf(points);
    for (int round = 0; round < 8; ++round)
        start = {start.tree().apply(
                     process::resample(start, process::selectAll(start.tree()), options, test::surfaceOf(points))),
                 start.definition()};
    start = test::surfaceOf(start.tree().surfels());

    StrokeSettings settings;
    settings.tool = "draw";
    settings.radius = 0.35f;
    settings.strength = 1;
    settings.graded = graded;
    std::vector<StrokeSample> samples;
    for (int pass = 0; pass < 6; ++pass)
        for (int k = 0; k <= 10; ++k)
            samples.push_back({{{0, (pass % 2 ? 0.6f : -0.6f) * (1 - 0.2f * float(k)), 4}, {0, 0, -1}}, 1, 0});
    const auto spreadOf = [&](const surface::Surface& surface) {
        std::vector<float> ratios;
        std::vector<tree::Neighbour> near;
        for (const surfel::Surfel& each : surface.tree().surfels().items)
            if (each.position.z > 0.9f && std::abs(each.position.y) < 0.6f) {
                surface.tree().nearest(each.position, 7, near);
                double sum = 0;
                for (std::size_t k = 1; k < 7; ++k)
                    sum += std::sqrt(double(near[k].distanceSq));
                ratios.push_back(float(0.93 * sum / 6 / (s * (1.2 - 0.5 * double(each.position.y)))));
            }
        return process::summarise(std::move(ratios));
    };
    const surface::Surface after = test::stroked(start, settings, samples);
    const process::Summary kept = spreadOf(after);
    const QString told = QString("of the target %1 to %2").arg(kept.min).arg(kept.max);
    qInfo("%s", qPrintable(told));
    QVERIFY(after.tree().bounds().hi.z > 1.2f);
    QVERIFY2(kept.min > 0.5f && kept.max < 1.6f, qPrintable(told));
}

static const test::Registered<SamplingLawsTest> registered;
#include "sampling_laws_test.moc"
