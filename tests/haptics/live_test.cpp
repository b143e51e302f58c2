// Both threads at work: versions take over while the servo runs, and forces stop where they must.
#include "core/haptics/devices/hand.h"
#include "core/haptics/live.h"
#include "haptics/solids.h"
#include "support/registry.h"

#include <QTest>

using namespace haptics;
using namespace haptics_test;

class LiveTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void versionsTakeOverWhileTheServoRuns();
    void withoutFocusNothingIsSent();
    void everyDeviceOfTheTableKeepsTheRules();
    void handsSwingAsMassesDo();
    void feelingDoesNotDependOnTheModelsSize();
};

static Trajectory press(double seconds) {
    return {{0, {0, 0, 0.02}}, {0.1, {0, 0, -0.01}}, {seconds, {0, 0, -0.01}}};
}

static surface::Surface floorAt(double height) {
    return shapes::surfaceOf(shapes::plane(10, 0.01, 0.035, height));
}

void LiveTest::versionsTakeOverWhileTheServoRuns() {
    ServoOptions options;
    options.law.stiffness = 500;
    options.safety.rampSeconds = 0;
    options.safety.stalePatch = options.safety.stalledDevice = 10; // the machine may be busy
    Live live(makeHand(press(0.6), {}), options);
    double most = 0;
    for (int version = 0; !live.ended(); ++version) {
        live.show(floorAt(0.002 * std::sin(0.3 * version)));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (const Tick* tick = live.newest()) {
            most = std::max(most, length(tick->sent));
            QVERIFY(base::isFinite(tick->proxy));
        }
    }
    QVERIFY(live.ticks() > 100);
    QVERIFY2(most > 0.5, std::to_string(most).c_str());
}

void LiveTest::withoutFocusNothingIsSent() {
    ServoOptions options;
    options.law.stiffness = 500;
    options.safety.rampSeconds = 0;
    Live live(makeHand(press(0.3), {}), options);
    live.focus(false);
    live.show(floorAt(0));
    double sent = 0, felt = 0;
    while (!live.ended()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (const Tick* tick = live.newest()) {
            sent = std::max(sent, length(tick->sent));
            felt = std::max(felt, length(tick->force));
        }
    }
    QVERIFY(felt > 0);
    QCOMPARE(sent, 0.0);
}

void LiveTest::everyDeviceOfTheTableKeepsTheRules() {
    for (const DeviceRow& row : deviceTable()) {
        QVERIFY(&device(row.id) == &row);
        QVERIFY((row.kind == DeviceKind::Line) == (*row.address != 0));
        if (row.kind != DeviceKind::Simulated)
            continue; // line_device_test.cpp has the others
        const auto opened = row.open({press(0.2), {}});
        DeviceState state;
        double time = -1;
        int states = 0;
        for (; opened->read(state); ++states) {
            QVERIFY(state.time > time && base::isFinite(state.position) && base::isFinite(state.velocity));
            time = state.time;
            opened->send({0, 0, 1});
        }
        QVERIFY(opened->ended() && states >= 3);
        QVERIFY(!opened->read(state));
        QVERIFY(opened->limits().force > 0);
        for (const Trajectory& bad : {Trajectory{}, Trajectory{{1, {}}, {1, {}}}, Trajectory{{0, {1e300, 0, 0}}}})
            QVERIFY_EXCEPTION_THROWN(row.open({bad, {}}), std::runtime_error);
    }
    QVERIFY_EXCEPTION_THROWN(device("spoon"), std::runtime_error);
}

void LiveTest::handsSwingAsMassesDo() {
    HandModel model;
    model.damping = 0;
    model.settling = 1;
    // pulled to 1 from 0 at once: it swings about 1 with the mass's own frequency
    const auto hand = makeHand({{0, {0, 0, 0}}, {1e-6, {1, 0, 0}}}, model);
    const double omega = std::sqrt(model.muscle / model.mass);
    for (DeviceState state; hand->read(state);) {
        QVERIFY(std::abs(state.position.x - (1 - std::cos(omega * state.time))) < 0.02);
        hand->send({});
    }
}

void LiveTest::feelingDoesNotDependOnTheModelsSize() {
    std::vector<double> felt[2];
    for (const int large : {0, 1}) {
        const double scale = large == 1 ? 128 : 1; // model units per metre
        ServoOptions options;
        options.law.stiffness = 500;
        options.safety.rampSeconds = 0;
        options.workspace = {Vec3d{0.1, 0.2, 0} * scale, scale};
        const surface::Surface floor = shapes::surfaceOf(shapes::plane(40, 0.01 * scale, 0.035 * scale));
        const auto patch = makePatch(floor, options.workspace.centre, scale * 0.03, 0);
        Servo servo(options);
        const auto hand = makeHand(press(0.3), {});
        for (DeviceState state; hand->read(state);) {
            const Tick tick = servo.step(patch, state, {0, 0, 0, true});
            hand->send(tick.sent);
            felt[large].push_back(tick.sent.z);
        }
    }
    QCOMPARE(felt[0].size(), felt[1].size());
    QVERIFY(*std::max_element(felt[0].begin(), felt[0].end()) > 0.5);
    for (std::size_t i = 0; i < felt[0].size(); ++i)
        QVERIFY(std::abs(felt[0][i] - felt[1][i]) < 1e-4);
}

static const test::Registered<LiveTest> registered;
#include "live_test.moc"
