// touch: what a hand feels it may change, and what it changed comes back without a hand.
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "workbench.h"

#include <atomic>
#include <QTest>
#include <set>

using base::Vec3d;
using nlohmann::json;
using test::Workbench;

class TouchCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void replaysWithoutAHandToTheSameBits_data();
    void replaysWithoutAHandToTheSameBits();
    void feelingChangesNothing();
    void pressingHarderWorksMore();
    void pullingAwayPulls();
    void aHoldEndsWhereTheHandRestsOrTears();
    void viscosityHoldsTheHandBack();
    void stopsInTheMiddleWithoutATrace();
    void wrongWaysAreRefused_data();
    void wrongWaysAreRefused();
};

/// Over the front of the unit sphere; heights from its middle.
class Way {
  public:
    explicit Way(double x = 0, double y = 0) { to(x, y, 1.1, 0); }
    Way& to(double x, double y, double height, double seconds) {
        const int parts = m_samples.empty() ? 1 : 16; // along the sphere, not through it
        const Vec3d from = m_samples.empty() ? Vec3d{x, y, height} : m_at, goal{x, y, height};
        for (int k = 1; k <= parts; ++k) {
            const Vec3d at = from + (goal - from) * (static_cast<double>(k) / parts);
            const Vec3d place = base::normalized(Vec3d{at.x, at.y, 1}) * at.z;
            m_samples.push_back({m_time + seconds * k / parts, place.x, place.y, place.z});
        }
        m_time += seconds;
        m_at = goal;
        return *this;
    }
    json touch(const std::string& tool, double radius = 0.25) const {
        json out{{"op", "touch"}, {"tool", tool}, {"radius", radius}, {"samples", m_samples}};
        if (tool == "clone")
            out["x"] = 0.3;
        return out;
    }

  private:
    double m_time = 0;
    Vec3d m_at; ///< slopes and height
    json m_samples = json::array();
};

/// Down, along, up, and all of it again elsewhere.
static Way twoStrokes(base::Random& random) {
    const double x = random.uniform(-0.3, 0), y = random.uniform(-0.3, 0.3);
    Way way(x, y);
    for (const double side : {0.0, 0.3})
        way.to(x, y + side, 0.9, 0.2)
            .to(x + random.uniform(0.2, 0.4), y + side, 0.88, 0.25)
            .to(x, y + side, random.uniform(1.15, 1.3), 0.3)
            .to(x, y + side, 1.15, 0.3);
    return way;
}

static double farthest(const session::Document& document) {
    double out = 0;
    document.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int i = 0; i < block.size(); ++i)
            out = std::max(out, base::length(base::cast<double>(block.position(i))));
    });
    return out;
}

static double deepest(const session::Document& document) {
    double out = 2;
    document.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int i = 0; i < block.size(); ++i)
            out = std::min(out, base::length(base::cast<double>(block.position(i))));
    });
    return out;
}

void TouchCommandTest::replaysWithoutAHandToTheSameBits_data() {
    QTest::addColumn<QString>("tool");
    QTest::addColumn<bool>("mirrored");
    const std::set<std::string_view> few{"draw", "smooth", "erase", "clone", "paint"}; // of every kind one
    for (const sculpt::ToolRow& tool : sculpt::toolTable())
        if (!tool.needs.layer && (!test::sanitized || few.contains(tool.id)))
            QTest::newRow(tool.id) << tool.id << false;
    for (const char* tool : {"clay", "grab", "twist"})
        if (!test::sanitized || tool != std::string_view("grab"))
            QTest::addRow("%s, mirrored", tool) << tool << true;
}

void TouchCommandTest::replaysWithoutAHandToTheSameBits() {
    QFETCH(QString, tool);
    QFETCH(bool, mirrored);
    base::Random random(test::seed());
    json touch = twoStrokes(random).touch(tool.toStdString());
    touch["invert"] = random.uniform() < 0.5;
    touch["tip"] = random.uniform() < 0.5 ? 0.0 : 0.03;
    touch["friction"] = 0.2;
    if (mirrored)
        touch["symmetry"] = {"x"};
    std::string first;
    for (const int threads : {1, 2}) {
        base::setThreadCount(threads);
        Workbench bench, again;
        session::Journal journal(bench.path("j.jsonl"));
        bench.context.journal = &journal;
        bench.run(test::newSphere());
        bench.run(touch);
        const double strokes = bench.context.figures.at("strokes");
        QVERIFY(tool == "erase" || strokes <= 2);         // who digs through presses anew
        for (const char* each : {"draw", "clay", "grab"}) // others may find nothing to do on an even ball
            QVERIFY(tool != each || strokes >= 1);
        again.context.progress = {};
        session::replay(bench.path("j.jsonl"), again.context);
        QVERIFY2(bench.hash() == again.hash(), qPrintable(QString("seed %1").arg(test::seed())));
        QVERIFY(test::contentOf(bench.path("j.jsonl")).find("\"touch\"") == std::string::npos);
        while (bench.document.canUndo()) { // a stroke is a step in both
            bench.run({{"op", "undo"}});
            QVERIFY(again.document.canUndo());
            again.run({{"op", "undo"}});
            QCOMPARE(bench.hash(), again.hash());
        }
        QVERIFY(!again.document.canUndo());
        first = first.empty() ? test::contentOf(bench.path("j.jsonl")) : first;
        QCOMPARE(test::contentOf(bench.path("j.jsonl")), first);
    }
    base::setThreadCount(0);
}

void TouchCommandTest::feelingChangesNothing() {
    Workbench bench;
    bench.run(test::newSphere());
    const std::string before = bench.hash();
    json light = Way().to(0, 0, 0.995, 0.3).to(0.4, 0.2, 0.995, 0.5).to(0.4, 0.2, 1.2, 0.2).touch("draw");
    light["threshold"] = 1.5;
    bench.run(light);
    QCOMPARE(bench.hash(), before);
    QVERIFY(bench.context.figures.at("most_force") > 0.01); // it was felt
    QVERIFY(bench.context.messages.back().find("never pressed") != std::string::npos);
    light["threshold"] = 0.1;
    bench.run(light);
    QVERIFY(bench.hash() != before);
}

void TouchCommandTest::pressingHarderWorksMore() {
    double before = 1;
    for (const double depth : {0.04, 0.08, 0.2}) {
        Workbench bench;
        bench.run(test::newSphere());
        json touch =
            Way(-0.3).to(-0.3, 0, 1 - depth, 0.2).to(0.3, 0, 1 - depth, 0.6).to(0.3, 0, 1.2, 0.2).touch("draw");
        touch["invert"] = true;
        bench.run(touch);
        const double reached = deepest(bench.document);
        QVERIFY2(reached < before - 0.003, std::to_string(reached).c_str());
        before = reached;
    }
}

void TouchCommandTest::pullingAwayPulls() {
    for (const char* tool : {"grab", "snake-hook", "elastic-grab"}) {
        Workbench bench;
        bench.run(test::newSphere());
        json touch = Way().to(0, 0, 0.93, 0.3).to(0, 0, 1.5, 0.8).to(0, 0, 1.5, 0.5).touch(tool, 0.4);
        touch["strength"] = 1;
        bench.run(touch);
        QCOMPARE(bench.context.figures.at("strokes"), 1.0);
        // the clay goes with the tool, which was so much in it when it took hold
        const double reached = farthest(bench.document);
        QVERIFY2(std::abs(reached - 1.5) < (tool == std::string("elastic-grab") ? 0.3 : 0.1), tool);
    }
}

void TouchCommandTest::aHoldEndsWhereTheHandRestsOrTears() {
    const Way away = Way().to(0, 0, 0.93, 0.3).to(0, 0, 1.3, 0.6).to(0, 0, 1.3, 0.6).to(0, 0, 2, 0.5);
    Workbench rests;
    rests.run(test::newSphere());
    rests.run(away.touch("grab", 0.4));
    QVERIFY2(std::abs(farthest(rests.document) - 1.3) < 0.1, std::to_string(farthest(rests.document)).c_str());

    Workbench tears;
    tears.run(test::newSphere());
    json touch = away.touch("grab", 0.4);
    touch["viscosity"] = 15;
    touch["tear"] = 0.8; // newtons: a pull of 5 cm/s
    tears.run(touch);
    QVERIFY(farthest(tears.document) < 1.2);
}

void TouchCommandTest::viscosityHoldsTheHandBack() {
    double before = 2;
    for (const double viscosity : {0.0, 10.0, 20.0}) {
        Workbench bench;
        bench.run(test::newSphere());
        json touch = Way().to(0, 0, 0.93, 0.3).to(0, 0, 1.6, 0.3).touch("grab", 0.4); // ends while it moves
        touch["viscosity"] = viscosity;
        touch["tear"] = 1000;
        bench.run(touch);
        const double reached = farthest(bench.document);
        QVERIFY2(reached < before - 0.01, std::to_string(reached).c_str());
        before = reached;
    }
    QVERIFY(before > 1.05);
}

void TouchCommandTest::stopsInTheMiddleWithoutATrace() {
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(test::newSphere());
    const std::string before = bench.hash(), recorded = test::contentOf(bench.path("j.jsonl"));
    base::Random random(test::seed());
    const json touch = twoStrokes(random).touch("clay");
    std::atomic<bool> cancel = false;
    bench.context.progress.cancel = &cancel;
    bench.context.progress.report = [&](double share, std::string_view) { cancel = share > 0.6; };
    QVERIFY_THROWS_EXCEPTION(base::Cancelled, bench.run(touch));
    QCOMPARE(bench.hash(), before);
    QVERIFY(!bench.document.canUndo());
    QCOMPARE(test::contentOf(bench.path("j.jsonl")), recorded);
}

void TouchCommandTest::wrongWaysAreRefused_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* rest, const char* told) {
        QTest::newRow(rest) << QString(R"({"op":"touch","tool":"draw","radius":0.1%1})").arg(rest) << told;
    };
    row("", "either");
    row(R"(,"samples":[])", "no places");
    row(R"(,"samples":[[0,0,0]])", "sample 1");
    row(R"(,"samples":[[0,0,0,1],[0,0,0,2]])", "not later");
    row(R"(,"samples":[[0,0,0,1],[1e9,0,0,2]])", "an hour");
    row(R"(,"samples":[[0,0,0,1e300]])", "farther");
    row(R"(,"samples":[[0,0,0,1]],"trajectory":"a.csv")", "either");
    row(R"(,"trajectory":"nowhere.csv")", "nowhere.csv");
    row(R"(,"samples":[[0,0,0,1]],"stiffness":1e9)", "stiffness");
    row(R"(,"samples":[[0,0,0,1]],"wetness":1)", "wetness");
}

void TouchCommandTest::wrongWaysAreRefused() {
    QFETCH(QString, line);
    QFETCH(QString, told);
    Workbench bench;
    bench.run(test::newSphere(500));
    const std::string before = bench.hash(), message = bench.refusal(json::parse(line.toStdString()));
    QVERIFY2(message.find(told.toStdString()) != std::string::npos, message.c_str());
    QCOMPARE(bench.hash(), before);
}

static const test::Registered<TouchCommandTest> registered;
#include "touch_command_test.moc"
