// Large discs that stand out over their surface give way to finer ones that lie on it, and only those do.
#include "core/render/splats/cpu_splatter.h"
#include "core/render/splats/finer_blocks.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;
using base::Vec3d;

class FinerBlocksTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void finerDiscsLieOnTheSurface();
    void discsStandOutAsTheirSurfaceBends();
    void smoothSurfacesAloneAreDrawnFiner();
    void updatesAreTheWholePicture();
};

namespace {

constexpr float radius = splatRadiusOfSupport;

std::vector<const surfel::SurfelBlock*> blocksOf(const tree::SurfelTree& model) {
    std::vector<const surfel::SurfelBlock*> out;
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { out.push_back(&block); });
    return out;
}

} // namespace

/// Seven for each surfel of a torus, but for some that have no foot near by. Of half of one, with a boundary limit,
/// none lies beyond it.
void FinerBlocksTest::finerDiscsLieOnTheSurface() {
    for (const bool ends : {false, true}) {
        surfel::SurfelList list = test::torus(0.7, 0.3, 1500, test::seed());
        if (ends)
            std::erase_if(list.items, [](const surfel::Surfel& s) { return s.position.x > 0; });
        const auto model = test::built(list);
        surface::SurfaceDefinition definition;
        if (ends)
            definition.boundaryLimit = 0.3f;
        FinerBlocks finer;
        finer.use(definition, radius);
        finer.follow(model);
        const auto blocks = blocksOf(model);
        finer.standOut(blocks);
        finer.prepare(blocks);
        const surface::Surface surface(model, definition);
        std::size_t count = 0, cut = 0;
        for (const surfel::SurfelBlock* block : blocks)
            for (const FinerBlocks::Part& part : finer.of(block)) {
                cut += part.cuts ? 1 : 0;
                for (int i = 0; i < part.block->size(); ++i, ++count) {
                    const surface::Evaluationf at = surface.evaluate(part.block->position(i), surface::Need::Gradient);
                    const float support = part.block->support(i);
                    const QString told = QString("%1 of %2, seed %3").arg(i).arg(count).arg(test::seed());
                    QVERIFY2(at.ok() && std::abs(at.value) < 1e-4f * support, qPrintable(told));
                    QVERIFY2(dot(part.block->normal(i), normalized(at.gradient)) > 0.999f, qPrintable(told));
                    QVERIFY2(!ends || at.offCentre <= 1.001f * definition.boundaryLimit * at.unit, qPrintable(told));
                }
            }
        QCOMPARE(cut > 0, ends);
        QVERIFY2(double(count) > 6.9 * double(list.size()),
                 qPrintable(QString("%1 for %2, seed %3").arg(count).arg(list.size()).arg(test::seed())));
    }
}

/// R^2 / 2 rho on a ball of radius rho, nothing in a plane.
void FinerBlocksTest::discsStandOutAsTheirSurfaceBends() {
    const auto most = [](const surfel::SurfelList& list) {
        const auto model = test::built(list);
        FinerBlocks finer;
        finer.use({}, radius);
        finer.follow(model);
        std::pair<float, float> out{1e9f, 0};
        for (const float each : finer.standOut(blocksOf(model)))
            out = {std::min(out.first, each), std::max(out.second, each)};
        return out;
    };
    const surfel::SurfelList ball = test::sphere({0, 0, 0}, 1, 4000);
    const float disc = radius * ball.items.front().support, told = 0.5f * disc * disc;
    const auto [least, largest] = most(ball);
    QVERIFY2(least > 0.98f * told && largest < 1.02f * told,
             qPrintable(QString("%1 %2 of %3").arg(least).arg(largest).arg(told)));
    QVERIFY(most(test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.05)).second < 1e-6f);
}

void FinerBlocksTest::smoothSurfacesAloneAreDrawnFiner() {
    const auto model = test::built(test::sphere({0, 0, 0}, 1, 500));
    RenderOptions options;
    QVERIFY(FinerBlocks::any(model, options));
    options.detailPx = 2; // in a view that moves
    QVERIFY(!FinerBlocks::any(model, options));
    options = {};
    options.definition.manifold = surface::Manifold::Curve;
    QVERIFY(!FinerBlocks::any(model, options));
    auto layout = std::make_shared<surfel::AttributeLayout>(*model.layout());
    layout->add("patch", surfel::ScalarType::Int32); // faces with sharp edges
    surfel::SurfelList list;
    list.layout = layout;
    list.append({{0, 0, 0}, {0, 0, 1}, 1}, std::vector<std::uint32_t>(layout->words()));
    QVERIFY(!FinerBlocks::any(tree::SurfelTree::build(list), {}));
}

/// Finer discs of blocks that an edit leaves alone follow what is about them.
void FinerBlocksTest::updatesAreTheWholePicture() {
    auto version = test::built(test::torus(0.7, 0.3, 1500, test::seed()));
    const Camera camera = test::cutTilesCamera();
    CpuSplatter splatter;
    Image image;
    base::Random random(test::seed());
    for (int k = 0; k < 6; ++k) {
        RenderOptions options;
        options.detailPx = k == 3 ? 2 : 1; // and what an edit changed in between
        splatter.update(version, camera, options, image);
        CpuSplatter fresh;
        const Image whole = test::drawn(fresh, version, camera, options);
        QVERIFY2(image.colour == whole.colour && image.depth == whole.depth,
                 qPrintable(QString("%1, seed %2").arg(k).arg(test::seed())));
        const base::Vec3f centre = base::cast<float>(random.unitVector() * 0.8);
        tree::Edit edit;
        edit.inserted.layout = version.layout();
        version.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            std::bitset<surfel::blockCapacity> gone;
            for (int slot = 0; slot < block.size(); ++slot)
                if (distance(block.position(slot), centre) < 0.3f) {
                    gone[static_cast<std::size_t>(slot)] = true;
                    surfel::Surfel moved = block.surfel(slot);
                    moved.position += moved.normal * 0.05f;
                    edit.inserted.items.push_back(moved);
                }
            if (gone.any())
                edit.blocks.push_back({number, {}, gone});
        });
        version = version.apply(edit);
    }
}

static const test::Registered<FinerBlocksTest> registered;
#include "finer_blocks_test.moc"
