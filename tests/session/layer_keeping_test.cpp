// What comes of layers when everything else is done to a model: they stay whole, in history and files, too.
#include "core/base/parallel.h"
#include "core/base/plane.h"
#include "core/base/random.h"
#include "layered.h"
#include "support/registry.h"

#include <QFile>
#include <QTest>

using base::Vec3d, base::Vec3f;
using test::Workbench, test::json;
using namespace test::layered;

class LayerKeepingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void movedOrTurnedOverTheyStayWhole_data();
    void movedOrTurnedOverTheyStayWhole();
    void turningNormalsOverKeepsWhatLayersHold_data();
    void turningNormalsOverKeepsWhatLayersHold();
    void mirroringMirrorsWhatLayersHold_data();
    void mirroringMirrorsWhatLayersHold();
    void aNewLayerAdoptsNoWordsThatStandThere();
    void layersOfAnotherModelStayBehind();
    void historyFilesAndJournalsKeepThem();
    void modelsWithoutLayersKnowNothingOfThem();
    void filesThatLackTheirWordsOpenWithoutLayers();
    void whatTakesNoStrokesRefusesThem();
    void nonsenseIsRefused_data();
    void nonsenseIsRefused();
};

void LayerKeepingTest::movedOrTurnedOverTheyStayWhole_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {R"({"op":"flip"})", R"({"op":"transform","mirror":[1,0,0,0]})", R"({"op":"transform","stretch":[1,2,0.5]})",
          R"({"op":"up","axis":"z"})", R"({"op":"cut","plane":"0,0,1,-0.2"})", R"({"op":"denoise"})",
          R"({"op":"primitive","shape":"ball","size":"0.3","position":"0,0,1","operation":"union"})",
          R"({"op":"surface","frame":"covariance"})", R"({"op":"colour","colour":[1,2,3]})",
          R"({"op":"mirror","plane":"1,0,0,0"})", R"({"op":"hollow","thickness":0.2})",
          R"({"op":"resample","count":2000})"})
        QTest::newRow(line) << line;
}

void LayerKeepingTest::movedOrTurnedOverTheyStayWhole() {
    QFETCH(QString, line);
    Workbench bench;
    bench.run(test::newSphere(6000));
    bench.run(layer("add"));
    bench.run(stroke("draw", 0, true));
    bench.run(layer("add"));
    bench.run(stroke("grab", 0, true));
    const std::string before = bench.hash();
    bench.run(json::parse(line.toStdString()));
    QVERIFY(bench.document.layers().empty() || isWhole(bench));
    if (!bench.document.layers().empty()) {
        bench.run(layer("hide", {{"name", "Layer 1"}}));
        bench.run(layer("hide", {{"name", "Layer 2"}}));
        bench.document.surface().tree().validate();
        bench.run({{"op", "undo"}});
        bench.run({{"op", "undo"}});
    }
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
    QCOMPARE(bench.document.layers().layers.size(), std::size_t(2));
}

void LayerKeepingTest::turningNormalsOverKeepsWhatLayersHold_data() {
    QTest::addColumn<QString>("line");
    for (const char* line : {R"({"op":"flip"})", R"({"op":"orient","method":"viewpoint","viewpoint":[0,0,0]})",
                             R"({"op":"normals"})", R"({"op":"clean","normals":"plane"})"})
        QTest::newRow(line) << line;
}

void LayerKeepingTest::turningNormalsOverKeepsWhatLayersHold() {
    QFETCH(QString, line);
    Workbench bench;
    bench.run(test::newSphere(6000));
    const surfel::SurfelList base = surfels(bench);
    bench.run(layer("add"));
    bench.run(stroke("draw", 0, false));
    QVERIFY(farthest(base, surfels(bench)) > 0.05);
    bench.run(json::parse(line.toStdString()));
    QVERIFY(isWhole(bench));
    bench.run(strength(0));
    QVERIFY(offSphere(surfels(bench)) < 1e-4);
}

/// Greatest distance of the mirror image of a surfel from the nearest surfel.
static double asymmetry(const surfel::SurfelList& list, const base::Plane& plane) {
    double out = 0;
    for (const surfel::Surfel& each : list.items) {
        const Vec3d p = base::cast<double>(each.position);
        const Vec3f image = base::cast<float>(p - plane.normal * (2 * plane.distance(p)));
        float nearest = 1e9f;
        for (const surfel::Surfel& other : list.items)
            nearest = std::min(nearest, distanceSq(other.position, image));
        out = std::max(out, std::sqrt(double(nearest)));
    }
    return out;
}

static surfel::SurfelList aboveOf(const Workbench& bench, const base::Plane& plane) {
    surfel::SurfelList out;
    for (const surfel::Surfel& each : surfels(bench).items)
        if (plane.distance(base::cast<double>(each.position)) >= 0)
            out.items.push_back(each);
    return out;
}

void LayerKeepingTest::mirroringMirrorsWhatLayersHold_data() {
    QTest::addColumn<bool>("across");
    QTest::newRow("a stroke over the plane") << true;
    QTest::newRow("a stroke beside it") << false;
}

void LayerKeepingTest::mirroringMirrorsWhatLayersHold() {
    QFETCH(bool, across);
    Workbench bench;
    base::Random random(test::seed());
    const auto some = [&] { return 0.2 * random.uniform() - 0.1; };
    const base::Plane plane{base::normalized(Vec3d{some(), across ? some() : 1.0, across ? 1e-3 : some()} +
                                             Vec3d{across ? 1.0 : 0.0, 0, 0}),
                            across ? some() : -0.4};
    bench.run(test::newSphere(3000));
    for (const char* tool : {"draw", "grab"}) {
        bench.run(layer("add"));
        bench.run(stroke(tool, 0, true));
    }
    const auto show = [&](double first, double second) {
        bench.run(layer("strength", {{"name", "Layer 1"}, {"strength", first}}));
        bench.run(layer("strength", {{"name", "Layer 2"}, {"strength", second}}));
    };
    show(0, 0);
    const double leftBefore = offSphere(aboveOf(bench, plane)); // by resampling (layers/README 4)
    show(1, 1);
    std::ostringstream text;
    text.precision(17);
    text << plane.normal.x << ',' << plane.normal.y << ',' << plane.normal.z << ',' << plane.offset;
    bench.run({{"op", "mirror"}, {"plane", text.str()}});
    QCOMPARE(bench.document.layers().layers.size(), std::size_t(2));
    QVERIFY(offSphere(surfels(bench)) > 0.05);
    for (const auto& [first, second] : {std::pair{1.0, 1.0}, {0.5, -1.0}, {0.0, 1.0}, {0.0, 0.0}}) {
        show(first, second);
        QVERIFY(isWhole(bench));
        const double off = asymmetry(surfels(bench), plane);
        QVERIFY2(off < 2e-5,
                 qPrintable(QString("%1 at %2, %3, seed %4").arg(off).arg(first).arg(second).arg(test::seed())));
    }
    // what was dragged over the plane cannot go back over it
    const double left = offSphere(aboveOf(bench, plane));
    QVERIFY2(across || left < leftBefore + 0.1 * spacing(bench),
             qPrintable(QString("%1, before %2, seed %3").arg(left).arg(leftBefore).arg(test::seed())));
}

void LayerKeepingTest::aNewLayerAdoptsNoWordsThatStandThere() {
    Workbench bench;
    bench.run(test::newSphere(3000));
    bench.run(layer("add"));
    bench.run(stroke("draw", 0, false));
    bench.run({{"op", "save"}, {"path", bench.path("some.ply").string()}});
    QFile file(QString::fromStdString(bench.path("some.ply").string()));
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray bytes = file.readAll();
    bytes.replace("pointclay-layer", "pointclay-loser"); // another program left the comment out
    file.resize(0), file.seek(0);
    QCOMPARE(file.write(bytes), bytes.size());
    file.close();
    bench.run({{"op", "open"}, {"path", bench.path("some.ply").string()}});
    QVERIFY(bench.document.layers().empty());
    const surfel::SurfelList before = surfels(bench);
    bench.run(layer("add"));
    QVERIFY(isWhole(bench));
    bench.run(strength(0.5));
    QCOMPARE(farthest(before, surfels(bench)), 0.0);
}

/// They have the same numbers, and nothing else to do with ours.
void LayerKeepingTest::layersOfAnotherModelStayBehind() {
    Workbench other, bench;
    other.run(test::newSphere());
    other.run({{"op", "transform"}, {"move", {5, 0, 0}}});
    other.run(layer("add"));
    other.run({{"op", "inflate"}, {"length", 0.1}});
    other.run({{"op", "save"}, {"path", bench.path("other.ply").string()}});
    bench.run(test::newSphere());
    bench.run(layer("add"));
    bench.run({{"op", "solid"}, {"path", bench.path("other.ply").string()}});
    QVERIFY(isWhole(bench));
    const surfel::SurfelList before = surfels(bench);
    QVERIFY(before.size() > 5000);
    bench.run(strength(0));
    QCOMPARE(farthest(before, surfels(bench)), 0.0);
}

void LayerKeepingTest::historyFilesAndJournalsKeepThem() {
    Workbench bench;
    session::Journal journal(bench.path("journal.jsonl"));
    bench.context.journal = &journal;
    std::vector<std::string> hashes;
    std::vector<json> lines{test::newSphere(),
                            layer("add", {{"name", "Wrinkles and pores"}}),
                            stroke("draw", 0, true),
                            strength(0.25),
                            layer("add"),
                            stroke("grab", 0.1, true),
                            layer("move", {{"place", 1}}),
                            layer("rename", {{"to", "form"}}),
                            layer("mask", {{"from", "nothing"}}),
                            layer("base"),
                            stroke("clay", -0.1, true),
                            layer("hide", {{"name", "form"}})};
    for (const json& line : lines) {
        bench.run(line);
        hashes.push_back(bench.hash());
    }
    bench.run({{"op", "save"}, {"path", bench.path("model.ply").string()}});
    Workbench opened;
    opened.run({{"op", "open"}, {"path", bench.path("model.ply").string()}, {"hash", hashes.back()}});
    QCOMPARE(opened.hash(), hashes.back());
    QVERIFY(opened.document.layers() == bench.document.layers());
    for (Workbench* each : {&bench, &opened}) { // goes on alike
        each->run(stroke("draw", 0.2, true));
        each->run(layer("show", {{"name", "form"}}));
    }
    QCOMPARE(opened.hash(), bench.hash());
    const std::string last = bench.hash();
    bench.run({{"op", "undo"}});
    bench.run({{"op", "undo"}});
    for (std::size_t k = hashes.size() - 1; k > 0; --k) {
        QCOMPARE(bench.hash(), hashes[k]);
        if (lines[k].value("from", "") != "nothing") // which changed nothing
            bench.run({{"op", "undo"}});
    }
    while (bench.document.canRedo())
        bench.run({{"op", "redo"}});
    QCOMPARE(bench.hash(), last);
    bench.context.journal = nullptr;
    journal.end(bench.context);
    Workbench recovered;
    session::recover(bench.path("journal.jsonl"), recovered.context);
    QCOMPARE(recovered.hash(), last);
}

void LayerKeepingTest::modelsWithoutLayersKnowNothingOfThem() {
    Workbench bench, other;
    bench.run(test::newSphere());
    bench.run(stroke("draw", 0, true));
    QCOMPARE(bench.document.surface().tree().layout()->words(), std::size_t(0));
    QVERIFY(bench.document.fileModel().comments.empty());
    other.run(test::newSphere());
    other.run(layer("add"));
    other.run(layer("remove"));
    other.run(stroke("draw", 0, true));
    QCOMPARE(other.hash(), bench.hash());
}

void LayerKeepingTest::filesThatLackTheirWordsOpenWithoutLayers() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run({{"op", "save"}, {"path", bench.path("plain.ply").string()}});
    std::string file = test::contentOf(bench.path("plain.ply"));
    file.insert(file.find("element vertex"), "comment pointclay-layer 1 strength 1 visible 1 active 1 name lost\n");
    test::write(bench.path("lost.ply"), file);
    const std::string before = bench.hash();
    bench.run({{"op", "open"}, {"path", bench.path("lost.ply").string()}});
    QCOMPARE(bench.hash(), before);
    QVERIFY(bench.document.layers().empty());
    QVERIFY(!bench.context.messages.empty() && bench.context.messages.back().find("layers") != std::string::npos);
}

void LayerKeepingTest::whatTakesNoStrokesRefusesThem() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(layer("add", {{"name", "faint"}}));
    bench.run(strength(0.01));
    QVERIFY(bench.refusal(stroke("draw", 0, true)).find("faint") != std::string::npos);
    bench.run(strength(1));
    bench.run(layer("hide"));
    QVERIFY(!bench.refusal(stroke("draw", 0, true)).empty());
    bench.run(layer("base"));
    QVERIFY(bench.refusal(stroke("draw", 0, true)).empty());
}

void LayerKeepingTest::nonsenseIsRefused_data() {
    QTest::addColumn<QString>("line");
    for (const char* line : {R"({"op":"layer","do":"strength"})", R"({"op":"layer","do":"strength","strength":2.5})",
                             R"({"op":"layer","do":"add","name":"one"})", R"({"op":"layer","do":"add","name":" x"})",
                             R"({"op":"layer","do":"hide","name":"nobody"})", R"({"op":"layer","do":"move"})",
                             R"({"op":"layer","do":"move","place":3})", R"({"op":"layer","do":"rename"})",
                             R"({"op":"layer","do":"rename","name":"two","to":"one"})", R"({"op":"layer"})",
                             R"({"op":"layer","do":"melt"})"})
        QTest::newRow(line) << line;
}

void LayerKeepingTest::nonsenseIsRefused() {
    QFETCH(QString, line);
    Workbench bench;
    bench.run(test::newSphere(1000));
    QVERIFY(!bench.refusal({{"op", "layer"}, {"do", "remove"}}).empty());
    bench.run(layer("add", {{"name", "one"}}));
    bench.run(layer("add", {{"name", "two"}}));
    const std::string before = bench.hash();
    QVERIFY(!bench.refusal(json::parse(line.toStdString())).empty());
    QCOMPARE(bench.hash(), before);
}

static const test::Registered<LayerKeepingTest> registered;
#include "layer_keeping_test.moc"
