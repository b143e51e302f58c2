// Several models in the window: a click chooses the one to work on, the picture stays, and the list is the scene.
#include "core/base/random.h"
#include "support/registry.h"
#include "ui/interaction/scene_pick.h"
#include "ui/panels/scene_panel.h"
#include "window_fixture.h"

#include <QDockWidget>
#include <QToolButton>
#include <QTreeWidget>

using base::Vec3d;
using test::WindowFixture;

class SceneWindowTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aPressOnAnotherModelActivatesItAndThePictureStays();
    void movingTheActiveModelLeavesTheView();
    void strokesChangeTheActiveModelAlone();
    void whatIsBehindAnotherModelHasNoContact();
    void theListIsTheScene();
    void refusedWishesLeaveTheListAsItWas();
    void modelsOfFilesComeBesideTheOthers();
    void picturesLeaveOutAnActiveModelThatIsHidden();
};

namespace {

/// A ball at the left, which is active, and another at the right, turned and moved by its pose.
struct Balls : WindowFixture {
    Balls() {
        make("sphere", 3000);
        const process::Rigid pose = process::motionOf({0.4, 1.1, -0.3}, {2.6, 0.2, 0.1});
        run({{"op", "scene"}, {"do", "rename"}, {"to", "left"}});
        run({{"op", "scene"}, {"do", "duplicate"}, {"to", "right"}, {"matrix", session::matrixOf(pose)}});
        run({{"op", "scene"}, {"do", "activate"}, {"name", "left"}});
        window->sculptView().motion().frameAll();
        settle();
    }
    void run(nlohmann::json command) {
        editor().run(std::move(command));
        QVERIFY(settle());
    }
    const ui::Snapshot& now() { return editor().snapshot(); }
    render::Camera camera() { return window->sculptView().motion().camera(); }
    /// Where the camera is in the scene.
    Vec3d eye() { return now().stand(camera().eye); }
    Vec3d upwards() { return now().stand.turn(camera().upright()); }
    /// Where a place of the scene is in the widget.
    QPointF at(const Vec3d& place) {
        const Vec3d pixel = camera().project(now().stand.inverse()(place));
        return QPointF(pixel.x, pixel.y) / view().devicePixelRatioF();
    }
    QTreeWidget& list() { return *window->findChild<ui::ScenePanel*>()->findChild<QTreeWidget*>(); }
    void click(const char* button) {
        window->findChild<ui::ScenePanel*>()->findChild<QToolButton*>(button)->click();
        QVERIFY(settle());
    }
    std::string active() { return now().scene[now().active].name; }
};

} // namespace

void SceneWindowTest::aPressOnAnotherModelActivatesItAndThePictureStays() {
    Balls scene;
    const Vec3d eye = scene.eye(), up = scene.upwards();
    const QPointF right = scene.at({2.6, 0.2, 0.1}), left = scene.at({0, 0, 0});
    const base::Hash128 hash = scene.hash();
    scene.press(right);
    scene.release(right);
    QCOMPARE(scene.active(), "right");
    QVERIFY(distance(scene.eye(), eye) < 1e-9 && distance(scene.upwards(), up) < 1e-9);
    QVERIFY(distance(Vec3d{scene.at({0, 0, 0}).x(), scene.at({0, 0, 0}).y(), 0}, {left.x(), left.y(), 0}) < 1e-6);
    QVERIFY(scene.hash() == hash); // a press chooses, and sculpts nothing
    scene.press(left);
    scene.release(left);
    QCOMPARE(scene.active(), "left");
    scene.run({{"op", "undo"}});
    QCOMPARE(scene.active(), "right");
    QVERIFY(distance(scene.eye(), eye) < 1e-9);
}

void SceneWindowTest::movingTheActiveModelLeavesTheView() {
    Balls scene;
    const Vec3d eye = scene.eye();
    scene.run({{"op", "scene"}, {"do", "move"}, {"move", {0, 1, 0}}, {"axis", {1, 0, 0}}, {"angle", 50}});
    QVERIFY(distance(scene.eye(), eye) < 1e-9);
    const QPointF place = scene.at({0, 1, 0}); // its middle
    const auto seen = ui::seenAt(scene.now(), scene.camera(), place * scene.view().devicePixelRatioF());
    QVERIFY(seen.contact && !seen.other);
}

void SceneWindowTest::strokesChangeTheActiveModelAlone() {
    Balls scene;
    const tree::SurfelTree other = scene.now().beside.front().surface.tree(), own = scene.now().surface.tree();
    const QPointF left = scene.at({0, 0, 0});
    scene.drag(left, left + QPointF(30, 10));
    QVERIFY(!(scene.now().surface.tree() == own));
    QVERIFY(scene.now().beside.front().surface.tree() == other);
    QCOMPARE(scene.now().whole.size(), scene.now().surface.tree().size() + other.size());
}

void SceneWindowTest::whatIsBehindAnotherModelHasNoContact() {
    Balls scene;
    base::Random random(test::seed());
    int covered = 0, met = 0, others = 0;
    // The right ball is moved to stand before the left one, as the camera sees them.
    const Vec3d toEye = normalized(scene.eye());
    nlohmann::json by{toEye.x * 2 - 2.6, toEye.y * 2 - 0.2 + 0.5, toEye.z * 2 - 0.1};
    scene.run({{"op", "scene"}, {"do", "move"}, {"name", "right"}, {"move", by}});
    const render::Camera camera = scene.camera();
    for (int k = 0; k < 400; ++k) {
        const QPointF pixel(random.uniform(0, camera.width), random.uniform(0, camera.height));
        const ui::Seen seen = ui::seenAt(scene.now(), camera, pixel);
        const auto own = ui::contactAt(scene.now().surface, camera, pixel),
                   front = ui::contactAt(scene.now().beside.front().surface, camera, pixel);
        QVERIFY(!(seen.contact && seen.other));
        QCOMPARE(seen.contact.has_value(), own && !front);
        QCOMPARE(seen.other != nullptr, front.has_value());
        covered += own && front, met += own && !front, others += front && !own;
    }
    QVERIFY(covered > 3 && met > 0 && others > 0);
    scene.run({{"op", "scene"}, {"do", "hide"}, {"name", "right"}});
    QVERIFY(scene.now().beside.empty());
}

void SceneWindowTest::theListIsTheScene() {
    Balls scene;
    QTreeWidget& list = scene.list();
    QVERIFY(!scene.window->findChild<QDockWidget*>("scene")->isHidden()); // shown with the second model
    QCOMPARE(scene.window->findChild<ui::ScenePanel*>()->names(), QStringList({"left", "right"}));
    list.setCurrentItem(list.topLevelItem(1));
    QVERIFY(scene.settle());
    QCOMPARE(scene.active(), "right");
    list.topLevelItem(0)->setCheckState(1, Qt::Unchecked);
    QVERIFY(scene.settle());
    QVERIFY(!scene.now().scene[0].visible && scene.now().beside.empty());
    list.topLevelItem(0)->setCheckState(2, Qt::Checked);
    QVERIFY(scene.settle());
    QVERIFY(scene.now().scene[0].locked);
    list.topLevelItem(1)->setText(0, "  nose ");
    QVERIFY(scene.settle());
    QCOMPARE(scene.active(), "nose");
    scene.click("scene-duplicate");
    QCOMPARE(scene.now().scene.size(), std::size_t(3));
    scene.click("scene-remove");
    scene.click("scene-remove");
    QCOMPARE(scene.now().scene.size(), std::size_t(1));
    QVERIFY(!scene.window->findChild<QToolButton*>("scene-remove")->isEnabled());
    for (int k = 0; k < 6; ++k)
        scene.run({{"op", "undo"}});
    QCOMPARE(scene.window->findChild<ui::ScenePanel*>()->names(), QStringList({"left", "right"}));
    QVERIFY(list.topLevelItem(0)->checkState(1) == Qt::Checked && list.topLevelItem(0)->checkState(2) == Qt::Unchecked);
}

void SceneWindowTest::refusedWishesLeaveTheListAsItWas() {
    Balls scene;
    scene.list().topLevelItem(0)->setText(0, "right"); // there is one
    QVERIFY(scene.settle());
    QCOMPARE(scene.window->findChild<ui::ScenePanel*>()->names(), QStringList({"left", "right"}));
    scene.list().topLevelItem(1)->setText(0, "");
    QVERIFY(scene.settle());
    QCOMPARE(scene.window->findChild<ui::ScenePanel*>()->names(), QStringList({"left", "right"}));
}

void SceneWindowTest::modelsOfFilesComeBesideTheOthers() {
    Balls scene;
    scene.run({{"op", "save"}, {"path", scene.file("all.scene.json").toStdString()}});
    QVERIFY(!scene.now().modified);
    const base::Hash128 hash = scene.hash();
    scene.run({{"op", "scene"}, {"do", "add"}, {"path", scene.file("all.left.ply").toStdString()}, {"name", "third"}});
    QCOMPARE(scene.now().scene.size(), std::size_t(3));
    QVERIFY(scene.now().modified);
    scene.run({{"op", "open"}, {"path", scene.file("all.scene.json").toStdString()}});
    QCOMPARE(scene.now().scene.size(), std::size_t(2));
    QVERIFY(scene.hash() == hash);
    QVERIFY(!scene.now().canUndo && !scene.now().modified);
}

void SceneWindowTest::picturesLeaveOutAnActiveModelThatIsHidden() {
    Balls scene;
    const auto seen = [&](const Vec3d& place) {
        const QString path = scene.file("scene.png");
        scene.window->images().write(path.toStdString(), {scene.view().size(), true, false, false});
        scene.settle();
        return qAlpha(QImage(path).pixel((scene.at(place)).toPoint())) > 0;
    };
    QVERIFY(seen({0, 0, 0}) && seen({2.6, 0.2, 0.1}));
    scene.run({{"op", "scene"}, {"do", "hide"}, {"name", "left"}});
    QVERIFY(!seen({0, 0, 0}) && seen({2.6, 0.2, 0.1}));
}

static const test::Registered<SceneWindowTest> registered;
#include "scene_window_test.moc"
