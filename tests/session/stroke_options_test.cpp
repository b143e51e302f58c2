// The options of a stroke as parameters of its command: recorded, refused, replayed.
#include "core/base/random.h"
#include "core/session/live_stroke.h"
#include "core/session/stroke_json.h"
#include "support/registry.h"
#include "workbench.h"

#include <png.h>
#include <QTest>

using nlohmann::json;
using sculpt::StrokeSettings;
using test::Workbench;

class StrokeOptionsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyOptionComesBackBitForBit();
    void defaultsAreThePlainBrush();
    void everyMethodReplaysFromItsJournal();
    void whatLiesBetweenIsNotRecordedWhereItHasNoSay();
    void mergedInputReplaysAlike();
    void stampsAreReadBesideTheSession();
    void aStampThatIsNoImageLeavesNoTrace();
    void wrongOptionsAreRefusedByName();
};

static StrokeSettings unusual(base::Random& random) {
    StrokeSettings out;
    out.tool = "draw";
    out.radius = float(random.uniform(0.01, 1));
    out.method = sculpt::methodTable()[random.below(5)].method;
    out.rate = float(random.uniform(1, 500));
    out.stabiliser = float(random.uniform(0, 100));
    out.falloff = sculpt::Falloff::Custom;
    for (auto* curve : {&out.falloffCurve, &out.pressureStrength, &out.pressureRadius}) {
        curve->clear();
        for (int k = 0; k < 5; ++k)
            curve->push_back({float(0.2 * k + random.uniform(0, 0.1)), float(random.uniform())});
    }
    out.symmetry = {true, false, true, int(1 + random.below(64)), int(random.below(3))};
    out.accumulate = false;
    out.autoSmooth = float(random.uniform());
    out.frontFacing = out.connected = out.stampFollows = out.graded = true;
    out.normalRadius = float(random.uniform(0, 2)), out.planeRadius = float(random.uniform(0, 2));
    out.stamp = "/somewhere/ümage.png";
    out.stampAngleRad = float(random.uniform(-6.2, 6.2));
    return out;
}

void StrokeOptionsTest::everyOptionComesBackBitForBit() {
    base::Random random(test::seed());
    for (int round = 0; round < 300; ++round) {
        const StrokeSettings settings = unusual(random);
        std::vector<sculpt::StrokeSample> samples{{{{0, 0, 5}, {0, 0, -1}}, 0.5f, 0}};
        samples.push_back(samples[0]);
        samples[1].stride = float(random.uniform(1, 10));
        const json line = session::complete(json::parse(session::strokeLine(settings, samples, {}).dump()));
        QVERIFY2(session::strokeSettings(line) == settings, qPrintable(QString("seed %1").arg(test::seed())));
        QVERIFY(session::strokeSamples(line, {}) == samples);
        QCOMPARE(line["samples"][0].size(), std::size_t(8)); // the ninth number only where it says something
        QCOMPARE(line["samples"][1].size(), std::size_t(9));
    }
}

void StrokeOptionsTest::defaultsAreThePlainBrush() {
    const json line =
        session::complete({{"op", "stroke"}, {"tool", "draw"}, {"radius", 0.5}, {"samples", json::array()}});
    StrokeSettings plain;
    plain.radius = 0.5f;
    QVERIFY(session::strokeSettings(line) == plain);
}

void StrokeOptionsTest::everyMethodReplaysFromItsJournal() {
    for (const sculpt::MethodRow& row : sculpt::methodTable()) {
        Workbench live, replayed;
        session::Journal journal(live.path("j.jsonl"));
        live.context.journal = &journal;
        live.run(test::newSphere());
        StrokeSettings settings;
        settings.radius = 0.3f;
        settings.method = row.method;
        settings.stabiliser = 0.2f;
        settings.autoSmooth = 0.3f;
        settings.symmetry.copies = 2;
        settings.connected = true;
        session::LiveStroke stroke(live.context, settings);
        for (const auto& sample : session::strokeSamples({{"samples", test::samplesAt(0.1)}}, {}))
            stroke.add(sample);
        QVERIFY2(stroke.finish(), row.id);
        session::replay(journal.path(), replayed.context);
        QVERIFY2(replayed.hash() == live.hash(), row.id);
    }
}

/// Samples of the last line of a journal.
static json recorded(const std::filesystem::path& journal) {
    std::ifstream in(journal);
    std::string line, last;
    while (std::getline(in, line))
        last = line;
    return json::parse(last).at("samples");
}

void StrokeOptionsTest::whatLiesBetweenIsNotRecordedWhereItHasNoSay() {
    for (const sculpt::MethodRow& row : sculpt::methodTable()) {
        Workbench live;
        session::Journal journal(live.path("j.jsonl"));
        live.context.journal = &journal;
        live.run(test::newSphere());
        StrokeSettings settings;
        settings.radius = 0.2f;
        settings.method = row.method;
        session::LiveStroke stroke(live.context, settings);
        for (const auto& sample : session::strokeSamples({{"samples", test::samplesAt(0)}}, {}))
            stroke.add(sample);
        QVERIFY(stroke.finish());
        QCOMPARE(recorded(journal.path()).size(), std::size_t(row.lastOnly ? 2 : 12));
    }
}

void StrokeOptionsTest::mergedInputReplaysAlike() {
    base::Random random(test::seed());
    Workbench live, replayed;
    session::Journal journal(live.path("j.jsonl"));
    live.context.journal = &journal;
    live.run(test::newSphere());
    for (const char* tool : {"draw", "smooth", "grab"}) {
        StrokeSettings settings;
        settings.tool = tool;
        settings.radius = 0.2f;
        session::LiveStroke stroke(live.context, settings);
        for (auto sample : session::strokeSamples({{"samples", test::samplesAt(0.05, 30)}}, {})) {
            sample.stride = random.uniform() < 0.5 ? 1.0f : float(random.uniform(1, 10));
            stroke.add(sample);
        }
        QVERIFY(stroke.finish());
    }
    session::replay(journal.path(), replayed.context);
    QVERIFY2(replayed.hash() == live.hash(), qPrintable(QString("seed %1").arg(test::seed())));
}

static void writeStamp(const std::filesystem::path& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = 2, image.format = PNG_FORMAT_GRAY;
    const png_byte values[] = {255, 255, 0, 0};
    QVERIFY(png_image_write_to_file(&image, path.c_str(), 0, values, 0, nullptr));
}

void StrokeOptionsTest::stampsAreReadBesideTheSession() {
    Workbench plain, stamped, again;
    writeStamp(stamped.path("half.png"));
    json stroke = test::strokeAt(0);
    plain.run(test::newSphere());
    plain.run(stroke);
    stroke["stamp"] = "half.png";
    const auto file = test::write(stamped.path("s.jsonl"), test::newSphere().dump() + "\n" + stroke.dump() + "\n");
    session::replay(file, stamped.context);
    session::replay(file, again.context);
    QVERIFY(stamped.hash() != plain.hash());
    QCOMPARE(again.hash(), stamped.hash());
}

void StrokeOptionsTest::aStampThatIsNoImageLeavesNoTrace() {
    Workbench bench;
    bench.run(test::newSphere());
    const std::string before = bench.hash();
    json stroke = test::strokeAt(0);
    stroke["stamp"] = bench.path("no.png").string();
    QVERIFY(!bench.refusal(stroke).empty());
    QCOMPARE(bench.hash(), before);
    QVERIFY(!bench.document.canUndo());
}

void StrokeOptionsTest::wrongOptionsAreRefusedByName() {
    Workbench bench;
    bench.run(test::newSphere());
    const std::pair<const char*, json> wrong[] = {
        {"method", "spray"},
        {"rate", 0},
        {"stabiliser", -1},
        {"pressure-strength", json::array({1, 2})},
        {"pressure-radius", {{0, 0}, {0, 1}}},
        {"falloff-curve", {{0, 7}, {1, 0}}},
        {"radial", 0},
        {"radial", 2.5},
        {"radial-axis", "w"},
        {"accumulate", "perhaps"},
        {"auto-smooth", 2},
        {"normal-radius", -0.5},
        {"plane-radius", 9},
        {"stamp-angle", 1000},
    };
    for (const auto& [id, value] : wrong) {
        json stroke = test::strokeAt(0);
        stroke[id] = value;
        QVERIFY2(bench.refusal(stroke).find(id) != std::string::npos, id);
    }
    QVERIFY(!bench.document.canUndo());
}

static const test::Registered<StrokeOptionsTest> registered;
#include "stroke_options_test.moc"
