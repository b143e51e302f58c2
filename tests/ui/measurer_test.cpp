#include "ui/work/measurer.h"

#include "render/render_models.h"
#include "support/patience.h"
#include "support/registry.h"
#include "ui/window_fixture.h"

using namespace ui;

class MeasurerTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void colouredInTheBackgroundAndByTheLastWish();
    void anEditIsMeasuredNearByAndKeepsTheScale();
    void whatIsCancelledOrUnmeasuredHasNoColours();
    void everyShadingThatMeasuresIsMeasuredInTheWindow();
};

static surface::Surface torus() {
    return {test::built(test::torus(1, 0.4, 20000, test::seed())), {}};
}

static bool settled(Measurer& measurer) {
    return QTest::qWaitFor([&] { return !measurer.busy(); }, test::patience);
}

static std::size_t known(const Measurer& measurer, const tree::SurfelTree& tree) {
    std::size_t out = 0;
    tree.forEachBlock(
        [&](std::uint32_t, const surfel::SurfelBlock& block) { out += measurer.colours()->of(&block) ? 1 : 0; });
    return out;
}

void MeasurerTest::colouredInTheBackgroundAndByTheLastWish() {
    Measurer measurer;
    const surface::Surface model = torus();
    measurer.want(render::Shading::Spacing, {}, model, {}, 1);
    measurer.want(render::Shading::Curvature, {}, model, {}, 1);
    QVERIFY(measurer.busy() && measurer.colours() && !measurer.scale());
    QVERIFY(settled(measurer));
    QCOMPARE(known(measurer, model.tree()), std::size_t(model.tree().blockCount()));
    QVERIFY(measurer.scale()->low == -measurer.scale()->high);
}

void MeasurerTest::anEditIsMeasuredNearByAndKeepsTheScale() {
    Measurer measurer;
    const surface::Surface model = torus();
    measurer.want(render::Shading::Deviation, {}, model, model, 1);
    QVERIFY(settled(measurer));
    measurer.want(render::Shading::Curvature, {}, model, {}, 1);
    QVERIFY(settled(measurer));
    const auto before = measurer.colours();
    const auto scale = measurer.scale();
    tree::Edit edit;
    auto changed = model.tree().block(3)->clone();
    changed->setPosition(0, changed->position(0) + changed->normal(0) * 0.001f);
    changed->seal();
    edit.blocks.push_back({3, changed, {}});
    const surface::Surface after(model.tree().apply(edit), model.definition());
    measurer.want(render::Shading::Curvature, {}, after, {}, 1);
    QCOMPARE(measurer.colours(), before); // what is known stays in the picture meanwhile
    QVERIFY(settled(measurer));
    QVERIFY(measurer.scale() == scale);
    std::size_t kept = 0;
    after.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        kept += before->of(&block) && before->of(&block) == measurer.colours()->of(&block) ? 1 : 0;
    });
    QVERIFY(kept > after.tree().blockCount() / 2 && kept < after.tree().blockCount());
}

void MeasurerTest::whatIsCancelledOrUnmeasuredHasNoColours() {
    Measurer measurer;
    const surface::Surface model = torus();
    measurer.want(render::Shading::Curvature, {}, model, {}, 1);
    measurer.cancel();
    QVERIFY(settled(measurer));
    measurer.want(render::Shading::Matcap, {}, model, {}, 1);
    QVERIFY(!measurer.colours() && !measurer.scale());
}

void MeasurerTest::everyShadingThatMeasuresIsMeasuredInTheWindow() {
    test::WindowFixture f;
    QVERIFY(f.make("torus", 5000));
    for (QAction* action : f.window->menu("shading")->actions()) {
        if (action->isSeparator())
            continue;
        action->trigger();
        QVERIFY(settled(f.window->measurer()));
        const bool measured = render::shadingRow(f.window->settings().shading).measure.has_value();
        QCOMPARE(bool(f.window->measurer().colours()), measured);
        if (measured)
            QVERIFY(known(f.window->measurer(), f.editor().snapshot().surface.tree()) > 0);
    }
}

static const test::Registered<MeasurerTest> registered;
#include "measurer_test.moc"
