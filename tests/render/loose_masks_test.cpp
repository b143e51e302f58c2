// What scans bring beside their surfaces: lone outliers, loose groups of points, ragged rims. Splats show of these what
// rays hit, and nothing else.
#include "core/process/estimation/prepare.h"
#include "render/masks.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using test::MaskGap;

class LooseMasksTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void roomsShowWhatRaysHit();
    void raggedSheetsShowWhatRaysHit();
    void loneSurfelsShowAsDots();
};

namespace {

void add(surfel::SurfelList& list, const Vec3d& p) {
    surfel::Surfel s;
    s.position = base::cast<float>(p);
    list.items.push_back(s);
}

/// Parts of four planes as a scanner in the middle sees them: denser where near, with noise; outliers far from all of
/// them, alone and in groups of up to twelve.
surfel::SurfelList room(std::size_t count, std::uint64_t seed) {
    base::Random random(seed);
    surfel::SurfelList out;
    while (out.size() < count) {
        const Vec3d d = random.unitVector();
        double t = 1e9;
        for (const Vec3d& wall : {Vec3d{1, 0, 0}, Vec3d{-0.6, 0.2, 0}, Vec3d{0, 0.7, 0}, Vec3d{0, 0, -0.4}})
            if (const double along = dot(d, wall); along > 0)
                t = std::min(t, dot(wall, wall) / along);
        if (t < 1.6)
            add(out, d * (t + 0.004 * random.normal()));
    }
    for (int group = 0; group < 8; ++group) {
        const Vec3d centre = random.unitVector() * 1.8;
        for (int i = group < 3 ? 1 : 1 + static_cast<int>(12 * random.uniform()); i > 0; --i)
            add(out, centre + random.unitVector() * (0.25 * random.uniform()));
    }
    return out;
}

/// Half of a lumpy dome with noise and a spacing of 1 to 5, cut along a wave.
surfel::SurfelList dome(std::size_t count, std::uint64_t seed) {
    base::Random random(seed);
    surfel::SurfelList out;
    while (out.size() < count) {
        const Vec3d d = random.unitVector();
        if (d.z < 0.25 * std::sin(4 * std::atan2(d.y, d.x)) || random.uniform() > std::pow(5, -2 * d.z))
            continue;
        add(out, d * (1 + 0.1 * std::sin(3 * d.x) * std::sin(4 * d.y) + 0.003 * random.normal()));
    }
    return out;
}

/// `before`: of the splats of a view that moves.
struct Gaps {
    MaskGap now, before;
};

Gaps gapsOf(const surface::Surface& surface, std::size_t most) {
    render::CpuSplatter splatter;
    Gaps out;
    render::RenderOptions options = test::atRest(surface), moving = options;
    moving.detailPx = 1.01f;
    std::vector<render::Camera> views = test::allAround(surface.tree().bounds(), 320, 240);
    views.resize(std::min(most, views.size()));
    for (const render::Camera& camera : views) {
        const render::Image rays = test::raysOf(surface, camera, options);
        out.now += test::maskGap(rays, test::drawn(splatter, surface.tree(), camera, options));
        out.before += test::maskGap(rays, test::drawn(splatter, surface.tree(), camera, moving));
    }
    return out;
}

QString told(const Gaps& gaps) {
    return QString("%1 % holes, %2 % strays; moving %3, %4; seed %5")
        .arg(gaps.now.holesPercent())
        .arg(gaps.now.straysPercent())
        .arg(gaps.before.holesPercent())
        .arg(gaps.before.straysPercent())
        .arg(test::seed());
}

} // namespace

void LooseMasksTest::roomsShowWhatRaysHit() {
    const surface::Surface surface = process::prepare(room(6000, test::seed()), {});
    QVERIFY(std::isfinite(surface.definition().boundaryLimit));
    const Gaps gaps = gapsOf(surface, std::size_t(test::effort(5)));
    QVERIFY2(gaps.now.holesPercent() < 0.3 && gaps.now.straysPercent() < 0.6, qPrintable(told(gaps)));
}

void LooseMasksTest::raggedSheetsShowWhatRaysHit() {
    const surface::Surface surface = process::prepare(dome(2000, test::seed()), {});
    QVERIFY(std::isfinite(surface.definition().boundaryLimit));
    const Gaps gaps = gapsOf(surface, std::size_t(test::effort(5)));
    QVERIFY2(gaps.now.holesPercent() < 0.3 && gaps.now.straysPercent() < 0.2, qPrintable(told(gaps)));
}

/// Whatever their supports: nothing is surface there, and yet a person may find them, and erase them. So do pairs.
void LooseMasksTest::loneSurfelsShowAsDots() {
    surfel::SurfelList list = test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.04);
    const std::size_t flat = list.size();
    for (const float x : {3.0f, -3.0f, -3.2f})
        list.items.push_back({{x, 0, 0}, {0, 0, 1}, 1.5f, surfel::white, 0});
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.2122f;
    render::DiscCuts cuts;
    const auto model = test::built(list);
    cuts.use(definition, render::splatRadiusOfSupport);
    cuts.follow(model);
    std::vector<const surfel::SurfelBlock*> blocks;
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { blocks.push_back(&block); });
    cuts.prepare(blocks);
    std::size_t lone = 0;
    for (const surfel::SurfelBlock* block : blocks)
        for (int i = 0; cuts.of(block) && i < block->size(); ++i)
            lone += (*cuts.of(block))[static_cast<std::size_t>(i)] == render::loneDisc ? 1 : 0;
    QCOMPARE(lone, list.size() - flat);

    render::Camera camera;
    camera.width = 400, camera.height = 200;
    camera.eye = {0, 0, 10};
    render::RenderOptions options;
    options.definition = definition;
    for (const float detailPx : {1.0f, 1.5f}) { // at rest, and while the view moves
        options.detailPx = detailPx;
        render::CpuSplatter splatter;
        const render::Image image = test::drawn(splatter, model, camera, options);
        std::size_t beside = 0;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x)
                beside += std::abs(x - 200) > 60 && std::isfinite(image.depth[std::size_t(400 * y + x)]) ? 1 : 0;
        QVERIFY2(beside >= 3 && beside <= 27, qPrintable(QString::number(beside)));
    }
}

static const test::Registered<LooseMasksTest> registered;
#include "loose_masks_test.moc"
