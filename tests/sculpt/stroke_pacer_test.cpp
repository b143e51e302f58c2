#include "core/sculpt/stroke/stroke_pacer.h"

#include "support/registry.h"

#include <QTest>

using namespace sculpt;

class StrokePacerTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aFastEngineGetsWhatTheHandDid();
    void aSlowEngineGetsFewerDabsAndTheSameWay();
    void longWaysComeInSlices();
    void whatLiesBetweenHasNoSayWhereOnlyTheLastCounts();
    void dotsAreThinned();
};

static StrokeSettings settingsOf(const char* tool, float radius) {
    StrokeSettings out;
    out.tool = tool;
    out.radius = radius;
    return out;
}

/// Rays from above along x.
static std::vector<StrokeSample> way(int count, float step) {
    std::vector<StrokeSample> out;
    for (int k = 0; k < count; ++k)
        out.push_back({{{float(k) * step, 0, 5}, {0, 0, -1}}, 1, float(k) * 0.01f, 1});
    return out;
}

void StrokePacerTest::aFastEngineGetsWhatTheHandDid() {
    StrokePacer pacer(settingsOf("draw", 1));
    const auto samples = way(50, 0.1f);
    QVERIFY(pacer.paced({samples.data(), 1}, {}) == std::vector(samples.begin(), samples.begin() + 1));
    pacer.took(1e-4, 1);
    QVERIFY(pacer.paced({samples.data() + 1, 49}, 5.0f) == std::vector(samples.begin() + 1, samples.end()));
}

void StrokePacerTest::aSlowEngineGetsFewerDabsAndTheSameWay() {
    for (const double seconds : {0.02, 0.05, 5.0}) {
        StrokePacer pacer(settingsOf("draw", 1));
        const auto samples = way(50, 0.1f); // a dab each
        pacer.paced({samples.data(), 1}, {});
        pacer.took(seconds, 1);
        const auto given = pacer.paced({samples.data() + 1, 49}, 5.0f);
        const double expected = std::min(49 * seconds / StrokePacer::pieceSeconds, double(StrokeSample::maxStride));
        for (const StrokeSample& sample : given)
            QVERIFY(std::abs(double(sample.stride) - expected) < 1e-3 * expected);
        QVERIFY(given.back().ray.origin == samples.back().ray.origin);
        for (std::size_t i = 1; i < given.size(); ++i)
            QVERIFY(given[i].seconds >= given[i - 1].seconds);
        for (const StrokeSample& sample : samples) // none of the way's corners is cut
            QVERIFY(&sample == &samples.front() || std::any_of(given.begin(), given.end(), [&](const StrokeSample& g) {
                return g.ray.origin == sample.ray.origin;
            }));
    }
}

void StrokePacerTest::longWaysComeInSlices() {
    StrokePacer pacer(settingsOf("draw", 1));
    const auto samples = way(2, 4.0f); // forty dabs
    pacer.paced({samples.data(), 1}, {});
    pacer.took(0.01, 1);
    const auto given = pacer.paced({samples.data() + 1, 1}, 5.0f);
    QVERIFY2(given.size() >= 3, qPrintable(QString::number(given.size())));
    for (std::size_t i = 0; i < given.size(); ++i) {
        const float from = i == 0 ? 0 : given[i - 1].ray.origin.x, step = given[i].ray.origin.x - from;
        const double slice = double(step) / 0.1 * 0.01 / double(given[i].stride);
        QVERIFY(slice > 0 && slice < StrokePacer::sliceSeconds * 1.001);
    }
    QVERIFY(given.back().ray.origin == samples.back().ray.origin);
}

void StrokePacerTest::whatLiesBetweenHasNoSayWhereOnlyTheLastCounts() {
    auto settings = settingsOf("draw", 1);
    settings.method = StrokeMethod::Anchored;
    StrokePacer pacer(settings);
    const auto samples = way(50, 0.1f);
    pacer.paced({samples.data(), 1}, {});
    QVERIFY(pacer.paced({samples.data() + 1, 49}, 5.0f) == std::vector{samples.back()});
    // Held pieces go all the way.
    StrokePacer grab(settingsOf("grab", 1));
    grab.paced({samples.data(), 1}, {});
    QCOMPARE(grab.paced({samples.data() + 1, 49}, 5.0f).size(), std::size_t(49));
}

void StrokePacerTest::dotsAreThinned() {
    auto settings = settingsOf("draw", 1);
    settings.method = StrokeMethod::Dots;
    StrokePacer pacer(settings);
    const auto samples = way(41, 0.1f);
    pacer.paced({samples.data(), 1}, {});
    pacer.took(0.01, 1);
    const auto given = pacer.paced({samples.data() + 1, 40}, 5.0f);
    QCOMPARE(given.size(), std::size_t(10)); // 0.4 s in 0.1
    QCOMPARE(given.front().stride, 4.0f);
    QVERIFY(given.back().ray.origin == samples.back().ray.origin);
}

static const test::Registered<StrokePacerTest> registered;
#include "stroke_pacer_test.moc"
