// The workspace follows the view and the clutch, and drifts without anybody noticing.
#include "core/haptics/calibration.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using namespace haptics;
using base::Vec3d;

class CalibrationTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void withoutAViewItStays();
    void anotherViewMovesNoTool();
    void theClutchMovesTheHandAlone();
    void driftIsPartOfTheHandsWay();
    void driftBringsTheMiddlesTogether();
};

static base::Mat3d turned(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
}

static DeviceState at(const Vec3d& position, unsigned buttons = 0) {
    return {position, {}, buttons, 0};
}

static Vec3d inReach(base::Random& random) {
    return random.unitVector() * random.uniform(0, 0.1);
}

void CalibrationTest::withoutAViewItStays() {
    base::Random random(test::seed());
    const Workspace given{{1, 2, 3}, 7};
    Calibration calibration(given);
    for (int i = 0; i < 100; ++i) {
        const Vec3d x = inReach(random);
        QVERIFY(calibration.step(at(x), i % 2 == 0).place(x) == given.place(x));
    }
}

void CalibrationTest::anotherViewMovesNoTool() {
    base::Random random(test::seed());
    for (const bool touches : {false, true}) {
        Calibration calibration;
        Vec3d x = inReach(random);
        calibration.look({{1, 1, 1}, turned(0.3), 5});
        QVERIFY(distance(calibration.step(at(x), false).place(x), {1, 1, 1}) < 1e-12); // it begins in the middle
        for (int i = 0; i < 50; ++i) {
            const Vec3d tool = calibration.workspace().place(x);
            calibration.look({random.unitVector(), turned(random.uniform(0, 6)), random.uniform(0.1, 10)});
            QVERIFY(distance(calibration.step(at(x), touches).place(x), tool) < 1e-9);
            x = inReach(random);
            calibration.step(at(x), touches);
        }
    }
}

void CalibrationTest::theClutchMovesTheHandAlone() {
    base::Random random(test::seed());
    Calibration calibration;
    calibration.look({{}, turned(1), 3});
    Vec3d x = inReach(random);
    const Vec3d tool = calibration.step(at(x), false).place(x);
    for (int i = 0; i < 100; ++i) {
        x = inReach(random);
        QVERIFY(distance(calibration.step(at(x, clutchButton), false).place(x), tool) < 1e-9);
    }
}

void CalibrationTest::driftIsPartOfTheHandsWay() {
    base::Random random(test::seed());
    Calibration calibration;
    Vec3d x;
    for (int i = 0; i < 2000; ++i) {
        if (i % 100 == 0) {
            calibration.look({random.unitVector(), turned(random.uniform(0, 6)), 2});
            calibration.step(at(x), false);
        }
        const Workspace before = calibration.workspace();
        const Vec3d to = i % 3 == 0 ? x : x + random.unitVector() * 0.002;
        const bool touches = i % 2 == 0;
        const Workspace now = calibration.step(at(to), touches);
        const double most = touches ? 0 : Calibration::drift * 2 * distance(to, x);
        QVERIFY(distance(now.centre, before.centre) <= most + 1e-12); // none where the hand rests or the tool touches
        QVERIFY(now.scale == before.scale);
        x = to;
    }
}

void CalibrationTest::driftBringsTheMiddlesTogether() {
    Calibration calibration;
    calibration.look({{1, 0, 0}, turned(0.5), 4});
    const Vec3d middle{0.02, 0.03, -0.01}; // the hand goes around it, and began beside it
    for (int i = 0; i <= 20000; ++i) {
        const double a = 0.01 * i;
        calibration.step(at(middle + Vec3d{std::cos(a), std::sin(a), std::sin(2 * a)} * 0.05), false);
    }
    QVERIFY(distance(calibration.workspace().place(middle), {1, 0, 0}) < 0.01);
}

static const test::Registered<CalibrationTest> registered;
#include "calibration_test.moc"
