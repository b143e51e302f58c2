// The quadratic program of contacts: against its conditions and against random places.
#include "core/base/random.h"
#include "core/haptics/half_spaces.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using haptics::HalfSpace;

class HalfSpacesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void noRandomPlaceIsNearer();
    void whatIsAllowedStays();
    void noPlaceInCommonIsTold();
};

static bool inside(std::span<const HalfSpace> spaces, const Vec3d& q, double slack) {
    return std::all_of(spaces.begin(), spaces.end(),
                       [&](const HalfSpace& s) { return dot(s.normal, q) >= s.offset - slack; });
}

void HalfSpacesTest::noRandomPlaceIsNearer() {
    base::Random random(test::seed());
    for (int i = 0; i < test::effort(2000); ++i) {
        std::vector<HalfSpace> spaces(1 + random.below(4));
        for (HalfSpace& s : spaces)
            s = {random.unitVector(), random.uniform(-1, 0)}; // 0 is in all of them
        const Vec3d goal = random.unitVector() * random.uniform(0, 3);
        const auto q = nearestIn(spaces, goal);
        QVERIFY2(q, std::to_string(test::seed()).c_str());
        QVERIFY(inside(spaces, *q, 1e-9));
        for (int k = 0; k < 200; ++k) {
            const Vec3d other = *q + random.unitVector() * std::pow(10.0, random.uniform(-4, 0.5));
            if (inside(spaces, other, 0))
                QVERIFY(distance(other, goal) >= distance(*q, goal) - 1e-9);
        }
    }
}

void HalfSpacesTest::whatIsAllowedStays() {
    const HalfSpace spaces[] = {{{0, 0, 1}, -0.5}, {{1, 0, 0}, 0.25}};
    QCOMPARE(nearestIn(spaces, {0.5, 2, 0})->y, 2.0);
    QCOMPARE(distance(*nearestIn(spaces, {0.5, 2, 0}), Vec3d{0.5, 2, 0}), 0.0);
    QCOMPARE(distance(*haptics::nearestIn({}, {1, 2, 3}), Vec3d{1, 2, 3}), 0.0);
}

void HalfSpacesTest::noPlaceInCommonIsTold() {
    const HalfSpace apart[] = {{{0, 0, 1}, 0.5}, {{0, 0, -1}, 0.5}};
    QVERIFY(!nearestIn(apart, {0, 0, 0}));
}

static const test::Registered<HalfSpacesTest> registered;
#include "half_spaces_test.moc"
