#include "core/render/splats/disc_cuts.h"

#include "cells/solids.h"
#include "core/base/error.h"
#include "core/render/cast/raycast_image.h"
#include "core/render/splats/cpu_splatter.h"
#include "render/masks.h"
#include "render/render_models.h"
#include "support/registry.h"
#include "ui/gl/offscreen_renderer.h"

#include <QTest>

using namespace render;
using base::Vec3d;
using base::Vec3f;

class DiscCutsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void codesTellDirectionAndDistance();
    void codesTellTwoLines();
    void discsEndWhereTheSurfaceDoes();
    void insideNothingIsCut();
    void splatsEndLikeRays_data();
    void splatsEndLikeRays();
    void normalsThatStandAcrossLoseTheirDiscs();
    void updatesAreTheWholePicture();
    void theGpuCutsTheSame();
    void theGpuCutsCornersTheSame();
};

static surface::SurfaceDefinition bounded(float limit = 0.3f) {
    surface::SurfaceDefinition out;
    out.boundaryLimit = limit;
    return out;
}

void DiscCutsTest::codesTellDirectionAndDistance() {
    base::Random random(test::seed());
    for (int k = 0; k < 2000; ++k) {
        const auto n = base::cast<float>(k == 0 ? Vec3d{1, 0, 0} : random.unitVector());
        const auto any = base::cast<float>(random.unitVector());
        const Vec3f direction = normalized(any - n * dot(n, any), Vec3f{1, 0, 0});
        constexpr float radii[] = {cutRadius, cornerRadius, tipRadius};
        const std::size_t which = random.below(3);
        const auto beside = static_cast<Beside>(which);
        const auto part = static_cast<float>(random.uniform(0.05, beside == Beside::Edge ? 0.95 : 0.46));
        const DiscCut cut = discCut(n, 1, cutCode(n, direction, part, beside));
        QCOMPARE(cut.radius, radii[which]);
        QVERIFY(std::abs(cut.part - part) <= 1 / 64.0f + 1e-6f);
        QVERIFY(dot(cut.direction, direction) > std::cos(0.025f));
        QVERIFY(std::abs(dot(cut.direction, n)) < 1e-5f);
        QVERIFY(cutCode(n, direction, part, beside) < 1 << cutBits);
    }
    QCOMPARE(cutCode({0, 0, 1}, {1, 0, 0}, 1), wholeDisc);
    // what is left of the radius is the bound then
    QVERIFY(discCut({0, 0, 1}, 1, cutCode({0, 0, 1}, {1, 0, 0}, 2, Beside::Corner)).part >= cornerRadius);
    QVERIFY(discCut({0, 0, 1}, 1, cutCode({0, 0, 1}, {1, 0, 0}, 2, Beside::Tip)).part >= tipRadius);
    QCOMPARE(discCut({0, 0, 1}, 1, wholeDisc).part, 0.0f);
    QCOMPARE(discCut({0, 0, 1}, 1, acrossDisc).part, 0.0f);
}

void DiscCutsTest::codesTellTwoLines() {
    base::Random random(test::seed());
    for (int k = 0; k < 2000; ++k) {
        const auto n = base::cast<float>(k == 0 ? Vec3d{1, 0, 0} : random.unitVector());
        const auto support = static_cast<float>(std::exp(random.uniform(-9, 9)));
        CutLine lines[2];
        for (CutLine& line : lines) {
            const auto any = base::cast<float>(random.unitVector());
            line = {normalized(any - n * dot(n, any), Vec3f{1, 0, 0}), static_cast<float>(random.uniform(0.05, 0.7))};
        }
        const DiscCut cut = discCut(n, support, twoCutsCode(n, support, lines[0], lines[1]));
        QVERIFY(std::abs(cut.radius / cutRadius - 1) < 0.126f);
        for (const auto& [found, wanted] : {std::pair<CutLine, CutLine>{cut, lines[0]}, {cut.second, lines[1]}}) {
            QVERIFY(std::abs(found.part - wanted.part) < 0.029f);
            QVERIFY(dot(found.direction, wanted.direction) > std::cos(0.05f));
        }
    }
}

static std::vector<const surfel::SurfelBlock*> blocksOf(const tree::SurfelTree& model) {
    std::vector<const surfel::SurfelBlock*> out;
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { out.push_back(&block); });
    return out;
}

/// A half-plane x <= 0: every cut lies where the off-centre value reaches the limit, across x.
void DiscCutsTest::discsEndWhereTheSurfaceDoes() {
    surfel::SurfelList list = test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.02);
    std::erase_if(list.items, [](const surfel::Surfel& s) { return s.position.x > 0; });
    const auto model = test::built(list);
    const surface::Surface surface(model, bounded());
    DiscCuts cuts;
    cuts.use(bounded(), splatRadiusOfSupport);
    cuts.follow(model);
    cuts.prepare(blocksOf(model));
    int cut = 0;
    for (const surfel::SurfelBlock* block : blocksOf(model))
        if (const CutCodes* codes = cuts.of(block))
            for (int slot = 0; slot < block->size(); ++slot) {
                const Vec3f p = block->position(slot);
                if (std::abs(p.y) > 0.6f || p.x < -0.3f)
                    continue;
                const DiscCut found =
                    discCut(block->normal(slot), block->support(slot), (*codes)[static_cast<std::size_t>(slot)]);
                if (found.part == 0)
                    continue;
                ++cut;
                QVERIFY(found.direction.x > 0.97f);
                const Vec3f end = p + found.direction * (found.part * splatRadiusOfSupport * block->support(slot));
                const surface::Evaluationf e = surface.evaluate(end);
                QVERIFY2(std::abs(e.offCentre / e.unit - 0.3f) < 0.05f, qPrintable(QString::number(e.offCentre)));
            }
    QVERIFY(cut >= 50);
}

void DiscCutsTest::insideNothingIsCut() {
    const auto model = test::built(test::torus(1, 0.4, 20000, test::seed()));
    DiscCuts cuts;
    cuts.use(bounded(), splatRadiusOfSupport);
    cuts.follow(model);
    cuts.prepare(blocksOf(model));
    for (const surfel::SurfelBlock* block : blocksOf(model))
        QVERIFY(!cuts.of(block));
}

void DiscCutsTest::splatsEndLikeRays_data() {
    QTest::addColumn<bool>("oriented");
    QTest::newRow("oriented") << true;
    QTest::newRow("unoriented") << false;
}

/// The outline of a ragged sheet: cut discs leave several times fewer pixels in which rays and splats disagree.
void DiscCutsTest::splatsEndLikeRays() {
    QFETCH(bool, oriented);
    surfel::SurfelList list = test::disc({0, 0, 0}, {0.3, 0.2, 0.93}, 0.6, 0.025);
    base::Random random(test::seed());
    for (auto& s : list.items) {
        s.position += base::cast<float>(Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), 0} * 0.004);
        if (!oriented && random.uniform() < 0.5)
            s.normal = -s.normal;
    }
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->oriented = oriented;
    list.layout = layout;
    const auto model = test::built(list);
    Camera camera;
    camera.width = camera.height = 400;
    camera.eye = {0, 0, 2.5};
    RenderOptions options;
    CpuSplatter splatter;
    const Image whole = test::drawn(splatter, model, camera, options);
    options.definition = bounded();
    const Image cut = test::drawn(splatter, model, camera, options);
    Image rays;
    rays.resize(400, 400);
    RayCounts counts;
    rayCast(surface::Surface(model, bounded()), camera, options, rays, counts);
    const std::size_t before = test::difference(whole, rays).apart, after = test::difference(cut, rays).apart;
    QVERIFY2(after * 3 < before, qPrintable(QString("%1 pixels of %2").arg(after).arg(before)));
}

void DiscCutsTest::normalsThatStandAcrossLoseTheirDiscs() {
    surfel::SurfelList list = test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.02);
    for (std::size_t k = 0; k < list.items.size(); k += 997)
        list.items[k].normal = {1, 0, 0};
    const auto model = test::built(list);
    DiscCuts cuts;
    cuts.use(bounded(), splatRadiusOfSupport);
    cuts.follow(model);
    cuts.prepare(blocksOf(model));
    for (const surfel::SurfelBlock* block : blocksOf(model))
        for (int slot = 0; slot < block->size(); ++slot)
            if (length(block->position(slot)) < 0.9f)
                QCOMPARE(cuts.of(block) && (*cuts.of(block))[static_cast<std::size_t>(slot)] == acrossDisc,
                         block->normal(slot).x == 1);
}

/// Erases what lies about a place.
static tree::SurfelTree holed(const tree::SurfelTree& model, const Vec3f& centre, float radius) {
    tree::Edit edit;
    edit.inserted.layout = model.layout();
    model.forBlocksInBall(centre, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        std::bitset<surfel::blockCapacity> gone;
        for (int slot = 0; slot < block.size(); ++slot)
            gone[static_cast<std::size_t>(slot)] = distance(block.position(slot), centre) < radius;
        if (gone.any())
            edit.blocks.push_back({number, {}, gone});
    });
    return model.apply(edit);
}

/// Holes change the cuts of surfels that the edit leaves alone.
void DiscCutsTest::updatesAreTheWholePicture() {
    base::Random random(test::seed());
    tree::SurfelTree model = test::built(test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.02));
    const tree::SurfelTree first = model;
    Camera camera;
    camera.width = 321, camera.height = 243;
    RenderOptions options;
    options.definition = bounded();
    CpuSplatter splatter;
    Image image;
    for (int k = 0; k < 10; ++k) {
        splatter.update(model, camera, options, image);
        CpuSplatter fresh;
        const Image whole = test::drawn(fresh, model, camera, options);
        QVERIFY2(image.colour == whole.colour && image.depth == whole.depth,
                 qPrintable(QString("step %1, seed %2").arg(k).arg(test::seed())));
        const auto centre = base::cast<float>(Vec3d{random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), 0});
        model = k == 6 ? first : holed(model, centre, static_cast<float>(random.uniform(0.03, 0.15)));
    }
}

void DiscCutsTest::theGpuCutsTheSame() {
    std::unique_ptr<OffscreenRenderer> gl;
    try {
        gl = std::make_unique<OffscreenRenderer>(makeOsMesaContext());
    } catch (const base::Error& e) {
        QSKIP(e.what());
    }
    CpuSplatter cpu;
    Camera camera;
    camera.width = 321, camera.height = 243;
    tree::SurfelTree model = test::built(test::disc({0, 0, 0}, {0.4, 0, 0.9}, 0.7, 0.02));
    RenderOptions options;
    for (int k = 0; k < 5; ++k) {
        options.definition = k == 4 ? surface::SurfaceDefinition{} : bounded();
        const Image a = test::drawn(cpu, model, camera, options), b = test::drawn(*gl, model, camera, options);
        const test::Difference d = test::difference(a, b);
        QVERIFY2(d.mean < 0.5 && d.apart <= 20, qPrintable(QString("%1, apart %2").arg(d.mean).arg(d.apart)));
        test::drawn(*gl, model, camera, options);
        QCOMPARE(gl->splatter().storage().uploadedBytes(), std::size_t(0));
        model = holed(model, {0.1f * static_cast<float>(k), 0, 0}, 0.08f);
    }
}

void DiscCutsTest::theGpuCutsCornersTheSame() {
    std::unique_ptr<OffscreenRenderer> gl;
    try {
        gl = std::make_unique<OffscreenRenderer>(makeOsMesaContext());
    } catch (const base::Error& e) {
        QSKIP(e.what());
    }
    base::Random random(test::seed());
    const plane_solids::Solid solid = plane_solids::polyhedron(random);
    const tree::SurfelTree model =
        plane_solids::surfaceOf(plane_solids::sampled(solid, 2.4, 0.15, random).surfels).tree();
    DiscCuts cuts;
    cuts.use({}, splatRadiusOfSupport);
    cuts.follow(model);
    cuts.prepare(blocksOf(model));
    int two = 0;
    for (const surfel::SurfelBlock* block : blocksOf(model))
        if (const CutCodes* codes = cuts.of(block))
            two += static_cast<int>(std::ranges::count_if(*codes, [](CutCode c) { return (c & twoCuts) != 0; }));
    QVERIFY2(two > 8, qPrintable(QString("%1, seed %2").arg(two).arg(test::seed())));
    CpuSplatter cpu;
    for (Camera& camera : test::allAround(model.bounds(), 240, 180)) {
        const Image a = test::drawn(cpu, model, camera), b = test::drawn(*gl, model, camera);
        const test::Difference d = test::difference(a, b);
        QVERIFY2(d.mean < 0.5 && d.apart <= 20,
                 qPrintable(QString("%1, apart %2, seed %3").arg(d.mean).arg(d.apart).arg(test::seed())));
    }
}

static const test::Registered<DiscCutsTest> registered;
#include "disc_cuts_test.moc"
