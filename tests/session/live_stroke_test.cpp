#include "core/session/live_stroke.h"

#include "core/base/random.h"
#include "core/session/model_argument.h"
#include "core/session/stroke_json.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "workbench.h"

#include <QTest>
#include <set>

using base::Vec3d;
using nlohmann::json;
using sculpt::StrokeSample;
using sculpt::StrokeSettings;
using test::Workbench;

class LiveStrokeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void linesComeBackBitForBit();
    void samplesSurviveLargeOrigins();
    void aLiveStrokeIsWhatItsLineReplays();
    void aDroppedStrokeLeavesNoTrace();
    void cancelEndsAStrokeInsideASample();
    void modelArgumentsNameFilesAndSamples();
};

static StrokeSample randomSample(base::Random& random, double scale) {
    const auto real = [&](double size) { return static_cast<float>(random.uniform(-size, size)); };
    StrokeSample out;
    out.ray.origin = {real(scale), real(scale), real(scale * 1e-3)};
    out.ray.direction = base::cast<float>(random.unitVector());
    out.pressure = static_cast<float>(random.uniform());
    out.seconds = static_cast<float>(random.uniform(0, 100));
    out.reach = random.uniform() < 0.5 ? 0 : static_cast<float>(random.uniform(0, scale));
    return out;
}

void LiveStrokeTest::linesComeBackBitForBit() {
    base::Random random(test::seed());
    for (const sculpt::ToolRow& tool : sculpt::toolTable()) {
        StrokeSettings settings;
        settings.tool = tool.id;
        settings.radius = static_cast<float>(random.uniform(0.01, 1));
        settings.strength = static_cast<float>(random.uniform());
        settings.invert = true;
        settings.falloff = sculpt::Falloff::Sharp;
        settings.symmetry.planes = {true, false, true};
        settings.resample = false;
        settings.spacing = static_cast<float>(random.uniform(0.05, 1));
        for (const sculpt::ToolParameter& p : tool.parameters)
            settings.parameters[p.id] = random.uniform(p.min, p.max);
        std::vector<StrokeSample> samples;
        for (int k = 0; k < 50; ++k)
            samples.push_back(randomSample(random, 5));
        const json line = session::complete(json::parse(session::strokeLine(settings, samples, {}).dump()));
        QVERIFY(session::strokeSettings(line) == settings);
        QVERIFY(session::strokeSamples(line, {}) == samples);
    }
}

void LiveStrokeTest::samplesSurviveLargeOrigins() {
    base::Random random(test::seed());
    for (int k = 0; k < 20000; ++k) {
        const double size = std::pow(10, random.uniform(0, 9));
        const Vec3d origin = random.unitVector() * size;
        const StrokeSample sample = randomSample(random, std::pow(10, random.uniform(-3, 4)));
        const StrokeSample put = session::recordable(sample, origin);
        const json line = json::parse(session::strokeLine({}, std::span(&put, 1), origin).dump());
        QVERIFY2(session::strokeSamples(line, origin).at(0) == put,
                 qPrintable(QString("round %1, seed %2").arg(k).arg(test::seed())));
        QVERIFY(base::distance(put.ray.origin, sample.ray.origin) < 1e-15 * size + 1e-6);
    }
}

void LiveStrokeTest::aLiveStrokeIsWhatItsLineReplays() {
    const std::set<std::string_view> few{"draw", "grab", "smooth", "erase", "clone", "paint"}; // of every kind one
    for (const sculpt::ToolRow& tool : sculpt::toolTable()) {
        if (tool.needs.layer || (test::sanitized && !few.contains(tool.id)))
            continue;
        Workbench live, replayed;
        session::Journal journal(live.path("j.jsonl"));
        live.context.journal = &journal;
        test::makeWorkpiece(live);
        StrokeSettings settings;
        settings.tool = tool.id;
        settings.radius = 0.3f;
        settings.symmetry.planes.x = true;
        if (settings.tool == "clone") // from itself it would copy what is there
            settings.parameters["x"] = 0.3;
        session::LiveStroke stroke(live.context, settings);
        const json rows{{"samples", test::samplesAt(0.1)}};
        bool dabbed = false;
        for (const StrokeSample& sample : session::strokeSamples(rows, {}))
            dabbed |= stroke.add(sample);
        QVERIFY2(stroke.finish() && dabbed, tool.id);
        QCOMPARE(live.document.undoLabel(), std::string(tool.label));
        QVERIFY(live.context.dabSeconds.size() == static_cast<std::size_t>(stroke.dabs()));
        session::replay(journal.path(), replayed.context);
        QCOMPARE(replayed.hash(), live.hash());
    }
}

static StrokeSettings drawing(float radius) {
    StrokeSettings out;
    out.tool = "draw";
    out.radius = radius;
    return out;
}

void LiveStrokeTest::aDroppedStrokeLeavesNoTrace() {
    Workbench bench;
    bench.run(test::newSphere());
    const std::string before = bench.hash();
    {
        session::LiveStroke stroke(bench.context, drawing(0.3f));
        QVERIFY(stroke.add({{{0, 0, 5}, {0, 0, -1}}, 1, 0}));
        QVERIFY(!(stroke.surface().tree() == bench.document.surface().tree()));
    }
    QCOMPARE(bench.hash(), before);
    QVERIFY(!bench.document.canUndo());
    QVERIFY_EXCEPTION_THROWN(session::LiveStroke(bench.context, drawing(0)), base::Error);
}

/// All of its dabs lie on the way to one sample, where the command itself has no look at the wish to stop.
void LiveStrokeTest::cancelEndsAStrokeInsideASample() {
    test::Workbench bench;
    bench.run(test::newSphere());
    const std::string before = bench.hash();
    std::atomic<bool> cancel = false;
    bench.context.progress = {[&](double done, std::string_view) { cancel = done > 0; }, &cancel};
    nlohmann::json stroke = test::strokeAt(0);
    stroke["samples"] = {{-0.4, 0, 5, 0, 0, -1, 1, 0}, {0.4, 0, 5, 0, 0, -1, 1, 1}};
    QVERIFY_EXCEPTION_THROWN(bench.run(stroke), base::Cancelled);
    QCOMPARE(bench.hash(), before);
}

void LiveStrokeTest::modelArgumentsNameFilesAndSamples() {
    QCOMPARE(session::modelCommand("a/b.ply"), (json{{"op", "open"}, {"path", "a/b.ply"}}));
    QCOMPARE(session::modelCommand("sample:torus"), (json{{"op", "new"}, {"sample", "torus"}}));
    QCOMPARE(session::modelCommand("sample:torus:500"), (json{{"op", "new"}, {"sample", "torus"}, {"count", 500}}));
    QCOMPARE(session::modelCommand("sample:scan:500:7"),
             (json{{"op", "new"}, {"sample", "scan"}, {"count", 500}, {"seed", 7}}));
    for (const char* wrong : {"sample:torus:many", "sample:torus:5:x", "sample:torus:5:1:2", "sample:torus:-3"})
        QVERIFY_EXCEPTION_THROWN(session::modelCommand(wrong), base::Error);
}

static const test::Registered<LiveStrokeTest> registered;
#include "live_stroke_test.moc"
