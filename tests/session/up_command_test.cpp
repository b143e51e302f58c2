// The axis that is upwards: from the file or the shape, turned by a command, kept with the model.
#include "support/registry.h"
#include "workbench.h"

#include <iomanip>
#include <QTest>

using base::UpAxis;
using nlohmann::json;
using test::Workbench;

class UpCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void turningIsAStepThatChangesNoSurfel();
    void savedFilesBringItBack();
    void journalsBringItBack();
    void theShapeTellsWhereTheFileDoesNot();
    void theFormatTellsWhereTheShapeDoesNot();
};

namespace {

json up(const char* axis) {
    return {{"op", "up"}, {"axis", axis}};
}

json open(const std::filesystem::path& path) {
    return {{"op", "open"}, {"path", path.string()}};
}

/// Hills over x and y, at coordinates of a national grid.
std::string terrain() {
    std::ostringstream out;
    out << std::fixed << std::setprecision(3);
    for (int x = 0; x < 40; ++x)
        for (int y = 0; y < 40; ++y)
            out << 3.5e6 + x << ' ' << 5.6e6 + y << ' ' << 400 + 1.5 * std::sin(0.2 * x) * std::cos(0.15 * y) << '\n';
    return out.str();
}

/// An octahedron, which stands on no side.
const char* const octahedronObj = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 3 5\nf 3 2 5\nf 2 4 5\n"
                                  "f 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";

std::string octahedronStl() {
    std::string out = "solid s\n";
    for (const int x : {-1, 1})
        for (const int y : {-1, 1})
            for (const int z : {-1, 1}) {
                const auto corner = [](int a, int b, int c) {
                    return "vertex " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
                };
                const bool straight = x * y * z > 0;
                out += "facet normal 0 0 0\nouter loop\n" + corner(x, 0, 0) +
                       (straight ? corner(0, y, 0) + corner(0, 0, z) : corner(0, 0, z) + corner(0, y, 0)) +
                       "endloop\nendfacet\n";
            }
    return out + "endsolid s\n";
}

} // namespace

void UpCommandTest::turningIsAStepThatChangesNoSurfel() {
    Workbench bench;
    QVERIFY(!bench.refusal(up("z")).empty()); // of what?
    bench.run(test::newSphere());
    QVERIFY(bench.document.up() == UpAxis::Y);
    const std::string before = bench.hash();
    bench.run(up("-z"));
    QVERIFY(bench.document.up() == UpAxis::MinusZ && bench.document.modified() && bench.hash() == before);
    QCOMPARE(bench.document.historyBytes(), std::size_t(0));
    bench.run(test::strokeAt(0));
    bench.run(up("x"));
    for (const UpAxis axis : {UpAxis::MinusZ, UpAxis::MinusZ, UpAxis::Y}) {
        bench.run({{"op", "undo"}});
        QVERIFY(bench.document.up() == axis);
    }
    QVERIFY(!bench.document.modified() && bench.hash() == before);
    bench.run({{"op", "redo"}});
    QVERIFY(bench.document.up() == UpAxis::MinusZ);
    bench.run(test::newSphere());
    QVERIFY(bench.document.up() == UpAxis::Y);
    QVERIFY(bench.refusal(up("w")).find("y z -y -z x -x") != std::string::npos);
}

void UpCommandTest::savedFilesBringItBack() {
    for (const base::UpRow& row : base::upTable()) {
        Workbench bench;
        bench.run(test::newSphere());
        bench.run(up(row.id));
        bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
        QVERIFY(!bench.document.modified());
        Workbench other;
        other.run(open(bench.path("a.ply")));
        QVERIFY2(other.document.up() == row.axis && other.hash() == bench.hash(), row.id);
    }
}

void UpCommandTest::journalsBringItBack() {
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(test::newSphere());
    for (const json& command : {up("z"), test::strokeAt(0), up("-x"), json{{"op", "undo"}}}) {
        bench.run(command);
        Workbench other;
        session::recover(journal.path(), other.context);
        QVERIFY(other.document.up() == bench.document.up() && other.hash() == bench.hash());
    }
}

void UpCommandTest::theShapeTellsWhereTheFileDoesNot() {
    Workbench bench;
    bench.run(open(test::write(bench.path("a.xyz"), terrain())));
    QVERIFY(bench.document.up() == UpAxis::Z);
}

void UpCommandTest::theFormatTellsWhereTheShapeDoesNot() {
    Workbench bench;
    const auto upOf = [&](const char* name, const std::string& content) {
        json command = open(test::write(bench.path(name), content));
        command["sample_count"] = 3000;
        bench.run(command);
        return bench.document.up();
    };
    QVERIFY(upOf("a.obj", octahedronObj) == UpAxis::Y);
    QVERIFY(upOf("a.stl", octahedronStl()) == UpAxis::Z);
}

static const test::Registered<UpCommandTest> registered;
#include "up_command_test.moc"
