#include "core/render/effects/screen_effects.h"

#include "core/base/error.h"
#include "core/render/cast/raycast_image.h"
#include "core/render/effects/effect_rows.h"
#include "core/render/splats/cpu_splatter.h"
#include "render/render_models.h"
#include "support/registry.h"
#include "ui/gl/offscreen_renderer.h"

#include <QTest>

using namespace render;
using base::Vec3d;

class ScreenEffectsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyEffectIsFoundByItsName();
    void planesAreLeftAsTheyAre_data();
    void planesAreLeftAsTheyAre();
    void everyEffectDarkensWhatItSays_data();
    void everyEffectDarkensWhatItSays();
    void samePictureByOpenGl_data();
    void samePictureByOpenGl();
    void anEditIsFinishedAsFarAsEffectsReach();
    void raysAreFinishedLikeSplats();
    void theGridStandsWhereItSaysAndBehindTheModel();
};

static int brightness(surfel::Colour c) {
    return static_cast<int>((c & 255u) + (c >> 8 & 255u) + (c >> 16 & 255u));
}

static Camera camera320(bool parallel = false) {
    Camera out;
    out.eye = {1.5, 1.7, 2.5};
    out.width = 320, out.height = 240;
    out.orthoHeight = parallel ? 3 : 0;
    return out;
}

static Image drawn(const tree::SurfelTree& model, const Camera& camera, Effects effects) {
    RenderOptions options;
    options.effects = effects;
    CpuSplatter cpu;
    return test::drawn(cpu, model, camera, options);
}

void ScreenEffectsTest::everyEffectIsFoundByItsName() {
    Effects all = 0;
    std::string list;
    for (const EffectRow& row : effectTable()) {
        QCOMPARE(effects(row.id), Effects(row.effect));
        QVERIFY(!(all & row.effect));
        all |= row.effect;
        list += (list.empty() ? "" : ",") + std::string(row.id);
    }
    QCOMPARE(effects(list), all);
    QCOMPARE(effects(""), Effects(0));
    QVERIFY_EXCEPTION_THROWN(effects("outline,glow"), base::Error);
}

void ScreenEffectsTest::planesAreLeftAsTheyAre_data() {
    QTest::addColumn<int>("effect");
    QTest::addColumn<double>("tilt");
    QTest::addColumn<bool>("parallel");
    for (const EffectRow& row : effectTable())
        for (const double tilt : {0.0, 35.0, 65.0})
            for (const bool parallel : {false, true})
                QTest::addRow("%s %g %s", row.id, tilt, parallel ? "parallel" : "perspective")
                    << static_cast<int>(row.effect) << tilt << parallel;
}

void ScreenEffectsTest::planesAreLeftAsTheyAre() {
    QFETCH(int, effect);
    QFETCH(double, tilt);
    QFETCH(bool, parallel);
    Camera camera = camera320(parallel);
    camera.eye = {0, 0, 3};
    const double angle = tilt * std::numbers::pi / 180;
    const tree::SurfelTree plane = test::built(test::disc({0, 0, 0}, {0, std::sin(angle), std::cos(angle)}, 2, 0.025));
    const Image bare = drawn(plane, camera, 0), done = drawn(plane, camera, static_cast<Effects>(effect));
    for (int y = 90; y < 150; ++y)
        for (int x = 90; x < 230; ++x) {
            const auto i = static_cast<std::size_t>(y * camera.width + x);
            QVERIFY(std::isfinite(bare.depth[i]));
            QVERIFY2(std::abs(brightness(bare.colour[i]) - brightness(done.colour[i])) <= 3,
                     qPrintable(
                         QString("%1 %2: %3 %4").arg(x).arg(y).arg(bare.colour[i], 0, 16).arg(done.colour[i], 0, 16)));
        }
    QVERIFY(bare.depth == done.depth);
}

/// A ball that lies on a table with a step in it.
static tree::SurfelTree stillLife() {
    surfel::SurfelList out = test::sphere({0, 0.5, 0}, 0.5, 20000);
    const auto add = [&](const surfel::SurfelList& more) {
        out.items.insert(out.items.end(), more.items.begin(), more.items.end());
    };
    add(test::disc({0, 0, 0}, {0, 1, 0}, 1.4, 0.02));
    add(test::disc({-1, 0.3, 0}, {1, 0, 0}, 0.3, 0.02));
    return test::built(out);
}

void ScreenEffectsTest::everyEffectDarkensWhatItSays_data() {
    QTest::addColumn<int>("effect");
    for (const EffectRow& row : effectTable())
        QTest::addRow("%s", row.id) << static_cast<int>(row.effect);
}

void ScreenEffectsTest::everyEffectDarkensWhatItSays() {
    QFETCH(int, effect);
    const Image bare = drawn(stillLife(), camera320(), 0),
                done = drawn(stillLife(), camera320(), static_cast<Effects>(effect));
    std::size_t darker = 0, lighter = 0, seen = 0, outside = 0;
    for (std::size_t i = 0; i < bare.colour.size(); ++i) {
        const int change = brightness(done.colour[i]) - brightness(bare.colour[i]);
        darker += change < -10 ? 1 : 0, lighter += change > 3 ? 1 : 0;
        seen += std::isfinite(bare.depth[i]) ? 1 : 0;
        outside += !std::isfinite(bare.depth[i]) && change != 0 ? 1 : 0;
    }
    if (effect != Contours) // neither ball nor table has any
        QVERIFY2(darker > 50, qPrintable(QString::number(darker)));
    QVERIFY2(darker < seen / 2, qPrintable(QString::number(darker)));
    QCOMPARE(outside, std::size_t(0));
    QVERIFY2(lighter < seen / 100, qPrintable(QString::number(lighter))); // ink on what was darker still
}

void ScreenEffectsTest::samePictureByOpenGl_data() {
    QTest::addColumn<int>("effects");
    QTest::addColumn<bool>("grid");
    QTest::addColumn<bool>("parallel");
    for (const bool parallel : {false, true}) {
        const char* rays = parallel ? "parallel" : "perspective";
        for (const EffectRow& row : effectTable())
            QTest::addRow("%s %s", row.id, rays) << static_cast<int>(row.effect) << false << parallel;
        QTest::addRow("grid %s", rays) << 0 << true << parallel;
        QTest::addRow("all %s", rays) << (1 << effectCount) - 1 << true << parallel;
    }
}

void ScreenEffectsTest::samePictureByOpenGl() {
    QFETCH(int, effects);
    QFETCH(bool, grid);
    QFETCH(bool, parallel);
    std::unique_ptr<OffscreenRenderer> gl;
    try {
        gl = std::make_unique<OffscreenRenderer>(makeOsMesaContext());
    } catch (const base::Error& error) {
        QSKIP(error.what());
    }
    const tree::SurfelTree model = stillLife();
    RenderOptions options;
    options.effects = static_cast<Effects>(effects);
    if (grid)
        options.grid = gridBelow(model.bounds(), {0, 1, 0}, {});
    for (const bool transparent : {false, true}) {
        options.transparent = transparent;
        CpuSplatter cpu;
        const Image a = test::drawn(cpu, model, camera320(parallel), options),
                    b = test::drawn(*gl, model, camera320(parallel), options);
        const test::Difference d = test::difference(a, b);
        QVERIFY2(d.mean < 1, qPrintable(QString::number(d.mean)));
        RenderOptions bare;
        bare.transparent = transparent;
        if (effects != Contours) // there are none
            QVERIFY(test::difference(b, test::drawn(*gl, model, camera320(parallel), bare)).mean > 0.05);
    }
}

void ScreenEffectsTest::anEditIsFinishedAsFarAsEffectsReach() {
    const tree::SurfelTree before = test::built(test::torus(1, 0.4, 30000, test::seed()));
    RenderOptions options;
    options.effects = (1u << effectCount) - 1;
    options.grid = gridBelow(before.bounds(), {0, 1, 0}, {});
    CpuSplatter cpu;
    Image image = test::drawn(cpu, before, camera320(), options);
    base::Random random(test::seed());
    tree::SurfelTree now = before;
    for (int k = 0; k < 4; ++k) {
        const auto number = static_cast<std::uint32_t>(random.uniform(0, now.blockCount() - 1));
        auto changed = now.block(number)->clone();
        for (int slot = 0; slot < changed->size(); ++slot)
            changed->setPosition(slot, changed->position(slot) + changed->normal(slot) * 0.05f);
        changed->seal();
        tree::Edit edit;
        edit.blocks.push_back({number, changed, {}});
        now = now.apply(edit);
        cpu.update(now, camera320(), options, image);
        CpuSplatter fresh;
        QVERIFY(image.colour == test::drawn(fresh, now, camera320(), options).colour);
    }
}

void ScreenEffectsTest::raysAreFinishedLikeSplats() {
    const surface::Surface model(test::built(test::torus(1, 0.4, 20000, test::seed())), {});
    RenderOptions options;
    options.effects = EyeDome | Occlusion | Outline;
    Image rays;
    RayCounts counts;
    rayCast(model, camera320(), options, rays, counts);
    CpuSplatter cpu;
    const test::Difference d = test::difference(rays, test::drawn(cpu, model.tree(), camera320(), options));
    QVERIFY2(d.mean < 3, qPrintable(QString::number(d.mean)));
}

void ScreenEffectsTest::theGridStandsWhereItSaysAndBehindTheModel() {
    const tree::SurfelTree model = test::built(test::sphere({0, 0, 0}, 1, 10000));
    RenderOptions options;
    options.backdrop = Backdrop::Plain;
    const GroundGrid grid = gridBelow(model.bounds(), {0, 1, 0}, {10, 20, 30.05});
    QVERIFY(std::abs(std::remainder(grid.centre.z + 30.05, grid.cell)) < 1e-9); // round in the file's coordinates
    QVERIFY(std::abs(grid.centre.y + 1) < 0.01);
    for (const bool parallel : {false, true}) {
        Camera camera = camera320(parallel);
        camera.width = 640, camera.height = 480;
        camera.eye = {0.3, 4, 5};
        camera.orthoHeight = parallel ? 5 : 0;
        CpuSplatter cpu;
        options.grid.reset();
        const Image bare = test::drawn(cpu, model, camera, options);
        options.grid = grid;
        const Image done = test::drawn(cpu, model, camera, options);
        for (std::size_t i = 0; i < bare.colour.size();
             ++i) // all of the ground lies behind the ball, as seen from above
            if (std::isfinite(bare.depth[i]))
                QCOMPARE(done.colour[i], bare.colour[i]);
        int found = 0;
        for (int k = -4; k <= 4; ++k)
            for (int m = -4; m <= 4; ++m) {
                const auto change = [&](double u, double v) {
                    const Vec3d p =
                        camera.project(grid.centre + grid.along * (u * grid.cell) + grid.across * (v * grid.cell));
                    if (p.x < 0 || p.y < 0 || p.x >= camera.width || p.y >= camera.height)
                        return -1;
                    const auto i =
                        static_cast<std::size_t>(static_cast<int>(p.y) * camera.width + static_cast<int>(p.x));
                    return std::isfinite(bare.depth[i])
                               ? -1
                               : std::abs(brightness(done.colour[i]) - brightness(bare.colour[i]));
                };
                const int onLine = change(k, m + 0.5), between = change(k + 0.5, m + 0.5);
                QVERIFY2(onLine == -1 || onLine > 12, qPrintable(QString::number(onLine)));
                QVERIFY2(between <= 3, qPrintable(QString::number(between)));
                found += onLine > 0 ? 1 : 0;
            }
        QVERIFY(found >= 10);
    }
}

static const test::Registered<ScreenEffectsTest> registered;
#include "screen_effects_test.moc"
