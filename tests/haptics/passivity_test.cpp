// No energy from nothing: the controller by itself, and a hand in the loop.
#include "core/haptics/devices/hand.h"
#include "core/haptics/servo.h"
#include "haptics/solids.h"
#include "support/registry.h"

#include <functional>
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
    void noHandGetsMoreThanItGave_data();
    void noHandGetsMoreThanItGave();
    void wrongPlacesGiveNothingEither_data();
    void wrongPlacesGiveNothingEither();
    void calmHandsFindTheWholeWall_data();
    void calmHandsFindTheWholeWall();
    void statesThatComeUnevenlyFeelTheSame();
    void handsThatWerePaidTooMuchFeelAgain();
    void whatFrictionTookFeedsNoOscillation();
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

namespace {

/// A stiff floor with friction, in closed form: what the controller gets, without anything of a model.
struct Floor {
    double stiffness, friction, most = 8;
    Vec3d proxy = {};

    Vec3d force(const Vec3d& x) {
        const double depth = std::max(0.0, -x.z);
        proxy.z = std::max(0.0, x.z);
        const Vec3d along{x.x - proxy.x, x.y - proxy.y, 0};
        if (const double far = length(along); far > friction * depth)
            proxy += along * (1 - friction * depth / far);
        const Vec3d f = (proxy - x) * stiffness;
        return length(f) > most ? f * (most / length(f)) : f;
    }
    Spring spring(const Vec3d& x) const { return {stiffness, distance(proxy, x)}; }
};

/// Somebody who does anything: pulled about by muscles whose wish jumps, or with a speed that changes by up to so much
/// in each tick, at random, towards a place, or along with the force.
struct AnyHand {
    base::Random& random;
    double acceleration;
    bool muscles;
    int habit;
    Vec3d x{0, 0, 0.005}, velocity = {}, wish = {};

    void tick(int i, const Vec3d& force) {
        if (i % 7 == 0 && random.below(5) == 0)
            wish = random.unitVector() * (0.02 * random.uniform());
        constexpr int parts = 20;
        for (int part = 0; muscles && part < parts; ++part) {
            Vec3d pull = (wish - x) * 300.0 - velocity * 4.0;
            pull *= std::min(1.0, 0.1 * acceleration / (length(pull) + 1e-9));
            velocity += (pull + force) * (0.001 / parts / 0.1);
            x += velocity * (0.001 / parts);
        }
        if (muscles)
            return;
        Vec3d way = random.unitVector();
        if (habit == 1)
            way = base::normalized((wish - x) * 20.0 - velocity, way);
        if (habit == 2 && random.below(2) == 0)
            way = base::normalized(force, way);
        if (length(x) > 0.03)
            way = base::normalized(x * -1.0 - velocity * 0.01, way);
        velocity += way * (0.001 * acceleration);
        velocity *= std::min(1.0, 1 / (length(velocity) + 1e-9));
        x += velocity * 0.001;
    }
};

/// The most work that was ever done on hands of that kind, of places as they truly are; `told` spoils what is told.
double mostWork(bool muscles, double acceleration, double stiffness, const Port& port, base::Random& random,
                const std::function<Vec3d(const Vec3d&)>& told) {
    double most = 0;
    for (int hand = 0; hand < test::effort(10); ++hand) {
        Passivity passivity(port);
        Floor floor{stiffness, hand % 2 == 0 ? 0.0 : 0.5};
        AnyHand who{random, acceleration, muscles, hand % 3};
        std::vector<Vec3d> sent;
        double work = 0;
        for (int i = 0; i < 3000; ++i) {
            const Vec3d place = told(who.x), force = floor.force(place);
            sent.push_back(passivity.limit(place, force, floor.spring(place)));
            const auto at = static_cast<std::size_t>(i);
            const Vec3d acts = at >= port.delay ? sent[at - port.delay] : Vec3d{}, before = who.x;
            who.tick(i, acts);
            work += dot(acts, who.x - before);
            most = std::max(most, work);
        }
    }
    return most;
}

void addHands() {
    QTest::addColumn<bool>("muscles");
    QTest::addColumn<double>("acceleration");
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<int>("delay");
    for (const bool muscles : {false, true})
        for (const double acceleration : {5.0, 40.0, 200.0, 400.0})
            for (const double stiffness : {500.0, 3000.0})
                for (const int delay : {0, 1, 3})
                    QTest::addRow("%s, %g m/s2, %g N/m, delay %d", muscles ? "muscles" : "speeds", acceleration,
                                  stiffness, delay)
                        << muscles << acceleration << stiffness << delay;
}

Port portOf(bool muscles, int delay) {
    Port port;
    port.delay = static_cast<std::size_t>(delay);
    if (muscles)
        port.mass = 0.1;
    return port;
}

} // namespace

void PassivityTest::noHandGetsMoreThanItGave_data() {
    addHands();
}

void PassivityTest::noHandGetsMoreThanItGave() {
    QFETCH(bool, muscles);
    QFETCH(double, acceleration);
    QFETCH(double, stiffness);
    QFETCH(int, delay);
    base::Random random(test::seed());
    const double work =
        mostWork(muscles, acceleration, stiffness, portOf(muscles, delay), random, [](const Vec3d& x) { return x; });
    QVERIFY2(work <= 1e-6, qPrintable(QString("%1 J, seed %2").arg(work).arg(test::seed())));
}

void PassivityTest::wrongPlacesGiveNothingEither_data() {
    addHands();
}

/// Encoders that count, and noise on top: where errors are known, the work on true ways is bounded.
void PassivityTest::wrongPlacesGiveNothingEither() {
    QFETCH(bool, muscles);
    QFETCH(double, acceleration);
    QFETCH(double, stiffness);
    QFETCH(int, delay);
    base::Random random(test::seed());
    Port port = portOf(muscles, delay);
    constexpr double count = 5e-6, noise = 3e-6;
    port.resolution = noise + 0.5 * count * std::sqrt(3.0);
    const auto told = [&](const Vec3d& x) {
        Vec3d out = x + random.unitVector() * (noise * random.uniform());
        for (std::size_t k = 0; k < 3; ++k)
            out[k] = std::round(out[k] / count) * count;
        return out;
    };
    const double work = mostWork(muscles, acceleration, stiffness, port, random, told);
    QVERIFY2(work <= 1e-6, qPrintable(QString("%1 J, seed %2").arg(work).arg(test::seed())));
}

void PassivityTest::calmHandsFindTheWholeWall_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<int>("delay");
    for (const double speed : {0.002, 0.02, 0.1})
        for (const int delay : {0, 1})
            QTest::addRow("%g m/s, delay %d", speed, delay) << speed << delay;
}

/// What is taken from the jerky is not taken from those who feel their way: whoever comes evenly has all of the force
/// from the second tick in it on.
void PassivityTest::calmHandsFindTheWholeWall() {
    QFETCH(double, speed);
    QFETCH(int, delay);
    for (const double stiffness : {500.0, 3000.0}) {
        Passivity passivity(portOf(false, delay));
        Floor floor{stiffness, 0};
        int within = 0;
        for (int i = 0; i < 6000; ++i) { // comes for three seconds, and to rest 3 mm deep
            const double straight = speed * (3 - 0.001 * i);
            const Vec3d x{0, 0, straight > 0 ? straight : -0.003 * (1 - std::exp(straight / 0.003))};
            const Vec3d force = floor.force(x), sent = passivity.limit(x, force, floor.spring(x));
            within += length(force) > 0 ? 1 : 0;
            if (within > 1)
                QVERIFY2(distance(sent, force) <= 1e-9,
                         qPrintable(QString("%1 of %2 N").arg(length(sent)).arg(length(force))));
        }
    }
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
            const double z = std::max(-0.003, 0.3 - 0.0001 * state);
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

/// Calm for a second, then thrown: nobody foresees that. It costs at most the force over what was not foreseen, and the
/// next touch is felt.
void PassivityTest::handsThatWerePaidTooMuchFeelAgain() {
    constexpr double stiffness = 3000, jerk = 4e-4;
    Passivity passivity;
    Floor floor{stiffness, 0};
    double work = 0;
    Vec3d before, sent;
    const auto go = [&](const Vec3d& x) {
        work += dot(sent, x - before);
        before = x;
        sent = passivity.limit(x, floor.force(x), floor.spring(x));
    };
    for (int i = 0; i < 4000; ++i)
        go({0, 0, 0.001 * (1 - 0.00025 * i)});
    for (int i = 0; i < 200; ++i)
        go({0, 0, -1e-6 * i});
    go({0, 0, before.z + jerk});
    QVERIFY(work > 1e-6); // else this asks nothing
    QVERIFY2(work <= 0.5 * stiffness * jerk * jerk, std::to_string(work).c_str());
    for (int i = 0; i < 4000; ++i)
        go({0, 0, 0.001 * (1 - 0.00025 * i)});
    for (int i = 0; i < 1000; ++i)
        go({0, 0, -1e-6 * i});
    QVERIFY(length(sent) > 0.99 * stiffness * 0.999e-3);
}

/// Half a minute of rubbing, and then a stiff wall that acts three ticks late: what it took is gone.
void PassivityTest::whatFrictionTookFeedsNoOscillation() {
    Port port = portOf(true, 3);
    Passivity passivity(port);
    Floor rough{3000, 0.8};
    for (int i = 0; i < 30000; ++i) {
        const Vec3d x{0.02 * std::sin(0.02 * i), 0, -0.001 * std::min(1.0, 0.001 * i)};
        passivity.limit(x, rough.force(x), rough.spring(x));
    }
    QVERIFY(passivity.workOnHand() < -1);
    QVERIFY2(passivity.left() < 0.01, std::to_string(passivity.left()).c_str());
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
