#include "core/render/splats/cpu_splatter.h"

#include "core/base/parallel.h"
#include "core/process/estimation/supports.h"
#include "core/render/shading/shading.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;
using base::Vec3d;

class CpuSplatterTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void tiltedPlaneHasOneNormalAndPlanarDepth();
    void nearSheetHidesTheFarOne();
    void thinSheetShowsItsOwnSide();
    void backsOfSolidsShowBeforeNoFront();
    void insidesAreBlendedAsOutsides();
    void splatsNeverFallBetweenPixels();
    void unorientedSplatsFaceTheEye();
    void thereIsNoNearPlane();
    void coloursAndMasksAreBlended();
    void sameBitsAtAnyThreadCount();
    void transparentBackgroundHasNoAlpha();
    void anEmptyModelIsBackground();
    void updatesAreTheWholePicture();
};

/// A normal of camera coordinates (x right, y up, z to the eye, which the default camera's axes are) as a pixel of the
/// image shades it.
static base::Vec3f asSeen(const Camera& camera, const Vec3d& normal, int x, int y) {
    const double dx = (x + 0.5 - 0.5 * camera.width) / camera.focalPx();
    const double dy = (0.5 * camera.height - y - 0.5) / camera.focalPx();
    return inRayFrame(base::cast<float>(normal), static_cast<float>(dx), static_cast<float>(dy));
}

void CpuSplatterTest::tiltedPlaneHasOneNormalAndPlanarDepth() {
    for (const double angle : {0.0, 0.6, 1.2}) {
        const Vec3d normal{std::sin(angle) * 0.8, std::sin(angle) * 0.6, std::cos(angle)};
        const Camera camera = test::cutTilesCamera();
        CpuSplatter splatter;
        RenderOptions options;
        options.shading = Shading::Normal;
        const auto model = test::built(test::disc({0, 0, 0}, normal, 6, 0.02));
        const Image image = test::drawn(splatter, model, camera, options);
        for (int y = 60; y < 180; ++y)
            for (int x = 80; x < 240; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * 321 + static_cast<std::size_t>(x);
                const base::Rayd ray = camera.ray(x + 0.5, y + 0.5);
                if (-dot(ray.direction, normal) < 0.27) // flatter, and pixels of the filter are held to filterDepth
                    continue;
                const double expected = -dot(ray.origin, normal) / dot(ray.direction, normal);
                QVERIFY2(std::abs(image.depth[i] / expected - 1) < 3e-6,
                         qPrintable(QString("%1 %2: %3 for %4").arg(x).arg(y).arg(image.depth[i]).arg(expected)));
                const base::Vec3f turned = asSeen(camera, normal, x, y);
                for (std::size_t k = 0; k < 3; ++k)
                    QVERIFY(std::abs(static_cast<float>(image.colour[i] >> (8 * k) & 255u) -
                                     127.5f * (turned[k] + 1)) <= 2.5f);
            }
    }
}

void CpuSplatterTest::nearSheetHidesTheFarOne() {
    surfel::SurfelList list = test::disc({0, 0, 0}, {0, 0, 1}, 1.5, 0.02);
    surfel::SurfelList behind = test::disc({0, 0, -0.1}, {0.6, 0, 0.8}, 1.5, 0.02);
    const surfel::SurfelList front = list;
    list.items.insert(list.items.end(), behind.items.begin(), behind.items.end());
    std::erase_if(list.items, [](const auto& s) { return s.normal.x > 0 && s.position.z > -0.05f; });
    CpuSplatter splatter;
    const Camera camera = test::cutTilesCamera();
    const Image both = test::drawn(splatter, test::built(list), camera),
                one = test::drawn(splatter, test::built(front), camera);
    // The far sheet passes 0.05 to 1 behind the near one; a splat's radius is 0.021.
    int compared = 0;
    for (std::size_t i = 0; i < one.colour.size(); ++i)
        if (std::isfinite(one.depth[i])) {
            QCOMPARE(both.depth[i], one.depth[i]);
            QCOMPARE(both.colour[i], one.colour[i]);
            ++compared;
        }
    QVERIFY(compared > 10000);
}

void CpuSplatterTest::thinSheetShowsItsOwnSide() {
    // Front and back of a plate thinner than a splat: colours tell which side a pixel shows.
    surfel::SurfelList list = test::disc({0, 0, 0.004}, {0, 0, 1}, 1, 0.02);
    for (auto& s : list.items)
        s.colour = surfel::rgba(255, 0, 0);
    surfel::SurfelList back = test::disc({0, 0, -0.004}, {0, 0, -1}, 1, 0.02);
    for (auto& s : back.items)
        s.colour = surfel::rgba(0, 0, 255);
    list.items.insert(list.items.end(), back.items.begin(), back.items.end());
    list.layout = test::orientedLayout(true);
    RenderOptions options;
    options.shading = Shading::Colour;
    CpuSplatter splatter;
    Camera camera = test::cutTilesCamera();
    for (const double z : {3.0, -3.0}) {
        camera.eye = {0.4, 0.2, z};
        const Image image = test::drawn(splatter, test::built(list), camera, options);
        const surfel::Colour middle = image.colour[121 * 321 + 160];
        QCOMPARE(middle >> (z > 0 ? 16 : 0) & 255u, 0u);
        QVERIFY((middle >> (z > 0 ? 0 : 16) & 255u) > 100);
    }
}

/// Of a face behind an edge parts of pixels stand out. Where a model may have an inside to see, all is drawn.
void CpuSplatterTest::backsOfSolidsShowBeforeNoFront() {
    Camera camera = test::cutTilesCamera();
    const std::size_t middle = 121 * 321 + 160;
    const auto depth = [&](const tree::SurfelTree& model, const RenderOptions& options = {}) {
        CpuSplatter splatter;
        return test::drawn(splatter, model, camera, options).depth[middle];
    };
    const tree::SurfelTree solid = test::backBeforeFront(true);
    QVERIFY(std::abs(depth(solid) - 3.5f) < 0.01f);
    QVERIFY(std::abs(depth(test::backBeforeFront(false)) - 3) < 0.01f);
    QVERIFY(std::abs(depth(test::built(test::disc({0, 0, 0}, {0, 0, -1}, 0.5, 0.02))) - 3) < 0.01f);
    RenderOptions open;
    open.definition.boundaryLimit = 0.2f;
    QVERIFY(std::abs(depth(solid, open) - 3) < 0.01f);
    RenderOptions several; // the others may be open
    several.entire = false;
    QVERIFY(std::abs(depth(solid, several) - 3) < 0.01f);
    camera.clips.add({{0, 1, 0}, -0.9});
    QVERIFY(std::abs(depth(solid) - 3) < 0.01f);
}

void CpuSplatterTest::insidesAreBlendedAsOutsides() {
    // From within a ball whose normals point outwards, and the same with normals that point to the eye.
    surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 20000);
    Camera camera = test::cutTilesCamera();
    camera.eye = {0, 0, 0.5};
    CpuSplatter splatter;
    const Image inside = test::drawn(splatter, test::built(list), camera);
    for (auto& s : list.items)
        s.normal = -s.normal;
    const Image front = test::drawn(splatter, test::built(list), camera);
    double worst = 0;
    for (std::size_t i = 0; i < front.depth.size(); ++i)
        worst = std::max(worst, static_cast<double>(std::abs(inside.depth[i] - front.depth[i])));
    QVERIFY2(worst < 2e-3, qPrintable(QString::number(worst)));
}

void CpuSplatterTest::splatsNeverFallBetweenPixels() {
    base::Random random(test::seed());
    surfel::SurfelList list;
    list.layout = test::orientedLayout();
    for (int k = 0; k < 200; ++k)
        list.items.push_back({base::cast<float>(Vec3d{random.uniform(-1, 1), random.uniform(-0.7, 0.7), 0}),
                              {0, 0, 1},
                              1e-5f,
                              surfel::white,
                              0});
    CpuSplatter splatter;
    const Camera camera = test::cutTilesCamera();
    const Image image = test::drawn(splatter, test::built(list), camera);
    for (const auto& s : list.items) {
        const Vec3d place = camera.project(base::cast<double>(s.position));
        const std::size_t i = static_cast<std::size_t>(place.y) * 321 + static_cast<std::size_t>(place.x);
        QVERIFY2(std::isfinite(image.depth[i]), qPrintable(QString("seed %1").arg(test::seed())));
    }
}

void CpuSplatterTest::unorientedSplatsFaceTheEye() {
    surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 20000);
    CpuSplatter splatter;
    const Camera camera = test::cutTilesCamera();
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->oriented = false;
    list.layout = layout;
    const Image before = test::drawn(splatter, test::built(list), camera);
    base::Random random(test::seed());
    for (auto& s : list.items)
        if (random.uniform() < 0.5)
            s.normal = -s.normal;
    const Image after = test::drawn(splatter, test::built(list), camera);
    QVERIFY(before.colour == after.colour && before.depth == after.depth);
    // Without any normals the model is still drawn.
    for (auto& s : list.items)
        s.normal = {};
    const Image bare = test::drawn(splatter, test::built(list), camera);
    QVERIFY(std::isfinite(bare.depth[121 * 321 + 160]));
}

void CpuSplatterTest::thereIsNoNearPlane() {
    const auto model = test::built(test::disc({0, 0, 0}, {0, 0, 1}, 0.01, 1e-4));
    CpuSplatter splatter;
    for (const double z : {1e-3, 1e3}) {
        Camera camera = test::cutTilesCamera();
        camera.eye = {0, 0, z};
        const Image image = test::drawn(splatter, model, camera);
        QVERIFY(std::abs(image.depth[121 * 321 + 160] / z - 1) < 1e-3);
        if (z < 1)
            for (const float depth : image.depth)
                QVERIFY(std::isfinite(depth));
    }
}

void CpuSplatterTest::coloursAndMasksAreBlended() {
    surfel::SurfelList list = test::disc({0, 0, 0}, {0, 0, 1}, 2, 0.02);
    list.layout = test::orientedLayout(true);
    for (auto& s : list.items) {
        s.colour = surfel::rgba(s.position.x > 0 ? 200 : 100, 50, 25);
        s.mask = 0.5f;
    }
    RenderOptions options;
    options.shading = Shading::Colour;
    CpuSplatter splatter;
    const Camera camera = test::cutTilesCamera();
    const Image image = test::drawn(splatter, test::built(list), camera, options);
    const auto at = [&](int x) { return image.colour[static_cast<std::size_t>(121 * 321 + x)]; };
    QCOMPARE(at(160 + 60),
             shade(Shading::Colour, asSeen(camera, {0, 0, 1}, 220, 121), surfel::rgba(200, 50, 25), 0.5f));
    QCOMPARE(at(160 - 60),
             shade(Shading::Colour, asSeen(camera, {0, 0, 1}, 100, 121), surfel::rgba(100, 50, 25), 0.5f));
}

void CpuSplatterTest::sameBitsAtAnyThreadCount() {
    const auto model = test::built(test::torus(1, 0.4, 60000, test::seed()));
    CpuSplatter splatter;
    base::setThreadCount(1);
    const Image one = test::drawn(splatter, model, test::cutTilesCamera());
    base::setThreadCount(0);
    for (int k = 0; k < 5; ++k) {
        const Image many = test::drawn(splatter, model, test::cutTilesCamera());
        QVERIFY(one.colour == many.colour && one.depth == many.depth);
    }
}

void CpuSplatterTest::transparentBackgroundHasNoAlpha() {
    RenderOptions options;
    options.transparent = true;
    CpuSplatter splatter;
    const Image image =
        test::drawn(splatter, test::built(test::sphere({0, 0, 0}, 0.3, 5000)), test::cutTilesCamera(), options);
    for (std::size_t i = 0; i < image.colour.size(); ++i)
        QCOMPARE(image.colour[i] >> 24, std::isfinite(image.depth[i]) ? 255u : 0u);
    QCOMPARE(image.colour[0] >> 24, 0u);
    QCOMPARE(image.colour[121 * 321 + 160] >> 24, 255u);
}

void CpuSplatterTest::anEmptyModelIsBackground() {
    CpuSplatter splatter;
    const Image image = test::drawn(splatter, {}, test::cutTilesCamera());
    QCOMPARE(image.colour.size(), std::size_t(321 * 243));
    for (const float depth : image.depth)
        QVERIFY(std::isinf(depth));
}

/// Versions of a stroke, of an undo, of another model, and views, one after the other into the same image.
void CpuSplatterTest::updatesAreTheWholePicture() {
    const auto start = test::built(test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.01));
    std::vector<tree::SurfelTree> versions{start};
    for (int dab = 0; dab < 6; ++dab) { // moves, removes and adds surfels about a place
        const base::Vec3f centre{0.12f * float(dab) - 0.3f, 0.05f * float(dab), 0};
        tree::Edit edit;
        edit.inserted.layout = start.layout();
        versions.back().forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            std::bitset<surfel::blockCapacity> gone;
            for (int slot = 0; slot < block.size(); ++slot)
                if (distance(block.position(slot), centre) < 0.15f) {
                    gone[static_cast<std::size_t>(slot)] = true;
                    surfel::Surfel moved = block.surfel(slot);
                    moved.position.z += 0.03f * float(dab % 3);
                    if (slot % 5 != dab % 5)
                        edit.inserted.items.push_back(moved);
                }
            if (gone.any())
                edit.blocks.push_back({number, {}, gone});
        });
        versions.push_back(versions.back().apply(edit));
    }
    versions.push_back(versions[2]);
    versions.push_back(versions[2]);
    versions.push_back(test::built(test::disc({0, 0, 0}, {0, 0.6, 0.8}, 1, 0.02)));
    versions.push_back(start);
    Camera camera = test::cutTilesCamera();
    RenderOptions options;
    CpuSplatter splatter;
    Image image;
    for (std::size_t k = 0; k < versions.size(); ++k) {
        if (k == 5)
            camera.eye.x += 0.1;
        if (k == 7)
            options.shading = Shading::Normal;
        splatter.update(versions[k], camera, options, image);
        CpuSplatter fresh;
        const Image whole = test::drawn(fresh, versions[k], camera, options);
        QVERIFY2(image.colour == whole.colour && image.depth == whole.depth, qPrintable(QString::number(k)));
    }
}

static const test::Registered<CpuSplatterTest> registered;
#include "cpu_splatter_test.moc"
