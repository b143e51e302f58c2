#include "core/render/shaded_layer.h"

#include "core/render/cast/raycast_image.h"
#include "core/render/effects/effect_rows.h"
#include "core/render/splats/cpu_splatter.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;

class ShadedLayerTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void wholeLayerIsThePictureOfItsRays();
    void unknownPixelsAreSplats();
    void layerThatComesLaterChangesThePictureInPlace();
    void layerOfAnotherSizeIsNone();
};

namespace {

struct Scene {
    tree::SurfelTree model = test::built(test::torus(0.7, 0.25, 8000, test::seed()));
    Camera camera;
    RenderOptions options;
    std::vector<raycast::Sample> samples;

    Scene() {
        camera.width = 150, camera.height = 110;
        camera.eye = {0.4, 1.1, 2.2};
        raycast::CastCounts counts;
        samples = raycast::fullCast(surface::Surface(model, {}), imageRays(camera), counts);
    }
    std::shared_ptr<const ShadedLayer> layer(const std::function<bool(std::size_t)>& known) const {
        const auto kind = [&](std::size_t i) {
            return !known(i) ? PixelKind::Unknown : samples[i].hit.hit ? PixelKind::Surface : PixelKind::Background;
        };
        return std::make_shared<ShadedLayer>(
            shadeSamples(samples, kind, sampleShade(options.shading, *model.layout(), false), camera));
    }
    Image cast() const {
        Image out;
        RayCounts counts;
        rayCast(surface::Surface(model, {}), camera, options, out, counts);
        return out;
    }
    Image splats(std::shared_ptr<const ShadedLayer> over) const {
        CpuSplatter splatter;
        splatter.showOver(std::move(over));
        Image out;
        splatter.render(model, camera, options, out);
        return out;
    }
};

bool same(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.colour == b.colour && a.depth == b.depth;
}

/// A known set with ragged borders, and tiles that are wholly known or wholly not.
bool patch(std::size_t i, std::uint64_t seed) {
    const std::size_t x = i % 150, y = i / 150;
    return x < 64 || (x < 110 && (i * 2654435761u + seed) % 3 == 0 && y > 20);
}

} // namespace

void ShadedLayerTest::wholeLayerIsThePictureOfItsRays() {
    Scene scene;
    const auto all = [](std::size_t) { return true; };
    QVERIFY(same(scene.splats(scene.layer(all)), scene.cast()));
    for (const EffectRow& row : effectTable())
        scene.options.effects |= row.effect;
    QVERIFY(same(scene.splats(scene.layer(all)), scene.cast()));
}

void ShadedLayerTest::unknownPixelsAreSplats() {
    const Scene scene;
    const std::uint64_t seed = test::seed();
    const Image mixed = scene.splats(scene.layer([&](std::size_t i) { return patch(i, seed); }));
    const Image splats = scene.splats(nullptr), cast = scene.cast();
    QVERIFY(!same(splats, cast));
    for (std::size_t i = 0; i < mixed.colour.size(); ++i) {
        const Image& from = patch(i, seed) ? cast : splats;
        QVERIFY2(mixed.colour[i] == from.colour[i] && mixed.depth[i] == from.depth[i],
                 qPrintable(QString("pixel %1, seed %2").arg(i).arg(seed)));
    }
}

void ShadedLayerTest::layerThatComesLaterChangesThePictureInPlace() {
    Scene scene;
    for (const EffectRow& row : effectTable())
        scene.options.effects |= row.effect;
    const std::uint64_t seed = test::seed();
    CpuSplatter splatter;
    Image image;
    splatter.render(scene.model, scene.camera, scene.options, image);
    for (const auto& layer :
         {scene.layer([&](std::size_t i) { return patch(i, seed); }),
          scene.layer([](std::size_t i) { return i % 150 < 40; }), std::shared_ptr<const ShadedLayer>()}) {
        splatter.showOver(layer);
        splatter.update(scene.model, scene.camera, scene.options, image);
        QVERIFY2(same(image, scene.splats(layer)), qPrintable(QString("seed %1").arg(seed)));
    }
}

void ShadedLayerTest::layerOfAnotherSizeIsNone() {
    const Scene scene;
    QVERIFY(same(scene.splats(std::make_shared<ShadedLayer>(30, 20)), scene.splats(nullptr)));
}

static const test::Registered<ShadedLayerTest> registered;
#include "shaded_layer_test.moc"
