// The parts that gestures are handed to, each by itself: what they change, what they leave, what they tell.
#include "support/registry.h"
#include "ui/interaction/contact.h"
#include "window_fixture.h"

#include <QSignalSpy>

using base::Vec3d;
using test::WindowFixture;
using Value = ui::BrushSizing::Value;

class InteractionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void dragsThereAndBackKeepTheRadius();
    void droppedDragsBringTheValueBack();
    void radiiInPixelsAndInModelUnitsAgreeAtTheContact();
    void freshPlanesGoThroughTheMiddle();
    void theFreePlaneFacesTheView();
    void raysBeginBehindAPlane();
    void sourcesAreToldInTheFilesCoordinates();
};

void InteractionTest::dragsThereAndBackKeepTheRadius() {
    WindowFixture f;
    ui::BrushSizing& sizing = f.window->sculptView().sizing();
    const double before = f.window->settings().radiusPx;
    sizing.beginDrag(Value::Radius);
    for (const double dx : {30.0, 45.0, -100.0, 25.0})
        sizing.drag(dx);
    QVERIFY(!sizing.label().isEmpty());
    sizing.endDrag(true);
    QVERIFY(std::abs(f.window->settings().radiusPx / before - 1) < 1e-12);
    QVERIFY(sizing.label().isEmpty() && !sizing.dragging());
}

void InteractionTest::droppedDragsBringTheValueBack() {
    WindowFixture f;
    ui::BrushSizing& sizing = f.window->sculptView().sizing();
    ui::Settings& settings = f.window->settings();
    for (const auto unit : {ui::RadiusUnit::Pixels, ui::RadiusUnit::Model})
        for (const Value value : {Value::Radius, Value::Strength}) {
            settings.radiusUnit = unit;
            const double px = settings.radiusPx, model = settings.radiusModel;
            const float strength = settings.choice(settings.toolRow()).strength;
            QSignalSpy changed(&sizing, &ui::BrushSizing::changed);
            sizing.beginDrag(value);
            sizing.drag(33);
            sizing.endDrag(false);
            QCOMPARE(changed.size(), 2);
            QVERIFY(settings.radiusPx == px && settings.radiusModel == model);
            QCOMPARE(settings.choice(settings.toolRow()).strength, strength);
        }
}

void InteractionTest::radiiInPixelsAndInModelUnitsAgreeAtTheContact() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    ui::SculptView& scene = f.window->sculptView();
    const auto contact =
        ui::contactAt(f.editor().snapshot().surface, scene.motion().camera(), f.centre() + QPointF(20, 10));
    QVERIFY(contact);
    const double radius = scene.sizing().radiusAt(contact->position);
    const double pixels = radius * scene.motion().pixelsPerUnitAt(contact->position);
    QVERIFY(std::abs(pixels - f.window->settings().radiusPx * f.view().devicePixelRatioF()) < 1e-9);
    f.window->settings().radiusUnit = ui::RadiusUnit::Model;
    QCOMPARE(scene.sizing().radiusAt(contact->position), f.window->settings().radiusModel);
}

void InteractionTest::freshPlanesGoThroughTheMiddle() {
    WindowFixture f;
    ui::CutPlanes& planes = f.window->sculptView().cuts();
    QSignalSpy changed(&planes, &ui::CutPlanes::changed);
    QVERIFY(f.make("torus", 3000));
    QVERIFY(!changed.empty());
    const base::Box3f box = f.editor().snapshot().surface.tree().bounds();
    for (const ui::Cut& cut : planes.cuts().each) {
        QVERIFY(!cut.on && !cut.flipped);
        QVERIFY(std::abs(cut.offset - dot(base::cast<double>(box.centre()), cut.normal)) < 1e-9);
    }
}

void InteractionTest::theFreePlaneFacesTheView() {
    WindowFixture f;
    QVERIFY(f.make("torus", 3000));
    ui::SculptView& scene = f.window->sculptView();
    QSignalSpy moved(&scene.cuts(), &ui::CutPlanes::moved);
    scene.faceFreePlane();
    QCOMPARE(moved.size(), 1);
    const ui::Cut& cut = scene.cuts().cuts().each[ui::Cuts::free];
    QVERIFY(distance(cut.normal, -scene.motion().camera().forward()) < 1e-12);
}

void InteractionTest::raysBeginBehindAPlane() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    const surface::Surface& surface = f.editor().snapshot().surface;
    render::Camera camera = f.window->sculptView().motion().camera();
    const Vec3d forward = camera.forward();
    const QPointF middle(camera.width / 2.0, camera.height / 2.0);
    const auto near = ui::contactAt(surface, camera, middle);
    camera.clips.add({forward, 0}); // what is nearer than the middle goes
    const auto far = ui::contactAt(surface, camera, middle);
    QVERIFY(near && far);
    QVERIFY(dot(near->position, forward) < -0.9 && dot(far->position, forward) > 0.9);
    const auto ray = ui::strokeRay(surface, camera, middle);
    QVERIFY(ray && dot(base::cast<double>(ray->origin), forward) > -1e-4);
    camera.clips.add({-forward, -2}); // and what is farther than 2
    QVERIFY(ui::strokeRay(surface, camera, middle));
    camera.clips.add({forward, 1.5}); // nothing is left but air
    QVERIFY(!ui::strokeRay(surface, camera, middle));
}

void InteractionTest::sourcesAreToldInTheFilesCoordinates() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    ui::CloneSource& source = f.window->sculptView().source();
    QSignalSpy changed(&source, &ui::CloneSource::changed);
    source.choose(Vec3d{0.5, -1, 0});
    const Vec3d at = Vec3d{0.5, -1, 0} + f.editor().snapshot().origin;
    QCOMPARE(changed.back().at(0).toString(), QString("(%1, %2, %3)").arg(at.x).arg(at.y).arg(at.z));
    source.choose({});
    QVERIFY(changed.back().at(0).toString().isEmpty() && !source.place());
}

static const test::Registered<InteractionTest> registered;
#include "interaction_test.moc"
