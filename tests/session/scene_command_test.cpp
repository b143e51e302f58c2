// Several models in one document: commands change the active one alone, and history is one.
#include "core/base/random.h"
#include "core/session/scene/shown_scene.h"
#include "scenes.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d, base::Vec3f;
using session::SceneModel;
using test::Workbench, test::json;
using namespace test::scenes;

class SceneCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void commandsChangeTheActiveModelAlone();
    void historyIsOneOfAllModels();
    void whatIsLockedOrHiddenIsNotChanged();
    void posesMoveNoSurfel();
    void addingAndDuplicatingMoveAsMovingDoes();
    void appliedPosesLeaveEverythingWhereItWas();
    void splittingAndJoiningKeepEverySurfel();
    void eachValueBecomesAModel();
    void joinedCellsKeepApart();
    void solidsOfTheSceneAreThoseOfFiles();
    void registeringMovesPosesAlone();
    void shownModelsStandWhereTheirPosesSay();
};

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

void SceneCommandTest::addingAndDuplicatingMoveAsMovingDoes() {
    const json way{{"move", {0.5, 1, -2}}, {"axis", {0, 1, 1}}, {"angle", 33}};
    const auto with = [&](json parameters) {
        parameters.update(way);
        return parameters;
    };
    Workbench once, twice;
    for (Workbench* bench : {&once, &twice})
        bench->run(test::newSphere());
    once.run(scene("add", with({{"sample", "torus:900"}, {"name", "ring"}})));
    once.run(scene("duplicate", with({{"to", "twin"}})));
    twice.run(scene("add", {{"sample", "torus:900"}, {"name", "ring"}}));
    twice.run(scene("move", way));
    twice.run(scene("duplicate", {{"to", "twin"}}));
    twice.run(scene("move", way));
    QCOMPARE(once.hash(), twice.hash());
    QVERIFY(length(model(once, "twin").pose(Vec3d()) - Vec3d{1, 2, -4}) < 0.2);
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
