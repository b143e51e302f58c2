// The ways of making dabs, and what changes them: pressure, stabiliser, stride, accumulate, auto-smooth.
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/sculpt/contact.h"
#include "core/sculpt/stroke/stroke_stabiliser.h"
#include "sculpt/stroke_samples.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;
using base::Vec3f;

class StrokeMethodsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase();
    void aLineIsSpaceBetweenItsEnds();
    void aLineForgetsWhatLiesBetween();
    void aLineBeginsWhereItMeetsTheModel();
    void dotsMakeOneDabASample();
    void airbrushMakesDabsByTimeAlone();
    void airbrushGoesOnWhereThePointerRests();
    void anAnchoredDabReachesThePointer();
    void anAnchoredDabForgetsWhatLiesBetween();
    void noRopeChangesNothing();
    void theRopeBoundsTheLagAndSmoothsTheLine();
    void identityPressureCurvesChangeNothing();
    void pressureScalesTheRadius();
    void aStrideMakesFewerDabsOfTheSameRidge();
    void withoutAccumulationDabsDoNotPileUp();
    void withoutAccumulationResamplingKeepsTheHeight();
    void autoSmoothEvensWhatTheDabsLeave();
    void everyMethodReplaysBitForBitOnAnyThreads();
    void droppedStrokesChangeNothing();

  private:
    surface::Surface m_plane, m_sphere;
};

using test::dabsOf, test::down, test::settingsOf;

static constexpr double s = 0.02;

void StrokeMethodsTest::initTestCase() {
    m_plane = test::surfaceOf(test::planePoints(80, s));
    m_sphere = test::surfaceOf(test::spherePoints(12000));
}

static std::vector<StrokeSample> wander(base::Random& random, int count) {
    std::vector<StrokeSample> out;
    double x = random.uniform(-0.3, 0.3), y = random.uniform(-0.3, 0.3);
    for (int k = 0; k < count; ++k) {
        out.push_back(down(float(x), float(y), 0.03f * float(k), float(random.uniform(0.2, 1))));
        x += random.uniform(-0.08, 0.08), y += random.uniform(-0.08, 0.08);
    }
    return out;
}

static float top(const surface::Surface& surface) {
    return surface.tree().bounds().hi.z;
}

void StrokeMethodsTest::aLineIsSpaceBetweenItsEnds() {
    const std::vector<StrokeSample> ends{down(-0.4f, 0.1f, 0, 0.5f), down(0.4f, -0.1f, 1)};
    for (const surface::Surface* start : {&m_plane, &m_sphere}) {
        const auto line = test::stroked(*start, settingsOf("draw", 0.2f, StrokeMethod::Line), ends);
        const auto space = test::stroked(*start, settingsOf("draw", 0.2f), ends);
        QVERIFY(test::hashOf(line) == test::hashOf(space));
        QVERIFY(test::hashOf(line) != test::hashOf(*start));
    }
}

void StrokeMethodsTest::aLineForgetsWhatLiesBetween() {
    base::Random random(test::seed());
    std::vector<StrokeSample> all = wander(random, 10);
    const StrokeSettings settings = settingsOf("clay", 0.15f, StrokeMethod::Line);
    QVERIFY(test::hashOf(test::stroked(m_plane, settings, all)) ==
            test::hashOf(test::stroked(m_plane, settings, {all.front(), all.back()})));
}

void StrokeMethodsTest::aLineBeginsWhereItMeetsTheModel() {
    const int beside = dabsOf(m_sphere, settingsOf("smooth", 0.2f, StrokeMethod::Line), {down(-2, 0), down(0, 0)});
    const int from = dabsOf(m_sphere, settingsOf("smooth", 0.2f, StrokeMethod::Line), {down(-0.999f, 0), down(0, 0)});
    QVERIFY2(from > 40 && std::abs(beside - from) <= 4, qPrintable(QString("%1 %2").arg(beside).arg(from)));
}

void StrokeMethodsTest::dotsMakeOneDabASample() {
    base::Random random(test::seed());
    std::vector<StrokeSample> samples = wander(random, 9);
    samples.push_back(samples.back());
    samples.push_back(down(7, 0)); // misses
    QCOMPARE(dabsOf(m_plane, settingsOf("draw", 0.2f, StrokeMethod::Dots), samples), 10);
    // One dab is the same whatever made it.
    QVERIFY(test::hashOf(test::stroked(m_plane, settingsOf("draw", 0.2f, StrokeMethod::Dots), {down(0, 0)})) ==
            test::hashOf(test::stroked(m_plane, settingsOf("draw", 0.2f), {down(0, 0)})));
}

void StrokeMethodsTest::airbrushMakesDabsByTimeAlone() {
    // The same way at the same times, told in 2, 11 and 41 samples.
    std::vector<surface::Surface> made;
    for (const int parts : {1, 10, 40}) {
        std::vector<StrokeSample> samples;
        for (int k = 0; k <= parts; ++k)
            samples.push_back(down(-0.4f + 0.8f * float(k) / float(parts), 0, float(k) / float(parts)));
        const StrokeSettings settings = settingsOf("draw", 0.2f, StrokeMethod::Airbrush);
        QCOMPARE(dabsOf(m_plane, settings, samples), 21); // at 0, 0.05, ... 1 s
        made.push_back(test::stroked(m_plane, settings, samples));
    }
    for (const float x : {-0.4f, -0.1f, 0.25f})
        for (std::size_t k = 1; k < made.size(); ++k) {
            const auto a = contact(made[0], down(x, 0.03f).ray), b = contact(made[k], down(x, 0.03f).ray);
            QVERIFY(a && b && a->position.z > 0.005f);
            QVERIFY2(std::abs(a->position.z - b->position.z) < 1e-4f * 0.2f,
                     qPrintable(QString::number(double(a->position.z - b->position.z))));
        }
}

void StrokeMethodsTest::airbrushGoesOnWhereThePointerRests() {
    StrokeSettings settings = settingsOf("draw", 0.2f, StrokeMethod::Airbrush);
    settings.rate = 40;
    QCOMPARE(dabsOf(m_plane, settings, {down(0, 0), down(0, 0, 0.5f)}), 21);
    QCOMPARE(dabsOf(m_plane, settings, {down(0, 0), down(0, 0, 0.01f), down(0, 0, 0.02f)}), 1);
    QCOMPARE(dabsOf(m_plane, settings, {down(0, 0, 3), down(0, 0, 2)}), 1); // time does not run backwards
    settings.stabiliser = 1;
    QCOMPARE(dabsOf(m_plane, settings, {down(0, 0), down(0.1f, 0, 0.5f)}), 21); // nor does a slack rope stop it
}

void StrokeMethodsTest::anAnchoredDabReachesThePointer() {
    StrokeSettings settings = settingsOf("draw", 0.05f, StrokeMethod::Anchored);
    settings.resample = false;
    const surface::Surface after = test::stroked(m_plane, settings, {down(0.1f, 0), down(0.1f, 0.3f)});
    float reach = 0;
    for (const surfel::Surfel& each : test::without(after, m_plane))
        reach = std::max(reach, std::hypot(each.position.x - 0.1f, each.position.y));
    QVERIFY2(reach > 0.27f && reach <= 0.3f, qPrintable(QString::number(double(reach))));
    QVERIFY(std::abs(top(after) - 0.5f * 0.05f * 0.3f) < 1e-4f);
    QCOMPARE(dabsOf(m_plane, settings, {down(0.1f, 0)}), 0);
}

void StrokeMethodsTest::anAnchoredDabForgetsWhatLiesBetween() {
    base::Random random(test::seed());
    for (const char* tool : {"draw", "clay", "smooth"}) {
        std::vector<StrokeSample> all = wander(random, 8);
        const StrokeSettings settings = settingsOf(tool, 0.1f, StrokeMethod::Anchored);
        for (const bool beside : {false, true}) {
            if (beside)
                all.front() = down(3, 0); // off the model
            const auto made = test::hashOf(test::stroked(m_sphere, settings, all));
            QVERIFY(made == test::hashOf(test::stroked(m_sphere, settings, {all.front(), all.back()})));
            QVERIFY(made != test::hashOf(m_sphere));
        }
    }
}

void StrokeMethodsTest::noRopeChangesNothing() {
    base::Random random(test::seed());
    for (int k = 0; k < 200; ++k) {
        Stabiliser none(0);
        const StrokeSample sample = wander(random, 1).front();
        QVERIFY(none.follow(sample, 5.0f).sample == sample && none.follow(sample, {}).moved);
    }
}

void StrokeMethodsTest::theRopeBoundsTheLagAndSmoothsTheLine() {
    base::Random random(test::seed());
    const float rope = 0.1f, depth = 5;
    Stabiliser stabiliser(rope);
    float roughIn = 0, roughOut = 0, lag = 0;
    Vec3f before;
    for (int k = 0; k <= 400; ++k) {
        const float x = float(k) / 200, tremble = float(random.uniform(-0.03, 0.03));
        const StrokeSample pointer = down(x, tremble, float(k) / 100, 0.7f);
        const Stabiliser::Step step = stabiliser.follow(pointer, depth);
        const Vec3f brush = step.sample.ray.at(depth);
        lag = std::max(lag, distance(brush, pointer.ray.at(depth)));
        QCOMPARE(step.sample.pressure, 0.7f);
        QCOMPARE(step.sample.seconds, pointer.seconds);
        if (k > 50)
            roughIn = std::max(roughIn, std::abs(tremble)), roughOut = std::max(roughOut, std::abs(brush.y));
        if (k > 0 && !step.moved)
            QVERIFY(brush == before);
        before = brush;
    }
    QVERIFY(lag <= rope * 1.001f);
    QVERIFY2(roughOut < 0.4f * roughIn, qPrintable(QString("%1 of %2").arg(roughOut).arg(roughIn)));
    // In a stroke: the brush stays a rope behind, in radii.
    StrokeSettings settings = settingsOf("smooth", 0.1f);
    settings.stabiliser = 2;
    const int free = dabsOf(m_plane, settingsOf("smooth", 0.1f), {down(-0.4f, 0), down(0.4f, 0)}),
              held = dabsOf(m_plane, settings, {down(-0.4f, 0), down(0.4f, 0)});
    QVERIFY2(std::abs(free - held - 20) <= 2, qPrintable(QString("%1 %2").arg(free).arg(held)));
}

void StrokeMethodsTest::identityPressureCurvesChangeNothing() {
    base::Random random(test::seed());
    const std::vector<StrokeSample> samples = wander(random, 8);
    StrokeSettings settings = settingsOf("draw", 0.15f);
    const auto plain = test::hashOf(test::stroked(m_plane, settings, samples));
    settings.pressureStrength = {{0, 0}, {1, 1}};
    settings.pressureRadius = {{0, 1}, {0.5f, 1}, {1, 1}};
    QVERIFY(test::hashOf(test::stroked(m_plane, settings, samples)) == plain);
    // Strength apart from pressure is full pressure.
    settings.pressureStrength = {{0, 1}, {1, 1}};
    std::vector<StrokeSample> full = samples;
    for (StrokeSample& sample : full)
        sample.pressure = 1;
    QVERIFY(test::hashOf(test::stroked(m_plane, settings, samples)) ==
            test::hashOf(test::stroked(m_plane, settingsOf("draw", 0.15f), full)));
}

void StrokeMethodsTest::pressureScalesTheRadius() {
    StrokeSettings settings = settingsOf("draw", 0.4f);
    settings.pressureRadius = {{0, 0.25f}, {1, 1}};
    settings.pressureStrength = {{0, 1}, {1, 1}};
    settings.resample = false;
    for (const float pressure : {0.0f, 0.5f, 1.0f}) {
        const float radius = 0.4f * (0.25f + 0.75f * pressure);
        float reach = 0;
        const surface::Surface after = test::stroked(m_plane, settings, {down(0, 0, 0, pressure)});
        for (const surfel::Surfel& each : test::without(after, m_plane))
            reach = std::max(reach, std::hypot(each.position.x, each.position.y));
        QVERIFY(reach <= radius && reach > radius - 1.5f * float(s));
        QVERIFY(std::abs(top(after) - 0.025f * radius) < 0.05f * 0.025f * radius);
    }
}

void StrokeMethodsTest::aStrideMakesFewerDabsOfTheSameRidge() {
    StrokeSettings settings = settingsOf("draw", 0.2f);
    settings.strength = 0.2f;
    std::vector<StrokeSample> ends{down(-0.5f, 0), down(0.5f, 0)};
    const float height = top(test::stroked(m_plane, settings, ends));
    const int many = dabsOf(m_plane, settings, ends);
    ends[1].stride = 4;
    const int few = dabsOf(m_plane, settings, ends);
    QVERIFY2(std::abs(4 * (few - 1) - (many - 1)) <= 4, qPrintable(QString("%1 %2").arg(many).arg(few)));
    const float merged = top(test::stroked(m_plane, settings, ends));
    QVERIFY2(std::abs(merged / height - 1) < 0.15f, qPrintable(QString::number(double(merged / height))));
    settings.method = StrokeMethod::Airbrush;
    ends[1].seconds = 2;
    QCOMPARE(dabsOf(m_plane, settings, ends), 11);
}

void StrokeMethodsTest::withoutAccumulationDabsDoNotPileUp() {
    base::Random random(test::seed());
    for (const StrokeMethod method : {StrokeMethod::Space, StrokeMethod::Dots, StrokeMethod::Airbrush}) {
        StrokeSettings settings = settingsOf("draw", 0.2f, method);
        settings.strength = 1;
        settings.resample = false;
        std::vector<StrokeSample> samples;
        for (int pass = 0; pass < 3; ++pass)
            for (const StrokeSample& each : wander(random, 8)) {
                samples.push_back(each);
                samples.back().pressure = 1;
                samples.back().seconds = 0.03f * float(samples.size());
            }
        const float one = top(test::stroked(m_plane, settings, {samples.front()}));
        QVERIFY(top(test::stroked(m_plane, settings, samples)) > 1.8f * one);
        settings.accumulate = false;
        const surface::Surface after = test::stroked(m_plane, settings, samples);
        QVERIFY2(top(after) <= 0.05f * 0.2f * 1.0001f && top(after) > 0.95f * one,
                 qPrintable(QString("%1, seed %2").arg(double(top(after) / one)).arg(test::seed())));
        QVERIFY(after.tree().bounds().lo.z > -1e-6f);
        for (const surfel::Surfel& each : after.tree().surfels().items)
            QVERIFY(std::abs(length(each.normal) - 1) < 1e-5f && each.normal.z > 0.5f);
    }
}

void StrokeMethodsTest::withoutAccumulationResamplingKeepsTheHeight() {
    StrokeSettings settings = settingsOf("draw", 0.2f);
    settings.accumulate = false;
    settings.strength = 1;
    const surface::Surface after =
        test::stroked(m_plane, settings, {down(-0.4f, 0), down(0.4f, 0), down(-0.4f, 0.05f)});
    QVERIFY(top(after) <= 0.01f + 0.06f * float(s) && top(after) > 0.009f);
    const auto hit = contact(after, down(0, 0).ray);
    QVERIFY(hit && std::abs(hit->position.z - 0.01f) < 0.06f * float(s));
    // A stroke may go on after it was finished.
    Stroke stroke(m_plane, settings);
    stroke.add(down(0, 0));
    stroke.finish();
    stroke.add(down(0.1f, 0));
    stroke.finish();
    stroke.surface().tree().validate();
}

void StrokeMethodsTest::autoSmoothEvensWhatTheDabsLeave() {
    // Relief of two spacings' wavelength under a stroke of draw.
    base::Random random(test::seed());
    surfel::SurfelList rough = test::planePoints(80, s);
    for (surfel::Surfel& each : rough.items)
        each.position.z += float(random.uniform(-0.1, 0.1) * s);
    const surface::Surface start = test::surfaceOf(rough);
    const auto roughness = [](const surface::Surface& surface) {
        double sum = 0;
        int count = 0;
        for (const surfel::Surfel& each : surface.tree().surfels().items)
            if (std::abs(each.position.x) < 0.3f && std::abs(each.position.y) < 0.03f) {
                const auto e = surface.evaluate(each.position, surface::Need::Gradient);
                sum += double(e.value) * double(e.value), ++count;
            }
        return std::sqrt(sum / count);
    };
    StrokeSettings settings = settingsOf("draw", 0.15f);
    settings.strength = 0.1f;
    settings.resample = false;
    const std::vector<StrokeSample> way{down(-0.4f, 0), down(0.4f, 0)};
    const double without = roughness(test::stroked(start, settings, way));
    settings.autoSmooth = 0.5f;
    const double with = roughness(test::stroked(start, settings, way));
    QVERIFY2(with < 0.3 * without, qPrintable(QString("%1 %2").arg(with).arg(without)));
    settings.strength = 0;
    QVERIFY(test::hashOf(test::stroked(start, settings, way)) == test::hashOf(start)); // a no-op stays one
}

void StrokeMethodsTest::everyMethodReplaysBitForBitOnAnyThreads() {
    base::Random random(test::seed());
    for (const MethodRow& row : methodTable()) {
        StrokeSettings settings = settingsOf("draw", 0.15f, row.value);
        settings.stabiliser = 0.3f;
        settings.accumulate = random.uniform() < 0.5;
        settings.autoSmooth = 0.2f;
        settings.frontFacing = settings.connected = true;
        settings.falloff = Falloff::Custom;
        settings.falloffCurve = {{0, 1}, {0.4f, 0.7f}, {1, 0}};
        settings.pressureRadius = {{0, 0.5f}, {1, 1}};
        settings.symmetry.copies = 3;
        const std::vector<StrokeSample> samples = wander(random, 8);
        const auto run = [&] { return test::hashOf(test::stroked(m_sphere, settings, samples)); };
        const auto once = run();
        QVERIFY2(once != test::hashOf(m_sphere), row.id);
        QVERIFY2(run() == once, row.id);
        base::setThreadCount(1);
        const auto alone = run();
        base::setThreadCount(0);
        QVERIFY2(alone == once, qPrintable(QString("%1, seed %2").arg(row.id).arg(test::seed())));
    }
}

void StrokeMethodsTest::droppedStrokesChangeNothing() {
    const auto before = test::hashOf(m_sphere);
    for (const MethodRow& row : methodTable()) {
        StrokeSettings settings = settingsOf("draw", 0.3f, row.value);
        settings.accumulate = false;
        Stroke stroke(m_sphere, settings);
        stroke.add(down(0, 0));
        QVERIFY2(stroke.add(down(0.3f, 0, 0.4f)), row.id);
    }
    QVERIFY(test::hashOf(m_sphere) == before);
}

static const test::Registered<StrokeMethodsTest> registered;
#include "stroke_methods_test.moc"
