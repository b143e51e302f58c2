// Whatever the model says, a device is not hurt: ramp, limits, and nothing where something is missing.
#include "core/base/random.h"
#include "core/haptics/safety.h"
#include "support/registry.h"

#include <QTest>

using namespace haptics;
using base::Vec3d;

class SafetyTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void forcesRampIn();
    void forcesAreLimitedInSizeAndChange();
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
