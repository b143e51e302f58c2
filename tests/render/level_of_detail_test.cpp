#include "core/base/parallel.h"
#include "core/render/splats/cpu_splatter.h"
#include "core/render/splats/detail_pacer.h"
#include "render/render_models.h"
#include "support/registry.h"
#include "ui/gl/offscreen_renderer.h"

#include <QTest>

using namespace render;
using base::Vec3d;
using base::Vec3f;

class LevelOfDetailTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void representativesCoverAllDiscs_data();
    void representativesCoverAllDiscs();
    void sheetsThatTurnApartAreNotAveraged();
    void unorientedNormalsDoNotCancel();
    void conesHoldAllNormals();
    void atRestItCannotBeSeen_data();
    void atRestItCannotBeSeen();
    void coarsePicturesHaveNoHoles();
    void zeroDetailDrawsEverySurfel();
    void updatesAreTheWholePicture();
    void sameBitsAtAnyThreadCount();
    void detailsAreKeptAcrossVersionsAndDroppedWithThem();
    void closedModelsLookTheSameWithoutTheirBack();
    void theGpuDrawsTheSameDetail();
    void thePacerFindsABudget();
};

static Camera smallCamera(double distance) {
    Camera camera;
    camera.width = 321;
    camera.height = 243;
    camera.eye = normalized(Vec3d{1, 2, 3}) * distance;
    return camera;
}

/// Blocks of a model of `n` surfels.
static std::vector<surfel::BlockPtr> blocksOf(const tree::SurfelTree& model) {
    std::vector<surfel::BlockPtr> out;
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { out.emplace_back(&block); });
    return out;
}

void LevelOfDetailTest::representativesCoverAllDiscs_data() {
    QTest::addColumn<int>("parts");
    QTest::addColumn<double>("graded");
    QTest::newRow("one block") << 1 << 1.0;
    QTest::newRow("eight blocks") << 8 << 1.0;
    QTest::newRow("graded by 5") << 8 << 5.0;
    QTest::newRow("graded by 50") << 5 << 50.0;
}

void LevelOfDetailTest::representativesCoverAllDiscs() {
    QFETCH(int, parts);
    QFETCH(double, graded);
    base::Random random(test::seed());
    surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 20000);
    for (auto& s : list.items)
        s.support *= static_cast<float>(std::pow(graded, random.uniform(-0.5, 0.5)));
    const tree::SurfelTree model = test::built(list);
    const auto blocks = blocksOf(model);
    constexpr float reach = splatRadiusOfSupport;
    for (std::size_t first = 0; first + 8 <= blocks.size(); first += 23) {
        std::vector<const surfel::SurfelBlock*> some;
        for (std::size_t i = 0; i < static_cast<std::size_t>(parts); ++i)
            some.push_back(blocks[first + i].get());
        const surfel::BlockPtr proxy = representatives(some, reach, true);
        QVERIFY(proxy->size() <= surfel::blockCapacity);
        QVERIFY(parts == 1 || proxy->size() > surfel::blockCapacity / 2);
        for (const surfel::SurfelBlock* block : some)
            for (int slot = 0; slot < block->size(); ++slot) {
                bool covered = false;
                for (int k = 0; k < proxy->size() && !covered; ++k)
                    covered = distance(proxy->position(k), block->position(slot)) + reach * block->support(slot) <=
                              reach * proxy->support(k) * 1.0001f;
                QVERIFY2(covered, qPrintable(QString("seed %1").arg(test::seed())));
            }
    }
}

/// Two parallel sheets nearer to each other than representatives are.
static surfel::SurfelList sheets(double apart) {
    surfel::SurfelList list = test::disc({0, 0, 0.5 * apart}, {0, 0, 1}, 0.1, 0.01);
    const surfel::SurfelList other = test::disc({0, 0, -0.5 * apart}, {0, 0, -1}, 0.1, 0.01);
    list.items.insert(list.items.end(), other.items.begin(), other.items.end());
    return list;
}

void LevelOfDetailTest::sheetsThatTurnApartAreNotAveraged() {
    const auto blocks = blocksOf(test::built(sheets(0.004)));
    std::vector<const surfel::SurfelBlock*> parts;
    for (const auto& block : blocks)
        parts.push_back(block.get());
    const surfel::BlockPtr proxy = representatives(parts, splatRadiusOfSupport, true);
    for (int k = 0; k < proxy->size(); ++k) {
        QVERIFY(std::abs(std::abs(proxy->normal(k).z) - 1) < 1e-5f);
        QVERIFY(std::abs(proxy->position(k).z - 0.002f * proxy->normal(k).z) < 1e-6f);
    }
}

void LevelOfDetailTest::unorientedNormalsDoNotCancel() {
    surfel::SurfelList list = test::disc({0, 0, 0}, {0, 0.6, 0.8}, 0.15, 0.01);
    base::Random random(test::seed());
    for (auto& s : list.items)
        if (random.uniform() < 0.5)
            s.normal = -s.normal;
    const auto blocks = blocksOf(test::built(list));
    std::vector<const surfel::SurfelBlock*> parts;
    for (const auto& block : blocks)
        parts.push_back(block.get());
    const surfel::BlockPtr proxy = representatives(parts, splatRadiusOfSupport, false);
    for (int k = 0; k < proxy->size(); ++k)
        QVERIFY(std::abs(std::abs(dot(proxy->normal(k), Vec3f{0, 0.6f, 0.8f})) - 1) < 1e-5f);
}

void LevelOfDetailTest::conesHoldAllNormals() {
    const auto blocks = blocksOf(test::built(test::torus(1, 0.4, 20000, test::seed())));
    for (std::size_t first = 0; first + 8 <= blocks.size(); first += 8) {
        std::vector<NormalCone> cones;
        for (std::size_t i = first; i < first + 8; ++i)
            cones.push_back(coneOf(*blocks[i]));
        const NormalCone cone = coneOf(cones);
        for (std::size_t i = first; i < first + 8; ++i)
            for (int slot = 0; slot < blocks[i]->size(); ++slot)
                QVERIFY(cone.all() || dot(cone.axis, blocks[i]->normal(slot)) >= std::cos(cone.angleRad) - 1e-5f);
    }
    surfel::SurfelList bare = test::disc({0, 0, 0}, {0, 0, 1}, 0.05, 0.01);
    bare.items[3].normal = {};
    QVERIFY(coneOf(*blocksOf(test::built(bare))[0]).all());
}

static bool seen(const Image& image, std::size_t i) {
    return std::isfinite(image.depth[i]);
}

void LevelOfDetailTest::atRestItCannotBeSeen_data() {
    QTest::addColumn<double>("distance");
    QTest::addColumn<bool>("oriented");
    QTest::newRow("all of level 1") << 4.0 << true;
    QTest::newRow("levels 1 and 2") << 9.0 << true;
    QTest::newRow("unoriented") << 6.0 << false;
    QTest::newRow("a speck") << 200.0 << true;
}

/// The picture of everything differs by little, and an outline by no more than a pixel.
void LevelOfDetailTest::atRestItCannotBeSeen() {
    QFETCH(double, distance);
    QFETCH(bool, oriented);
    surfel::SurfelList list = test::torus(1, 0.4, 400000, test::seed());
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->oriented = oriented;
    list.layout = layout;
    const tree::SurfelTree model = test::built(list);
    const Camera camera = smallCamera(distance);
    RenderOptions all;
    all.detailPx = 0;
    CpuSplatter splatter;
    const Image full = test::drawn(splatter, model, camera, all);
    QCOMPARE(splatter.details().size(), std::size_t(0));
    const Image image = test::drawn(splatter, model, camera);
    QVERIFY(splatter.details().size() > 0);
    const test::Difference d = test::difference(full, image);
    QVERIFY2(d.mean < 0.5, qPrintable(QString("mean %1").arg(d.mean)));
    const int width = camera.width;
    for (int y = 1; y + 1 < camera.height; ++y)
        for (int x = 1; x + 1 < width; ++x) {
            int around = 0;
            const auto at = [&](int dx, int dy) { return static_cast<std::size_t>((y + dy) * width + x + dx); };
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    around += seen(full, at(dx, dy)) ? 1 : 0;
            if (around == 9)
                QVERIFY(seen(image, at(0, 0)));
            if (around == 0)
                QVERIFY(!seen(image, at(0, 0)));
        }
}

void LevelOfDetailTest::coarsePicturesHaveNoHoles() {
    const tree::SurfelTree model = test::built(test::sphere({0, 0, 0}, 1, 200000));
    CpuSplatter splatter;
    for (const float detail : {2.0f, 4.0f, 8.0f, 30.0f})
        for (const double distance : {2.0, 4.0, 12.0}) {
            const Camera camera = smallCamera(distance);
            RenderOptions options;
            options.detailPx = detail;
            const Image image = test::drawn(splatter, model, camera, options);
            for (int y = 0; y < camera.height; ++y)
                for (int x = 0; x < camera.width; ++x)
                    if (std::isfinite(test::sphereDepth(camera.ray(x + 0.5, y + 0.5), {0, 0, 0}, 0.97)))
                        QVERIFY(seen(image, static_cast<std::size_t>(y * camera.width + x)));
        }
}

void LevelOfDetailTest::zeroDetailDrawsEverySurfel() {
    // One red surfel among many, far away.
    surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 100000, true);
    const tree::SurfelTree model = test::built(list);
    RenderOptions options;
    options.detailPx = 0;
    CpuSplatter splatter;
    test::drawn(splatter, model, smallCamera(50), options);
    QCOMPARE(splatter.details().made(), std::size_t(0));
    options.detailPx = 1;
    test::drawn(splatter, model, smallCamera(1.2), options);
    QCOMPARE(splatter.details().made(), std::size_t(0)); // large in the image
}

/// Moves, removes and adds surfels about a place.
static tree::SurfelTree dabbed(const tree::SurfelTree& model, const Vec3f& centre, float radius, int kind) {
    tree::Edit edit;
    edit.inserted.layout = model.layout();
    model.forBlocksInBall(centre, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        std::bitset<surfel::blockCapacity> gone;
        for (int slot = 0; slot < block.size(); ++slot)
            if (distance(block.position(slot), centre) < radius) {
                gone[static_cast<std::size_t>(slot)] = true;
                surfel::Surfel moved = block.surfel(slot);
                moved.position += moved.normal * (0.03f * static_cast<float>(kind % 3));
                for (int copies = kind % 4 == 3 ? 3 : slot % 5 != kind % 5; copies > 0; --copies) {
                    edit.inserted.items.push_back(moved);
                    moved.position += Vec3f{0.002f, 0.001f, 0};
                }
            }
        if (gone.any())
            edit.blocks.push_back({number, {}, gone});
    });
    return model.apply(edit);
}

/// An edit redraws what it changed, with details of several levels in play: to the bits of the whole picture.
void LevelOfDetailTest::updatesAreTheWholePicture() {
    base::Random random(test::seed());
    const auto start = test::built(test::sphere({0, 0, 0}, 1, 150000));
    for (const bool closed : {false, true})
        for (const float detail : {1.0f, 3.0f, 9.0f}) {
            RenderOptions options;
            options.detailPx = detail;
            options.closed = closed;
            std::vector<tree::SurfelTree> versions{start};
            const Camera camera = smallCamera(random.uniform(3, 6));
            CpuSplatter splatter;
            Image image;
            for (int k = 0; k < 12; ++k) {
                const std::size_t from = k % 5 == 4 ? random.below(versions.size()) : versions.size() - 1;
                const auto centre = base::cast<float>(random.unitVector());
                const auto radius = static_cast<float>(random.uniform(0.02, 0.3));
                versions.push_back(k % 5 == 3 ? versions[from] : dabbed(versions[from], centre, radius, k));
                splatter.update(versions.back(), camera, options, image);
                CpuSplatter fresh;
                const Image whole = test::drawn(fresh, versions.back(), camera, options);
                QVERIFY2(image.colour == whole.colour && image.depth == whole.depth,
                         qPrintable(QString("step %1, detail %2, seed %3").arg(k).arg(detail).arg(test::seed())));
            }
        }
}

void LevelOfDetailTest::sameBitsAtAnyThreadCount() {
    const auto model = test::built(test::torus(1, 0.4, 200000, test::seed()));
    RenderOptions options;
    options.detailPx = 2;
    base::setThreadCount(1);
    CpuSplatter alone;
    const Image one = test::drawn(alone, model, smallCamera(5), options);
    base::setThreadCount(0);
    CpuSplatter splatter;
    const Image many = test::drawn(splatter, model, smallCamera(5), options);
    QVERIFY(one.colour == many.colour && one.depth == many.depth);
}

static std::size_t nodesOf(const tree::Node& node) {
    std::size_t sum = 1;
    if (node.level > 1)
        for (std::size_t i = 0; i < node.childCount; ++i)
            sum += nodesOf(*node.nodes[i]);
    return sum;
}

void LevelOfDetailTest::detailsAreKeptAcrossVersionsAndDroppedWithThem() {
    const auto first = test::built(test::sphere({0, 0, 0}, 1, 300000));
    const Camera camera = smallCamera(100);
    CpuSplatter splatter;
    Image image;
    splatter.update(first, camera, {}, image);
    const std::size_t made = splatter.details().made();
    QVERIFY(made >= nodesOf(*first.root()) / 2);
    // Bounded: a sixth of the blocks' memory at most.
    QVERIFY(splatter.details().bytes() < first.bytes() / 5);
    tree::SurfelTree model = first;
    for (int k = 0; k < 20; ++k) {
        model = dabbed(model, {0, 0, 1}, 0.05f, k % 3);
        splatter.update(model, camera, {}, image);
        QVERIFY(splatter.details().size() <= nodesOf(*model.root()));
    }
    QVERIFY2(splatter.details().made() - made < made, "an edit remade what it did not touch");
    splatter.update({}, camera, {}, image);
    QCOMPARE(splatter.details().size(), std::size_t(0));
}

void LevelOfDetailTest::closedModelsLookTheSameWithoutTheirBack() {
    const auto model = test::built(test::torus(1, 0.4, 150000, test::seed()));
    CpuSplatter splatter;
    base::Random random(test::seed());
    for (const double distance : {2.2, 4.0, 30.0})
        for (const float detail : {0.0f, 1.0f, 4.0f}) {
            Camera camera = smallCamera(distance);
            camera.eye = random.unitVector() * distance;
            RenderOptions options;
            options.detailPx = detail;
            const Image all = test::drawn(splatter, model, camera, options);
            options.closed = true;
            const Image front = test::drawn(splatter, model, camera, options);
            QVERIFY2(
                all.colour == front.colour && all.depth == front.depth,
                qPrintable(QString("distance %1, detail %2, seed %3").arg(distance).arg(detail).arg(test::seed())));
        }
}

void LevelOfDetailTest::theGpuDrawsTheSameDetail() {
    std::unique_ptr<OffscreenRenderer> gl;
    try {
        gl = std::make_unique<OffscreenRenderer>(makeOsMesaContext());
    } catch (const base::Error& e) {
        QSKIP(e.what());
    }
    tree::SurfelTree model = test::built(test::torus(1, 0.4, 100000, test::seed()));
    CpuSplatter cpu;
    for (const float detail : {1.0f, 3.0f, 6.0f}) {
        RenderOptions options;
        options.detailPx = detail;
        const Camera camera = smallCamera(4);
        for (int k = 0; k < 4; ++k) {
            const Image a = test::drawn(cpu, model, camera, options), b = test::drawn(*gl, model, camera, options);
            const test::Difference d = test::difference(a, b);
            QVERIFY2(d.mean < 0.5 && d.apart <= 20, qPrintable(QString("%1, apart %2").arg(d.mean).arg(d.apart)));
            // Nothing goes over to the GPU twice, and after an edit what it changed alone.
            test::drawn(*gl, model, camera, options);
            QCOMPARE(gl->splatter().storage().uploadedBytes(), std::size_t(0));
            model = dabbed(model, {1.4f, 0, 0}, 0.1f, k);
            test::drawn(*gl, model, camera, options);
            QVERIFY(gl->splatter().storage().uploadedBytes() < 100 * slotBytes);
        }
    }
}

void LevelOfDetailTest::thePacerFindsABudget() {
    // Machines on which a frame costs a fixed part and one per splat, which come in steps of the tree's levels.
    for (const double whole : {0.004, 0.03, 0.2, 3.0}) {
        DetailPacer pacer(0.016);
        const auto cost = [&](float detail) { return 0.002 + whole * std::pow(7, -std::floor(std::log2(detail))); };
        int slow = 0;
        float least = DetailPacer::mostPx, most = 0;
        for (int frame = 0; frame < 300; ++frame) {
            const float detail = pacer.moving();
            QVERIFY(detail >= DetailPacer::restPx && detail <= DetailPacer::mostPx);
            pacer.drew(detail, cost(detail));
            if (frame < 20)
                continue;
            slow += cost(detail) > 0.016 ? 1 : 0;
            least = std::min(least, detail), most = std::max(most, detail);
        }
        QVERIFY2(slow < 10, qPrintable(QString("%1 of a whole frame of %2 s").arg(slow).arg(whole)));
        QVERIFY(whole > 0.01 || most == DetailPacer::restPx);
        QVERIFY(!pacer.overwhelmed());
        // It settles to the best in a few frames.
        float detail = pacer.moving();
        int frames = 0;
        for (; detail > DetailPacer::restPx; ++frames)
            detail = pacer.settling(detail);
        QVERIFY(frames <= 3);
    }
    DetailPacer hopeless(0.016);
    for (int frame = 0; frame < 20; ++frame)
        hopeless.drew(hopeless.moving(), 0.5);
    QVERIFY(hopeless.overwhelmed() && hopeless.moving() == DetailPacer::mostPx);
}

static const test::Registered<LevelOfDetailTest> registered;
#include "level_of_detail_test.moc"
