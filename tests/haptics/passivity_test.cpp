// No energy from nothing: the controller by itself, and a hand in the loop.
#include "core/haptics/devices/hand.h"
#include "core/haptics/servo.h"
#include "haptics/solids.h"
#include "support/registry.h"

#include <QTest>

using namespace haptics;
using namespace haptics_test;

class PassivityTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void closedLoopsGainNothing_data();
    void closedLoopsGainNothing();
    void theLawItselfKeepsEnergy();
    void whatTheHandPutInComesBack();
    void statesThatComeUnevenlyFeelTheSame();
    void handsThatDrawEightsKeepTheirForce_data();
    void handsThatDrawEightsKeepTheirForce();
    void handsComeToRest_data();
    void handsComeToRest();
};

static PatchPtr patchOf(const Solid& solid) {
    return std::make_shared<const Patch>(Patch{solid.surface, 0, solid.surface.tree().bounds()});
}

/// Over and over the same loop: into the surface, along it, out.
static Vec3d loop(const Solid& s, double t) {
    const Vec3d n = s.outward(s.outside), u = base::perpendicular(n);
    const Vec3d at =
        onto(s, s.outside) + (u * std::cos(2 * shapes::pi * t) + cross(n, u) * std::sin(2 * shapes::pi * t)) * s.unit;
    return onto(s, at) + s.outward(at) * (std::cos(2 * shapes::pi * t) - 0.6) * 0.5 * s.unit;
}

void PassivityTest::closedLoopsGainNothing_data() {
    QTest::addColumn<int>("solid");
    QTest::addColumn<double>("friction");
    QTest::addColumn<int>("delay");
    for (int i = 0; i < 4; ++i)
        for (const double friction : {0.0, 0.5})
            for (const int delay : {0, 1})
                QTest::addRow("%s, friction %g, delay %d", solids()[static_cast<std::size_t>(i)].name.c_str(), friction,
                              delay)
                    << i << friction << delay;
}

void PassivityTest::closedLoopsGainNothing() {
    QFETCH(int, solid);
    QFETCH(double, friction);
    QFETCH(int, delay);
    const Solid& s = solids()[static_cast<std::size_t>(solid)];
    ServoOptions options;
    options.tool.friction = friction;
    options.law.stiffness = 1000;
    options.safety = SafetyLimits::off();
    options.port.delay = static_cast<std::size_t>(delay);
    Servo servo(options);
    const PatchPtr patch = patchOf(s);
    constexpr int perLoop = 250, loops = 3;
    const double joules = 1e-6 * options.law.stiffness * s.size * s.size;
    std::vector<Vec3d> sent;
    Vec3d before;
    double work = 0, least = 0; // counted here, by what acted
    for (int i = 0; i < loops * perLoop; ++i) {
        const Vec3d x = loop(s, static_cast<double>(i) / perLoop);
        if (i > delay)
            work += dot(sent[static_cast<std::size_t>(i - 1 - delay)], x - before);
        before = x;
        least = std::min(least, work);
        QVERIFY2(work <= joules, std::to_string(work / joules).c_str());
        const double t = 0.001 * i;
        sent.push_back(servo.step(patch, {x, {}, 0, t}, {t, 0, t, true}).sent);
    }
    QVERIFY(least < -joules); // something was felt
}

/// Without a controller, by trapezoids, a frictionless loop gives back what it took.
void PassivityTest::theLawItselfKeepsEnergy() {
    for (const Solid& s : solids()) {
        Proxy proxy;
        double work = 0, turned = 0;
        Vec3d before, force;
        constexpr int parts = 400;
        for (int i = 0; i <= parts; ++i) {
            const Vec3d x = loop(s, static_cast<double>(i) / parts);
            if (i == 0)
                proxy.place(s.surface, x);
            proxy.move(s.surface, x);
            const Vec3d now = forceOn({1000, 0, 0}, proxy, s.surface, x, {});
            if (i > 0) {
                work += 0.5 * dot(now + force, x - before);
                turned += std::abs(0.5 * dot(now + force, x - before));
            }
            before = x;
            force = now;
        }
        QVERIFY2(std::abs(work) <= 1e-3 * turned, (s.name + " " + std::to_string(work / turned)).c_str());
    }
}

void PassivityTest::whatTheHandPutInComesBack() {
    Passivity passivity;
    double work = 0;
    Vec3d before, sent;
    for (int i = -3000; i <= 200; ++i) { // rests, and goes slowly into a spring and out again
        const Vec3d x{0, 0, i < 0 ? 0 : -0.01 * (0.5 - 0.5 * std::cos(2 * shapes::pi * i / 200))};
        work += dot(sent, x - before);
        before = x;
        sent = passivity.limit(x, x * -1000.0);
        QVERIFY(work <= 1e-6);
        if (i < 150)
            QVERIFY(distance(sent, x * -1000.0) < 1e-9); // nothing is taken while the hand has energy in it
    }
    QVERIFY(work > -0.1 * 0.5 * 1000 * 0.01 * 0.01); // most of it
    QCOMPARE(passivity.workOnHand(), work);
}

/// A line that hands over none, one or two states a tick, each with its time: an even hand still finds its wall.
void PassivityTest::statesThatComeUnevenlyFeelTheSame() {
    base::Random random(test::seed());
    for (const int delay : {0, 2}) {
        const Solid s = plane(0.035);
        ServoOptions options;
        options.law.stiffness = 1000;
        options.safety = SafetyLimits::off();
        options.port.delay = static_cast<std::size_t>(delay);
        Servo servo(options);
        const PatchPtr patch = patchOf(s);
        int state = 0;
        for (int i = 0; i < 4000; ++i) {
            const double way = 0.3 - 0.0001 * state, z = way > 0 ? way : -0.003 * (1 - std::exp(way / 0.003));
            const Tick tick = servo.step(patch, {{0, 0, z}, {}, 0, 0.001 * state}, {0.001 * i, 0, 0.001 * i, true});
            if (z < -0.0015)
                QVERIFY2(
                    tick.sent.z > 0.9 * tick.force.z - 0.4, // a state that was skipped is 0.1 N
                    qPrintable(QString("%1 of %2 N, seed %3").arg(tick.sent.z).arg(tick.force.z).arg(test::seed())));
            state += static_cast<int>(random.below(3));
        }
        QVERIFY(std::abs(servo.step(patch, {{0, 0, -0.003}, {}, 0, 9}, {9, 0, 9, true}).sent.z - 3) < 0.01);
    }
}

void PassivityTest::handsThatDrawEightsKeepTheirForce_data() {
    QTest::addColumn<double>("friction");
    QTest::addColumn<double>("jump");
    for (const double friction : {0.0, 0.2})
        for (const double jump : {SafetyLimits::none, 0.08})
            QTest::addRow("friction %g, jump %g N", friction, jump) << friction << jump;
}

/// The window's demonstration: eights on a rough ball of 10 cm. The controller is for walls that shake, not for this.
void PassivityTest::handsThatDrawEightsKeepTheirForce() {
    QFETCH(double, friction);
    QFETCH(double, jump);
    const Solid& s = solids()[1];
    Trajectory way;
    for (int i = 0; i <= 800; ++i) {
        const double t = 0.01 * i, u = 2 * shapes::pi * t / 4, in = std::min(1.0, t);
        way.push_back({t, {0.03 * std::sin(u) * in, 0.02 * std::sin(2 * u) * in, -0.042 * in}});
    }
    const auto hand = makeHand(way, {});
    ServoOptions options;
    options.tool = {0.02, friction};
    options.law.stiffness = 800;
    options.safety = SafetyLimits::off();
    options.safety.mostForce = 8;
    options.safety.mostJump = jump;
    options.port.mass = HandModel{}.mass;
    options.workspace.scale = 10; // a radius of ten centimetres
    options.workspace.centre = {0, 0, 1.3};
    Servo servo(options);
    const PatchPtr patch = patchOf(s);
    DeviceState state;
    double law = 0, sent = 0, most = 0;
    int contacts = 0, ticks = 0;
    while (hand->read(state)) {
        const Tick tick = servo.step(patch, state, {state.time, state.time, state.time, true});
        hand->send(tick.sent);
        if (state.time < 1.2)
            continue;
        law += length(tick.force) / options.workspace.scale;
        sent += length(tick.sent);
        most = std::max(most, length(tick.force) / options.workspace.scale);
        contacts += tick.contact;
        ++ticks;
    }
    const QString told =
        QString("sent %1, most %2 N, contact %3").arg(sent / law).arg(most).arg(double(contacts) / ticks);
    QVERIFY2(sent > 0.98 * law && most < 6 && contacts > 0.9 * ticks, qPrintable(told));
}

void PassivityTest::handsComeToRest_data() {
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<int>("delay");
    for (const double stiffness : {500.0, 3000.0})
        for (const int delay : {0, 1})
            QTest::addRow("%g N/m, delay %d", stiffness, delay) << stiffness << delay;
}

/// A hand presses on a plane a centimetre below it: with the controller it comes to rest, up to the device's limit.
void PassivityTest::handsComeToRest() {
    QFETCH(double, stiffness);
    QFETCH(int, delay);
    const Solid s = plane(0.035);
    HandModel model;
    model.delay = static_cast<std::size_t>(delay);
    model.settling = 1;
    const auto hand = makeHand({{0, {0, 0, 0.01}}, {0.2, {0, 0, -0.01}}, {1, {0, 0, -0.01}}}, model);
    ServoOptions options;
    options.law.stiffness = stiffness;
    options.safety = SafetyLimits::off();
    options.port = {static_cast<std::size_t>(delay), model.mass, model.tick};
    Servo servo(options);
    const PatchPtr patch = patchOf(s);
    DeviceState state;
    double lowest = 0, highest = -1;
    while (hand->read(state)) {
        const Tick tick = servo.step(patch, state, {state.time, 0, state.time, true});
        hand->send(tick.sent);
        QVERIFY(servo.passivity().workOnHand() <= 1e-6);
        if (state.time > 1.6) {
            lowest = std::min(lowest, state.position.z);
            highest = std::max(highest, state.position.z);
        }
    }
    const double rest = -0.01 * model.muscle / (model.muscle + stiffness); // where both springs balance
    QVERIFY2(highest - lowest < 1e-3, std::to_string(highest - lowest).c_str());
    QVERIFY2(std::abs(0.5 * (highest + lowest) - rest) < 2e-3, std::to_string(lowest).c_str());
}

static const test::Registered<PassivityTest> registered;
#include "passivity_test.moc"
