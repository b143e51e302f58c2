#include "core/render/shading/measured_colours.h"

#include "core/base/error.h"
#include "core/process/measuring/measured_attribute.h"
#include "core/render/picture.h"
#include "core/render/splats/cpu_splatter.h"
#include "render/render_models.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "ui/gl/offscreen_renderer.h"

#include <QTest>

using namespace render;
using base::Vec3d;
using base::Vec3f;
using process::FieldQuestion;
using process::Quantity;
using process::ScalarField;

class MeasuredColoursTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void mapsKeepTheOrderOfLightnessAndGreyMeansZero();
    void ticksAreRoundAndStayWithinTheScale();
    void rangesAreThoseOfMostValuesAndRound();
    void anAttributeIsShownAsItIsCarried();
    void nothingIsSelectedWhereNothingWasEver();
    void aSphereHasOneColourThatOfOneOverItsRadius();
    void aPlaneIsNeutral();
    void aShiftedPlaneDeviatesByTheShift();
    void aModelDoesNotDeviateFromItself();
    void anEditIsMeasuredWhereItReachesWithTheBitsOfAll_data();
    void anEditIsMeasuredWhereItReachesWithTheBitsOfAll();
    void anEditRedrawsAndUploadsItsBlocksAlone();
    void everyRowIsDrawnAlikeByEveryRenderer_data();
    void everyRowIsDrawnAlikeByEveryRenderer();
    void raysAndSplatsShowTheSameNumbers();
};

static surface::Surface surfaceOf(const surfel::SurfelList& list) {
    return {test::built(list), {}};
}

static double lightness(surfel::Colour c) {
    const auto linear = [&](int k) { return std::pow(static_cast<double>(c >> (8 * k) & 255u) / 255, 2.2); };
    return std::cbrt(0.2126 * linear(0) + 0.7152 * linear(1) + 0.0722 * linear(2));
}

void MeasuredColoursTest::mapsKeepTheOrderOfLightnessAndGreyMeansZero() {
    for (int k = 1; k <= 100; ++k) {
        const float t = 0.01f * static_cast<float>(k), before = t - 0.01f;
        QVERIFY(lightness(mapped(ColourMap::Sequential, t)) >= lightness(mapped(ColourMap::Sequential, before)));
        const bool rising = k <= 50;
        QVERIFY((lightness(mapped(ColourMap::Diverging, t)) >= lightness(mapped(ColourMap::Diverging, before))) ==
                rising);
    }
    const surfel::Colour zero = mapped(ColourMap::Diverging, 0.5f);
    for (int k = 8; k <= 16; k += 8)
        QVERIFY(std::abs(int(zero & 255u) - int(zero >> k & 255u)) <= 3);
    QCOMPARE(mapped(ColourMap::Diverging, -5), mapped(ColourMap::Diverging, 0));
    QCOMPARE(mapped(ColourMap::Sequential, std::numeric_limits<float>::quiet_NaN()), unknownColour);
}

void MeasuredColoursTest::ticksAreRoundAndStayWithinTheScale() {
    base::Random random(test::seed());
    for (int k = 0; k < 500; ++k) {
        ColourScale scale;
        const double size = std::pow(10, random.uniform(-6, 6));
        scale.low = static_cast<float>(random.uniform(-1, 1) * size);
        scale.high = scale.low + static_cast<float>(size * random.uniform(0.5, 2));
        const std::vector<double> found = ticks(scale);
        QVERIFY(found.size() >= 3 && found.size() <= 9);
        for (const double tick : found) {
            QVERIFY(tick >= double(scale.low) - 1e-5 * size && tick <= double(scale.high) + 1e-5 * size);
            QVERIFY(std::abs(std::stod(numberLabel(tick)) - tick) <= 1e-3 * std::abs(tick) + 1e-9 * size);
        }
    }
}

void MeasuredColoursTest::rangesAreThoseOfMostValuesAndRound() {
    base::Random random(test::seed());
    for (const ShadingRow& row : shadingTable()) {
        if (!row.measure || row.measure->chosen)
            continue;
        std::vector<float> values;
        for (int k = 0; k < 10000; ++k)
            values.push_back(static_cast<float>(random.uniform(row.measure->isSigned ? -3 : 1, 3)));
        values.push_back(1e6f); // one wild value
        const ColourScale scale = automaticScale(*row.measure, values, 1);
        QVERIFY(scale.high > 2.4f && scale.high < 3.2f);
        QCOMPARE(scale.low, row.measure->isSigned ? -scale.high : scale.low);
        QCOMPARE(std::stof(numberLabel(static_cast<double>(scale.high))), scale.high);
        QVERIFY(automaticScale(*row.measure, {}, 1).low < automaticScale(*row.measure, {}, 1).high);
        QVERIFY(automaticScale(*row.measure, {0, 0}, 1).low < automaticScale(*row.measure, {0, 0}, 1).high);
        QVERIFY_EXCEPTION_THROWN(fixedScale(*row.measure, 1, 1), base::Error);
    }
}

/// The model with an attribute that its places tell.
static surface::Surface labelled(const surface::Surface& surface) {
    std::vector<float> numbers;
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            numbers.push_back(block.position(slot).x);
    });
    return {process::withAttribute(surface.tree(), "height", numbers), surface.definition()};
}

void MeasuredColoursTest::anAttributeIsShownAsItIsCarried() {
    const surface::Surface sphere = labelled(surfaceOf(test::sphere({1, 2, 3}, 2, 20000)));
    const FieldQuestion question{Quantity::Attribute, sphere, {}, "height"};
    const ScalarField field = process::evaluateField(question);
    std::vector<base::Vec3f> places;
    sphere.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            QCOMPARE((*field.of(&block))[static_cast<std::size_t>(slot)], block.position(slot).x);
        places.push_back(block.position(0));
    });
    std::vector<float> between(places.size());
    process::quantityAt(question, places, between);
    for (std::size_t i = 0; i < places.size(); ++i)
        QVERIFY(std::abs(between[i] - places[i].x) < 0.01f);
    const MeasureRow& row = *shadingRow(Shading::Attribute).measure;
    QCOMPARE(scaleFor(row, question, {}, &field).title, std::string("height"));
    const FieldQuestion lost{Quantity::Attribute, sphere, {}, "depth"};
    const ScalarField none = process::evaluateField(lost, &field);
    QVERIFY(std::isnan((*none.of(sphere.tree().block(0).get()))[0]));
}

void MeasuredColoursTest::nothingIsSelectedWhereNothingWasEver() {
    const surface::Surface sphere = surfaceOf(test::sphere({1, 2, 3}, 2, 2000));
    const MeasureRow& row = *shadingRow(Shading::Selection).measure;
    const FieldQuestion question = row.question(sphere, {}, "other");
    const ScalarField field = process::evaluateField(question);
    const auto colours = coloursOf(field, scaleFor(row, question, {}, &field));
    sphere.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            QCOMPARE(colours->of(&block)[slot], mapped(ColourMap::Chosen, 0));
    });
}

void MeasuredColoursTest::aSphereHasOneColourThatOfOneOverItsRadius() {
    const surface::Surface sphere = surfaceOf(test::sphere({1, 2, 3}, 2, 20000));
    const ScalarField field = process::evaluateField({Quantity::MeanCurvature, sphere, {}});
    const ColourScale scale{ColourMap::Diverging, -1, 1, ""};
    const auto colours = coloursOf(field, scale);
    const surfel::Colour wanted = mapped(ColourMap::Diverging, 0.75f); // 1/2 on [-1, 1]
    sphere.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const float k = (*field.of(&block))[static_cast<std::size_t>(slot)];
            QVERIFY2(std::abs(k - 0.5f) < 0.015f, qPrintable(QString::number(double(k))));
            for (int shift = 0; shift < 24; shift += 8)
                QVERIFY(std::abs(int(colours->of(&block)[slot] >> shift & 255u) - int(wanted >> shift & 255u)) <= 3);
        }
    });
}

void MeasuredColoursTest::aPlaneIsNeutral() {
    const surface::Surface plane = surfaceOf(test::disc({0, 0, 0}, {0.6, 0, 0.8}, 1, 0.02));
    const float diagonal = plane.tree().bounds().diagonal();
    const surfel::Colour zero = mapped(ColourMap::Diverging, 0.5f);
    for (const ShadingRow& row : shadingTable()) {
        if (!row.measure || !row.measure->isSigned)
            continue;
        const FieldQuestion question{row.measure->quantity, plane, plane};
        const ScalarField field = process::evaluateField(question);
        const auto colours = coloursOf(field, automaticScale(*row.measure, process::sampleField(question), diagonal));
        plane.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                if (length(block.position(slot)) < 0.7f)
                    for (int shift = 0; shift < 24; shift += 8)
                        QVERIFY2(std::abs(int(colours->of(&block)[slot] >> shift & 255u) - int(zero >> shift & 255u)) <=
                                     4,
                                 row.id);
        });
    }
}

void MeasuredColoursTest::aShiftedPlaneDeviatesByTheShift() {
    const surface::Surface plane = surfaceOf(test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.03));
    for (const double shift : {0.01, -0.02, 0.4}) { // the last beyond all supports
        const surface::Surface moved = surfaceOf(test::disc({0, 0, shift}, {0, 0, 1}, 0.6, 0.03));
        const ScalarField field = process::evaluateField({Quantity::Deviation, moved, plane});
        moved.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (const float value : *field.of(&block))
                QVERIFY2(std::abs(static_cast<double>(value) - shift) < 1e-4,
                         qPrintable(QString::number(double(value))));
        });
    }
}

void MeasuredColoursTest::aModelDoesNotDeviateFromItself() {
    const surface::Surface model = surfaceOf(test::torus(1, 0.4, 5000, test::seed()));
    const ScalarField field = process::evaluateField({Quantity::Deviation, model, model});
    QCOMPARE(field.evaluatedBlocks(), std::size_t(0));
    model.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (const float value : *field.of(&block))
            QCOMPARE(value, 0.0f);
    });
}

static tree::SurfelTree bumped(const tree::SurfelTree& model, const Vec3f& place, float radius) {
    tree::Edit edit;
    model.forBlocksInBall(place, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        auto changed = block.clone();
        for (int slot = 0; slot < block.size(); ++slot)
            if (const float far = distance(block.position(slot), place) / radius; far < 1)
                changed->setPosition(slot, block.position(slot) + block.normal(slot) * (0.03f * (1 - far * far)));
        changed->seal();
        edit.blocks.push_back({number, changed, {}});
    });
    return model.apply(edit);
}

void MeasuredColoursTest::anEditIsMeasuredWhereItReachesWithTheBitsOfAll_data() {
    QTest::addColumn<int>("quantity");
    for (const ShadingRow& row : shadingTable())
        if (row.measure)
            QTest::addRow("%s", row.id) << static_cast<int>(row.measure->quantity);
}

void MeasuredColoursTest::anEditIsMeasuredWhereItReachesWithTheBitsOfAll() {
    QFETCH(int, quantity);
    const surface::Surface before = surfaceOf(test::torus(1, 0.4, 30000, test::seed()));
    const surface::Surface reference = surfaceOf(test::torus(1, 0.41, 30000, test::seed() + 1));
    const surface::Surface after(bumped(before.tree(), {1.4f, 0, 0}, 0.1f), before.definition());
    const auto what = static_cast<Quantity>(quantity);
    const ScalarField old = process::evaluateField({what, before, reference});
    const ScalarField all = process::evaluateField({what, after, reference});
    const ScalarField few = process::evaluateField({what, after, reference}, &old);
    QVERIFY(few.evaluatedBlocks() < all.evaluatedBlocks() / 2);
    std::size_t different = 0;
    after.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        const auto &a = *all.of(&block), &b = *few.of(&block);
        for (std::size_t i = 0; i < a.size(); ++i)
            QVERIFY(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])));
        different += few.of(&block) != old.of(&block) ? 1 : 0;
    });
    QCOMPARE(different, few.evaluatedBlocks());
}

static std::unique_ptr<OffscreenRenderer> osmesa() {
    try {
        return std::make_unique<OffscreenRenderer>(makeOsMesaContext());
    } catch (const base::Error&) {
        return nullptr;
    }
}

/// Colours for a row that measures; the surface is its own reference but for a shift.
static std::shared_ptr<const BlockColours> coloursFor(const ShadingRow& row, const surface::Surface& surface) {
    if (!row.measure)
        return nullptr;
    const FieldQuestion question{row.measure->quantity, surface, surface};
    const ScalarField field = process::evaluateField(question);
    return coloursOf(field, scaleFor(*row.measure, question, {}, &field));
}

static Camera camera320() {
    Camera out;
    out.eye = {1.5, 1, 2.5};
    out.width = 320, out.height = 240;
    return out;
}

void MeasuredColoursTest::anEditRedrawsAndUploadsItsBlocksAlone() {
    const surface::Surface before = surfaceOf(test::torus(1, 0.4, 30000, test::seed()));
    const surface::Surface after(bumped(before.tree(), {0, 0.4f, 1}, 0.1f), before.definition());
    const ColourScale scale{ColourMap::Diverging, -3, 3, ""};
    Coloured old{process::evaluateField({Quantity::MeanCurvature, before, {}}), scale, nullptr};
    old.colours = coloursOf(old.field, scale);
    const ScalarField field = process::evaluateField({Quantity::MeanCurvature, after, {}}, &old.field);
    RenderOptions options;
    options.shading = Shading::Curvature;
    options.colours = old.colours;
    CpuSplatter cpu;
    const Camera camera = camera320();
    Image image = test::drawn(cpu, before.tree(), camera, options);
    cpu.update(after.tree(), camera, options, image); // the numbers come later than the edit
    options.colours = coloursOf(field, scale, &old);
    cpu.update(after.tree(), camera, options, image);
    CpuSplatter fresh;
    QVERIFY(image.colour == test::drawn(fresh, after.tree(), camera, options).colour);
    const auto gl = osmesa();
    if (!gl)
        QSKIP("no OSMesa");
    options.colours = old.colours;
    test::drawn(*gl, before.tree(), camera, options);
    options.colours = coloursOf(field, scale, &old);
    const Image drawn = test::drawn(*gl, after.tree(), camera, options);
    QVERIFY(gl->splatter().storage().uploadedBytes() <= field.evaluatedBlocks() * slotBytes);
    QVERIFY(test::difference(image, drawn).mean < 0.5);
}

void MeasuredColoursTest::everyRowIsDrawnAlikeByEveryRenderer_data() {
    QTest::addColumn<int>("row");
    for (const ShadingRow& row : shadingTable())
        QTest::addRow("%s", row.id) << static_cast<int>(row.shading);
}

void MeasuredColoursTest::everyRowIsDrawnAlikeByEveryRenderer() {
    if (test::sanitized)
        QSKIP("minutes under a sanitizer");
    QFETCH(int, row);
    const auto shading = static_cast<Shading>(row);
    const surface::Surface surface = surfaceOf(test::sphere({0, 0, 0}, 1, 10000, true));
    RenderOptions options;
    options.shading = shading;
    options.colours = coloursFor(shadingRow(shading), surface);
    CpuSplatter cpu;
    const Image a = test::drawn(cpu, surface.tree(), camera320(), options);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < a.colour.size(); ++i)
        covered += std::isfinite(a.depth[i]) ? 1 : 0;
    QVERIFY(covered > a.colour.size() / 10);
    const auto gl = osmesa();
    if (!gl)
        QSKIP("no OSMesa");
    const test::Difference d = test::difference(a, test::drawn(*gl, surface.tree(), camera320(), options));
    QVERIFY2(d.mean < 1, qPrintable(QString::number(d.mean)));
}

void MeasuredColoursTest::raysAndSplatsShowTheSameNumbers() {
    const surface::Surface surface = surfaceOf(test::torus(1, 0.4, 20000, test::seed()));
    for (const ShadingRow& row : shadingTable()) {
        if (!row.measure)
            continue;
        PictureOptions options;
        options.style.shading = row.shading;
        options.reference = surfaceOf(test::torus(1, 0.38, 20000, test::seed() + 1));
        PictureStats splats, rays;
        Camera camera = camera320();
        camera.width = 160, camera.height = 120;
        const Image a = drawPicture(surface, camera, options, splats, {});
        options.rayCast = true;
        const Image b = drawPicture(surface, camera, options, rays, {});
        QVERIFY(splats.scale == rays.scale && splats.scale);
        const test::Difference d = test::difference(a, b);
        // What changes from one surfel to the next is smoother in splats.
        const bool rough = row.shading == Shading::OffCentre || row.shading == Shading::Spacing;
        QVERIFY2(d.mean < (rough ? 30 : 8), qPrintable(QString("%1: %2").arg(row.id).arg(d.mean)));
    }
}

static const test::Registered<MeasuredColoursTest> registered;
#include "measured_colours_test.moc"
