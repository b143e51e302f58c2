// The bar of layers: it shows the document's list, and its controls are commands.
#include "ui/panels/layer_bar.h"

#include "support/patience.h"
#include "support/registry.h"
#include "ui/panels/number_slider.h"
#include "ui/window_fixture.h"

#include <QComboBox>
#include <QToolButton>

using test::WindowFixture;

class LayerBarTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void controlsAreCommands();
    void aSliderThatMovesAsksOnceWhenItRests();
    void aStrengthIsThatOfTheLayerItWasMovedFor();
    void theListFollowsUndo();
};

namespace {

void click(WindowFixture& f, const char* name) {
    auto* button = f.window->findChild<QToolButton*>(QString("layer-") + name);
    QVERIFY(button && button->isEnabled());
    button->click();
    QVERIFY(f.settle());
}

const layers::Stack& stackOf(WindowFixture& f) {
    return f.editor().snapshot().layers;
}

} // namespace

void LayerBarTest::controlsAreCommands() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    QVERIFY(!f.window->findChild<QToolButton*>("layer-merge")->isEnabled());
    click(f, "add");
    click(f, "add");
    QCOMPARE(stackOf(f).layers.size(), std::size_t(2));
    QCOMPARE(stackOf(f).target(), 1);
    click(f, "down");
    QCOMPARE(stackOf(f).target(), 0);
    click(f, "show");
    QVERIFY(!stackOf(f).layers[0].visible && stackOf(f).layers[1].visible);
    click(f, "up");
    QCOMPARE(stackOf(f).target(), 1);
    auto& list = *f.window->findChild<QComboBox*>("layer-list");
    QCOMPARE(list.count(), 3);
    list.setCurrentIndex(1); // the lower one, which is below it in the list, too
    Q_EMIT list.activated(1);
    QVERIFY(f.settle());
    QCOMPARE(stackOf(f).target(), 0);
    click(f, "merge");
    QCOMPARE(stackOf(f).layers.size(), std::size_t(1));
    list.setCurrentIndex(0);
    Q_EMIT list.activated(0);
    QVERIFY(f.settle());
    click(f, "remove");
    QVERIFY(stackOf(f).empty());
}

void LayerBarTest::aSliderThatMovesAsksOnceWhenItRests() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    click(f, "add");
    auto& slider = *f.window->findChild<ui::NumberSlider*>("layer-strength");
    for (const double value : {0.9, 0.6, 0.25}) {
        slider.setValue(value);
        Q_EMIT slider.edited(value);
    }
    QTRY_COMPARE_WITH_TIMEOUT(stackOf(f).layers.front().strength, 0.25f, test::patience);
    QVERIFY(f.settle());
    f.window->undo();
    QVERIFY(f.settle());
    QCOMPARE(stackOf(f).layers.front().strength, 1.0f);
    QCOMPARE(slider.value(), 1.0);
}

/// Another layer becomes the active one before the slider rests.
void LayerBarTest::aStrengthIsThatOfTheLayerItWasMovedFor() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    click(f, "add");
    click(f, "add");
    auto& slider = *f.window->findChild<ui::NumberSlider*>("layer-strength");
    slider.setValue(0.25);
    Q_EMIT slider.edited(0.25);
    auto& list = *f.window->findChild<QComboBox*>("layer-list");
    list.setCurrentIndex(1);
    Q_EMIT list.activated(1);
    QTRY_COMPARE_WITH_TIMEOUT(stackOf(f).layers[1].strength, 0.25f, test::patience);
    QVERIFY(f.settle());
    QCOMPARE(stackOf(f).target(), 0);
    QCOMPARE(stackOf(f).layers[0].strength, 1.0f);
    QCOMPARE(slider.value(), 1.0);
}

void LayerBarTest::theListFollowsUndo() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    click(f, "add");
    auto& list = *f.window->findChild<QComboBox*>("layer-list");
    QCOMPARE(list.count(), 2);
    f.window->undo();
    QVERIFY(f.settle());
    QCOMPARE(list.count(), 1);
    QVERIFY(!f.window->findChild<QToolButton*>("layer-remove")->isEnabled());
}

static const test::Registered<LayerBarTest> registered;
#include "layer_bar_test.moc"
