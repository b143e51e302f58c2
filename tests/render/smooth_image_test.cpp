#include "core/render/smooth_image.h"

#include "core/render/splats/cpu_splatter.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;

class SmoothImageTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void colourIsTheMeanOfFourWeightedByAlpha();
    void outlinesGetTheirShareOfThePixel();
};

void SmoothImageTest::colourIsTheMeanOfFourWeightedByAlpha() {
    Camera camera;
    camera.width = 2;
    camera.height = 1;
    const auto draw = [](const Camera& view, Image& image) {
        image.resize(view.width, view.height);
        if (view.width != 4)
            return;
        // Left pixel: 10, 20, 30, 40 opaque. Right: one opaque 80 beside three transparent ones.
        const unsigned values[8] = {10, 20, 200, 80, 30, 40, 200, 200};
        for (std::size_t i = 0; i < 8; ++i)
            image.colour[i] = surfel::rgba(values[i], 0, 0, values[i] == 200 ? 0 : 255);
    };
    Image out;
    renderSmooth(camera, draw, out);
    QCOMPARE(out.colour[0], surfel::rgba(25, 0, 0, 255));
    QCOMPARE(out.colour[1], surfel::rgba(80, 0, 0, 64));
}

void SmoothImageTest::outlinesGetTheirShareOfThePixel() {
    CpuSplatter splatter;
    const auto model = test::built(test::sphere({0, 0, 0}, 0.5, 20000));
    Camera camera;
    camera.width = 160;
    camera.height = 120;
    RenderOptions options;
    options.transparent = true;
    Image smooth;
    renderSmooth(splatter, model, camera, options, smooth);
    const Image plain = test::drawn(splatter, model, camera, options);
    QVERIFY(smooth.depth == plain.depth);
    int partial = 0;
    double area = 0;
    for (const surfel::Colour c : smooth.colour) {
        partial += c >> 24 > 0 && c >> 24 < 255 ? 1 : 0;
        area += (c >> 24) / 255.0;
    }
    // The outline is a circle of tan(asin(r / d)) f pixels; discs and the filter widen it by about one.
    const double radius = 0.5 / std::sqrt(9 - 0.25) * camera.focalPx();
    QVERIFY2(partial > 2 * radius && partial < 12 * radius, qPrintable(QString::number(partial)));
    QVERIFY(area > std::numbers::pi * radius * radius && area < std::numbers::pi * (radius + 1.2) * (radius + 1.2));
}

static const test::Registered<SmoothImageTest> registered;
#include "smooth_image_test.moc"
