// Commands that select and that work on what is selected: undone and replayed to the same bits, saved with the model,
// exact in numbers, and refused with a sentence where they make no sense.
#include "core/base/random.h"
#include "core/selection/field.h"
#include "core/session/journal.h"
#include "core/session/recover.h"
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using base::Vec3d;
using test::json;
using test::Workbench;

class SelectionCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyStepUndoesAndReplays_data();
    void everyStepUndoesAndReplays();
    void waysSelectWhatTheySay_data();
    void waysSelectWhatTheySay();
    void selectionIsSavedAndOpened();
    void strokesCarryTheSelection();
    void partsAreSplitOff();
    void mapsAreExact();
    void softMovesTurnNormalsWithTheSurface();
    void modelsStandOnTheGroundAlongTheAxes();
    void modelsThatLieFarComeToZeroAndBack();
    void oneRadiusForAllIsScaledAlong();
    void sidesOfWhatIsThinDoNotMeet();
    void unitsAreSetByADistance();
    void whatHasNothingToDoLeavesNoStep();
    void nonsenseIsRefused_data();
    void nonsenseIsRefused();
};

namespace {

/// A ball in coordinates far from zero, colours by place.
json openBall(Workbench& bench, double offset) {
    std::ostringstream out;
    out.precision(14);
    out << "ply\nformat ascii 1.0\nelement vertex 2000\nproperty double x\nproperty double y\nproperty double z\n"
           "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\nend_header\n";
    for (int i = 0; i < 2000; ++i) {
        const double z = 1 - (2 * i + 1.0) / 2000, r = std::sqrt(1 - z * z), a = i * 2.399963229728653;
        out << r * std::cos(a) + offset << ' ' << r * std::sin(a) - offset << ' ' << z << ' ' << (z > 0 ? 255 : 0)
            << " 0 0 " << i << '\n';
    }
    return {{"op", "open"}, {"path", test::write(bench.path("ball.ply"), out.str()).string()}};
}

json parsed(const char* text) {
    return json::parse(text);
}

std::size_t selected(const Workbench& bench) {
    return tree::sizeOf(selection::selectedIn(bench.document.surface().tree()));
}

} // namespace

void SelectionCommandTest::everyStepUndoesAndReplays_data() {
    QTest::addColumn<QString>("line");
    for (const char* line : {R"({"op":"select","by":"all"})",
                             R"({"op":"select","by":"plane","plane":[1,0,0,1e7],"mode":"intersect"})",
                             R"({"op":"select","by":"piece","mode":"subtract"})",
                             R"({"op":"selection","do":"invert"})",
                             R"({"op":"selection","do":"grow","length":0.2})",
                             R"({"op":"selection","do":"shrink","length":0.2})",
                             R"({"op":"selection","do":"blur","length":0.4})",
                             R"({"op":"selection","do":"border"})",
                             R"({"op":"selection","do":"clear"})",
                             R"({"op":"mask","do":"copy"})",
                             R"({"op":"mask","do":"invert"})",
                             R"({"op":"mask","do":"curvature","to":3})",
                             R"({"op":"delete"})",
                             R"({"op":"keep"})",
                             R"({"op":"duplicate","move":[3,0,0]})",
                             R"({"op":"transform","axis":[1,2,3],"angle":20,"scale":1.5})",
                             R"({"op":"transform","stretch":[1,2,-1],"of":"all"})",
                             R"({"op":"transform","mirror":[0,1,1,-1e7],"move":[0,0,0.25]})",
                             R"({"op":"colour","colour":[10,200,30],"strength":0.5})",
                             R"({"op":"flip"})",
                             R"({"op":"smooth","scale":3,"of":"all"})",
                             R"({"op":"sharpen"})",
                             R"({"op":"inflate","length":-0.1})",
                             R"({"op":"noise","amplitude":0.05,"size":0.3})",
                             R"({"op":"align","do":"axes"})",
                             R"({"op":"shell","thickness":0.2})",
                             R"({"op":"unit","from":[1e7,-1e7,-1],"to":[1e7,-1e7,1],"length":3})"})
        QTest::newRow(line) << line;
}

void SelectionCommandTest::everyStepUndoesAndReplays() {
    QFETCH(QString, line);
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(openBall(bench, 1e7));
    bench.run(parsed(R"({"op":"select","by":"ball","at":[1e7,-1e7,1],"radius":0.8})"));
    QVERIFY(selected(bench) > 200 && selected(bench) < 600);
    const std::string before = bench.hash();
    bench.run(json::parse(line.toStdString()));
    const std::string after = bench.hash();
    QVERIFY(before != after);
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "redo"}});
    QCOMPARE(bench.hash(), after);
    Workbench other;
    session::recover(bench.path("j.jsonl"), other.context);
    QCOMPARE(other.hash(), after);
}

void SelectionCommandTest::waysSelectWhatTheySay_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<double>("share"); // of the 2000 surfels
    const auto row = [](const char* line, double share) { QTest::newRow(line) << line << share; };
    row(R"({"op":"select","by":"all"})", 1);
    row(R"({"op":"select","by":"none"})", 0);
    row(R"({"op":"select","by":"ball","at":[1000,-1000,1],"radius":1})", 0.25);
    row(R"({"op":"select","by":"box","least":[999,-1001,-1],"most":[1001,-999,0.5]})", 0.75);
    row(R"({"op":"select","by":"plane","plane":[0,0,2,1.2]})", 0.2);
    row(R"({"op":"select","by":"range","of":"z","from":-0.5,"to":0})", 0.25);
    row(R"({"op":"select","by":"range","of":"quality","from":500})", 0.75);
    row(R"({"op":"select","by":"range","of":"curvature-mean","from":0.5,"to":1.5})", 1);
    row(R"({"op":"select","by":"colour","colour":[255,0,0]})", 0.5);
    row(R"({"op":"select","by":"normal","direction":[0,0,-1],"angle":60})", 0.25);
    row(R"({"op":"select","by":"piece","at":[1000,-1000,1]})", 1);
    row(R"({"op":"select","by":"view","eye":[1000,-1000,9],"target":[1000,-1000,0],"up":[0,1,0],"ortho":4,
            "size":[400,400],"rectangle":[0,0,200,400]})",
        0.5);
    row(R"({"op":"select","by":"view","eye":[1000,-1000,9],"target":[1000,-1000,0],"up":[0,1,0],"ortho":4,
            "size":[400,400],"polygon":[[0,0],[200,0],[200,200],[0,200]],"visible":true})",
        0.125);
    row(R"({"op":"select","by":"view","eye":[1000,-1000,9],"target":[1000,-1000,0],"up":[0,1,0],
            "rectangle":[-9999,-9999,9999,9999],"depth":[0,8.5]})",
        0.25);
}

void SelectionCommandTest::waysSelectWhatTheySay() {
    QFETCH(QString, line);
    QFETCH(double, share);
    Workbench bench;
    bench.run(openBall(bench, 1000));
    bench.run(json::parse(line.toStdString()));
    QVERIFY2(std::abs(double(selected(bench)) / 2000 - share) < 0.02, qPrintable(QString::number(selected(bench))));
}

void SelectionCommandTest::selectionIsSavedAndOpened() {
    Workbench bench, other;
    bench.run(openBall(bench, 1e7));
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[0,0,1,0.3]})"));
    bench.run(parsed(R"({"op":"selection","do":"blur","length":0.3})"));
    bench.run({{"op", "save"}, {"path", bench.path("out.ply").string()}});
    other.run({{"op", "open"}, {"path", bench.path("out.ply").string()}});
    QCOMPARE(other.hash(), bench.hash());
    QCOMPARE(selected(other), selected(bench));
}

void SelectionCommandTest::strokesCarryTheSelection() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[0,1,0,0.02]})"));
    json stroke = test::strokeAt(0.1, "clay");
    stroke["strength"] = 1.0;
    for (int k = 0; k < 3; ++k)
        bench.run(stroke);
    QVERIFY(bench.size() != 3000); // surfels were born
    const auto& tree = bench.document.surface().tree();
    const int channel = selection::channelOf(*tree.layout(), selection::Field::Selection);
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const float v = selection::valueAt(block, channel, slot), y = block.position(slot).y;
            QVERIFY(v >= 0 && v <= 1);
            if (std::abs(y) > 0.2f)
                QVERIFY(std::abs(v - (y > 0 ? 1.0f : 0.0f)) < 0.01f); // born there, of surfels within a support
        }
    });
}

void SelectionCommandTest::partsAreSplitOff() {
    Workbench bench, part, rest;
    bench.run(openBall(bench, 1e7));
    bench.run(parsed(R"({"op":"select","by":"range","of":"z","from":0.5})"));
    const std::size_t count = selected(bench);
    bench.run({{"op", "save"}, {"path", bench.path("part.ply").string()}, {"part", "selection"}});
    bench.run({{"op", "save"}, {"path", bench.path("rest.ply").string()}, {"part", "rest"}});
    QVERIFY(bench.document.modified()); // the whole was not saved
    bench.run({{"op", "delete"}});
    part.run({{"op", "open"}, {"path", bench.path("part.ply").string()}});
    rest.run({{"op", "open"}, {"path", bench.path("rest.ply").string()}});
    QCOMPARE(part.size(), count);
    QCOMPARE(rest.size(), 2000 - count);
    QCOMPARE(bench.size(), 2000 - count);
    QVERIFY(selected(part) == 0 && selected(rest) == 0);
    QCOMPARE(rest.hash(), bench.hash());
}

/// One surfel to look at: the nearest to a place.
static surfel::Surfel at(const Workbench& bench, const Vec3d& x) {
    std::vector<tree::Neighbour> near;
    bench.document.surface().tree().nearest(base::cast<float>(x - bench.document.provenance().origin), 1, near);
    return near[0].block->surfel(near[0].slot);
}

void SelectionCommandTest::mapsAreExact() {
    Workbench bench;
    bench.run(test::newSphere());
    const surfel::SurfelList before = bench.document.surface().tree().surfels();
    // An ellipsoid: normals are x / a^2.
    bench.run(parsed(R"({"op":"transform","stretch":[3,1,0.5],"about":[0,0,0],"of":"all"})"));
    const surfel::SurfelList after = bench.document.surface().tree().surfels();
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Vec3d p = base::cast<double>(before.items[i].position), n = base::cast<double>(before.items[i].normal);
        const Vec3d q{3 * p.x, p.y, 0.5 * p.z}, m = normalized(Vec3d{n.x / 3, n.y, n.z * 2});
        QVERIFY(distance(base::cast<double>(after.items[i].position), q) < 1e-6);
        QVERIFY(distance(base::cast<double>(after.items[i].normal), m) < 1e-6);
    }
    bench.run({{"op", "undo"}});
    // Four quarter turns and two mirrors are nothing.
    for (int k = 0; k < 4; ++k)
        bench.run(parsed(R"({"op":"transform","axis":[0,0,2],"angle":90,"about":[0.5,1,0]})"));
    for (int k = 0; k < 2; ++k)
        bench.run(parsed(R"({"op":"transform","mirror":[1,2,3,0.7]})"));
    const surfel::SurfelList back = bench.document.surface().tree().surfels();
    for (std::size_t i = 0; i < before.size(); ++i) {
        QVERIFY(distance(back.items[i].position, before.items[i].position) < 2e-6f);
        QVERIFY(distance(back.items[i].normal, before.items[i].normal) < 2e-6f);
        QCOMPARE(back.items[i].support, before.items[i].support);
    }
    // A mirrored ball is not turned inside out.
    bench.run(parsed(R"({"op":"transform","stretch":[-1,1,1],"about":[0,0,0]})"));
    for (const surfel::Surfel& s : bench.document.surface().tree().surfels().items)
        QVERIFY(dot(s.position, s.normal) > 0.99f);
    // The same numbers as a matrix of the file's coordinates.
    Workbench far, matrix;
    for (Workbench* each : {&far, &matrix})
        each->run(openBall(*each, 1e7));
    far.run(parsed(R"({"op":"transform","scale":2,"about":[1e7,-1e7,0],"move":[1,2,3]})"));
    matrix.run(parsed(R"({"op":"transform","matrix":[2,0,0,-9999999,0,2,0,10000002,0,0,2,3,0,0,0,1]})"));
    QVERIFY(distance(at(far, {1e7 + 1, -1e7 + 2, 5}).position, at(matrix, {1e7 + 1, -1e7 + 2, 5}).position) < 1e-5f);
    QVERIFY(distance(base::cast<double>(at(far, {1e7 + 1, -1e7 + 2, 5}).position) + far.document.provenance().origin,
                     Vec3d{1e7 + 1, -1e7 + 2, 5}) < 0.1);
}

void SelectionCommandTest::softMovesTurnNormalsWithTheSurface() {
    // A plane lifted by a soft bump z = w(x, y): its normals are those of the graph.
    Workbench bench;
    std::ostringstream out;
    out << "ply\nformat ascii 1.0\nelement vertex 3600\nproperty float x\nproperty float y\nproperty float z\n"
           "property float nx\nproperty float ny\nproperty float nz\nproperty float selection\nend_header\n";
    const auto weight = [](double x, double y) { return std::exp(-(x * x + y * y)); };
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 60; ++j) {
            const double x = 0.1 * i - 3, y = 0.1 * j - 3;
            out << x << ' ' << y << " 0 0 0 1 " << weight(x, y) << '\n';
        }
    bench.run({{"op", "open"}, {"path", test::write(bench.path("plane.ply"), out.str()).string()}});
    bench.run(parsed(R"({"op":"transform","move":[0,0,0.8],"of":"selection"})"));
    for (const surfel::Surfel& s : bench.document.surface().tree().surfels().items) {
        const double x = double(s.position.x), y = double(s.position.y), w = weight(x, y);
        QVERIFY(std::abs(double(s.position.z) - 0.8 * w) < 1e-5);
        if (std::max(std::abs(x), std::abs(y)) < 2.4)
            QVERIFY(dot(base::cast<double>(s.normal), normalized(Vec3d{1.6 * x * w, 1.6 * y * w, 1})) > 0.998);
    }
}

void SelectionCommandTest::modelsStandOnTheGroundAlongTheAxes() {
    Workbench bench;
    bench.run(test::newSphere(4000));
    bench.run(parsed(R"({"op":"transform","stretch":[3,1,2]})"));
    const base::Box3f straight = bench.document.surface().tree().bounds();
    bench.run(parsed(R"({"op":"transform","axis":[1,2,0.5],"angle":25,"move":[4,5,6]})"));
    bench.run(parsed(R"({"op":"align","do":"axes"})"));
    const base::Box3f turned = bench.document.surface().tree().bounds();
    QVERIFY(length(turned.size() - straight.size()) < 0.06f); // as even as the sampling is
    bench.run(parsed(R"({"op":"align","do":"centre"})"));
    bench.run(parsed(R"({"op":"up","axis":"z"})"));
    bench.run(parsed(R"({"op":"align","do":"ground"})"));
    const base::Box3f box = bench.document.surface().tree().bounds();
    QVERIFY(std::abs(box.lo.z) < 1e-5f && std::abs(box.centre().x) < 1e-5f);
    bench.run(parsed(R"({"op":"up","axis":"-y"})"));
    bench.run(parsed(R"({"op":"align","do":"ground"})"));
    QVERIFY(std::abs(bench.document.surface().tree().bounds().hi.y) < 1e-5f);
}

void SelectionCommandTest::modelsThatLieFarComeToZeroAndBack() {
    Workbench bench;
    bench.run(openBall(bench, 1e7));
    const std::string opened = bench.hash();
    const base::Box3f first = bench.document.surface().tree().bounds();
    const auto places = [&] {
        const base::Box3f box = bench.document.surface().tree().bounds();
        const Vec3d origin = bench.document.provenance().origin;
        return std::pair(base::cast<double>(box.lo) + origin, base::cast<double>(box.hi) + origin);
    };
    bench.run(parsed(R"({"op":"transform","move":[-1e7,1e7,0]})"));
    QCOMPARE(bench.document.provenance().origin, Vec3d());
    QVERIFY(length(places().first + Vec3d{1, 1, 1}) < 0.01 && length(places().second - Vec3d{1, 1, 1}) < 0.01);
    const std::string moved = bench.hash();
    bench.run({{"op", "save"}, {"path", bench.path("moved.ply").string()}});
    Workbench again;
    again.run({{"op", "open"}, {"path", bench.path("moved.ply").string()}});
    QCOMPARE(again.hash(), moved);
    // Not only there: as far on the other side, where float32 alone would tell no neighbours apart.
    bench.run(parsed(R"({"op":"transform","move":[3e7,0,-2e7]})"));
    QVERIFY(length(places().first - Vec3d{3e7 - 1, -1, -2e7 - 1}) < 0.01);
    QVERIFY(length(bench.document.surface().tree().bounds().size() - first.size()) < 1e-6f);
    bench.run(parsed(R"({"op":"align","do":"centre"})"));
    QVERIFY(std::abs(places().first.x + places().second.x) < 1e-5);
    QVERIFY(std::abs(places().first.z + places().second.z) < 1e-5);
    for (int k = 0; k < 3; ++k)
        bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), opened);
    bench.run({{"op", "redo"}});
    QCOMPARE(bench.hash(), moved);
}

void SelectionCommandTest::oneRadiusForAllIsScaledAlong() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(parsed(R"({"op":"surface","support":0.25})"));
    bench.run(parsed(R"({"op":"transform","scale":2})"));
    QVERIFY(std::abs(bench.document.surface().definition().support - 0.5f) < 1e-6f);
    QVERIFY(std::abs(bench.document.surface().tree().surfels().items[5].support - 0.5f) < 1e-6f);
}

void SelectionCommandTest::sidesOfWhatIsThinDoNotMeet() {
    Workbench bench;
    bench.run(test::newSphere(2000));
    bench.run(parsed(R"({"op":"transform","stretch":[1,1,0.3],"about":[0,0,0]})"));
    const std::string hash = bench.hash();
    const auto refusal = [&](double length) { return bench.refusal({{"op", "inflate"}, {"length", length}}); };
    for (const double length : {-0.31, -0.5, -3.0}) // 0.6 thick in the middle, so 0.3 from each side
        QVERIFY2(refusal(length).find("both sides would meet") != std::string::npos, refusal(length).c_str());
    QCOMPARE(bench.hash(), hash);
    QCOMPARE(refusal(-0.02), std::string());
    bench.run({{"op", "undo"}});
    // One side alone has all of the way.
    bench.run(parsed(R"({"op":"select","by":"normal","direction":[0,0,1],"angle":30})"));
    QCOMPARE(refusal(-0.4), std::string());
    bench.run({{"op", "undo"}});
    QVERIFY(!refusal(-0.7).empty());
}

void SelectionCommandTest::unitsAreSetByADistance() {
    Workbench bench;
    bench.run(openBall(bench, 1e7));
    const float before = bench.document.surface().tree().bounds().size().z;
    const surfel::Surfel one = bench.document.surface().tree().surfels().items[7];
    bench.run(parsed(R"({"op":"unit","from":[1e7,-1e7,-1],"to":[1e7,-1e7,1],"length":5})"));
    QVERIFY(std::abs(bench.document.surface().tree().bounds().size().z - 2.5f * before) < 1e-5f);
    QVERIFY(std::abs(bench.document.surface().tree().surfels().items[7].support - 2.5f * one.support) < 1e-5f);
    QCOMPARE(bench.context.figures.at("scale"), 2.5);
}

void SelectionCommandTest::whatHasNothingToDoLeavesNoStep() {
    Workbench bench;
    bench.run(test::newSphere());
    for (const char* line : {R"({"op":"select","by":"none"})", R"({"op":"selection","do":"clear"})",
                             R"({"op":"mask","do":"clear"})", R"({"op":"selection","do":"grow","length":1})",
                             R"({"op":"transform"})", R"({"op":"transform","scale":1,"angle":0,"axis":[0,0,1]})"}) {
        bench.run(parsed(line));
        QVERIFY2(!bench.document.canUndo(), line);
    }
}

void SelectionCommandTest::nonsenseIsRefused_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* line, const char* told) { QTest::newRow(line) << line << told; };
    row(R"({"op":"select","by":"ball","at":[0,0,0]})", "needs the parameter \"radius\"");
    row(R"({"op":"select","by":"all","radius":1})", "\"radius\" has no say");
    row(R"({"op":"select","by":"ball","at":[0,0],"radius":1})", "no list of 3 numbers");
    row(R"({"op":"select","by":"ball","at":[0,0,"x"],"radius":1})", "no list of 3 numbers");
    row(R"({"op":"select","by":"box","least":[0,0,0],"most":[1,-1,1]})", "lies beyond");
    row(R"({"op":"select","by":"plane","plane":[0,0,0,1]})", "no direction");
    row(R"({"op":"select","by":"range","of":"beauty"})", "nothing named \"beauty\"");
    row(R"({"op":"select","by":"view","eye":[0,0,5],"target":[0,0,0]})", "one of rectangle and polygon");
    row(R"({"op":"select","by":"view","eye":[0,0,5],"target":[0,0,5],"rectangle":[0,0,9,9]})", "same place");
    row(R"({"op":"select","by":"view","eye":[0,0,5],"target":[0,0,0],"polygon":[[0,0],[1,1]]})", "fewer than three");
    row(R"({"op":"select","by":"view","eye":[0,0,5],"target":[0,0,0],"polygon":[[0,0],[1,1],[2]]})",
        "no list of 2 numbers");
    row(R"({"op":"select","by":"colour","colour":[0,0,300]})", "no colour");
    row(R"({"op":"select","by":"piece"})", "nothing selected to begin with");
    row(R"({"op":"selection","do":"grow"})", "needs the parameter \"length\"");
    row(R"({"op":"mask","do":"curvature","from":3,"to":2})", "not below");
    row(R"({"op":"delete"})", "nothing is selected");
    row(R"({"op":"duplicate","move":[1,0,0]})", "nothing is selected");
    row(R"({"op":"transform","of":"selection","move":[1,0,0]})", "nothing is selected");
    row(R"({"op":"transform","stretch":[1,0,1]})", "pressed flat");
    row(R"({"op":"transform","scale":1e16})", "keep their places");
    row(R"({"op":"inflate","length":1e9})", "keep their places");
    row(R"({"op":"shell","thickness":100})", "thicker than");
    row(R"({"op":"transform","axis":[0,0,1]})", "belong together");
    row(R"({"op":"unit","from":[1,2,3],"to":[1,2,3],"length":1})", "same place");
    row(R"({"op":"transform","matrix":[1,2,3]})", "no list of 16 numbers");
    row(R"({"op":"save","path":"nowhere.ply","part":"selection"})", "nothing is selected");
}

void SelectionCommandTest::nonsenseIsRefused() {
    QFETCH(QString, line);
    QFETCH(QString, told);
    Workbench bench;
    bench.run(test::newSphere(500));
    const std::string before = bench.hash(), refusal = bench.refusal(json::parse(line.toStdString()));
    QVERIFY2(QString::fromStdString(refusal).contains(told), refusal.c_str());
    QCOMPARE(bench.hash(), before);
    if (told == "nothing is selected") // nor may all of it go
        QVERIFY(bench.size() == 500);
}

static const test::Registered<SelectionCommandTest> registered;
#include "selection_command_test.moc"
