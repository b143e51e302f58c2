// Views, pivots, cuts and flight in the window: picking is what is drawn, whatever the camera.
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
    QVERIFY(f.window->controller().view().parallel);
    for (const QPointF& at : {f.centre(), f.centre() + QPointF(80, -60), f.centre() + QPointF(-120, 90)}) {
        test::sendMouse(f.view(), QEvent::MouseMove, at, Qt::NoButton);
        const auto& contact = f.window->controller().cursor().contact;
        QVERIFY(contact);
        const render::Camera camera = f.window->controller().camera();
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

void ViewWindowTest::pivotsArePickedOnTheSurface() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    auto& controller = f.window->controller();
    const render::Camera before = controller.camera();
    const QPointF at = f.centre() + QPointF(90, 40);
    test::sendMouse(f.view(), QEvent::MouseButtonDblClick, at, Qt::RightButton);
    QVERIFY(controller.view().pivot && std::abs(length(*controller.view().pivot) - 1) < 0.01);
    QVERIFY(controller.camera() == before); // no jump
    f.drag({30, 30}, {130, 60});
    const Vec3d place = controller.camera().project(*controller.view().pivot);
    QVERIFY(std::hypot(place.x - at.x(), place.y - at.y()) < 0.1);
    QVERIFY(controller.camera() != before);
    test::sendMouse(f.view(), QEvent::MouseButtonDblClick, {5, 5}, Qt::RightButton);
    QVERIFY(!controller.view().pivot);
}

void ViewWindowTest::strokesWorkBehindAPlane() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    auto& controller = f.window->controller();
    controller.turnTo(render::namedViews()[0]);
    ui::Cuts cuts = controller.cuts();
    cuts.each[2].on = true; // what is nearer than the middle goes
    cuts.each[2].offset = 0;
    controller.setCuts(cuts);
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre(), Qt::NoButton);
    const auto& contact = controller.cursor().contact;
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
    auto& controller = f.window->controller();
    auto& bar = *f.window->findChild<ui::CutBar*>();
    bar.findChild<QToolButton*>("cut-0")->click();
    QVERIFY(controller.cuts().each[0].on && controller.camera().clips.all().size() == 1);
    QTRY_VERIFY(controller.sections().size() == 1 && controller.sections()[0].size() == 2);
    for (const auto& curve : controller.sections()[0])
        for (const auto& p : curve.points)
            QVERIFY(std::abs(p.position.x) < 1e-6);
    bar.findChild<QSlider*>("cut-0-place")->setValue(1500);
    const double offset = controller.cuts().each[0].offset;
    QVERIFY(offset > 0.1);
    QTRY_VERIFY(controller.sections().size() == 1 && !controller.sections()[0].empty() &&
                std::abs(controller.sections()[0][0].points[0].position.x - offset) < 1e-6);
    bar.findChild<QToolButton*>("cut-0-flip")->click();
    QVERIFY(controller.camera().clips.all()[0].normal.x > 0);
    bar.findChild<QToolButton*>("cut-3")->click();
    QCOMPARE(controller.camera().clips.all().size(), std::size_t(2));
    QVERIFY(distance(controller.cuts().each[3].normal, -controller.camera().forward()) < 1e-9);
    QVERIFY(f.make("sphere", 2000)); // another model is whole
    QVERIFY(controller.camera().clips.empty() && !bar.cuts().each[0].on);
}

void ViewWindowTest::savedViewsAreKeptAndRecalled() {
    WindowFixture f;
    QVERIFY(f.make("torus", 3000));
    f.drag({30, 30}, {230, 90});
    const render::Camera camera = f.window->controller().camera();
    ui::keep(f.window->settings().savedViews, f.window->controller().savedView("mine"));
    f.window->close(); // writes the settings
    f.open();
    QVERIFY(f.make("torus", 3000));
    f.window->resize(1000, 700);
    QCOMPARE(f.window->settings().savedViews.size(), std::size_t(1));
    QVERIFY(f.window->controller().camera() != camera);
    f.window->controller().recall(f.window->settings().savedViews[0]);
    QVERIFY(f.window->controller().camera() == camera);
}

void ViewWindowTest::flightTakesLettersAndEndsWithEscape() {
    WindowFixture f;
    QVERIFY(f.make("torus", 3000));
    auto& controller = f.window->controller();
    const std::string tool = f.window->settings().toolRow().id;
    controller.fly();
    QVERIFY(controller.navigator().flying());
    QKeyEvent letter(QEvent::ShortcutOverride, Qt::Key_S, Qt::NoModifier);
    letter.ignore();
    QApplication::sendEvent(&f.view(), &letter);
    QVERIFY(letter.isAccepted());
    const Vec3d eye = controller.camera().eye;
    key(f.view(), QEvent::KeyPress, Qt::Key_S);
    QTRY_VERIFY(distance(controller.camera().eye, eye) > 0.05);
    key(f.view(), QEvent::KeyRelease, Qt::Key_S);
    QVERIFY(dot(controller.camera().eye - eye, controller.camera().forward()) < 0); // backwards
    QCOMPARE(std::string(f.window->settings().toolRow().id), tool);
    QVERIFY(controller.cancel());
    QVERIFY(!controller.navigator().flying() && !controller.cancel());
}

void ViewWindowTest::frameSelectionShowsWhatIsNotMasked() {
    WindowFixture f;
    QVERIFY(f.make("torus", 3000));
    auto& controller = f.window->controller();
    controller.frameAll();
    const double all = controller.view().distance;
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&f.view(), &leave);
    controller.frameSelection(); // nothing is masked, nothing under the brush
    QCOMPARE(controller.view().distance, all);
    for (const int dx : {-160, -150, -140, 140, 150, 160}) { // somewhere on the ring
        test::sendMouse(f.view(), QEvent::MouseMove, f.centre() + QPointF(dx, 0), Qt::NoButton);
        if (!controller.cursor().contact)
            continue;
        const Vec3d place = controller.cursor().contact->position;
        controller.frameSelection();
        QVERIFY(controller.view().distance < all);
        QVERIFY(distance(controller.view().target, place) < 1e-5);
        return;
    }
    QFAIL("no contact");
}

static const test::Registered<ViewWindowTest> registered;
#include "view_window_test.moc"
