// Whatever the model says, a device is not hurt: ramp, limits, and nothing where something is missing.
#include "core/base/random.h"
#include "core/haptics/servo.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using namespace haptics;
using base::Vec3d;

class SafetyTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void forcesRampIn();
    void forcesAreLimitedInSizeAndChange();
    void whatTheWayDoesNotExplainIsSpreadOverTicks();
    void jumpsOfTheModelAreNoBlow();
    void nothingIsSentOnWhatIsMissing_data();
    void nothingIsSentOnWhatIsMissing();
    void offChangesNothing();
};

void SafetyTest::forcesRampIn() {
    Safety safety({0.5, SafetyLimits::none, SafetyLimits::none, 0.02, 0.02});
    for (int i = 0; i <= 600; ++i) {
        const double t = 0.001 * i;
        const double sent = safety.pass({2, 0, 0}, {t, t, t, true}).x;
        QVERIFY(std::abs(sent - std::min(2.0, 4 * t)) < 1e-9);
    }
}

void SafetyTest::forcesAreLimitedInSizeAndChange() {
    base::Random random(test::seed());
    Safety safety({0, 3, 50, 0.02, 0.02});
    Vec3d before;
    for (int i = 0; i < 1000; ++i) {
        const double t = 0.001 * i;
        const Vec3d sent = safety.pass(random.unitVector() * random.uniform(0, 100), {t, t, t, true});
        QVERIFY(length(sent) <= 3 + 1e-12);
        QVERIFY(distance(sent, before) <= 0.05 + 1e-12);
        before = sent;
    }
}

void SafetyTest::whatTheWayDoesNotExplainIsSpreadOverTicks() {
    SafetyLimits limits = SafetyLimits::off();
    limits.mostJump = 0.08;
    Safety safety(limits);
    const auto at = [](int i, double explained) {
        const double t = 0.001 * i;
        return Circumstances{t, t, t, true, explained};
    };
    QCOMPARE(safety.pass({1, 0, 0}, at(0, 1)).x, 1.0); // all of it was the tool's own way
    for (int i = 1; i <= 25; ++i)
        QVERIFY(std::abs(safety.pass({3, 0, 0}, at(i, 0)).x - std::min(3.0, 1 + 0.08 * i)) < 1e-12);
    QCOMPARE(safety.pass({3, 0, 0}, {0.1, 0.1, 0.1, false}).x, 0.0); // but not where forces must end
}

/// A floor that jumps up and down under a tool that rests or slides: no tick changes the force by more than two per
/// cent of the limit.
void SafetyTest::jumpsOfTheModelAreNoBlow() {
    base::Random random(test::seed());
    constexpr double spacing = 0.01, unit = 0.035, most = 8;
    std::vector<PatchPtr> floors;
    for (int i = 0; i < 5; ++i) {
        surfel::SurfelList list = shapes::plane(12, spacing, unit);
        for (surfel::Surfel& each : list.items)
            each.position.z = static_cast<float>(0.001 * i);
        const surface::Surface floor = shapes::surfaceOf(list);
        floors.push_back(std::make_shared<const Patch>(Patch{floor, 0, floor.tree().bounds()}));
    }
    ServoOptions options;
    options.law.stiffness = 800;
    options.safety.mostForce = most;
    options.safety.mostJump = 0.01 * most;
    options.safety.stalePatch = SafetyLimits::none;
    options.passive = false;
    Servo servo(options);
    Vec3d x{0, 0, 0.01}, before;
    double largest = 0;
    PatchPtr floor = floors[0];
    for (int i = 0; i < 4000; ++i) {
        if (random.below(50) == 0)
            floor = floors[random.below(5)];
        const double goal = i < 500 ? 0.01 : -0.002;
        x += base::normalized(Vec3d{0.02 * std::sin(0.003 * i), 0, goal} - x) * 5e-5; // 5 cm/s
        const double t = 0.001 * i;
        const Tick tick = servo.step(floor, {x, {}, 0, t}, {t, 0, t, true});
        QVERIFY2(distance(tick.sent, before) <= 0.02 * most + 1e-9,
                 qPrintable(QString("%1 N, seed %2").arg(distance(tick.sent, before)).arg(test::seed())));
        before = tick.sent;
        largest = std::max(largest, length(before));
    }
    QVERIFY(largest > 2);
}

void SafetyTest::nothingIsSentOnWhatIsMissing_data() {
    QTest::addColumn<double>("patch"); // how old
    QTest::addColumn<double>("device");
    QTest::addColumn<bool>("focus");
    QTest::addColumn<double>("force");
    QTest::addColumn<bool>("sent");
    QTest::newRow("all is well") << 0.015 << 0.015 << true << 1.0 << true;
    QTest::newRow("an old patch") << 0.021 << 0.0 << true << 1.0 << false;
    QTest::newRow("no patch") << SafetyLimits::none << 0.0 << true << 1.0 << false;
    QTest::newRow("a silent device") << 0.0 << 0.021 << true << 1.0 << false;
    QTest::newRow("no focus") << 0.0 << 0.0 << false << 1.0 << false;
    QTest::newRow("no number") << 0.0 << 0.0 << true << std::nan("") << false;
}

void SafetyTest::nothingIsSentOnWhatIsMissing() {
    QFETCH(double, patch);
    QFETCH(double, device);
    QFETCH(bool, focus);
    QFETCH(double, force);
    QFETCH(bool, sent);
    Safety safety({0.1, 5, 100, 0.02, 0.02});
    for (int i = 0; i <= 200; ++i)
        safety.pass({1, 0, 0}, {0.001 * i, 0.001 * i, 0.001 * i, true});
    const double t = 0.201;
    const Vec3d out = safety.pass({force, 0, 0}, {t, t - patch, t - device, focus});
    QCOMPARE(lengthSq(out) > 0, sent);
    QCOMPARE(safety.interrupted(), !sent);
    if (!sent) // and then from nothing again
        QVERIFY(safety.pass({1, 0, 0}, {t + 0.001, t, t, true}).x < 0.05);
}

void SafetyTest::offChangesNothing() {
    Safety safety(SafetyLimits::off());
    QCOMPARE(safety.pass({1e6, 2, 3}, {0, 0, 0, true}).x, 1e6);
    QCOMPARE(safety.pass({-1e6, 2, 3}, {0, -1e9, -1e9, true}).x, -1e6);
}

static const test::Registered<SafetyTest> registered;
#include "safety_test.moc"
