// The options of a stroke as parameters of its command: recorded, refused, replayed.
#include "core/session/live_stroke.h"
#include "core/session/option_json.h"
#include "core/session/stroke_json.h"
#include "sculpt/random_options.h"
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
    void everyRowSurvivesLineAndText();
    void everyRowRefusesWhatIsBeyondItsEnds();
    void everyRowIsAParameterWithTheFieldsDefault();
    void defaultsAreThePlainBrush();
    void everyMethodReplaysFromItsJournal();
    void whatLiesBetweenIsNotRecordedWhereItHasNoSay();
    void mergedInputReplaysAlike();
    void stampsAreReadBesideTheSession();
    void aStampThatIsNoImageLeavesNoTrace();
    void wrongOptionsAreRefusedByName();
};

constexpr auto everyScope = {sculpt::Scope::Tool, sculpt::Scope::AllTools, sculpt::Scope::Stroke};

static QByteArray seeded(const char* what) {
    return QByteArray(what) + ", seed " + QByteArray::number(qulonglong(test::seed()));
}

/// The line as it is read again from a file and checked.
static json readAgain(const StrokeSettings& settings, std::span<const sculpt::StrokeSample> samples) {
    return session::complete(json::parse(session::strokeLine(settings, samples, {}).dump()));
}

void StrokeOptionsTest::everyOptionComesBackBitForBit() {
    base::Random random(test::seed());
    for (int round = 0; round < 300; ++round) {
        StrokeSettings settings;
        test::drawAll(everyScope, random, test::Part::Within, settings);
        std::vector<sculpt::StrokeSample> samples{{{{0, 0, 5}, {0, 0, -1}}, 0.5f, 0}};
        samples.push_back(samples[0]);
        samples[1].stride = float(random.uniform(1, 10));
        const json line = readAgain(settings, samples);
        QVERIFY2(session::strokeSettings(line) == settings, seeded("all"));
        QVERIFY(session::strokeSamples(line, {}) == samples);
        QCOMPARE(line["samples"][0].size(), std::size_t(8)); // the ninth number only where it says something
        QCOMPARE(line["samples"][1].size(), std::size_t(9));
    }
}

/// Each alone, so that one that is forgotten is named.
void StrokeOptionsTest::everyRowSurvivesLineAndText() {
    base::Random random(test::seed());
    for (const sculpt::StrokeOption& option : sculpt::strokeOptionTable())
        for (const test::Part part : {test::Part::Low, test::Part::High, test::Part::Within}) {
            StrokeSettings settings;
            settings.radius = 0.5f;
            test::draw(option, random, part, settings);
            sculpt::check(settings);
            const json line = readAgain(settings, {});
            QVERIFY2(session::strokeSettings(line) == settings, seeded(option.id));
            QVERIFY2(session::strokeLine(settings, {}, {}).contains(option.id) || settings.stamp.empty(), option.id);
            StrokeSettings read;
            read.radius = 0.5f;
            const std::string text = session::textOf(option, settings);
            if (!text.empty())
                session::setText(option, text, read);
            QVERIFY2(read == settings, seeded(option.id));
        }
}

void StrokeOptionsTest::everyRowRefusesWhatIsBeyondItsEnds() {
    for (const sculpt::StrokeOption& option : sculpt::strokeOptionTable())
        for (const double value : test::outside(option)) {
            json line{{"op", "stroke"}, {"tool", "draw"}, {"radius", 1}, {"samples", json::array()}};
            const bool whole = std::holds_alternative<int sculpt::Symmetry::*>(option.field);
            line[option.id] = whole ? json(int(value)) : json(value);
            QVERIFY_EXCEPTION_THROWN(session::complete(line), base::Error);
            StrokeSettings settings;
            settings.radius = 1;
            session::setValue(option, line[option.id], settings);
            QVERIFY_EXCEPTION_THROWN(sculpt::check(settings), base::Error);
            QVERIFY_EXCEPTION_THROWN(session::setText(option, line[option.id].dump(), settings), base::Error);
        }
}

void StrokeOptionsTest::everyRowIsAParameterWithTheFieldsDefault() {
    for (const sculpt::StrokeOption& option : sculpt::strokeOptionTable()) {
        const auto parameters = session::command("stroke").parameters;
        const auto found = std::find_if(parameters.begin(), parameters.end(),
                                        [&](const auto& p) { return p.id == std::string_view(option.id); });
        QVERIFY2(found != parameters.end() && *found->tip, option.id);
        if (std::string_view(found->fallback).size() && found->fallback != std::string_view("null")) {
            StrokeSettings settings, plain;
            session::setValue(option, json::parse(found->fallback), settings);
            QVERIFY2(settings == plain, option.id);
        }
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
        settings.method = row.value;
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
        settings.method = row.value;
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
