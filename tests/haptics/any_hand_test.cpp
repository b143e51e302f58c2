// Hands that do anything get no more out of the controller than they put in, and calm ones get all of it.
#include "core/base/random.h"
#include "core/haptics/passivity.h"
#include "support/registry.h"

#include <functional>
#include <QTest>
#include <vector>

using namespace haptics;
using base::Vec3d;

class AnyHandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void noHandGetsMoreThanItGave_data();
    void noHandGetsMoreThanItGave();
    void wrongPlacesGiveNothingEither_data();
    void wrongPlacesGiveNothingEither();
    void calmHandsFindTheWholeWall_data();
    void calmHandsFindTheWholeWall();
    void handsThatWerePaidTooMuchFeelAgain();
    void whatFrictionTookFeedsNoOscillation();
};

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

/// Now and then a wish is more than three times what was seen in the last half second, and three ticks are long.
double mostOf(int delay) {
    return delay > 1 ? 1e-5 : 1e-6;
}

Port portOf(bool muscles, int delay) {
    Port port;
    port.delay = static_cast<std::size_t>(delay);
    if (muscles)
        port.mass = 0.1;
    return port;
}

} // namespace

void AnyHandTest::noHandGetsMoreThanItGave_data() {
    addHands();
}

void AnyHandTest::noHandGetsMoreThanItGave() {
    QFETCH(bool, muscles);
    QFETCH(double, acceleration);
    QFETCH(double, stiffness);
    QFETCH(int, delay);
    base::Random random(test::seed());
    const double work =
        mostWork(muscles, acceleration, stiffness, portOf(muscles, delay), random, [](const Vec3d& x) { return x; });
    QVERIFY2(work <= mostOf(delay), qPrintable(QString("%1 J, seed %2").arg(work).arg(test::seed())));
}

void AnyHandTest::wrongPlacesGiveNothingEither_data() {
    addHands();
}

/// Encoders that count, and noise on top: where errors are known, the work on true ways is bounded.
void AnyHandTest::wrongPlacesGiveNothingEither() {
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
    QVERIFY2(work <= mostOf(delay), qPrintable(QString("%1 J, seed %2").arg(work).arg(test::seed())));
}

void AnyHandTest::calmHandsFindTheWholeWall_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<int>("delay");
    for (const double speed : {0.002, 0.02, 0.1})
        for (const int delay : {0, 1})
            QTest::addRow("%g m/s, delay %d", speed, delay) << speed << delay;
}

/// What is taken from the jerky is not taken from those who feel their way: whoever comes evenly has all of the force
/// from the second tick in it on.
void AnyHandTest::calmHandsFindTheWholeWall() {
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

/// Calm for a second, then thrown: nobody foresees that. It costs at most the force over what was not foreseen, and the
/// next touch is felt.
void AnyHandTest::handsThatWerePaidTooMuchFeelAgain() {
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
void AnyHandTest::whatFrictionTookFeedsNoOscillation() {
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

static const test::Registered<AnyHandTest> registered;
#include "any_hand_test.moc"
