// Handles: what is grasped stays under the pointer, and what they say is what the command does.
#include "core/base/random.h"
#include "support/patience.h"
#include "support/registry.h"
#include "ui/view/placement.h"
#include "ui/window/command_desk.h"
#include "ui/window/command_dialog.h"
#include "ui/window/status_line.h"
#include "ui/window_fixture.h"

#include <numbers>
#include <QLineEdit>

using base::Vec3d;
using test::WindowFixture;
using ui::Handle, ui::HandleDrag, ui::Placement, ui::Rotation;

class PlacementTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void arrowsFollowThePointerAlongTheirAxes();
    void ringsTurnByTheAngleThatThePointerGoes();
    void ringsSeenFromTheEdgeGoAlongWithThePointer();
    void theSquareScalesByDistances();
    void axesAndAnglesAreTheSameTurn();
    void everyHandleIsFoundWhereItIsDrawn();
    void draggingFillsTheFieldsAndShowsWhatComes();
    void typedNumbersMoveTheHandles();
    void handlesAreThereForWhatIsSelected();
};

namespace {

Vec3d axisOf(int axis) {
    return {axis == 0 ? 1.0 : 0, axis == 1 ? 1.0 : 0, axis == 2 ? 1.0 : 0};
}

render::Camera cameraBy(base::Random& random, int round) {
    render::Camera out;
    out.eye = Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)} * 2.0 + Vec3d{3, 2, 4};
    out.target = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
    out.orthoHeight = round % 2 == 0 ? 0 : 3;
    return out;
}

HandleDrag grasp(const Handle& handle, const render::Camera& camera, const Vec3d& middle, const Vec3d& at) {
    const Vec3d pixel = camera.project(at);
    return {handle, {}, middle, pixel.x, pixel.y};
}

Placement to(const HandleDrag& drag, const render::Camera& camera, const Vec3d& place, bool steps = false) {
    const Vec3d pixel = camera.project(place);
    return ui::dragged(drag, camera, pixel.x, pixel.y, steps);
}

} // namespace

void PlacementTest::arrowsFollowThePointerAlongTheirAxes() {
    base::Random random(71);
    for (int round = 0; round < 60; ++round) {
        const render::Camera camera = cameraBy(random, round);
        const Vec3d middle{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
        const Vec3d axis = axisOf(round % 3);
        const double s = random.uniform(0.1, 0.5), t = random.uniform(-0.5, 0.5);
        const HandleDrag drag = grasp({Handle::Kind::Move, round % 3}, camera, middle, middle + axis * s);
        QVERIFY2(distance(to(drag, camera, middle + axis * t).move, axis * (t - s)) < 1e-6, "seed 71");
        const HandleDrag free = grasp({Handle::Kind::Free, 0}, camera, middle, middle);
        const Vec3d across = (camera.right() * s + camera.upright() * t);
        QVERIFY2(distance(to(free, camera, middle + across).move, across) < 1e-6, "seed 71");
    }
}

void PlacementTest::ringsTurnByTheAngleThatThePointerGoes() {
    base::Random random(72);
    for (int round = 0; round < 60; ++round) {
        const render::Camera camera = cameraBy(random, round);
        const int k = round % 3;
        const Vec3d a = axisOf((k + 1) % 3), b = axisOf((k + 2) % 3);
        const double from = random.uniform(0, 6), by = random.uniform(-3, 3);
        const auto at = [&](double angle) { return (a * std::cos(angle) + b * std::sin(angle)) * 0.4; };
        const HandleDrag drag = grasp({Handle::Kind::Turn, k}, camera, {}, at(from));
        const Vec3d pixel = camera.project(at(from));
        if (std::abs(dot(camera.ray(pixel.x, pixel.y).direction, axisOf(k))) < 0.16)
            continue; // from the edge
        const Rotation turn = to(drag, camera, at(from + by)).turn;
        QVERIFY2(distance(turn(a), Rotation::about(axisOf(k), by)(a)) < 1e-6, "seed 72");
        const double steps = ui::axisAngleOf(to(drag, camera, at(from + by), true).turn).degrees / 15;
        QVERIFY2(std::abs(steps - std::round(steps)) < 1e-6, "seed 72");
    }
}

void PlacementTest::ringsSeenFromTheEdgeGoAlongWithThePointer() {
    render::Camera camera; // along z: the ring about x is a line upwards, and its near side goes down as y turns to z
    const HandleDrag drag = grasp({Handle::Kind::Turn, 0}, camera, {}, {0, 0, 0.4});
    const ui::AxisAngle turn = ui::axisAngleOf(ui::dragged(drag, camera, drag.fromX, drag.fromY + 50, false).turn);
    QVERIFY(distance(turn.axis, {1, 0, 0}) < 1e-9 && turn.degrees > 5 && turn.degrees < 90);
}

void PlacementTest::theSquareScalesByDistances() {
    render::Camera camera;
    const HandleDrag drag = grasp({Handle::Kind::Scale, 0}, camera, {}, {0.2, 0.2, 0});
    QVERIFY(std::abs(to(drag, camera, {0.4, 0.4, 0}).scale - 2) < 1e-9);
    QVERIFY(std::abs(to(drag, camera, {-0.1, 0.1, 0}).scale - 0.5) < 1e-9);
    QVERIFY(to(drag, camera, {}).scale > 0); // never nothing
}

void PlacementTest::axesAndAnglesAreTheSameTurn() {
    base::Random random(73);
    for (int round = 0; round < 50; ++round) {
        const Vec3d axis{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
        const Rotation turn = ui::rotationOf({axis, random.uniform(-350, 350)});
        const Rotation again = ui::rotationOf(ui::axisAngleOf(turn));
        QVERIFY2(distance(turn({1, 2, 3}), again({1, 2, 3})) < 1e-9, "seed 73");
    }
    QCOMPARE(ui::axisAngleOf(Rotation()).degrees, 0.0);
    QVERIFY(ui::rotationOf({{0, 0, 0}, 40}) == Rotation());
}

void PlacementTest::everyHandleIsFoundWhereItIsDrawn() {
    base::Random random(74);
    for (int round = 0; round < 20; ++round) {
        const render::Camera camera = cameraBy(random, round);
        for (const ui::HandleShape& shape : ui::handleShapes(camera, {}, 80))
            for (const Vec3d& each : shape.line) {
                const Vec3d pixel = camera.project(each);
                QVERIFY2(ui::handleAt(camera, {}, 80, pixel.x, pixel.y, 1), "seed 74"); // some cross
            }
        QVERIFY(!ui::handleAt(camera, {}, 80, 5000, 5000, 9));
    }
}

// --- in the window ---

static QLineEdit& field(WindowFixture& f, const char* name) {
    return *f.window->findChild<ui::CommandDesk*>()->dialog()->findChild<QLineEdit*>(name);
}

/// In units of the widget.
static QPointF pixelOf(WindowFixture& f, const Vec3d& place) {
    const Vec3d at = f.window->sculptView().motion().camera().project(place);
    return QPointF(at.x, at.y) / f.view().devicePixelRatioF();
}

void PlacementTest::draggingFillsTheFieldsAndShowsWhatComes() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1500));
    auto& desk = *f.window->findChild<ui::CommandDesk*>();
    desk.open(session::command("transform"));
    ui::PlacementTool& handles = f.window->sculptView().placement();
    QVERIFY(handles.on());
    const auto shapes =
        ui::handleShapes(f.window->sculptView().motion().camera(), handles.middle(), handles.lengthPx());
    const auto arrow = std::ranges::find(shapes, Handle{Handle::Kind::Move, 0}, &ui::HandleShape::handle);
    const Vec3d tip = arrow->line.back();
    f.drag(pixelOf(f, tip), pixelOf(f, tip + Vec3d{0.3, 0, 0}));
    const nlohmann::json command = desk.dialog()->command();
    QVERIFY2(std::abs(command["move"][0].get<double>() - 0.3) < 0.01, command.dump().c_str());
    QVERIFY(command["move"][1] == 0 && command["move"][2] == 0 && !command.contains("angle"));
    QVERIFY(!f.editor().snapshot().canUndo); // no stroke
    QTRY_VERIFY_WITH_TIMEOUT(f.window->sculptView().look().showsInstead(), test::patience);
    f.press(pixelOf(f, handles.middle())); // and Esc takes back what is being dragged, alone
    f.moveTo(f.centre() + QPointF(90, 90));
    f.window->escape();
    f.release(f.centre() + QPointF(90, 90));
    QVERIFY(desk.dialog() && desk.dialog()->command() == command);
    desk.dialog()->accept();
    QVERIFY(f.settle() && !handles.on());
    // What it said of them goes with them.
    QTRY_VERIFY_WITH_TIMEOUT(!f.window->statusLine().message().startsWith("Drag an arrow"), test::patience);
    const base::Vec3f middle = f.editor().snapshot().surface.tree().bounds().centre();
    QVERIFY(std::abs(middle.x - 0.3f) < 0.02f && std::abs(middle.y) < 0.01f);
}

void PlacementTest::typedNumbersMoveTheHandles() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    f.window->findChild<ui::CommandDesk*>()->open(session::command("transform"));
    field(f, "move").setText("0, 0.5, 0");
    field(f, "axis").setText("0, 0, 2");
    field(f, "angle").setText("90");
    const ui::PlacementTool& handles = f.window->sculptView().placement();
    QVERIFY(std::abs(handles.middle().y - 0.5) < 0.01);
    QVERIFY(distance(handles.placement().turn({1, 0, 0}), {0, 1, 0}) < 1e-9);
    field(f, "move").setText("0, 0.5, "); // not yet three
    QVERIFY(f.window->sculptView().placement().on());
}

void PlacementTest::handlesAreThereForWhatIsSelected() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    f.editor().run({{"op", "select"}, {"by", "ball"}, {"at", {0, 1, 0}}, {"radius", 0.5}});
    QVERIFY(f.settle());
    auto& desk = *f.window->findChild<ui::CommandDesk*>();
    desk.open(session::command("transform"));
    QVERIFY(f.window->sculptView().placement().middle().y > 0.8);
    desk.open(session::command("inflate")); // knows no moves
    QVERIFY(!f.window->sculptView().placement().on());
}

static const test::Registered<PlacementTest> registered;
#include "placement_test.moc"
