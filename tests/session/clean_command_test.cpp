// The commands that clean: undone to the same bits, replayed to the same bits, and what they protect.
#include "core/base/random.h"
#include "core/session/journal.h"
#include "core/session/recover.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "workbench.h"

#include <QTest>

using base::Vec3d;
using test::json;
using test::Workbench;

class CleanCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void contradictingNormalsAreTurnedAndTold();
    void everyStepUndoesAndReplays_data();
    void everyStepUndoesAndReplays();
    void stepsTogetherAreOneStep();
    void whatHasNothingToDoLeavesNoStep();
    void maskedSurfelsAreProtected();
    void othersKeepEveryBit();
    void bodiesInShellsOfStraysLookOutwards();
    void sidesGuessedAmongStraysAreGuessedAgain();
    void basesOfConesLookOutwardsAfterCleaning();
    void viewpointsTurnNormals();
    void gridsGiveNormals();
    void scansHaveGridsOfTheirOwn();
    void nonsenseIsRefused();
};

namespace {

/// A noisy sphere with a fiftieth of strays, at coordinates far from zero where asked for.
std::string scan(double offset = 0, bool masked = false, int count = 3000) {
    base::Random random(7);
    const int all = count + count / 50;
    std::ostringstream out;
    out.precision(12);
    out << "ply\nformat ascii 1.0\nelement vertex " << all
        << "\nproperty double x\nproperty double y\nproperty double z\n"
        << (masked ? "property float mask\n" : "") << "end_header\n";
    for (int i = 0; i < all; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(std::max(0.0, 1 - z * z)), a = i * 2.399963229728653;
        Vec3d p = Vec3d{r * std::cos(a), r * std::sin(a), z} * (1 + 0.01 * random.normal());
        if (i >= count)
            p = random.unitVector() * random.uniform(1.3, 2);
        out << p.x + offset << ' ' << p.y << ' ' << p.z << (masked ? i % 2 ? " 1" : " 0" : "") << '\n';
    }
    return out.str();
}

json open(Workbench& bench, const std::string& content) {
    return {{"op", "open"}, {"path", test::write(bench.path("scan.ply"), content).string()}};
}

/// A box in a shell that is no part of it, without normals.
std::string boxInShell(std::uint64_t seed) {
    base::Random random(seed);
    const Vec3d half{random.uniform(0.5, 0.85), random.uniform(0.5, 0.85), random.uniform(0.5, 0.85)};
    std::ostringstream out;
    for (int i = 0; i < 8800; ++i) {
        Vec3d p = random.unitVector() * 2;
        if (i < 8000) {
            const std::size_t axis = random.below(3);
            p = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
            p[axis] = p[axis] < 0 ? -1 : 1;
            p = {p.x * half.x, p.y * half.y, p.z * half.z};
        }
        out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    return out.str();
}

/// A cone, whose base no way reaches but over an acute edge, with strays around it.
std::string coneAmongStrays(std::uint64_t seed, double height, int strays = 150, int count = 6000) {
    base::Random random(seed);
    const double slant = std::hypot(1, height);
    std::ostringstream out;
    for (int i = 0; i < count + strays; ++i) {
        const double turn = random.uniform(0, 6.283185307179586), r = std::sqrt(random.uniform());
        const bool base = random.uniform(0, 1 + slant) < 1;
        Vec3d p{std::cos(turn) * r, std::sin(turn) * r, base ? 0 : height * (1 - r)};
        if (i >= count)
            p = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 3)};
        out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    return out.str();
}

bool looksOutwards(const Workbench& bench) {
    Vec3d middle;
    const surfel::SurfelList points = bench.document.surface().tree().surfels();
    for (const surfel::Surfel& s : points.items)
        if (length(s.position) < 1.6f)
            middle += base::cast<double>(s.position) / 8000.0;
    double sum = 0;
    for (const surfel::Surfel& s : points.items)
        if (length(s.position) < 1.6f)
            sum += dot(base::cast<double>(s.position) - middle, base::cast<double>(s.normal));
    return sum > 0;
}

double meanRadius(const Workbench& bench) {
    double sum = 0;
    for (const surfel::Surfel& s : bench.document.surface().tree().surfels().items)
        sum += length(base::cast<double>(s.position));
    return sum / double(bench.size());
}

} // namespace

void CleanCommandTest::everyStepUndoesAndReplays_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {R"({"op":"outliers"})", R"({"op":"outliers","method":"radius"})", R"({"op":"outliers","method":"islands"})",
          R"({"op":"outliers","method":"surface","limit":3})", R"({"op":"denoise"})",
          R"({"op":"denoise","sigma":0.02})", R"({"op":"thin","spacing":0.15})", R"({"op":"normals","method":"jet"})",
          R"({"op":"normals","method":"viewpoint","viewpoint":[0,0,9]})", R"({"op":"orient","method":"viewpoint"})",
          R"({"op":"clean","outliers":"surface","denoise":"auto","thin":0.1,"normals":"jet","orient":"global"})"})
        QTest::newRow(line) << line;
}

void CleanCommandTest::everyStepUndoesAndReplays() {
    QFETCH(QString, line);
    const json command = json::parse(line.toStdString());
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(open(bench, scan(1e6, false, 1000)));
    const std::string before = bench.hash();
    bench.run(command);
    const std::string after = bench.hash();
    QVERIFY(after != before && bench.document.canUndo() && !bench.context.messages.empty());
    Workbench other;
    session::recover(journal.path(), other.context);
    QCOMPARE(other.hash(), after);
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "redo"}});
    QCOMPARE(bench.hash(), after);
}

void CleanCommandTest::stepsTogetherAreOneStep() {
    Workbench together, apart;
    together.run(open(together, scan()));
    apart.run(open(apart, scan()));
    together.run({{"op", "clean"}, {"outliers", "statistical"}, {"denoise", "auto"}, {"thin", 0.1}});
    apart.run({{"op", "outliers"}});
    apart.run({{"op", "denoise"}});
    apart.run({{"op", "thin"}, {"spacing", 0.1}});
    QCOMPARE(together.hash(), apart.hash());
    QCOMPARE(together.document.undoLabel(), std::string("Clean"));
    together.run({{"op", "undo"}});
    QVERIFY(!together.document.canUndo());
    QVERIFY(together.context.figures.at("outliers") > 50 && together.context.figures.at("sigma") > 0.005);
    QVERIFY(std::abs(meanRadius(apart) - 1) < 0.004);
}

void CleanCommandTest::whatHasNothingToDoLeavesNoStep() {
    Workbench bench;
    bench.run(test::newSphere(2000));
    bench.run({{"op", "duplicates"}});
    bench.run({{"op", "outliers"}});
    QVERIFY(!bench.document.canUndo() && !bench.document.modified());
}

void CleanCommandTest::maskedSurfelsAreProtected() {
    Workbench bench;
    bench.run(open(bench, scan(0, true)));
    const auto masked = [&] {
        std::vector<base::Vec3f> out;
        for (const surfel::Surfel& s : bench.document.surface().tree().surfels().items)
            if (s.mask >= 1)
                out.push_back(s.position);
        const auto before = [](const base::Vec3f& a, const base::Vec3f& b) {
            return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
        };
        std::sort(out.begin(), out.end(), before);
        return out;
    };
    const auto all = masked();
    QCOMPARE(all.size(), std::size_t(1530));
    const std::size_t size = bench.size();
    bench.run({{"op", "clean"}, {"outliers", "statistical"}, {"denoise", 0.02}, {"thin", 0.1}});
    QVERIFY(masked() == all && bench.size() < size);
}

/// Far from where strays went surfels stay as they were, supports and all.
void CleanCommandTest::othersKeepEveryBit() {
    Workbench bench;
    base::Random random(3);
    std::ostringstream out;
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 60; ++j)
            out << i << ' ' << j << ' ' << 0.1 * random.normal() << '\n';
    out << "5 5 20\n6 5 21\n";
    bench.run({{"op", "open"}, {"path", test::write(bench.path("a.xyz"), out.str()).string()}});
    const surfel::SurfelList before = bench.document.surface().tree().surfels();
    bench.run({{"op", "outliers"}});
    const surfel::SurfelList after = bench.document.surface().tree().surfels();
    QCOMPARE(after.size(), before.size() - 2);
    std::size_t same = 0;
    for (const surfel::Surfel& s : after.items)
        same += std::find(before.items.begin(), before.items.end(), s) != before.items.end();
    QVERIFY2(same > after.size() * 95 / 100, qPrintable(QString::number(same)));
}

/// A shell of strays makes no hollow of the box in it, and takes no side with it when it goes.
void CleanCommandTest::bodiesInShellsOfStraysLookOutwards() {
    for (std::uint64_t k = 0; k < (test::sanitized ? 1 : 3); ++k) {
        Workbench bench;
        bench.run(
            {{"op", "open"}, {"path", test::write(bench.path("scan.xyz"), boxInShell(test::seed() + k)).string()}});
        QVERIFY2(looksOutwards(bench), qPrintable(QString("seed %1 + %2").arg(test::seed()).arg(k)));
        bench.run({{"op", "outliers"}, {"method", "islands"}, {"limit", 1000}});
        QVERIFY(bench.size() <= 8000 && looksOutwards(bench));
    }
}

/// Normals beside strays look wherever these led them, until they went. A file's own, and those that were turned since,
/// stay.
void CleanCommandTest::sidesGuessedAmongStraysAreGuessedAgain() {
    for (const char* line : {R"({"op":"outliers"})", R"({"op":"clean","outliers":"statistical"})"}) {
        Workbench bench;
        const std::string path =
            test::write(bench.path("scan.xyz"), coneAmongStrays(test::seed(), 1.5, 500, 2000)).string();
        bench.run({{"op", "open"}, {"path", path}});
        bench.run(json::parse(line));
        QVERIFY2(bench.context.figures.contains("flipped"), qPrintable(QString("seed %1").arg(test::seed())));
        bench.run({{"op", "undo"}});
        bench.run({{"op", "flip"}});
        bench.context.figures.clear();
        const surfel::SurfelList before = bench.document.surface().tree().surfels();
        bench.run(json::parse(line));
        QVERIFY(!bench.context.figures.contains("flipped"));
        const surfel::SurfelList after = bench.document.surface().tree().surfels();
        for (std::size_t i = 0; i < after.size(); i += 20)
            QVERIFY(std::ranges::any_of(before.items, [&](const surfel::Surfel& each) {
                return each.position == after.items[i].position && each.normal == after.items[i].normal;
            }));
    }
}

/// What opening gets right by asking the whole, no step of cleaning undoes.
void CleanCommandTest::basesOfConesLookOutwardsAfterCleaning() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(4); ++k) {
        const double height = random.uniform(0.8, 2.2);
        Workbench bench;
        bench.run(
            {{"op", "open"},
             {"path",
              test::write(bench.path("cone.xyz"), coneAmongStrays(test::seed() + std::uint64_t(k), height)).string()}});
        bench.run({{"op", "outliers"}});
        for (const char* line : {R"({"op":"expect"})", R"({"op":"orient"})"}) {
            bench.run(json::parse(line));
            std::size_t base = 0, inwards = 0;
            for (const surfel::Surfel& s : bench.document.surface().tree().surfels().items)
                if (std::abs(s.position.z) < 1e-3f && length(s.position) < 0.8f)
                    ++base, inwards += s.normal.z > 0;
            QVERIFY2(base > 500 && inwards < base / 10, qPrintable(QString("%1: %2 of %3 inwards, height %4, seed %5")
                                                                       .arg(line)
                                                                       .arg(inwards)
                                                                       .arg(base)
                                                                       .arg(height)
                                                                       .arg(test::seed())));
        }
    }
}

void CleanCommandTest::viewpointsTurnNormals() {
    Workbench bench;
    bench.run(open(bench, scan(1e6)));
    bench.run({{"op", "clean"}, {"outliers", "statistical"}, {"orient", "tree"}});
    bench.run({{"op", "orient"}, {"method", "viewpoint"}, {"viewpoint", {1e6, 0.0, 0.0}}}); // from the middle
    const base::Vec3d origin = bench.document.provenance().origin;
    for (const surfel::Surfel& s : bench.document.surface().tree().surfels().items) {
        const base::Vec3d way = base::Vec3d{1e6, 0, 0} - origin - base::cast<double>(s.position);
        QVERIFY(dot(way, base::cast<double>(s.normal)) >= 0);
    }
    QVERIFY(bench.context.figures.at("flipped") > 2000);
    QVERIFY(!bench.refusal({{"op", "orient"}, {"method", "viewpoint"}, {"viewpoint", {1, 2}}}).empty());
    QVERIFY(!bench.refusal({{"op", "orient"}, {"method", "viewpoint"}, {"viewpoint", {1, 2, "c"}}}).empty());
}

void CleanCommandTest::gridsGiveNormals() {
    Workbench bench;
    std::ostringstream out;
    out << "ply\nformat ascii 1.0\nelement vertex 2500\nproperty float x\nproperty float y\nproperty float z\n"
           "property int row\nproperty int column\nend_header\n";
    for (int i = 0; i < 50; ++i)
        for (int j = 0; j < 50; ++j) // two levels with a step between
            out << i << ' ' << j << ' ' << 0.5 * j + (i < 25 ? 0 : 40) << ' ' << i << ' ' << j << '\n';
    bench.run({{"op", "open"}, {"path", test::write(bench.path("grid.ply"), out.str()).string()}});
    bench.run({{"op", "normals"}, {"method", "grid"}});
    const base::Vec3f wanted = base::normalized(base::Vec3f{0, -0.5f, 1});
    for (const surfel::Surfel& s : bench.document.surface().tree().surfels().items)
        QVERIFY(std::abs(std::abs(dot(s.normal, wanted)) - 1) < 1e-5f);
    Workbench none;
    none.run(test::newSphere(500));
    QVERIFY(none.refusal({{"op", "normals"}, {"method", "grid"}}).find("use plane or jet") != std::string::npos);
}

/// The same rows and columns in two scans: none of the one has neighbours in the other.
void CleanCommandTest::scansHaveGridsOfTheirOwn() {
    std::ostringstream out;
    out << "ply\nformat ascii 1.0\nelement vertex 800\nproperty float x\nproperty float y\nproperty float z\n"
           "property int row\nproperty int column\nproperty int scan\nend_header\n";
    for (int scan = 0; scan < 2; ++scan)
        for (int i = 0; i < 20; ++i)
            for (int j = 0; j < 20; ++j) // the floor and a wall
                out << i << ' ' << (scan ? 40 : j) << ' ' << (scan ? j + 30 : 0) << ' ' << i << ' ' << j << ' ' << scan
                    << '\n';
    Workbench bench;
    bench.run({{"op", "open"}, {"path", test::write(bench.path("grids.ply"), out.str()).string()}});
    bench.run({{"op", "normals"}, {"method", "grid"}});
    for (const surfel::Surfel& s : bench.document.surface().tree().surfels().items)
        QVERIFY(std::abs(s.position.y == 40 ? s.normal.y : s.normal.z) > 0.9999f);
}

void CleanCommandTest::nonsenseIsRefused() {
    Workbench bench;
    bench.run(test::newSphere(1000));
    const std::string before = bench.hash();
    for (const json& command :
         {json{{"op", "clean"}}, json{{"op", "thin"}}, json{{"op", "thin"}, {"spacing", 0}},
          json{{"op", "thin"}, {"spacing", 100}}, json{{"op", "denoise"}, {"sigma", -1}},
          json{{"op", "denoise"}, {"sigma", "much"}}, json{{"op", "outliers"}, {"method", "magic"}},
          json{{"op", "outliers"}, {"limit", -2}}, json{{"op", "normals"}, {"method", 3}}, json{{"op", "resample"}},
          json{{"op", "resample"}, {"count", 3}}, json{{"op", "resample"}, {"count", 500}, {"spacing", 0.1}}})
        QVERIFY2(!bench.refusal(command).empty(), command.dump().c_str());
    QVERIFY(bench.hash() == before && !bench.document.canUndo());
}

/// Opening mends them, and says how many it turned; of what it has mended it says nothing.
void CleanCommandTest::contradictingNormalsAreTurnedAndTold() {
    base::Random random(test::seed());
    std::ostringstream out;
    for (int i = 0; i < 3000; ++i) {
        const double z = 1 - (2 * i + 1.0) / 3000, r = std::sqrt(1 - z * z), a = i * 2.399963229728653,
                     side = random.uniform() < 0.5 ? 1 : -1;
        const Vec3d p{r * std::cos(a), r * std::sin(a), z};
        out << p.x << ' ' << p.y << ' ' << p.z << ' ' << side * p.x << ' ' << side * p.y << ' ' << side * p.z << '\n';
    }
    Workbench bench;
    const auto tells = [&](const char* what) {
        bool told = false;
        for (const std::string& each : bench.context.messages)
            told = told || each.find(what) != std::string::npos;
        return told;
    };
    bench.run({{"op", "open"}, {"path", test::write(bench.path("flipped.xyz"), out.str()).string()}});
    QVERIFY(tells("turned, so that all agree") && !tells("opposite ways"));
    bench.document.surface().tree().forEachBlock([](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            QVERIFY(dot(block.position(slot), block.normal(slot)) > 0);
    });
    bench.run({{"op", "save"}, {"path", bench.path("turned.xyz").string()}});
    bench.context.messages.clear();
    bench.run({{"op", "open"}, {"path", bench.path("turned.xyz").string()}});
    QVERIFY(!tells("all agree") && !tells("opposite ways"));
}

static const test::Registered<CleanCommandTest> registered;
#include "clean_command_test.moc"
