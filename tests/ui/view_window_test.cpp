// Views, pivots, cuts and flight in the window: picking is what is drawn, whatever the camera.
#include "support/patience.h"
#include "support/registry.h"
#include "ui/panels/cut_bar.h"
#include "window_fixture.h"

#include <QSlider>
#include <QToolButton>

using base::Vec3d;
using test::WindowFixture;

class ViewWindowTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void parallelPickingIsTheDrawnPlace();
    void pivotsArePickedOnTheSurface();
    void oneKeyTurnsTheUpAxis();
    void strokesWorkBehindAPlane();
    void sectionsFollowTheirPlanes();
    void savedViewsAreKeptAndRecalled();
    void flightTakesLettersAndEndsWithEscape();
    void frameSelectionShowsWhatIsNotMasked();
};

namespace {

void key(QWidget& widget, QEvent::Type type, int code) {
    QKeyEvent event(type, code, Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
}

} // namespace

/// The contact under the pointer projects to the pointer, and lies on the sphere.
void ViewWindowTest::parallelPickingIsTheDrawnPlace() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    f.action("view", "Orthographic")->trigger();
    QVERIFY(f.window->sculptView().motion().view().parallel);
    for (const QPointF& at : {f.centre(), f.centre() + QPointF(80, -60), f.centre() + QPointF(-120, 90)}) {
        test::sendMouse(f.view(), QEvent::MouseMove, at, Qt::NoButton);
        const auto& contact = f.window->sculptView().cursor().contact;
        QVERIFY(contact);
        const render::Camera camera = f.window->sculptView().motion().camera();
        QVERIFY(camera.parallel());
        const Vec3d place = camera.project(contact->position);
        QVERIFY(std::hypot(place.x - at.x(), place.y - at.y()) < 0.05);
        QVERIFY(std::abs(length(contact->position) - 1) < 0.01);
        QVERIFY(dot(contact->position, camera.forward()) < 0); // the near side
    }
    const std::size_t before = f.editor().snapshot().canUndo;
    f.drag(f.centre(), f.centre() + QPointF(40, 0));
    QVERIFY(!before && f.editor().snapshot().canUndo); // strokes reach it too
}

void ViewWindowTest::oneKeyTurnsTheUpAxis() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    f.window->settings().grid = true;
    auto& motion = f.window->sculptView().motion();
    const auto standing = [&] { return toStanding(motion.view().upAxis, motion.camera().forward()); };
    const Vec3d before = standing();
    for (const char* axis : {"z", "-y", "-z", "x", "-x", "y"}) {
        QTest::keyClick(f.window.get(), Qt::Key_U);
        QVERIFY(f.settle());
        const base::UpRow& row = base::upRow(f.editor().snapshot().up);
        QCOMPARE(QString(row.id), QString(axis));
        QVERIFY(motion.view().upAxis == row.axis);
        QVERIFY(dot(motion.camera().upright(), row.up) > 0.9 && length(standing() - before) < 1e-9);
        const auto grid = f.window->sculptView().look().options().grid;
        QVERIFY(grid && std::abs(dot(cross(grid->along, grid->across), row.up)) > 0.99);
    }
    f.editor().run({{"op", "undo"}});
    QVERIFY(f.settle());
    QVERIFY(motion.view().upAxis == base::UpAxis::MinusX);
    motion.turnTo(render::namedViews()[0]);
    QVERIFY(length(motion.camera().upright() - Vec3d{-1, 0, 0}) < 1e-9);
}

void ViewWindowTest::pivotsArePickedOnTheSurface() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    auto& scene = f.window->sculptView();
    const render::Camera before = scene.motion().camera();
    const QPointF at = f.centre() + QPointF(90, 40);
    test::sendMouse(f.view(), QEvent::MouseButtonDblClick, at, Qt::RightButton);
    QVERIFY(scene.motion().view().pivot && std::abs(length(*scene.motion().view().pivot) - 1) < 0.01);
    QVERIFY(scene.motion().camera() == before); // no jump
    f.drag({30, 30}, {130, 60});
    const Vec3d place = scene.motion().camera().project(*scene.motion().view().pivot);
    QVERIFY(std::hypot(place.x - at.x(), place.y - at.y()) < 0.1);
    QVERIFY(scene.motion().camera() != before);
    test::sendMouse(f.view(), QEvent::MouseButtonDblClick, {5, 5}, Qt::RightButton);
    QVERIFY(!scene.motion().view().picked);
}

void ViewWindowTest::strokesWorkBehindAPlane() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    auto& scene = f.window->sculptView();
    scene.motion().turnTo(render::namedViews()[0]);
    ui::Cuts cuts = scene.cuts().cuts();
    cuts.each[2].on = true; // what is nearer than the middle goes
    cuts.each[2].offset = 0;
    scene.cuts().set(cuts);
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre(), Qt::NoButton);
    const auto& contact = scene.cursor().contact;
    QVERIFY(contact && contact->position.z < -0.9);
    f.drag(f.centre(), f.centre() + QPointF(30, 0));
    QVERIFY(f.editor().snapshot().canUndo);
    // The near side is as it was.
    float nearest = 0;
    f.editor().snapshot().surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (block.position(slot).z > 0.5f)
                nearest = std::max(nearest, std::abs(length(block.position(slot)) - 1));
    });
    QVERIFY(nearest < 1e-3f);
}

void ViewWindowTest::sectionsFollowTheirPlanes() {
    WindowFixture f;
    QVERIFY(f.make("torus", 6000));
    auto& scene = f.window->sculptView();
    auto& bar = *f.window->findChild<ui::CutBar*>();
    bar.findChild<QToolButton*>("cut-0")->click();
    QVERIFY(scene.cuts().cuts().each[0].on && scene.motion().camera().clips.all().size() == 1);
    QTRY_VERIFY_WITH_TIMEOUT(scene.cuts().sections().size() == 1 && scene.cuts().sections()[0].size() == 2,
                             test::patience);
    for (const auto& curve : scene.cuts().sections()[0])
        for (const auto& p : curve.points)
            QVERIFY(std::abs(p.position.x) < 1e-6);
    bar.findChild<QSlider*>("cut-0-place")->setValue(1500);
    const double offset = scene.cuts().cuts().each[0].offset;
    QVERIFY(offset > 0.1);
    QTRY_VERIFY_WITH_TIMEOUT(scene.cuts().sections().size() == 1 && !scene.cuts().sections()[0].empty() &&
                                 std::abs(scene.cuts().sections()[0][0].points[0].position.x - offset) < 1e-6,
                             test::patience);
    bar.findChild<QToolButton*>("cut-0-flip")->click();
    QVERIFY(scene.motion().camera().clips.all()[0].normal.x > 0);
    bar.findChild<QToolButton*>("cut-3")->click();
    QCOMPARE(scene.motion().camera().clips.all().size(), std::size_t(2));
    QVERIFY(distance(scene.cuts().cuts().each[3].normal, -scene.motion().camera().forward()) < 1e-9);
    QVERIFY(f.make("sphere", 2000)); // another model is whole
    QVERIFY(scene.motion().camera().clips.empty() && !bar.cuts().each[0].on);
}

void ViewWindowTest::savedViewsAreKeptAndRecalled() {
    WindowFixture f;
    QVERIFY(f.make("torus", 3000));
    f.drag({30, 30}, {230, 90});
    const render::Camera camera = f.window->sculptView().motion().camera();
    ui::keep(f.window->settings().savedViews, f.window->sculptView().motion().savedView("mine"));
    f.window->close(); // writes the settings
    f.open();
    QVERIFY(f.make("torus", 3000));
    f.window->resize(1000, 700);
    QCOMPARE(f.window->settings().savedViews.size(), std::size_t(1));
    QVERIFY(f.window->sculptView().motion().camera() != camera);
    f.window->sculptView().motion().recall(f.window->settings().savedViews[0]);
    QVERIFY(f.window->sculptView().motion().camera() == camera);
}

void ViewWindowTest::flightTakesLettersAndEndsWithEscape() {
    WindowFixture f;
    QVERIFY(f.make("torus", 3000));
    auto& scene = f.window->sculptView();
    const std::string tool = f.window->settings().toolRow().id;
    scene.pointer().takeOff();
    QVERIFY(scene.motion().navigator().flying());
    QKeyEvent letter(QEvent::ShortcutOverride, Qt::Key_S, Qt::NoModifier);
    letter.ignore();
    QApplication::sendEvent(&f.view(), &letter);
    QVERIFY(letter.isAccepted());
    const Vec3d eye = scene.motion().camera().eye;
    key(f.view(), QEvent::KeyPress, Qt::Key_S);
    QTRY_VERIFY_WITH_TIMEOUT(distance(scene.motion().camera().eye, eye) > 0.05, test::patience);
    key(f.view(), QEvent::KeyRelease, Qt::Key_S);
    QVERIFY(dot(scene.motion().camera().eye - eye, scene.motion().camera().forward()) < 0); // backwards
    QCOMPARE(std::string(f.window->settings().toolRow().id), tool);
    QVERIFY(scene.pointer().cancel());
    QVERIFY(!scene.motion().navigator().flying() && !scene.pointer().cancel());
}

void ViewWindowTest::frameSelectionShowsWhatIsNotMasked() {
    WindowFixture f;
    QVERIFY(f.make("torus", 3000));
    auto& scene = f.window->sculptView();
    scene.motion().frameAll();
    const double all = scene.motion().view().distance;
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&f.view(), &leave);
    scene.frameSelection(); // nothing is masked, nothing under the brush
    QCOMPARE(scene.motion().view().distance, all);
    for (const int dx : {-160, -150, -140, 140, 150, 160}) { // somewhere on the ring
        test::sendMouse(f.view(), QEvent::MouseMove, f.centre() + QPointF(dx, 0), Qt::NoButton);
        if (!scene.cursor().contact)
            continue;
        const Vec3d place = scene.cursor().contact->position;
        scene.frameSelection();
        QVERIFY(scene.motion().view().distance < all);
        QVERIFY(distance(scene.motion().view().turningPoint(), place) < 1e-5);
        return;
    }
    QFAIL("no contact");
}

static const test::Registered<ViewWindowTest> registered;
#include "view_window_test.moc"
