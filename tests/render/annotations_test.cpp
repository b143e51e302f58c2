#include "core/render/overlay/annotation_canvas.h"

#include "core/render/overlay/stroke_font.h"
#include "core/render/shading/shading_table.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;

class AnnotationsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void legendsNumbersMatchTheRange();
    void theScaleBarIsAsLongAsItSays();
    void axesPointWhereTheyAreSeen();
    void everyLetterOfTheTablesHasAShape();
    void whatIsPaintedStaysInTheImageAndReads();
};

static ColourScale scaleOf(float low, float high) {
    return {low < 0 ? ColourMap::Diverging : ColourMap::Sequential, low, high, "Mean curvature (1/length)"};
}

void AnnotationsTest::legendsNumbersMatchTheRange() {
    base::Random random(test::seed());
    for (int k = 0; k < 100; ++k) {
        const auto size = static_cast<float>(std::pow(10, random.uniform(-5, 5)));
        const ColourScale scale = k % 2 ? scaleOf(-size, size) : scaleOf(0.2f * size, size);
        const Drawing drawing = annotate(Legend, {}, scale, Backdrop::Studio);
        QCOMPARE(drawing.ramps.size(), std::size_t(1));
        const DrawnRamp& ramp = drawing.ramps.front();
        QVERIFY(ramp.map == scale.map);
        float least = 1e30f, most = -1e30f;
        for (const DrawnText& text : drawing.texts) {
            if (text.text == scale.title)
                continue;
            const float value = std::stof(text.text);
            least = std::min(least, value), most = std::max(most, value);
            const float part = 1 - (text.at.y - 0.5f * text.capHeight - ramp.corner.y) / ramp.height;
            QVERIFY(std::abs(part - (value - scale.low) / (scale.high - scale.low)) < 2e-3f);
        }
        QVERIFY(std::abs(least - scale.low) <= 1e-3f * size && std::abs(most - scale.high) <= 1e-3f * size);
        for (std::size_t a = 0; a < drawing.texts.size(); ++a) // no number stands on another
            for (std::size_t b = 0; b < a; ++b)
                QVERIFY(std::abs(drawing.texts[a].at.y - drawing.texts[b].at.y) > drawing.texts[a].capHeight);
    }
    QVERIFY(annotate(Legend, {}, {}, Backdrop::Studio).ramps.empty());
}

void AnnotationsTest::theScaleBarIsAsLongAsItSays() {
    base::Random random(test::seed());
    for (int k = 0; k < 50; ++k) {
        Camera camera;
        camera.eye = {random.uniform(-1, 1), random.uniform(-1, 1), std::pow(10, random.uniform(-3, 3))};
        camera.fovDeg = random.uniform(10, 80);
        camera.orthoHeight = k % 2 ? random.uniform(0.1, 10) : 0;
        const Drawing drawing = annotate(ScaleBar, camera, {}, Backdrop::White);
        const DrawnLine& bar = drawing.lines.front();
        const double length = std::stod(drawing.texts.front().text);
        const base::Vec3d a = camera.project(camera.target),
                          b = camera.project(camera.target + camera.right() * length);
        QVERIFY(std::abs(static_cast<double>(bar.to.x - bar.from.x) - (b.x - a.x)) < 0.1);
        QVERIFY(bar.to.x - bar.from.x > 0.08f * 1280 && bar.to.x < 1280);
    }
}

void AnnotationsTest::axesPointWhereTheyAreSeen() {
    Camera camera;
    camera.eye = {2, 1, 3};
    const Drawing drawing = annotate(Axes, camera, {}, Backdrop::Studio);
    QCOMPARE(drawing.lines.size(), std::size_t(3));
    const base::Vec3d start = camera.project({});
    for (std::size_t i = 0; i < 3; ++i) {
        const char name = drawing.texts[i].text[0];
        const base::Vec3d axis{name == 'X' ? 1e-3 : 0, name == 'Y' ? 1e-3 : 0, name == 'Z' ? 1e-3 : 0};
        const base::Vec3d seen = camera.project(axis) - start;
        const float x = drawing.lines[i].to.x - drawing.lines[i].from.x,
                    y = drawing.lines[i].to.y - drawing.lines[i].from.y;
        const double cosine = (seen.x * static_cast<double>(x) + seen.y * static_cast<double>(y)) /
                              (std::hypot(seen.x, seen.y) * static_cast<double>(std::hypot(x, y)));
        QVERIFY(cosine > 0.999);
    }
}

void AnnotationsTest::everyLetterOfTheTablesHasAShape() {
    std::string all = "0123456789+-.e";
    for (const ShadingRow& row : shadingTable())
        if (row.measure)
            all += row.measure->title;
    for (const char letter : all)
        QVERIFY2(hasGlyph(letter), std::string(1, letter).c_str());
    QVERIFY(textWidth("10", 10) > textWidth("1", 10));
    QCOMPARE(textWidth("", 10), 0.0f);
}

void AnnotationsTest::whatIsPaintedStaysInTheImageAndReads() {
    for (const BackdropRow& row : backdropTable())
        for (const auto& [width, height] : {std::pair(1280, 720), std::pair(64, 48), std::pair(1, 1)}) {
            Image image;
            image.resize(width, height);
            std::fill(image.colour.begin(), image.colour.end(), background(row.backdrop, 0.5f));
            const Image before = image;
            Camera camera;
            camera.width = width, camera.height = height;
            paint(annotate(Legend | ScaleBar | Axes, camera, scaleOf(-1, 1), row.backdrop), image);
            if (width < 100)
                continue;
            int contrast = 0;
            for (std::size_t i = 0; i < image.colour.size(); ++i)
                contrast =
                    std::max(contrast, std::abs(int(image.colour[i] >> 8 & 255u) - int(before.colour[i] >> 8 & 255u)));
            QVERIFY(contrast > 100);
        }
}

static const test::Registered<AnnotationsTest> registered;
#include "annotations_test.moc"
