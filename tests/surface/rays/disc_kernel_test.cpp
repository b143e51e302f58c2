// Nearest discs along rays: the walk against a loop over all surfels, packets against single rays.
#include "core/surface/rays/disc_kernel.h"

#include "core/surface/rays/surface_intervals.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <hwy/targets.h>
#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;

class DiscKernelTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void walksFindTheNearestOfAllDiscs();
    void packetsGiveTheBitsOfSingleRays_data();
    void packetsGiveTheBitsOfSingleRays();
    void crossingsBeforeTMinArePassedOver();
    void raysInTheAxesMeetWhatTheyShould();
    void intervalsCoverAllBallsAndNothingElse();
    void avx2AndAvx512GiveTheSameBits();
};

namespace {

/// Supports differ by a factor of two.
surfel::SurfelList noisyTorus(std::uint64_t seed) {
    surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.05, 0.18), 0.01, seed);
    base::Random random(seed + 1);
    for (surfel::Surfel& s : list.items)
        s.support *= static_cast<float>(random.uniform(0.7, 1.4));
    return list;
}

std::vector<base::Rayf> randomRays(std::size_t count, std::uint64_t seed) {
    base::Random random(seed);
    std::vector<base::Rayf> out;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d d = random.unitVector(), target = random.unitVector() * random.uniform(0, 1.5);
        out.push_back({base::cast<float>(target - d * 4.0), base::normalized(base::cast<float>(d))});
    }
    return out;
}

/// A camera's rays, row by row.
std::vector<base::Rayf> cameraRays(int size) {
    std::vector<base::Rayf> out;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Vec3f d{3.2f * (float(x) / float(size) - 0.5f), 3.2f * (float(y) / float(size) - 0.5f), -3};
            out.push_back({{0.3f, 0.2f, 4}, base::normalized(d)});
        }
    return out;
}

std::vector<DiscHit> find(const Surface& surface, std::span<const base::Rayf> rays, std::size_t packet) {
    std::vector<DiscHit> out(rays.size());
    for (std::size_t begin = 0; begin < rays.size(); begin += packet) {
        const std::size_t count = std::min(packet, rays.size() - begin);
        nearestDiscs(surface.tree(), rays.subspan(begin, count),
                     {0, std::numeric_limits<float>::infinity(), surface.tree().maxSupport()},
                     std::span(out).subspan(begin, count));
    }
    return out;
}

bool same(const DiscHit& a, const DiscHit& b) {
    return a.nearest == b.nearest && a.guess == b.guess && a.cosine == b.cosine && a.support == b.support &&
           a.brushFirst == b.brushFirst && a.brushLast == b.brushLast && a.brushSupport == b.brushSupport &&
           a.facing == b.facing;
}

/// How far inside a disc its crossing lies, from 0 at the rim; negative for none. Where it crosses in t.
double depthOfCrossing(const surfel::Surfel& s, const base::Rayd& ray, double& t) {
    const Vec3d n = base::cast<double>(s.normal), p = base::cast<double>(s.position);
    t = dot(n, p - ray.origin) / dot(n, ray.direction);
    return t > 0 ? double(surfel::surfaceReach * s.support) - distance(ray.at(t), p) : -1;
}

} // namespace

void DiscKernelTest::walksFindTheNearestOfAllDiscs() {
    const surfel::SurfelList list = noisyTorus(test::seed());
    const Surface surface = shapes::surfaceOf(list);
    const std::vector<base::Rayf> rays = randomRays(400, test::seed() + 2);
    const std::vector<DiscHit> found = find(surface, rays, 32);
    int hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const base::Rayd ray{base::cast<double>(rays[i].origin), base::cast<double>(rays[i].direction)};
        // discs met at their very rim may count or not
        double surely = std::numeric_limits<double>::infinity(), perhaps = surely;
        for (const surfel::Surfel& s : list.items) {
            double t = 0;
            const double depth = depthOfCrossing(s, ray, t);
            surely = depth > 1e-4 ? std::min(surely, t) : surely;
            perhaps = depth > -1e-4 ? std::min(perhaps, t) : perhaps;
        }
        const double t = double(found[i].nearest);
        const QString where = QString("ray %1, seed %2: %3").arg(i).arg(test::seed()).arg(t);
        QVERIFY2(t <= surely + 2e-4 && (t >= perhaps - 2e-4), qPrintable(where));
        hits += found[i].crossed();
        if (found[i].crossed())
            QVERIFY2(std::abs(found[i].guess - found[i].nearest) <= 0.5f * found[i].support, qPrintable(where));
    }
    QVERIFY(hits > 150 && hits < 390);
}

void DiscKernelTest::packetsGiveTheBitsOfSingleRays_data() {
    QTest::addColumn<bool>("camera");
    QTest::addRow("camera") << true;
    QTest::addRow("scattered") << false;
}

void DiscKernelTest::packetsGiveTheBitsOfSingleRays() {
    QFETCH(bool, camera);
    const Surface noisy = shapes::surfaceOf(noisyTorus(test::seed()));
    // all crossings of one ray at the same t
    const Surface flat = shapes::surfaceOf(shapes::plane(20, 0.1, 0.35));
    const std::vector<base::Rayf> rays = camera ? cameraRays(48) : randomRays(1500, test::seed());
    for (const Surface* surface : {&noisy, &flat}) {
        const std::vector<DiscHit> single = find(*surface, rays, 1);
        for (const std::size_t packet : {std::size_t(3), std::size_t(32), std::size_t(200)}) {
            const std::vector<DiscHit> together = find(*surface, rays, packet);
            for (std::size_t i = 0; i < rays.size(); ++i)
                QVERIFY2(same(single[i], together[i]),
                         qPrintable(QString("packets of %1, ray %2, seed %3").arg(packet).arg(i).arg(test::seed())));
        }
    }
}

void DiscKernelTest::crossingsBeforeTMinArePassedOver() {
    const Surface surface = shapes::surfaceOf(shapes::sphere(4000, 1, 0.2));
    const base::Rayf ray{{0.1f, 0.2f, 5}, {0, 0, -1}};
    DiscHit front, back, none;
    nearestDiscs(surface.tree(), {&ray, 1}, {0, 100, 0.2f}, {&front, 1});
    nearestDiscs(surface.tree(), {&ray, 1}, {4.5f, 100, 0.2f}, {&back, 1});
    nearestDiscs(surface.tree(), {&ray, 1}, {4.5f, 5.5f, 0.2f}, {&none, 1});
    QVERIFY2(front.cosine < -0.9f && std::abs(front.guess - 4.0253f) < 0.012f && !front.doubtful(),
             qPrintable(QString("%1 %2").arg(front.cosine).arg(front.guess)));
    QVERIFY2(back.cosine > 0.9f && std::abs(back.guess - 5.9747f) < 0.012f && !back.doubtful(),
             qPrintable(QString("%1 %2").arg(back.cosine).arg(back.guess)));
    QVERIFY(!none.crossed());
}

/// Zero components of directions, and boxes without thickness.
void DiscKernelTest::raysInTheAxesMeetWhatTheyShould() {
    const Surface surface = shapes::surfaceOf(shapes::plane(10, 0.1, 0.35));
    for (const float x : {0.0f, 0.5f, 1.0f, 1.2f, 1.3f}) {
        const base::Rayf ray{{x, 0, 2}, {0, 0, -1}};
        DiscHit hit;
        nearestDiscs(surface.tree(), {&ray, 1}, {0, 100, 0.35f}, {&hit, 1});
        QCOMPARE(hit.crossed(), x < 1.245f);
        if (hit.crossed())
            QVERIFY(std::abs(hit.guess - 2) < 1e-6f);
    }
    const base::Rayf within{{-5, 0.05f, 0}, {1, 0, 0}};
    DiscHit hit;
    nearestDiscs(surface.tree(), {&within, 1}, {0, 100, 0.35f}, {&hit, 1});
    QVERIFY(!hit.crossed() && hit.brushed() && hit.doubtful());
}

void DiscKernelTest::intervalsCoverAllBallsAndNothingElse() {
    const surfel::SurfelList list = noisyTorus(test::seed());
    const Surface surface = shapes::surfaceOf(list);
    int inside = 0, outside = 0;
    for (const base::Rayf& ray : randomRays(60, test::seed())) {
        std::vector<SurfaceInterval> intervals;
        forSurfaceIntervals(surface, ray, 0, 100, [&](const SurfaceInterval& i) {
            if (!intervals.empty() && i.begin <= intervals.back().end)
                throw std::logic_error("intervals overlap or come out of order");
            intervals.push_back(i);
            return true;
        });
        for (double t = 2; t < 6; t += 0.01) {
            const Vec3d x = base::Rayd{base::cast<double>(ray.origin), base::cast<double>(ray.direction)}.at(t);
            double depth = -1;
            for (const surfel::Surfel& s : list.items)
                depth = std::max(depth, double(surfel::surfaceReach * s.support) -
                                            distance(x, base::cast<double>(s.position)));
            const bool covered = std::any_of(intervals.begin(), intervals.end(),
                                             [&](const SurfaceInterval& i) { return t >= i.begin && t <= i.end; });
            QVERIFY2(covered || depth < 1e-4, qPrintable(QString("seed %1, t %2").arg(test::seed()).arg(t)));
            inside += covered;
            outside += !covered;
        }
    }
    QVERIFY(inside > 1000 && outside > 1000);
}

void DiscKernelTest::avx2AndAvx512GiveTheSameBits() {
    if ((hwy::SupportedTargets() & HWY_AVX3) == 0)
        QSKIP("this machine has no AVX-512");
    const Surface surface = shapes::surfaceOf(noisyTorus(test::seed()));
    const std::vector<base::Rayf> rays = cameraRays(40);
    const std::vector<DiscHit> wide = find(surface, rays, 32);
    hwy::DisableTargets(HWY_AVX3 | HWY_AVX3_DL);
    hwy::GetChosenTarget().DeInit();
    const std::vector<DiscHit> narrow = find(surface, rays, 32);
    hwy::DisableTargets(0);
    hwy::GetChosenTarget().DeInit();
    for (std::size_t i = 0; i < rays.size(); ++i)
        QVERIFY2(same(wide[i], narrow[i]), qPrintable(QString("ray %1, seed %2").arg(i).arg(test::seed())));
}

static const test::Registered<DiscKernelTest> registered;
#include "disc_kernel_test.moc"
