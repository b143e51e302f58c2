// Mixed pixels as a command: the places of scanners come from the file or are told, and move with the model.
#include "core/base/random.h"
#include "core/session/journal.h"
#include "core/session/recover.h"
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using base::Vec3d;
using test::json;
using test::Workbench;

class MixedCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void mixedPixelsAreSeenFromWhereTheFileSays();
    void scannersMoveWithTheirModels();
};

namespace {

json open(Workbench& bench, const std::string& content) {
    return {{"op", "open"}, {"path", test::write(bench.path("scan.ply"), content).string()}};
}

/// A board before a wall, and a row of points between them along its rims, seen from `eye`.
/// Points come from `scans` scans by turns.
std::string boardBeforeWall(const Vec3d& eye, const std::string& comment, bool grid, int scans = 0) {
    base::Random random(5);
    std::ostringstream out;
    out.precision(12);
    out << "ply\nformat ascii 1.0\n"
        << comment << "element vertex 3600\nproperty double x\nproperty double y\n"
        << "property double z\n"
        << (grid ? "property int row\nproperty int column\n" : "") << (scans > 0 ? "property int scan\n" : "")
        << "end_header\n";
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 60; ++j) {
            const int in = std::min(std::min(i - 20, 40 - i), std::min(j - 20, 40 - j));
            const double depth = in > 0 ? 2 : in < 0 ? 4 : random.uniform(2.4, 3.6);
            const Vec3d p = eye + Vec3d{(i - 29.5) * 0.01, (j - 29.5) * 0.01, 1} * depth;
            out << p.x << ' ' << p.y << ' ' << p.z;
            if (grid)
                out << ' ' << i << ' ' << j;
            if (scans > 0)
                out << ' ' << (i + j) % scans;
            out << '\n';
        }
    return out.str();
}

} // namespace

void MixedCommandTest::mixedPixelsAreSeenFromWhereTheFileSays() {
    const auto left = [](const std::string& file, const json& command) {
        Workbench bench;
        bench.run(open(bench, file));
        bench.run(command);
        return std::make_pair(bench.size(), bench.context.figures.at("mixed"));
    };
    const json plain{{"op", "mixed"}};
    const auto [grid, removed] = left(boardBeforeWall({}, "", true), plain);
    QVERIFY2(removed >= 74 && removed <= 84, std::to_string(removed).c_str()); // 80 on the rims
    QCOMPARE(grid, std::size_t(3600 - removed));
    const Vec3d far{1e6, -2e6, 50};
    QCOMPARE(left(boardBeforeWall(far, "comment viewpoint 1000000 -2000000 50 1 0 0 0\n", false), plain).second,
             removed);
    QCOMPARE(left(boardBeforeWall(far, "", false), {{"op", "mixed"}, {"viewpoint", {1e6, -2e6, 50}}}).second, removed);
    QCOMPARE(left(boardBeforeWall({}, "", true), {{"op", "clean"}, {"mixed", true}}).second, removed);
    Workbench told;
    told.run(open(told, boardBeforeWall({}, "", false)));
    told.run({{"op", "clean"}, {"mixed", true}, {"viewpoint", {0, 0, 0}}});
    const Vec3d eye = Vec3d{} - told.context.document.provenance().origin;
    for (const surfel::Surfel& each : told.context.document.surface().tree().surfels().items)
        QVERIFY(dot(base::cast<double>(each.normal), eye - base::cast<double>(each.position)) >= 0);
    Workbench again;
    session::Journal journal(again.path("j.jsonl"));
    again.context.journal = &journal;
    again.run(open(again, boardBeforeWall({}, "", true)));
    const std::string whole = again.hash();
    again.run(plain);
    const std::string after = again.hash();
    Workbench replayed;
    session::recover(journal.path(), replayed.context);
    QCOMPARE(replayed.hash(), after);
    again.run({{"op", "undo"}});
    QVERIFY(again.hash() == whole && after != whole);
    Workbench none;
    none.run(test::newSphere(500));
    QVERIFY(none.refusal(plain).find("give the viewpoint") != std::string::npos);
    QVERIFY(!none.refusal({{"op", "mixed"}, {"viewpoint", {1, 2}}}).empty());
    Workbench several; // of which one point is of none
    several.run(
        open(several, boardBeforeWall({},
                                      "comment scan 0 viewpoint 0 0 0 1 0 0 0\ncomment scan 1 viewpoint 1 0 0 1 "
                                      "0 0 0\n",
                                      false)));
    QVERIFY(several.refusal(plain).find("give the viewpoint") != std::string::npos);
    const std::string one = "comment viewpoint 0 0 0 1 0 0 0\n";
    QCOMPARE(left(boardBeforeWall({}, one, false, 1), plain).second, removed);
    Workbench joined; // another scan was moved onto the one that the viewpoint is of
    joined.run(open(joined, boardBeforeWall({}, one, false, 2)));
    QVERIFY(joined.refusal(plain).find("give the viewpoint") != std::string::npos);
}

/// Of a grid without a comment, of one with, and of two scans: what goes is what would have gone before.
void MixedCommandTest::scannersMoveWithTheirModels() {
    const json moves[] = {{{"op", "transform"}, {"matrix", {0, -2, 0, 5, 2, 0, 0, -7, 0, 0, 2, 1e3, 0, 0, 0, 1}}},
                          {{"op", "unit"}, {"from", {0, 0, 0}}, {"to", {1, 0, 0}}, {"length", 1000}}};
    const std::string files[] = {
        boardBeforeWall({}, "", true), boardBeforeWall({3, 4, 5}, "comment viewpoint 3 4 5 1 0 0 0\n", false),
        boardBeforeWall({}, "comment scan a viewpoint 0 0 0 1 0 0 0\ncomment scan b viewpoint 0 0 0 1 0 0 0\n", false,
                        2)};
    for (const std::string& file : files) {
        Workbench bench;
        bench.run(open(bench, file));
        bench.run({{"op", "mixed"}});
        const double removed = bench.context.figures.at("mixed");
        bench.run({{"op", "undo"}});
        for (const json& move : moves) {
            bench.run(move);
            bench.run({{"op", "mixed"}});
            const double now = bench.context.figures.at("mixed");
            QVERIFY2(removed > 20 && std::abs(now - removed) <= 2, qPrintable(QString("%1 %2").arg(now).arg(removed)));
            bench.run({{"op", "undo"}});
            bench.run({{"op", "undo"}});
        }
        bench.run({{"op", "mixed"}});
        QCOMPARE(bench.context.figures.at("mixed"), removed);
    }
}

static const test::Registered<MixedCommandTest> registered;
#include "mixed_command_test.moc"
