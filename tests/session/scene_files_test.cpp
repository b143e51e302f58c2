// Scenes in files and journals: what is read back is the scene that was written, wherever its models stand.
#include "core/session/scene/shown_scene.h"
#include "scenes.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using session::SceneModel;
using test::Workbench, test::json;
using namespace test::scenes;

class SceneFilesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void sceneFilesHoldEverything();
    void savingWritesOverItsOwnFilesAlone();
    void otherFormatsHoldWhatIsShown();
    void onePlyHoldsAllWhereTheyStand();
    void attributesOfEachComeBackFromOnePly();
    void farModelsKeepTheirPlaces();
    void journalsBringScenesBack();
    void scansStandAsTheirPosesSay();
    void sceneFilesThatAreNoneAreRefused_data();
    void sceneFilesThatAreNoneAreRefused();
};

void SceneFilesTest::sceneFilesHoldEverything() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    bench.run({{"op", "layer"}, {"do", "add"}});
    bench.run(test::strokeAt(0));
    bench.run(scene("duplicate", {{"to", "twin/..\\:2"}, {"matrix", randomPose(random)}}));
    bench.run(scene("hide", {{"name", "ring"}}));
    bench.run(scene("lock", {{"name", "ball"}}));
    bench.run({{"op", "save"}, {"path", bench.path("all.scene.json").string()}});
    QVERIFY(!bench.document.modified());
    Workbench again;
    again.run({{"op", "open"}, {"path", bench.path("all.scene.json").string()}});
    QCOMPARE(again.hash(), bench.hash());
    QCOMPARE(again.document.scene().active, bench.document.scene().active);
    QVERIFY(!again.document.canUndo() && !again.document.modified());
    QCOMPARE(again.document.path().string(), bench.path("all.scene.json").string());
    QVERIFY(!model(again, "ring").visible && model(again, "ball").locked);
    QCOMPARE(model(again, "ball").layers.layers.size(), std::size_t(1));
}

void SceneFilesTest::savingWritesOverItsOwnFilesAlone() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    test::write(bench.path("all.ring.ply"), "somebody's");
    const json save{{"op", "save"}, {"path", bench.path("all.scene.json").string()}};
    bench.run(save);
    bench.run(test::strokeAt(0));
    bench.run(save);
    QCOMPARE(test::contentOf(bench.path("all.ring.ply")), std::string("somebody's"));
    QVERIFY(std::filesystem::exists(bench.path("all.ring-2.ply")));
    QVERIFY(!std::filesystem::exists(bench.path("all.ring-3.ply")) &&
            !std::filesystem::exists(bench.path("all.ball-2.ply")));
    Workbench again;
    again.run({{"op", "open"}, {"path", bench.path("all.scene.json").string()}});
    QCOMPARE(again.hash(), bench.hash());
}

void SceneFilesTest::otherFormatsHoldWhatIsShown() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    bench.run(scene("add", {{"sample", "knot:3000"}}));
    bench.run(scene("hide", {{"name", "ring"}}));
    bench.context.messages.clear();
    bench.run({{"op", "save"}, {"path", bench.path("all.xyz").string()}});
    std::string said;
    for (const std::string& each : bench.context.messages)
        said += each + "\n";
    QVERIFY2(said.find("one cloud") != std::string::npos && said.find("hidden") != std::string::npos, said.c_str());
    Workbench again;
    again.run({{"op", "open"}, {"path", bench.path("all.xyz").string()}});
    QCOMPARE(again.size(), model(bench, "ball").surface.tree().size() + model(bench, "knot").surface.tree().size());
}

void SceneFilesTest::onePlyHoldsAllWhereTheyStand() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    bench.run(scene("hide", {{"name", "ring"}}));
    const std::vector<Vec3d> ball = placesOf(model(bench, "ball")), ring = placesOf(model(bench, "ring"));
    bench.run({{"op", "save"}, {"path", bench.path("all.ply").string()}});
    QVERIFY(!bench.document.modified());
    Workbench again;
    again.run({{"op", "open"}, {"path", bench.path("all.ply").string()}});
    QCOMPARE(again.document.scene().models.size(), std::size_t(2));
    QVERIFY(apart(placesOf(model(again, "ball")), ball) < 1e-6);
    QVERIFY(apart(placesOf(model(again, "ring")), ring) < 1e-6);
    QVERIFY(!model(again, "ring").visible);
    const std::string hash = again.hash();
    again.run({{"op", "save"}, {"path", bench.path("twice.ply").string()}});
    again.run({{"op", "open"}, {"path", bench.path("twice.ply").string()}});
    QCOMPARE(again.hash(), hash);
    bench.run({{"op", "layer"}, {"do", "add"}});
    QVERIFY(bench.refusal({{"op", "save"}, {"path", bench.path("all.ply").string()}}).find(".scene.json") !=
            std::string::npos);
}

void SceneFilesTest::attributesOfEachComeBackFromOnePly() {
    Workbench bench;
    test::write(bench.path("a.xyz"), [] {
        std::string out = "x,y,z,nx,ny,nz,heat,part\n";
        for (int k = 0; k < 400; ++k)
            out += std::to_string(0.1 * (k % 20)) + "," + std::to_string(0.1 * (k / 20)) + ",0,0,0,1," +
                   std::to_string(k) + "," + std::to_string(k % 7) + "\n";
        return out;
    }());
    bench.run(test::newSphere(1000));
    bench.run(test::strokeAt(0, "paint"));
    bench.run(scene("add", {{"path", bench.path("a.xyz").string()}, {"name", "sheet"}}));
    bench.run({{"op", "save"}, {"path", bench.path("all.ply").string()}});
    Workbench again;
    again.run({{"op", "open"}, {"path", bench.path("all.ply").string()}});
    for (const SceneModel& each : bench.document.scene().models) {
        const SceneModel& back = model(again, each.name.c_str());
        std::vector<std::string> names = each.surface.tree().layout()->names(),
                                 found = back.surface.tree().layout()->names();
        std::erase(names, "part"); // the file's own word for whose a surfel is
        std::erase(found, "part");
        QCOMPARE(found, names);
        QCOMPARE(back.surface.tree().size(), each.surface.tree().size());
    }
    double sum = 0;
    const surfel::SurfelList sheet = model(again, "sheet").surface.tree().surfels();
    for (std::size_t i = 0; i < sheet.size(); ++i)
        sum += surfel::read(*sheet.layout->find("heat"), sheet.extraOf(i));
    QCOMPARE(sum, 399.0 * 400 / 2);
}

void SceneFilesTest::farModelsKeepTheirPlaces() {
    Workbench bench;
    base::Random random(test::seed());
    const Vec3d far{1e7, 2e7, 300};
    std::string text;
    for (int k = 0; k < 900; ++k) {
        char line[96];
        std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", far.x + 0.125 * (k % 30), far.y + 0.125 * (k / 30),
                      far.z + 0.25 * random.uniform(0, 1));
        text += line;
    }
    test::write(bench.path("far.xyz"), text);
    bench.run({{"op", "open"}, {"path", bench.path("far.xyz").string()}});
    bench.run(scene("duplicate", {{"to", "beside"}}));
    bench.run(scene("move", {{"move", {4, 0, 0}}, {"axis", {0, 0, 1}}, {"angle", 45}}));
    const std::vector<Vec3d> places = allPlaces(bench);
    session::ShownScene shown; // in the coordinates of "beside"
    const auto& seen = shown.beside(bench.document.scene());
    QCOMPARE(seen.size(), std::size_t(1));
    const SceneModel& active = model(bench, "beside");
    const SceneModel& other = model(bench, "far");
    const auto there = seen.front().surface.tree().surfels();
    const auto own = other.surface.tree().surfels();
    for (std::size_t i = 0; i < own.size(); ++i) {
        const Vec3d wanted = other.pose(base::cast<double>(own.items[i].position) + other.origin()),
                    found = active.pose(base::cast<double>(there.items[i].position) + active.origin());
        QVERIFY(distance(wanted, found) < 1e-5);
    }
    bench.run({{"op", "save"}, {"path", bench.path("all.ply").string()}});
    Workbench again;
    again.run({{"op", "open"}, {"path", bench.path("all.ply").string()}});
    QVERIFY(apart(allPlaces(again), places) < 1e-5);
}

/// That a crash would lose, as a person is told.
static int commandsIn(const Workbench& bench) {
    std::filesystem::copy_file(bench.path("j.jsonl"), bench.path("journal-1.jsonl"),
                               std::filesystem::copy_options::overwrite_existing);
    const auto left = session::findLeftJournals(bench.path("j.jsonl").parent_path());
    return left.empty() ? -1 : left.front().commands;
}

void SceneFilesTest::journalsBringScenesBack() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    bench.run({{"op", "save"}, {"path", bench.path("all.scene.json").string()}});
    std::string hash;
    {
        session::Journal journal(bench.path("j.jsonl"));
        Workbench used;
        used.context.journal = &journal;
        used.run({{"op", "open"}, {"path", bench.path("all.scene.json").string()}});
        QCOMPARE(commandsIn(bench), 0); // opening loses nothing
        used.run(test::strokeAt(0));
        QCOMPARE(commandsIn(bench), 1);
        used.run(scene("add", {{"path", bench.path("ring.ply").string()}, {"name", "third"}}));
        used.run(test::strokeAt(0.1));
        used.run({{"op", "save"}, {"path", bench.path("all.scene.json").string()}}); // over what the journal reads
        used.run(scene("remove", {{"name", "ring"}}));
        used.run({{"op", "save"}, {"path", bench.path("ring.ply").string()}, {"part", "model"}});
        used.run({{"op", "undo"}});
        hash = used.hash();
        journal.copyTo(bench.path("session.jsonl"));
    }
    Workbench back, again;
    session::replay(bench.path("session.jsonl"), again.context);
    QCOMPARE(again.hash(), hash);
    session::recover(bench.path("j.jsonl"), back.context);
    QCOMPARE(back.hash(), hash);
}

void SceneFilesTest::scansStandAsTheirPosesSay() {
    Workbench bench;
    bench.run(test::newSphere(1000));
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    const std::vector<Vec3d> own = allPlaces(bench);
    // A quarter turn about z, whose transpose takes (x, y) to (y, -x); lengths of quaternions do not count.
    test::write(bench.path("scans.conf"), "camera 1 2 3\n\nbmesh a.ply 0 0 0 0 0 0 1\r\n"
                                          "bmesh  a.ply\t1 2 3 0 0 2 2\n");
    bench.run({{"op", "open"}, {"path", bench.path("scans.conf").string()}});
    QCOMPARE(bench.document.scene().models.size(), std::size_t(2));
    QCOMPARE(apart(placesOf(model(bench, "a")), own), 0.0);
    const std::vector<Vec3d> turned = placesOf(model(bench, "a 2"));
    for (std::size_t i = 0; i < own.size(); ++i)
        QVERIFY(distance(turned[i], Vec3d{own[i].y + 1, -own[i].x + 2, own[i].z + 3}) < 1e-12);
    for (const char* wrong : {"", "camera 1 2 3\n", "bmesh a.ply 0 0 0 0 0 0\n", "bmesh a.ply 0 0 0 0 0 0 0\n",
                              "bmesh a.ply 0 0 0 0 0 x 1\n", "bmesh none.ply 0 0 0 0 0 0 1\n"}) {
        test::write(bench.path("wrong.conf"), wrong);
        QVERIFY2(!bench.refusal({{"op", "open"}, {"path", bench.path("wrong.conf").string()}}).empty(), wrong);
    }
}

void SceneFilesTest::sceneFilesThatAreNoneAreRefused_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("told");
    const char* one = R"({"name":"a","file":"ring.ply")";
    QTest::newRow("empty") << ""
                           << "scene.json";
    QTest::newRow("no JSON") << "ply"
                             << "scene.json";
    QTest::newRow("a list") << "[]"
                            << "is no scene";
    QTest::newRow("later version") << R"({"pointclay-scene":2,"models":[]})"
                                   << "is no scene";
    QTest::newRow("no models") << R"({"pointclay-scene":1,"models":[]})"
                               << "no models";
    QTest::newRow("models that are none") << R"({"pointclay-scene":1,"models":[1]})"
                                          << "no models";
    QTest::newRow("no file") << R"({"pointclay-scene":1,"models":[{"name":"a"}]})"
                             << "\"file\"";
    QTest::newRow("file is a number") << R"({"pointclay-scene":1,"models":[{"name":"a","file":3}]})"
                                      << "\"file\"";
    QTest::newRow("missing file") << R"({"pointclay-scene":1,"models":[{"name":"a","file":"none.ply"}]})"
                                  << "none.ply";
    QTest::newRow("twice") << QString(R"({"pointclay-scene":1,"models":[%1},%1}]})").arg(one) << "two models";
    QTest::newRow("bad name") << R"({"pointclay-scene":1,"models":[{"name":" a","file":"ring.ply"}]})"
                              << "no name";
    QTest::newRow("stretching pose")
        << QString(R"({"pointclay-scene":1,"models":[%1,"matrix":[2,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}]})").arg(one)
        << "only turns and moves";
    QTest::newRow("short pose") << QString(R"({"pointclay-scene":1,"models":[%1,"matrix":[1]}]})").arg(one) << "16";
    QTest::newRow("active is none") << QString(R"({"pointclay-scene":1,"active":"b","models":[%1}]})").arg(one)
                                    << "active";
    QTest::newRow("itself") << R"({"pointclay-scene":1,"models":[{"name":"a","file":"bad.scene.json"}]})"
                            << "a scene itself";
}

void SceneFilesTest::sceneFilesThatAreNoneAreRefused() {
    QFETCH(QString, text);
    QFETCH(QString, told);
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    const std::string hash = bench.hash();
    test::write(bench.path("bad.scene.json"), text.toStdString());
    const std::string said = bench.refusal({{"op", "open"}, {"path", bench.path("bad.scene.json").string()}});
    QVERIFY2(QString::fromStdString(said).contains(told), said.c_str());
    QCOMPARE(bench.hash(), hash);
}

static const test::Registered<SceneFilesTest> registered;
#include "scene_files_test.moc"
