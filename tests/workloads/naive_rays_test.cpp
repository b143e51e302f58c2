// The naive rays hit what ours hit.
#include "app/bench/naive/naive_rays.h"

#include "app/bench/scene.h"
#include "core/surface/rays/intersect.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using bench::NaiveHit;
using bench::Scene;

class NaiveRaysTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void hitsAreOursUpToTheTolerance();
    void lightIsBlockedWhereAFirstHitIs();
};

void NaiveRaysTest::hitsAreOursUpToTheTolerance() {
    Scene scene({20000, 0.02});
    const auto h = static_cast<double>(scene.surface().tree().maxSupport());
    for (const auto rays : {scene.cameraRays(), scene.randomRays()}) {
        int same = 0, all = 0, hits = 0;
        for (std::size_t i = 0; i < rays.size(); i += 173, ++all) {
            const NaiveHit naive = scene.naiveRays().intersect(
                {base::cast<double>(rays[i].origin), base::cast<double>(rays[i].direction)});
            const auto hit = intersect(scene.surface(), rays[i]);
            const bool both = hit.hit && std::isfinite(naive.t);
            hits += hit.hit ? 1 : 0;
            same += both ? std::abs(naive.t - static_cast<double>(hit.t)) < 1e-3 * h &&
                               std::abs(dot(naive.normal, base::cast<double>(hit.normal))) > 0.9999
                         : hit.hit == std::isfinite(naive.t);
        }
        QVERIFY2(hits > all / 3 && same >= 0.99 * all, qPrintable(QString("%1 of %2").arg(same).arg(all)));
    }
}

void NaiveRaysTest::lightIsBlockedWhereAFirstHitIs() {
    Scene scene({20000, 0.02});
    const auto rays = scene.randomRays().first(4096);
    std::vector<std::uint8_t> any(rays.size());
    std::vector<surface::RayHit<float>> first(rays.size());
    surface::intersectAny(scene.surface(), rays, {}, any);
    surface::intersect(scene.surface(), rays, {}, first);
    for (std::size_t i = 0; i < rays.size(); ++i)
        QCOMPARE(any[i] != 0, first[i].hit);
}

static const test::Registered<NaiveRaysTest> registered;
#include "naive_rays_test.moc"
