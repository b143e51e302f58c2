// When the tool works, how strongly, and what the clay does to it.
#include "core/haptics/touch.h"

#include "core/haptics/servo.h"
#include "haptics/solids.h"
#include "support/registry.h"

#include <QTest>

using namespace haptics;
using namespace haptics_test;

class TouchTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void worksBetweenThresholdAndRelease();
    void pressureGrowsWithTheForce();
    void clayIsADamperWhileItIsWorked();
    void whatIsHeldFollowsAsAMaxwellElement();
    void feelingAddsNothing();
    void forcesDoNotJumpWhereAHoldBeginsAndEnds();
    void samplesBeginBelowWhatIsAbove();
};

namespace {

/// A tool over a plane, a tick at a time; stiffness 1000 N/m, a model unit a metre.
class Bench {
  public:
    explicit Bench(const TouchLaw& law, const surface::Surface& surface = plane(0.035).surface)
        : m_surface(surface), m_touch(law) {}

    /// At a height above the plane, a millisecond after the last.
    Vec3d at(double height, const Vec3d& velocity = {}) {
        const Vec3d x{0, 0, height};
        if (!m_proxy.placed())
            m_proxy.place(m_surface, {0, 0, 0.01});
        m_proxy.move(m_surface, x);
        m_time += 0.001;
        return m_touch.step({m_time, x, velocity, law(x), 1000, 1, false}, m_proxy, m_surface);
    }
    Vec3d law(const Vec3d& x) const { return forceOn({1000, 0, 0}, m_proxy, m_surface, x, {}); }
    const Touched& now() const { return m_touch.now(); }

  private:
    surface::Surface m_surface;
    Proxy m_proxy;
    Touch m_touch;
    double m_time = 0;
};

TouchLaw working() {
    TouchLaw law;
    law.works = true;
    law.threshold = 1;
    law.full = 5;
    return law;
}

TouchLaw holding(double viscosity) {
    TouchLaw law = working();
    law.holds = true;
    law.viscosity = viscosity;
    law.tear = 1e9;
    law.slack = 0.002;
    return law;
}

} // namespace

void TouchTest::worksBetweenThresholdAndRelease() {
    Bench bench(working());
    const std::pair<double, Touching> way[] = {
        {0.001, Touching::Nothing},  {-0.0009, Touching::Hovers},  {-0.0011, Touching::Works},
        {-0.00055, Touching::Works}, {-0.00045, Touching::Hovers}, {-0.0009, Touching::Hovers},
        {-0.002, Touching::Works},   {0.001, Touching::Nothing},
    };
    for (const auto& [height, phase] : way) {
        bench.at(height);
        QCOMPARE(bench.now().phase, phase);
    }
    QCOMPARE(bench.now().stroke, 2u);
}

void TouchTest::pressureGrowsWithTheForce() {
    Bench bench(working());
    for (const double newtons : {1.0, 2.0, 4.0, 5.0, 9.0}) {
        bench.at(-newtons / 1000 * (1 + 1e-7));
        QVERIFY(std::abs(bench.now().pressure - std::clamp((newtons - 1) / 4, 0.0, 1.0)) < 1e-3);
        QVERIFY(std::abs(bench.now().place.z) < 1e-6 && std::abs(bench.now().normal.z - 1) < 1e-6);
    }
}

void TouchTest::clayIsADamperWhileItIsWorked() {
    TouchLaw law = working();
    law.viscosity = 3;
    Bench bench(law);
    const Vec3d v{0.02, -0.01, -0.05};
    const Vec3d hovering = bench.at(-0.0005, v);
    QVERIFY(distance(hovering, bench.law({0, 0, -0.0005})) < 1e-9);
    const Vec3d felt = bench.at(-0.002, v), law2 = bench.law({0, 0, -0.002});
    QVERIFY(distance(felt, law2 - v * 3.0) < 1e-9);
}

/// A constant speed v: the pull goes to viscosity times v with the time constant viscosity / stiffness.
void TouchTest::whatIsHeldFollowsAsAMaxwellElement() {
    const double viscosity = 8, speed = 0.05;
    Bench bench(holding(viscosity));
    for (int i = 0; i < 100; ++i)
        bench.at(-0.002);
    QCOMPARE(bench.now().phase, Touching::Holds);
    for (int i = 1; i <= 200; ++i) {
        const double t = 0.001 * i, z = -0.002 + speed * t;
        const double force = -bench.at(z, {0, 0, speed}).z;
        const double expected = viscosity * speed * (1 - std::exp(-1000 * t / viscosity));
        QVERIFY2(std::abs(force - expected) <= 0.07 * viscosity * speed, // a tick's step of the way
                 qPrintable(QString("%1 s: %2 for %3").arg(t).arg(force).arg(expected)));
        QVERIFY(bench.now().phase == Touching::Holds);
        QVERIFY(bench.now().place.z <= speed * t + 1e-9 && bench.now().place.z >= speed * t - 0.001);
    }
    for (int i = 0; i < 300; ++i)
        bench.at(-0.002 + speed * 0.2);
    QCOMPARE(bench.now().phase, Touching::Nothing); // it rests
    QCOMPARE(bench.now().stroke, 1u);
}

void TouchTest::feelingAddsNothing() {
    TouchLaw law = holding(5);
    law.works = false;
    Bench bench(law);
    for (const double height : {0.0, -0.01, -0.003, 0.01}) {
        const Vec3d felt = bench.at(height, {1, 2, 3});
        QVERIFY(distance(felt, bench.law({0, 0, height})) < 1e-12);
        QVERIFY(!bench.now().working());
    }
}

void TouchTest::forcesDoNotJumpWhereAHoldBeginsAndEnds() {
    Bench bench(holding(2));
    Vec3d before;
    double height = 0.004, phase = 0;
    for (int i = 0; i < 2000; ++i) { // in, out to 3 cm, still, back in
        const double goal = i < 300 ? -0.003 : i < 900 ? 0.03 : i < 1400 ? 0.03 : -0.002;
        const double step = std::clamp(goal - height, -0.00005, 0.00005); // 5 cm/s
        height += step;
        const Vec3d force = bench.at(height, {0, 0, 1000 * step});
        QVERIFY2(distance(force, before) < 0.12, // of 3 N; a tick of the spring is 0.05
                 qPrintable(QString("tick %1: %2").arg(i).arg(distance(force, before))));
        before = force;
        phase = std::max(phase, static_cast<double>(bench.now().phase));
    }
    QCOMPARE(phase, static_cast<double>(Touching::Holds));
}

/// Under a lid, rays must not begin above it.
void TouchTest::samplesBeginBelowWhatIsAbove() {
    surfel::SurfelList list = shapes::plane(40, 0.01, 0.035);
    for (const surfel::Surfel& s : shapes::plane(40, 0.01, 0.035, 0.2).items)
        list.items.push_back(s);
    for (const double above : {0.05, 1.0}) {
        TouchLaw law = working();
        law.above = above;
        Bench bench(law, shapes::surfaceOf(list));
        bench.at(-0.003);
        QVERIFY(bench.now().working());
        QVERIFY(bench.now().room > 0.04 && bench.now().room < 0.2);
    }
}

static const test::Registered<TouchTest> registered;
#include "touch_test.moc"
