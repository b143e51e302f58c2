// The pass as a whole: the same at any thread count, alike for full and adaptive pictures, stopped when asked to.
#include "core/raycast/illuminate.h"

#include "core/raycast/edge_aware_filter.h"
#include "light_scenes.h"
#include "raycast_views.h"
#include "support/registry.h"
#include "support/threads.h"

#include <atomic>
#include <cstring>
#include <QTest>

using namespace raycast;
using base::Vec3d;
using base::Vec3f;

class IlluminateTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void samplesAreTheFirstHitsOfTheirRays();
    void sameBitsAtAnyThreadCount();
    void adaptivePicturesAreLitAlike();
    void aFacingPlaceGetsTheLampsPower();
    void evenOutKeepsWhatDoesNotBelongTogether();
    void tablesKnowTheirRows();
    void cancellingStopsIt();
};

namespace {

const surface::Surface& torus() {
    static const surface::Surface out = shapes::surfaceOf(shapes::torus(0.7, 0.3, 0.04, 0.14));
    return out;
}

ImageRays view(int pixels) {
    return views::filling({0, 0, 0}, 1.1, {0.4, 0.5, -1}, pixels);
}

std::vector<Lit> litBy(const LightScene& scene, const ImageRays& rays, std::span<const Sample> samples,
                       const base::Progress& progress = {}) {
    std::vector<Lit> out(samples.size());
    LightCounts counts;
    illuminate(scene, seenThrough(rays, samples), out, counts, progress);
    return out;
}

Lighting everything(Material material) {
    Lighting out = scenes::lightingOf(material);
    out.shadows = out.occlusion = out.ground = true;
    return out;
}

} // namespace

void IlluminateTest::samplesAreTheFirstHitsOfTheirRays() {
    const ImageRays rays = view(48);
    CastCounts counts;
    const auto samples = fullCast(torus(), rays, counts);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const base::Rayd ray = rays.ray(static_cast<int>(i) % 48, static_cast<int>(i) / 48);
        Sample alone;
        alone.hit = intersect(torus(), {base::cast<float>(ray.origin), base::cast<float>(ray.direction)});
        QVERIFY2(views::sameBits(samples[i], alone), qPrintable(QString::number(i)));
    }
    QVERIFY(counts.hits > 300);
}

void IlluminateTest::sameBitsAtAnyThreadCount() {
    const ImageRays rays = view(40);
    CastCounts counts;
    const auto samples = fullCast(torus(), rays, counts);
    for (const MaterialRow& row : materialTable()) {
        const LightScene scene(torus(), everything(row.material), scenes::viewer());
        const auto work = [&] { return litBy(scene, rays, samples); };
        const auto one = test::onThreads(1, work), two = test::onThreads(2, work);
        for (std::size_t i = 0; i < one.size(); ++i)
            QVERIFY2(one[i].colour == two[i].colour && one[i].shade == two[i].shade && one[i].seen == two[i].seen,
                     row.id);
    }
}

void IlluminateTest::adaptivePicturesAreLitAlike() {
    const ImageRays rays = view(128);
    CastCounts counts;
    const auto full = fullCast(torus(), rays, counts);
    AdaptiveCast caster(torus());
    const AdaptiveImage image = caster.cast(rays, {1}, counts);
    QVERIFY(counts.rays * 2 < full.size());
    const LightScene scene(torus(), everything(Material::Clay), scenes::viewer());
    const auto exact = litBy(scene, rays, full), between = litBy(scene, rays, image.samples);
    std::size_t hits = 0, close = 0;
    for (std::size_t i = 0; i < full.size(); ++i)
        if (full[i].hit.hit && image.samples[i].hit.hit) {
            ++hits;
            close += scenes::largest(exact[i].colour - between[i].colour) < 0.03f ? 1 : 0;
        }
    QVERIFY2(close * 100 >= hits * 98, qPrintable(QString("%1 of %2").arg(close).arg(hits)));
}

void IlluminateTest::aFacingPlaceGetsTheLampsPower() {
    // Clay in one lamp straight on: colour times power, plus the room's light, plus gloss seen from the lamp's side.
    Lighting lighting = scenes::lightingOf(Material::Clay);
    lighting.directions = {{0, 0, 1}};
    const LightScene scene(shapes::surfaceOf(shapes::plane(20, 0.05, 0.17)), lighting, scenes::viewer());
    const std::vector<base::Rayd> rays{{{0, 0, 3}, {0, 0, -1}}};
    const Vec3f light = scenes::lightAlong(scene, rays).front();
    const MaterialRow& clay = materialRow(Material::Clay);
    const Vec3f n{0, 0, 1}, power = scene.environment.lamps().front().power;
    for (const std::size_t k : {0u, 1u, 2u}) {
        const float expected = clay.colour[k] * (power[k] + scene.environment.room(n)[k]) + clay.gloss * power[k];
        QVERIFY2(std::abs(light[k] - expected) < 1e-3f, qPrintable(QString::number(light[k])));
    }
}

void IlluminateTest::evenOutKeepsWhatDoesNotBelongTogether() {
    constexpr int side = 16;
    std::vector<LightPoint> points(side * side);
    std::vector<float> flat(points.size(), 0.7f), halves(points.size()), pattern(points.size());
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto i = static_cast<std::size_t>(y * side + x);
            const bool near = x < side / 2; // a step in depth between the halves
            points[i] = scenes::pointAt({0.01 * x, 0.01 * y, near ? 1.0 : 0.0}, {0, 0, 1}, 0.1f);
            halves[i] = near ? 0.25f : 1;
            pattern[i] = static_cast<float>(y % 4 * 4 + x % 4) / 15;
        }
    edgeAwareFilter(points, side, flat);
    edgeAwareFilter(points, side, halves);
    edgeAwareFilter(points, side, pattern);
    for (int y = 2; y < side - 2; ++y)
        for (const int x : {0, 5, 7, 8, 12}) {
            const auto i = static_cast<std::size_t>(y * side + x);
            QVERIFY(std::abs(flat[i] - 0.7f) < 1e-6f && halves[i] == (x < side / 2 ? 0.25f : 1));
            if (x == 5 || x == 12)
                QVERIFY(std::abs(pattern[i] - 0.5f) < 1e-5f); // all sixteen have the same say
        }
    auto alone = pattern;
    edgeAwareFilter(points, 0, alone);
    QVERIFY(alone == pattern);
}

void IlluminateTest::tablesKnowTheirRows() {
    for (std::size_t k = 0; k < materialTable().size(); ++k) {
        const MaterialRow& row = materialTable()[k];
        QVERIFY(static_cast<std::size_t>(row.material) == k && material(row.id) == row.material);
        QVERIFY(std::strlen(row.label) > 0 && std::strlen(row.tip) > 10);
    }
    for (std::size_t k = 0; k < lightRigTable().size(); ++k) {
        const LightRigRow& row = lightRigTable()[k];
        QVERIFY(static_cast<std::size_t>(row.rig) == k && lightRig(row.id) == row.rig && !row.lamps.empty());
        Lighting lighting;
        lighting.rig = row.rig;
        const Environment environment(lighting, scenes::viewer());
        for (const Lamp& lamp : environment.lamps()) {
            QVERIFY(std::abs(length(lamp.direction) - 1) < 1e-5f);
            QVERIFY(environment.from(lamp.direction).y > environment.room(lamp.direction).y); // it can be seen
        }
    }
    QVERIFY_EXCEPTION_THROWN(material("wood"), base::Error);
    QVERIFY_EXCEPTION_THROWN(lightRig("moon"), base::Error);
}

void IlluminateTest::cancellingStopsIt() {
    const ImageRays rays = view(16);
    CastCounts counts;
    const auto samples = fullCast(torus(), rays, counts);
    const std::atomic<bool> stop{true};
    for (const MaterialRow& row : materialTable()) {
        const LightScene scene(torus(), everything(row.material), scenes::viewer());
        QVERIFY_EXCEPTION_THROWN(litBy(scene, rays, samples, {{}, &stop}), base::Cancelled);
    }
}

static const test::Registered<IlluminateTest> registered;
#include "illuminate_test.moc"
