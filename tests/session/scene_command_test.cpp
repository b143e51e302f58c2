// Several models in one document: commands change the active one alone, history is one, and files hold them all.
#include "core/base/random.h"
#include "core/session/shown_scene.h"
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using base::Vec3d, base::Vec3f;
using session::Scene, session::SceneModel;
using test::Workbench, test::json;

class SceneCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void commandsChangeTheActiveModelAlone();
    void historyIsOneOfAllModels();
    void whatIsLockedOrHiddenIsNotChanged();
    void posesMoveNoSurfel();
    void appliedPosesLeaveEverythingWhereItWas();
    void sceneFilesHoldEverything();
    void savingWritesOverItsOwnFilesAlone();
    void otherFormatsHoldWhatIsShown();
    void onePlyHoldsAllWhereTheyStand();
    void attributesOfEachComeBackFromOnePly();
    void farModelsKeepTheirPlaces();
    void splittingAndJoiningKeepEverySurfel();
    void eachValueBecomesAModel();
    void joinedCellsKeepApart();
    void solidsOfTheSceneAreThoseOfFiles();
    void registeringMovesPosesAlone();
    void journalsBringScenesBack();
    void scansStandAsTheirPosesSay();
    void sceneFilesThatAreNoneAreRefused_data();
    void sceneFilesThatAreNoneAreRefused();
    void shownModelsStandWhereTheirPosesSay();
};

static json scene(const char* what, const json& more = json::object()) {
    json out{{"op", "scene"}, {"do", what}};
    out.update(more);
    return out;
}

static const SceneModel& model(const Workbench& bench, const char* name) {
    const Scene& all = bench.document.scene();
    const int index = all.indexOf(std::string_view(name));
    if (index < 0)
        throw std::logic_error(name);
    return all.models[static_cast<std::size_t>(index)];
}

static json randomPose(base::Random& random, double reach = 2) {
    const process::Rigid turned = process::motionOf(
        {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)},
        {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)});
    return session::matrixOf(turned);
}

/// "ball", which is active, and "ring", somewhere.
static void makeScene(Workbench& bench, base::Random& random) {
    bench.run({{"op", "new"}, {"sample", "torus"}, {"count", 2500}});
    bench.run({{"op", "save"}, {"path", bench.path("ring.ply").string()}});
    bench.run(test::newSphere(2000));
    bench.run(scene("rename", {{"to", "ball"}}));
    bench.run(scene("add", {{"path", bench.path("ring.ply").string()}, {"matrix", randomPose(random)}}));
    bench.run(scene("activate", {{"name", "ball"}}));
}

/// Where each surfel stands in the scene.
static std::vector<Vec3d> placesOf(const SceneModel& model) {
    std::vector<Vec3d> out;
    for (const surfel::Surfel& s : model.surface.tree().surfels().items)
        out.push_back(model.pose(base::cast<double>(s.position) + model.origin()));
    return out;
}

/// Greatest distance of any place from the nearest of the others, both ways.
static double apart(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
    double out = a.size() == b.size() ? 0 : 1e30;
    const auto reach = [&out](const std::vector<Vec3d>& from, const std::vector<Vec3d>& to) {
        for (const Vec3d& x : from) {
            double least = 1e30;
            for (const Vec3d& y : to)
                least = std::min(least, distance(x, y));
            out = std::max(out, least);
        }
    };
    reach(a, b);
    reach(b, a);
    return out;
}

static std::vector<Vec3d> allPlaces(const Workbench& bench) {
    std::vector<Vec3d> out;
    for (const SceneModel& each : bench.document.scene().models) {
        const std::vector<Vec3d> own = placesOf(each);
        out.insert(out.end(), own.begin(), own.end());
    }
    return out;
}

void SceneCommandTest::commandsChangeTheActiveModelAlone() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    const SceneModel ring = model(bench, "ring"), ball = model(bench, "ball");
    bench.run(test::strokeAt(0));
    bench.run({{"op", "smooth"}});
    QVERIFY(model(bench, "ring").surface.tree() == ring.surface.tree());
    QVERIFY(!(model(bench, "ball").surface.tree() == ball.surface.tree()));
    bench.run(scene("activate", {{"name", "ring"}}));
    const tree::SurfelTree sculpted = model(bench, "ball").surface.tree();
    bench.run({{"op", "flip"}});
    QVERIFY(model(bench, "ball").surface.tree() == sculpted);
    QVERIFY(!(model(bench, "ring").surface.tree() == ring.surface.tree()));
}

void SceneCommandTest::historyIsOneOfAllModels() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    std::vector<std::string> hashes{bench.hash()};
    const std::vector<json> steps{test::strokeAt(0),
                                  scene("duplicate", {{"to", "twin"}}),
                                  scene("move", {{"move", {0.5, 0, 0}}, {"axis", {0, 1, 1}}, {"angle", 33}}),
                                  scene("hide", {{"name", "ring"}}),
                                  scene("activate", {{"name", "ball"}}),
                                  {{"op", "inflate"}, {"length", 0.02}},
                                  scene("remove", {{"name", "twin"}}),
                                  scene("rename", {{"name", "ring"}, {"to", "wheel"}})};
    for (const json& each : steps) {
        bench.run(each);
        hashes.push_back(bench.hash());
    }
    for (std::size_t k = steps.size(); k-- > 0;) {
        bench.run({{"op", "undo"}});
        QCOMPARE(bench.hash(), hashes[k]);
    }
    for (std::size_t k = 1; k <= steps.size(); ++k) {
        bench.run({{"op", "redo"}});
        QCOMPARE(bench.hash(), hashes[k]);
    }
    QVERIFY(bench.document.historyBytes() < 40u * 2000u * 100u); // what models share is counted once
}

void SceneCommandTest::whatIsLockedOrHiddenIsNotChanged() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    for (const auto& [close, open] : {std::pair{"lock", "unlock"}, {"hide", "show"}}) {
        bench.run(scene(close));
        const std::string hash = bench.hash();
        for (const json& each : {test::strokeAt(0), json{{"op", "smooth"}}, json{{"op", "flip"}},
                                 json{{"op", "surface"}, {"neighbours", 24}}})
            QVERIFY2(QString::fromStdString(bench.refusal(each)).contains(open), each.dump().c_str());
        QCOMPARE(bench.hash(), hash);
        bench.run(scene(open));
        bench.run(test::strokeAt(0));
        QVERIFY(bench.hash() != hash);
    }
    bench.run(scene("lock", {{"name", "ring"}}));
    for (const char* what : {"remove", "move", "place"})
        QVERIFY(!bench.refusal(scene(what, {{"name", "ring"}, {"matrix", randomPose(random)}})).empty());
    bench.run({{"op", "undo"}}); // the lock itself goes back
    QVERIFY(!model(bench, "ring").locked);
}

void SceneCommandTest::posesMoveNoSurfel() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    const tree::SurfelTree before = model(bench, "ring").surface.tree();
    const std::vector<Vec3d> places = placesOf(model(bench, "ring"));
    bench.run(scene("move",
                    {{"name", "ring"}, {"move", {1, 2, 3}}, {"axis", {0, 0, 1}}, {"angle", 90}, {"about", {1, 0, 0}}}));
    QVERIFY(model(bench, "ring").surface.tree() == before);
    const std::vector<Vec3d> moved = placesOf(model(bench, "ring"));
    for (std::size_t i = 0; i < places.size(); ++i) { // (x, y) - (1, 0) turned by 90 degrees, then moved
        const Vec3d wanted{1 - places[i].y + 1, places[i].x - 1 + 2, places[i].z + 3};
        QVERIFY(distance(moved[i], wanted) < 1e-12);
    }
    json mirror = session::matrixOf({});
    mirror[0] = -1;
    json larger = session::matrixOf({});
    larger[5] = 1.01;
    for (const json& matrix : {mirror, larger})
        QVERIFY(!bench.refusal(scene("place", {{"matrix", matrix}})).empty());
}

void SceneCommandTest::appliedPosesLeaveEverythingWhereItWas() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    const std::vector<Vec3d> places = placesOf(model(bench, "ring"));
    bench.run(scene("apply", {{"name", "ring"}}));
    QVERIFY(session::isNothing(model(bench, "ring").pose));
    QVERIFY(apart(placesOf(model(bench, "ring")), places) < 1e-6);
    bench.run({{"op", "undo"}});
    QVERIFY(!session::isNothing(model(bench, "ring").pose));
}

void SceneCommandTest::sceneFilesHoldEverything() {
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

void SceneCommandTest::savingWritesOverItsOwnFilesAlone() {
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

void SceneCommandTest::otherFormatsHoldWhatIsShown() {
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

void SceneCommandTest::onePlyHoldsAllWhereTheyStand() {
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

void SceneCommandTest::attributesOfEachComeBackFromOnePly() {
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

void SceneCommandTest::farModelsKeepTheirPlaces() {
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

void SceneCommandTest::splittingAndJoiningKeepEverySurfel() {
    Workbench bench;
    bench.run(test::newSphere(3000));
    const std::vector<Vec3d> before = allPlaces(bench);
    const std::string hash = bench.hash();
    bench.run({{"op", "select"}, {"by", "ball"}, {"at", {0, 1, 0}}, {"radius", 0.7}});
    bench.run(scene("split", {{"to", "cap"}}));
    const std::size_t cap = model(bench, "cap").surface.tree().size();
    QVERIFY(cap > 200 && cap < 1500);
    QCOMPARE(bench.size() + cap, before.size());
    QVERIFY(std::isfinite(model(bench, "cap").surface.definition().boundaryLimit)); // it has a rim
    bench.run(scene("join"));
    QCOMPARE(bench.document.scene().models.size(), std::size_t(1));
    QCOMPARE(apart(allPlaces(bench), before), 0.0);
    QVERIFY(!std::isfinite(bench.document.surface().definition().boundaryLimit)); // and none once it is whole
    for (int k = 0; k < 3; ++k)
        bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), hash);
}

void SceneCommandTest::eachValueBecomesAModel() {
    Workbench bench;
    base::Random random(test::seed());
    std::string text = "x,y,z,nx,ny,nz,scan\n";
    std::map<int, std::size_t> counts;
    for (int k = 0; k < 4000; ++k) { // three balls in any order
        const int scan = static_cast<int>(random.uniform(0, 3));
        const Vec3d n = random.unitVector();
        ++counts[scan];
        for (const double v : {n.x + 3 * scan, n.y, n.z, n.x, n.y, n.z})
            text += std::to_string(v) + ",";
        text += std::to_string(5 * scan) + "\n";
    }
    test::write(bench.path("balls.csv"), text);
    bench.run({{"op", "open"}, {"path", bench.path("balls.csv").string()}});
    const std::vector<Vec3d> before = allPlaces(bench);
    bench.run(scene("split", {{"by", "scan"}}));
    const auto& models = bench.document.scene().models;
    QCOMPARE(models.size(), std::size_t(3));
    for (std::size_t k = 0; k < 3; ++k)
        QCOMPARE(models[k].surface.tree().size(), counts[static_cast<int>(k)]);
    QCOMPARE(apart(allPlaces(bench), before), 0.0);
    for (const char* wrong : {"none", "scan"})
        QVERIFY(!bench.refusal(scene("split", {{"by", wrong}})).empty());
}

void SceneCommandTest::joinedCellsKeepApart() {
    Workbench bench;
    bench.run({{"op", "new"}, {"sample", "sphere"}, {"count", 2000}});
    bench.run({{"op", "cut"}, {"plane", "0,1,0,0.3"}, {"keep", "below"}, {"cap", true}});
    bench.run(scene("duplicate", {{"matrix", session::matrixOf({base::Mat3d::identity(), {3, 0, 0}})}}));
    bench.run(scene("join"));
    const tree::SurfelTree tree = bench.document.surface().tree();
    const auto layout = tree.layout();
    QVERIFY(layout->find("cell"));
    std::map<double, int> sides; // of each cell: where its surfels are
    const surfel::SurfelList list = tree.surfels();
    for (std::size_t i = 0; i < list.size(); ++i)
        sides[surfel::read(*layout->find("cell"), list.extraOf(i))] |= list.items[i].position.x < -1.5f ? 1 : 2;
    QCOMPARE(sides.size(), std::size_t(4));
    for (const auto& [cell, side] : sides)
        QVERIFY(side == 1 || side == 2);
}

void SceneCommandTest::solidsOfTheSceneAreThoseOfFiles() {
    Workbench bench, files;
    const json pose = session::matrixOf({base::Mat3d::identity(), {0.75, 0.25, 0.5}});
    for (Workbench* each : {&bench, &files}) {
        each->run(test::newSphere(4000));
        each->run({{"op", "save"}, {"path", bench.path("ball.ply").string()}});
    }
    bench.run(scene("rename", {{"to", "ball"}}));
    bench.run(scene("duplicate", {{"to", "other"}, {"matrix", pose}}));
    bench.run(scene("activate", {{"name", "ball"}}));
    const std::string before = bench.hash();
    bench.run({{"op", "solid"}, {"model", "other"}, {"operation", "difference"}});
    files.run({{"op", "solid"},
               {"path", bench.path("ball.ply").string()},
               {"position", "0.75,0.25,0.5"},
               {"operation", "difference"}});
    QCOMPARE(bench.size(), files.size());
    QVERIFY(apart(placesOf(model(bench, "ball")), allPlaces(files)) < 1e-6);
    QVERIFY(!model(bench, "other").visible);
    bench.run({{"op", "undo"}}); // one step
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "redo"}});
    QVERIFY(!model(bench, "other").visible);
    for (const json& wrong : {json{{"op", "solid"}, {"model", "none"}}, json{{"op", "solid"}, {"model", "ball"}},
                              json{{"op", "solid"}, {"model", "other"}, {"sample", "sphere"}}, json{{"op", "solid"}}})
        QVERIFY2(!bench.refusal(wrong).empty(), wrong.dump().c_str());
}

void SceneCommandTest::registeringMovesPosesAlone() {
    Workbench bench;
    base::Random random(test::seed());
    bench.run({{"op", "new"}, {"sample", "knot"}, {"count", 6000}});
    bench.run(scene("rename", {{"to", "fixed"}}));
    bench.run(scene("place", {{"matrix", randomPose(random)}})); // the scene's frame is none of the models'
    const process::Rigid wanted = model(bench, "fixed").pose;
    const process::Rigid off = process::motionOf({0.05, -0.04, 0.06}, {0.02, 0.03, -0.02});
    bench.run(scene("duplicate", {{"to", "moving"}}));
    bench.run(scene("place", {{"matrix", session::matrixOf(wanted * off)}}));
    const tree::SurfelTree surfels = model(bench, "moving").surface.tree();
    bench.run(scene("activate", {{"name", "fixed"}}));
    bench.run({{"op", "register"}, {"scene", true}});
    QVERIFY(model(bench, "moving").surface.tree() == surfels);
    QCOMPARE(session::matrixOf(model(bench, "fixed").pose), session::matrixOf(wanted));
    const double least = apart(placesOf(model(bench, "moving")), placesOf(model(bench, "fixed")));
    QVERIFY2(least < 0.01, qPrintable(QString::number(least)));
    bench.run(scene("lock", {{"name", "moving"}}));
    QVERIFY(!bench.refusal({{"op", "register"}, {"scene", true}}).empty());
}

/// That a crash would lose, as a person is told.
static int commandsIn(const Workbench& bench) {
    std::filesystem::copy_file(bench.path("j.jsonl"), bench.path("journal-1.jsonl"),
                               std::filesystem::copy_options::overwrite_existing);
    const auto left = session::findLeftJournals(bench.path("j.jsonl").parent_path());
    return left.empty() ? -1 : left.front().commands;
}

void SceneCommandTest::journalsBringScenesBack() {
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

void SceneCommandTest::scansStandAsTheirPosesSay() {
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

void SceneCommandTest::sceneFilesThatAreNoneAreRefused_data() {
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

void SceneCommandTest::sceneFilesThatAreNoneAreRefused() {
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

void SceneCommandTest::shownModelsStandWhereTheirPosesSay() {
    Workbench bench;
    base::Random random(test::seed());
    makeScene(bench, random);
    bench.run(scene("place", {{"matrix", randomPose(random)}})); // the frame of all others
    session::ShownScene shown;
    const auto first = shown.beside(bench.document.scene());
    QCOMPARE(first.size(), std::size_t(1));
    const SceneModel& ball = model(bench, "ball");
    std::vector<Vec3d> seen;
    for (const surfel::Surfel& s : first.front().surface.tree().surfels().items)
        seen.push_back(ball.pose(base::cast<double>(s.position) + ball.origin()));
    QVERIFY(apart(seen, placesOf(model(bench, "ring"))) < 1e-5);
    bench.run(test::strokeAt(0));
    QVERIFY(shown.beside(bench.document.scene()).front().surface.tree() == first.front().surface.tree()); // kept
    const tree::SurfelTree whole = shown.whole(bench.document.surface().tree());
    QCOMPARE(whole.size(), bench.size() + first.front().surface.tree().size());
    bench.run(scene("hide", {{"name", "ring"}}));
    QVERIFY(shown.beside(bench.document.scene()).empty());
}

static const test::Registered<SceneCommandTest> registered;
#include "scene_command_test.moc"
