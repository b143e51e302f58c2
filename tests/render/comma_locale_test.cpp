// Pictures where a comma separates decimals: the same shaders, the same legends.
#include "support/comma_locale.h"

#include "core/base/error.h"
#include "core/render/effects/effect_rows.h"
#include "core/render/overlay/annotations.h"
#include "core/render/splats/cpu_splatter.h"
#include "render/render_models.h"
#include "support/registry.h"
#include "ui/gl/gl_finish.h"
#include "ui/gl/gl_shaders.h"
#include "ui/gl/glsl_text.h"
#include "ui/gl/offscreen_renderer.h"

#include <charconv>
#include <QTest>

using namespace render;

class CommaLocaleTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void shadersAreTheSameText();
    void openGlDrawsTheSamePicture();
    void legendsAreTheSame();
    void shaderNumbersReadBack();
};

static std::vector<std::string> sources() {
    return {splatVertexShader(SplatShape::Point), splatFragmentShader(SplatPass::Attributes), shadeFragmentShader(),
            finishFragmentShader()};
}

void CommaLocaleTest::shadersAreTheSameText() {
    const auto usual = sources();
    const test::CommaLocale comma;
    QVERIFY(comma.works());
    QVERIFY(sources() == usual);
    for (const EffectRow& row : effectTable())
        for (const SharedConstant& constant : row.constants)
            QVERIFY2(usual.back().find(glslConstant(constant)) != std::string::npos, constant.name);
}

static Image picture() {
    OffscreenRenderer gl(makeOsMesaContext());
    RenderOptions options;
    options.effects = (1u << effectCount) - 1;
    const tree::SurfelTree model = test::built(test::sphere({0, 0, 0}, 1, 4000));
    options.grid = gridBelow(model.bounds(), {0, 1, 0}, {});
    Camera camera;
    camera.eye = {1, 1, 3};
    camera.width = 160, camera.height = 120;
    return test::drawn(gl, model, camera, options);
}

void CommaLocaleTest::openGlDrawsTheSamePicture() {
    try {
        makeOsMesaContext();
    } catch (const base::Error& error) {
        QSKIP(error.what());
    }
    const Image usual = picture();
    const test::CommaLocale comma;
    QVERIFY(comma.works());
    const Image now = picture();
    QVERIFY(now.colour == usual.colour && now.depth == usual.depth);
}

static std::vector<std::string> labels() {
    std::vector<std::string> out;
    for (const double value : {0.0, 0.5, -1.25, 1e-7, 3.14159265, 12345.678, 1.3e9, 1e300})
        out.push_back(numberLabel(value));
    return out;
}

void CommaLocaleTest::legendsAreTheSame() {
    const auto usual = labels();
    QCOMPARE(usual, (std::vector<std::string>{"0", "0.5", "-1.25", "1e-07", "3.142", "12350", "1.3e+09", "1e+300"}));
    const test::CommaLocale comma;
    QVERIFY(comma.works());
    QCOMPARE(labels(), usual);
}

void CommaLocaleTest::shaderNumbersReadBack() {
    const test::CommaLocale comma;
    for (const float value : {0.07f, 3.0f, 1e-30f, 3e38f, -0.5f, 16777216.0f}) {
        const std::string text = glslFloat(value);
        float back = 0;
        std::from_chars(text.data(), text.data() + text.size(), back);
        QCOMPARE(back, value);
        QVERIFY2(text.find_first_of(".e") != std::string::npos && text.find(',') == std::string::npos, text.c_str());
    }
}

static const test::Registered<CommaLocaleTest> registered;
#include "comma_locale_test.moc"
