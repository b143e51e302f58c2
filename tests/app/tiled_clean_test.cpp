// LAS files that are larger than the memory that they may take: cleaned tile by tile to the same points.
#include "core/base/random.h"
#include "program.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <algorithm>
#include <array>
#include <QFile>
#include <QTest>

using test::json;
using test::Outcome;
using test::Program;
using test::rowsOf;

class TiledCleanTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void tilesShowNowhere_data();
    void tilesShowNowhere();
    void farStraysTakeNoMemory();
    void stepsForTheWholeRefuse();
};

namespace {

constexpr int count = test::sanitized ? 12000 : 30000;
const QString memory = test::sanitized ? "2500K" : "4M"; ///< for eight tiles and more

double onGrid(double x) {
    return std::round(x * 1000) / 1000;
}

/// A hilly ground, a fifth as dense on one side, with points in one place, strays above it, and far coordinates.
void makeScan(const Program& program, double far) {
    base::Random random(test::seed());
    std::ostringstream text;
    text.precision(12);
    for (int i = 0; i < count; ++i) {
        double x = random.uniform(0, 20), y = random.uniform(0, 15);
        while (x > 12 && random.uniform() < 0.8)
            x = random.uniform(0, 20);
        const double z = 0.3 * std::sin(x) * std::cos(0.7 * y) + 0.01 * random.normal();
        const double stray = i % 400 == 7 ? random.uniform(0.4, 1) : 0;
        for (int twice = 0; twice < (i % 500 == 3 ? 2 : 1); ++twice)
            text << far + onGrid(x) << ' ' << onGrid(y) - far << ' ' << onGrid(z + stray) << '\n';
    }
    program.write("scan.xyz", text.str());
    QCOMPARE(program.run({"convert", "scan.xyz", "scan.las"}).code, 0);
}

/// In thousandths, the grid of the scan.
std::vector<std::array<long long, 3>> pointsOf(const Program& program, const QString& name) {
    if (program.run({"convert", name, "points.xyz"}).code != 0)
        return {};
    std::istringstream in(program.read("points.xyz"));
    std::vector<std::array<long long, 3>> out;
    double x = 0, y = 0, z = 0;
    for (std::string rest; in >> x >> y >> z && std::getline(in, rest);)
        out.push_back({std::llround(x * 1000), std::llround(y * 1000), std::llround(z * 1000)});
    std::sort(out.begin(), out.end());
    return out;
}

} // namespace

void TiledCleanTest::tilesShowNowhere_data() {
    QTest::addColumn<QString>("ways");
    QTest::addColumn<double>("far");
    QTest::newRow("statistical") << "statistical" << 0.0;
    QTest::newRow("radius, far away") << "radius" << 1e7;
    QTest::newRow("two ways, far away") << "surface,statistical" << 1e7;
}

void TiledCleanTest::tilesShowNowhere() {
    QFETCH(QString, ways);
    QFETCH(double, far);
    const Program program;
    makeScan(program, far);
    QCOMPARE(program.run({"clean", "scan.las", "whole.las", "--outliers", ways}).code, 0);
    const Outcome tiled =
        program.run({"clean", "scan.las", "tiles.las", "--outliers", ways, "--memory", memory, "--report", "r.json"});
    QVERIFY2(tiled.code == 0 && tiled.err.find("tiles") != std::string::npos, tiled.err.c_str());
    const json report = json::parse(program.read("r.json"));
    QVERIFY2(report.at("tiles") > 5, report.dump().c_str());
    const auto whole = pointsOf(program, "whole.las"), tiles = pointsOf(program, "tiles.las");
    QVERIFY2(whole.size() > count * 29 / 30 && whole.size() < count - count / 1000,
             std::to_string(whole.size()).c_str());
    QCOMPARE(report.at("surfels").get<std::size_t>(), tiles.size());
    std::vector<std::array<long long, 3>> other;
    std::set_symmetric_difference(whole.begin(), whole.end(), tiles.begin(), tiles.end(), std::back_inserter(other));
    QVERIFY2(other.empty(),
             (std::to_string(other.size()) + " points differ, seed " + std::to_string(test::seed())).c_str());
    QCOMPARE(program.run({"clean", "scan.las", "much.las", "--outliers", ways, "--memory", "1G"}).code, 0);
    QCOMPARE(program.read("much.las"), program.read("whole.las")); // in one piece, where that fits
}

/// Strays a thousand times as far away as the scan is wide: a board over all has the scan in one field, and a margin
/// that shows a stray its neighbours shows it the whole scan. Both were refused.
void TiledCleanTest::farStraysTakeNoMemory() {
    const Program program;
    makeScan(program, 0);
    base::Random random(test::seed() + 1);
    std::ostringstream text(program.read("scan.xyz"), std::ios::ate);
    for (int i = 0; i < 25; ++i)
        text << onGrid(random.uniform(-20000, 20000)) << ' ' << onGrid(random.uniform(-20000, 20000)) << ' '
             << onGrid(random.uniform(-50, 50)) << '\n';
    program.write("far.xyz", text.str());
    QCOMPARE(program.run({"convert", "far.xyz", "far.las"}).code, 0);
    QCOMPARE(program.run({"clean", "far.las", "whole.las", "--outliers", "statistical"}).code, 0);
    const Outcome tiled =
        program.run({"clean", "far.las", "tiles.las", "--outliers", "statistical", "--memory", memory});
    QVERIFY2(tiled.code == 0 && tiled.err.find("an even choice") != std::string::npos, tiled.err.c_str());
    auto whole = pointsOf(program, "whole.las"), tiles = pointsOf(program, "tiles.las");
    const auto isFar = [](const auto& p) { return std::abs(p[0]) > 30000 || std::abs(p[1]) > 30000; };
    // Strays that see each other are kept by the whole at times; among a choice they see fewer.
    QVERIFY(std::erase_if(tiles, isFar) <= std::erase_if(whole, isFar));
    QVERIFY2(whole.size() > count * 29 / 30 && whole == tiles,
             qPrintable(QString("%1 and %2 points, seed %3").arg(whole.size()).arg(tiles.size()).arg(test::seed())));
}

void TiledCleanTest::stepsForTheWholeRefuse() {
    const Program program;
    makeScan(program, 0);
    for (const char* steps : {"--outliers islands", "--denoise auto", "--thin 0.1", "--orient tree", "--normals jet",
                              "--mixed --viewpoint 0,0,9"}) {
        const Outcome refused =
            program.run(QStringList{"clean", "scan.las", "out.las", "--memory", "1M"} + QString(steps).split(' '));
        QVERIFY2(refused.code == 1 && refused.err.find("does not work in tiles: ") != std::string::npos,
                 refused.err.c_str());
    }
    const auto refusal = [&](const char* in, const char* out, const char* memory) {
        const Outcome refused = program.run({"clean", in, out, "--outliers", "radius", "--memory", memory});
        return refused.code == 1 ? refused.err : std::string();
    };
    QVERIFY(refusal("scan.xyz", "out.las", "100K").find("only LAS") != std::string::npos);
    QVERIFY(refusal("scan.las", "out.ply", "4M").find("name it .las") != std::string::npos);
    QVERIFY(refusal("scan.las", "out.las", "25K").find("give more --memory") != std::string::npos);
    QVERIFY(!QFile::exists(program.dir().filePath("out.las")) && !QFile::exists(program.dir().filePath("out.ply")));
    QCOMPARE(program.run({"clean", "scan.las", "--dry-run", "--outliers", "radius", "--memory", memory}).code, 0);
}

static const test::Registered<TiledCleanTest> registered;
#include "tiled_clean_test.moc"
