#include "ui/gl/backends.h"
#include "ui/gl/offscreen_renderer.h"

#include "core/base/error.h"
#include "core/render/splats/cpu_splatter.h"
#include "core/surfel/shape.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;
using base::Vec3d;

class GlSplatterTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void samePictureAsTheCpu_data();
    void samePictureAsTheCpu();
    void quadsDrawWhatPointsDraw();
    void ellipsoidsAreEllipses();
    void backsOfSolidsShowBeforeNoFront();
    void anEditUploadsItsBlocksAlone();
    void drawsIntoAFramebufferOfOthers();
    void anUnknownBackendIsRefusedByName();

  private:
    /// Null, with the test skipped, where the machine has no such context.
    static std::unique_ptr<OffscreenRenderer> offscreen(const QString& backend, QString& reason);
};

std::unique_ptr<OffscreenRenderer> GlSplatterTest::offscreen(const QString& backend, QString& reason) {
    try {
        return std::make_unique<OffscreenRenderer>(backend == "egl" ? makeEglContext() : makeOsMesaContext());
    } catch (const base::Error& e) {
        reason = e.what();
        return nullptr;
    }
}

static Camera smallCamera() {
    Camera camera;
    camera.width = 320;
    camera.height = 240;
    return camera;
}

void GlSplatterTest::samePictureAsTheCpu_data() {
    QTest::addColumn<QString>("backend");
    QTest::addColumn<QString>("shading");
    QTest::addColumn<bool>("oriented");
    QTest::addColumn<double>("distance");
    QTest::addColumn<float>("pointLimit");
    for (const char* backend : {"osmesa", "egl"}) {
        QTest::addRow("%s clay", backend) << backend << "matcap" << true << 3.0 << 1e9f;
        QTest::addRow("%s normals", backend) << backend << "normal" << true << 3.0 << 1e9f;
        QTest::addRow("%s colours, masks", backend) << backend << "colour" << true << 3.0 << 1e9f;
        QTest::addRow("%s far", backend) << backend << "mask" << true << 20.0 << 1e9f;
        QTest::addRow("%s close, by quads", backend) << backend << "matcap" << true << 1.05 << 20.0f;
        QTest::addRow("%s unoriented", backend) << backend << "matcap" << false << 3.0 << 1e9f;
        QTest::addRow("%s from inside", backend) << backend << "colour" << true << 0.3 << 20.0f;
    }
}

void GlSplatterTest::samePictureAsTheCpu() {
    QFETCH(QString, backend);
    QFETCH(QString, shading);
    QFETCH(bool, oriented);
    QFETCH(double, distance);
    QFETCH(float, pointLimit);
    QString reason;
    const auto gl = offscreen(backend, reason);
    if (!gl)
        QSKIP(qPrintable(reason));
    gl->limitPointSize(pointLimit);
    surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 20000, true);
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->oriented = oriented;
    list.layout = layout;
    const tree::SurfelTree model = test::built(list);
    RenderOptions options;
    options.shading = render::shading(shading.toStdString());
    CpuSplatter cpu;
    for (const Vec3d& direction : {Vec3d{1, 2, 3}, Vec3d{-2, 0.1, -1}, Vec3d{0.2, -3, 0.5}}) {
        Camera camera = smallCamera();
        camera.eye = normalized(direction) * distance;
        const Image a = test::drawn(cpu, model, camera, options), b = test::drawn(*gl, model, camera, options);
        const test::Difference d = test::difference(a, b);
        QVERIFY2(d.mean < 0.5 && d.apart <= 20,
                 qPrintable(QString("mean %1, largest %2, apart %3").arg(d.mean).arg(d.largest).arg(d.apart)));
        std::size_t deep = 0;
        for (std::size_t i = 0; i < a.depth.size(); ++i)
            deep += std::isfinite(a.depth[i]) && std::abs(a.depth[i] - b.depth[i]) > 1e-3f * a.depth[i] ? 1 : 0;
        QVERIFY2(deep <= 40, qPrintable(QString::number(deep)));
        if (distance < 1)
            break; // all around is near: each picture takes as long as those of the other rows together
    }
}

void GlSplatterTest::quadsDrawWhatPointsDraw() {
    QString reason;
    const auto gl = offscreen("osmesa", reason);
    if (!gl)
        QSKIP(qPrintable(reason));
    const tree::SurfelTree model = test::built(test::torus(1, 0.4, 5000, test::seed()));
    Camera camera = smallCamera();
    camera.eye = {1.5, 1, 2.5};
    const Image points = test::drawn(*gl, model, camera);
    gl->limitPointSize(0);
    const Image quads = test::drawn(*gl, model, camera);
    QVERIFY(points.colour == quads.colour && points.depth == quads.depth);
}

void GlSplatterTest::backsOfSolidsShowBeforeNoFront() {
    QString reason;
    const auto gl = offscreen("osmesa", reason);
    if (!gl)
        QSKIP(qPrintable(reason));
    CpuSplatter cpu;
    for (const bool labelled : {true, false}) {
        const tree::SurfelTree model = test::backBeforeFront(labelled);
        const Image a = test::drawn(cpu, model, smallCamera()), b = test::drawn(*gl, model, smallCamera());
        const test::Difference d = test::difference(a, b);
        QVERIFY2(d.mean < 0.5 && d.apart <= 20,
                 qPrintable(QString("mean %1, largest %2, apart %3").arg(d.mean).arg(d.largest).arg(d.apart)));
    }
}

/// As the CPU draws them; and as balls again where the next model has none.
void GlSplatterTest::ellipsoidsAreEllipses() {
    QString reason;
    const auto gl = offscreen("osmesa", reason);
    if (!gl)
        QSKIP(qPrintable(reason));
    CpuSplatter cpu;
    surfel::SurfelList balls = test::sphere({0, 0, 0}, 1, 600, true), ellipsoids;
    auto layout = std::make_shared<surfel::AttributeLayout>(*balls.layout);
    surfel::addShape(*layout);
    ellipsoids.layout = layout;
    for (surfel::Surfel& s : balls.items) {
        s.support *= 0.5f; // far enough apart to see their shapes
        std::vector<std::uint32_t> words(layout->words());
        surfel::putShape(words, surfel::shapeWord(*layout), base::perpendicular(s.normal) * 2.5f);
        ellipsoids.append(s, words);
    }
    for (const bool parallel : {false, true}) {
        Camera camera = smallCamera();
        camera.eye = {1.5, 1, 2.5};
        camera.orthoHeight = parallel ? 2.5 : 0;
        for (const surfel::SurfelList* list : {&balls, &ellipsoids, &balls}) {
            const tree::SurfelTree model = test::built(*list);
            const test::Difference d =
                test::difference(test::drawn(*gl, model, camera), test::drawn(cpu, model, camera));
            QVERIFY2(d.mean < 0.5 && d.apart <= 100, qPrintable(QString("mean %1, apart %2").arg(d.mean).arg(d.apart)));
        }
    }
}

/// Moves the surfels near a place outwards.
static tree::Edit bump(const tree::SurfelTree& model, const base::Vec3f& place, float radius) {
    tree::Edit edit;
    model.forBlocksInBall(place, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        auto changed = block.clone();
        for (int slot = 0; slot < block.size(); ++slot)
            if (distance(block.position(slot), place) < radius)
                changed->setPosition(slot, block.position(slot) + block.normal(slot) * 0.1f);
        changed->seal();
        edit.blocks.push_back({number, changed, {}});
    });
    return edit;
}

void GlSplatterTest::anEditUploadsItsBlocksAlone() {
    QString reason;
    const auto gl = offscreen("osmesa", reason), fresh = offscreen("osmesa", reason);
    if (!gl)
        QSKIP(qPrintable(reason));
    tree::SurfelTree model = test::built(test::sphere({0, 0, 0}, 1, 50000));
    const tree::SurfelTree first = model;
    const Camera camera = smallCamera();
    const Image before = test::drawn(*gl, model, camera);
    const std::size_t all = gl->splatter().storage().uploadedBytes();
    test::drawn(*gl, model, camera);
    QCOMPARE(gl->splatter().storage().uploadedBytes(), std::size_t(0));

    base::Random random(test::seed());
    for (int k = 0; k < 8; ++k) {
        tree::Edit edit = bump(model, base::cast<float>(random.unitVector()), 0.12f);
        if (k % 2 == 1) { // surfels that go and come, so that blocks split and merge
            for (auto& block : edit.blocks)
                for (int slot = 0; slot < 60; ++slot)
                    block.removed.set(static_cast<std::size_t>(slot));
            edit.inserted = test::disc(random.unitVector() * 0.8, random.unitVector(), 0.15, 0.01);
        }
        const tree::SurfelTree next = model.apply(edit);
        const Image changed = test::drawn(*gl, next, camera);
        const std::size_t touched = tree::diff(model, next).added.size();
        QCOMPARE(gl->splatter().storage().uploadedBytes(), touched * slotBytes);
        QVERIFY(touched * slotBytes < all / 4);
        const Image scratch = test::drawn(*fresh, next, camera);
        const test::Difference d = test::difference(changed, scratch);
        // The same splats in another order of addition: half floats round differently.
        QVERIFY2(d.mean < 0.05 && d.apart == 0, qPrintable(QString("%1, seed %2").arg(d.mean).arg(test::seed())));
        model = next;
    }
    const Image undone = test::drawn(*gl, first, camera);
    const test::Difference d = test::difference(before, undone);
    QVERIFY(d.mean < 0.05 && d.apart == 0);
}

void GlSplatterTest::drawsIntoAFramebufferOfOthers() {
    std::unique_ptr<GlContext> context;
    try {
        context = makeOsMesaContext();
    } catch (const base::Error& e) {
        QSKIP(e.what());
    }
    const Current current(*context);
    const auto address = [&](const char* name) { return context->procAddress(name); };
    const GlFunctions gl = GlFunctions::load(address);
    GlSplatter splatter(address);
    GLuint texture = 0, framebuffer = 0;
    gl.genTextures(1, &texture);
    gl.bindTexture(GL_TEXTURE_2D, texture);
    gl.texImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 320, 240, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.genFramebuffers(1, &framebuffer);
    gl.bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);

    const tree::SurfelTree model = test::built(test::sphere({0, 0, 0}, 1, 20000));
    const Camera camera = smallCamera();
    splatter.drawTo(framebuffer, model, camera, {});
    std::vector<std::uint32_t> pixels(320 * 240);
    gl.bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.readPixels(0, 0, 320, 240, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    QCOMPARE(gl.getError(), static_cast<GLenum>(GL_NO_ERROR));
    Image own;
    splatter.drawTo(own, model, camera, {});
    for (int y = 0; y < 240; ++y)
        QVERIFY(std::equal(pixels.begin() + (239 - y) * 320, pixels.begin() + (240 - y) * 320,
                           own.colour.begin() + y * 320));
    gl.deleteFramebuffers(1, &framebuffer);
    gl.deleteTextures(1, &texture);
}

void GlSplatterTest::anUnknownBackendIsRefusedByName() {
    QCOMPARE(std::string(makeRenderer("cpu")->name()), std::string("cpu"));
    try {
        makeRenderer("vulkan");
        QFAIL("made a renderer of an unknown name");
    } catch (const base::Error& e) {
        QVERIFY(e.message().find("vulkan") != std::string::npos && e.message().find("osmesa") != std::string::npos);
    }
}

static const test::Registered<GlSplatterTest> registered;
#include "gl_splatter_test.moc"
