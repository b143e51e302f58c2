#include "core/surfel/bounds_lanes.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using namespace surfel;

class BoundsLanesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void lanesAnswerLikeBoxes();
    void rayIntervalsAreThoseOfClip();
    void emptyLanesAnswerNo();
    void containingBoundsAnswerYesWheneverInnerOnesDo();
};

static base::Vec3f randomPoint(base::Random& random) {
    // On a coarse lattice, so that borders and equal coordinates are frequent.
    const auto c = [&] { return static_cast<float>(static_cast<int>(random.below(17)) - 8) * 0.25f; };
    return {c(), c(), c()};
}

static base::Box3f randomBox(base::Random& random) {
    base::Box3f box;
    box.extend(randomPoint(random));
    box.extend(randomPoint(random));
    return box;
}

static BoundsLanes randomLanes(base::Random& random) {
    BoundsLanes lanes;
    for (int i = 0; i < laneCount; ++i)
        lanes.set(i, randomBox(random), static_cast<float>(random.below(5)) * 0.25f);
    return lanes;
}

static float boxDistanceSq(const base::Box3f& a, const base::Box3f& b) {
    float sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const float gap = std::max({a.lo[k] - b.hi[k], b.lo[k] - a.hi[k], 0.0f});
        sum += gap * gap;
    }
    return sum;
}

void BoundsLanesTest::lanesAnswerLikeBoxes() {
    base::Random random(test::seed());
    for (int round = 0; round < 20000; ++round) {
        const BoundsLanes lanes = randomLanes(random);
        const base::Vec3f x = randomPoint(random);
        const base::Box3f q = randomBox(random);
        const float radius = static_cast<float>(random.below(9)) * 0.25f, reach = 1 + radius;
        float distanceSq[laneCount];
        lanes.distanceSq(x, distanceSq);
        for (int i = 0; i < laneCount; ++i) {
            const base::Box3f box = lanes.box(i);
            const float support = lanes.maxSupport[i];
            QVERIFY(distanceSq[i] == box.distanceSq(x));
            QCOMPARE((lanes.supporting(x) >> i & 1) != 0, box.distanceSq(x) < support * support);
            QCOMPARE((lanes.supporting(q) >> i & 1) != 0, boxDistanceSq(box, q) < support * support);
            const float far = reach * support;
            QCOMPARE((lanes.supporting(x, reach) >> i & 1) != 0, box.distanceSq(x) < far * far);
            QCOMPARE((lanes.supporting(q, reach) >> i & 1) != 0, boxDistanceSq(box, q) < far * far);
            QCOMPARE((lanes.within(x, radius * radius) >> i & 1) != 0, box.distanceSq(x) <= radius * radius);
        }
    }
}

void BoundsLanesTest::rayIntervalsAreThoseOfClip() {
    base::Random random(test::seed());
    int hits = 0;
    for (int round = 0; round < 20000; ++round) {
        const BoundsLanes lanes = randomLanes(random);
        base::Rayf ray{randomPoint(random), base::cast<float>(random.unitVector())};
        if (round % 3 == 0)
            ray.direction = round % 2 ? base::Vec3f{0, 0, -1} : base::Vec3f{0.6f, 0, 0.8f};
        float enter[laneCount], leave[laneCount];
        const unsigned mask = lanes.meeting(RaySlabs(ray), enter, leave);
        for (int i = 0; i < laneCount; ++i) {
            const auto expected = clip(ray, lanes.box(i).inflated(surfaceReach * lanes.maxSupport[i]));
            QCOMPARE((mask >> i & 1) != 0, expected.first <= expected.second);
            if (mask >> i & 1) {
                QVERIFY(enter[i] == expected.first);
                QVERIFY(leave[i] == expected.second);
                ++hits;
            }
        }
    }
    QVERIFY(hits > 1000);
}

void BoundsLanesTest::emptyLanesAnswerNo() {
    const BoundsLanes lanes;
    QCOMPARE(lanes.supporting(base::Vec3f{0, 0, 0}), 0u);
    QCOMPARE(lanes.supporting(base::Box3f{{-1e30f, -1e30f, -1e30f}, {1e30f, 1e30f, 1e30f}}), 0u);
    QCOMPARE(lanes.within({0, 0, 0}, 1e30f), 0u);
    QVERIFY(lanes.box(3).empty());
}

/// What lets a descent skip a node: no answer may be lost to rounding on the way up.
void BoundsLanesTest::containingBoundsAnswerYesWheneverInnerOnesDo() {
    base::Random random(test::seed());
    for (int round = 0; round < 20000; ++round) {
        BoundsLanes lanes;
        base::Box3f outer;
        float support = 0;
        for (int i = 1; i < laneCount; ++i) {
            base::Box3f box;
            box.extend(base::cast<float>(random.unitVector() * random.uniform(0, 100)));
            box.extend(base::cast<float>(random.unitVector() * random.uniform(0, 100)));
            const auto s = static_cast<float>(random.uniform(0, 40));
            lanes.set(i, box, s);
            outer.extend(box);
            support = std::max(support, s);
        }
        lanes.set(0, outer, support);
        const base::Vec3f x = base::cast<float>(random.unitVector() * random.uniform(0, 200));
        const base::Rayf ray{x, base::cast<float>(random.unitVector())};
        float enter[laneCount], leave[laneCount];
        const unsigned met = lanes.meeting(RaySlabs(ray), enter, leave), supporting = lanes.supporting(x);
        QVERIFY(met == 0 || (met & 1));
        QVERIFY(supporting == 0 || (supporting & 1));
        for (int i = 1; i < laneCount; ++i)
            QVERIFY(!(met >> i & 1) || (enter[0] <= enter[i] && leave[i] <= leave[0]));
    }
}

static const test::Registered<BoundsLanesTest> registered;
#include "bounds_lanes_test.moc"
