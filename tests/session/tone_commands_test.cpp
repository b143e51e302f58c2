// Levels, white balance, colours of scans, and shapes found, as commands: undone, limited, refused.
#include "core/base/random.h"
#include "support/registry.h"
#include "workbench.h"

#include <cmath>
#include <QTest>

using test::json, test::Workbench;

class ToneCommandsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void levelsThatDoNothingChangeNothing();
    void levelsStretchWhatIsThere();
    void aCastIsTakenOut();
    void onlyWhatIsSelectedChanges();
    void withoutColoursTheyAreRefused();
    void scansAreBlendedAndUndone();
    void shapesAreNumberedAndUndone();
};

/// A ball whose colours run from dark to light, all with a cast of red.
static std::string tinted(double red) {
    base::Random random(test::seed());
    std::ostringstream out;
    for (int i = 0; i < 1500; ++i) {
        const base::Vec3d p = random.unitVector();
        const int grey = 60 + static_cast<int>(60 * (1 + p.z));
        out << p.x << ' ' << p.y << ' ' << p.z << ' ' << std::lround(red * grey) << ' ' << grey << ' ' << grey << '\n';
    }
    return out.str();
}

static void open(Workbench& bench, const std::string& text) {
    bench.run({{"op", "open"}, {"path", test::write(bench.path("a.xyz"), text).string()}});
}

/// Least, mean and most of a channel, 0 to 2.
struct Range {
    int least = 255, most = 0;
    double mean = 0;
};

static Range rangeOf(const Workbench& bench, unsigned channel) {
    Range out;
    const surfel::SurfelList list = bench.document.surface().tree().surfels();
    for (const surfel::Surfel& each : list.items) {
        const int level = static_cast<int>(each.colour >> 8 * channel & 255u);
        out.least = std::min(out.least, level), out.most = std::max(out.most, level);
        out.mean += level / static_cast<double>(list.size());
    }
    return out;
}

void ToneCommandsTest::levelsThatDoNothingChangeNothing() {
    Workbench bench;
    open(bench, tinted(1));
    const std::string before = bench.hash();
    bench.run({{"op", "levels"}});
    QCOMPARE(bench.hash(), before);
}

void ToneCommandsTest::levelsStretchWhatIsThere() {
    Workbench bench;
    open(bench, tinted(1));
    const std::string before = bench.hash();
    const Range was = rangeOf(bench, 1);
    bench.run({{"op", "levels"}, {"black", "auto"}, {"white", "auto"}});
    const Range now = rangeOf(bench, 1);
    QVERIFY(was.least >= 60 && was.most <= 180 && now.least == 0 && now.most == 255);
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "levels"}, {"gamma", 2}});
    QVERIFY(rangeOf(bench, 1).mean > was.mean + 20);
    QVERIFY(bench.refusal({{"op", "levels"}, {"black", 200}, {"white", 100}}).find("below white") != std::string::npos);
}

void ToneCommandsTest::aCastIsTakenOut() {
    for (const bool picked : {false, true}) {
        Workbench bench;
        open(bench, tinted(1.25));
        json command{{"op", "levels"}};
        if (picked)
            command["grey"] = {0, 0, -1};
        else
            command["balance"] = true;
        bench.run(command);
        const Range red = rangeOf(bench, 0), green = rangeOf(bench, 1);
        QVERIFY2(std::abs(red.mean - green.mean) < 4, qPrintable(QString("%1, %2").arg(red.mean).arg(green.mean)));
    }
}

void ToneCommandsTest::onlyWhatIsSelectedChanges() {
    Workbench bench;
    open(bench, tinted(1));
    const surfel::SurfelList before = bench.document.surface().tree().surfels();
    bench.run({{"op", "select"}, {"by", "plane"}, {"plane", {1, 0, 0, 0}}});
    bench.run({{"op", "levels"}, {"gamma", 0.5}});
    const surfel::SurfelList after = bench.document.surface().tree().surfels();
    for (std::size_t i = 0; i < after.size(); ++i)
        QCOMPARE(after.items[i].colour != before.items[i].colour, after.items[i].position.x >= 0);
}

void ToneCommandsTest::withoutColoursTheyAreRefused() {
    Workbench bench;
    bench.run(test::newSphere(600));
    for (const char* op : {"levels", "blend"})
        QVERIFY(bench.refusal({{"op", op}}).find("no colours") != std::string::npos);
    open(bench, tinted(1));
    QVERIFY(bench.refusal({{"op", "blend"}}).find("no attribute") != std::string::npos);
}

void ToneCommandsTest::scansAreBlendedAndUndone() {
    base::Random random(test::seed());
    std::ostringstream out;
    out << "x y z red green blue scan\n";
    for (int i = 0; i < 3000; ++i) {
        const int scan = i % 2;
        const double x = random.uniform(0, 2) + scan;
        out << x << ' ' << random.uniform() << " 0 " << (scan ? "120 120 120 1\n" : "160 150 140 0\n");
    }
    Workbench bench;
    bench.run({{"op", "open"}, {"path", test::write(bench.path("a.txt"), out.str()).string()}});
    const std::string before = bench.hash();
    bench.run({{"op", "blend"}});
    QVERIFY(bench.context.figures.at("after") < 0.1 * bench.context.figures.at("before"));
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
}

void ToneCommandsTest::shapesAreNumberedAndUndone() {
    Workbench bench;
    const std::string cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
                             "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    bench.run({{"op", "open"}, {"path", test::write(bench.path("cube.obj"), cube).string()}, {"sample_count", 6000}});
    const std::string before = bench.hash();
    bench.run({{"op", "shapes"}, {"colours", true}});
    QCOMPARE(bench.context.figures.at("shapes"), 6.0);
    QVERIFY(bench.context.figures.at("on") > 0.98 * static_cast<double>(bench.size()));
    bench.run({{"op", "select"}, {"by", "range"}, {"of", "shape"}, {"from", 3}, {"to", 3}});
    const std::size_t face = bench.size() / 6;
    bench.run({{"op", "keep"}});
    QVERIFY(bench.size() > face / 2 && bench.size() < 2 * face);
    for (int k = 0; k < 3; ++k)
        bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
}

static const test::Registered<ToneCommandsTest> registered;
#include "tone_commands_test.moc"
