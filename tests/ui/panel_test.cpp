// The properties panel: one table of options, edited by slider, by typing and by hand; each tool keeps its own.
#include "support/patience.h"
#include "support/registry.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/number_slider.h"
#include "ui/panels/panel_group.h"
#include "ui/panels/properties_panel.h"
#include "ui/panels/stamp_field.h"
#include "ui/panels/tool_bar.h"
#include "window_fixture.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

using test::WindowFixture;

class PanelTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void panelEditsReachTheSettings();
    void numbersAreTypedAfterAClick();
    void panelShowsWhatHasASay();
    void panelFitsTheWindowWithoutScrolling();
    void panelGroupsStayAsTheyWereLeft();
    void toolsKeepTheirOwnOptions();
    void falloffIsDrawnByHand();
    void otherButtonsLeaveAHeldPointAlone();
    void stampsAreChosenShownAndCleared();
};

void PanelTest::panelEditsReachTheSettings() {
    WindowFixture f;
    int sliders = 0;
    for (auto* slider : f.window->panel().findChildren<ui::NumberSlider*>()) {
        const ui::Settings before = f.window->settings();
        auto* bar = slider->findChild<QSlider*>();
        bar->setValue(bar->value() < 500 ? 900 : 100);
        QVERIFY(!(f.window->settings() == before));
        ++sliders;
    }
    QVERIFY(sliders >= 3);
    for (auto* box : f.window->panel().findChildren<QCheckBox*>()) {
        const ui::Settings before = f.window->settings();
        box->click();
        QVERIFY(!(f.window->settings() == before));
        box->click();
        QVERIFY(f.window->settings() == before);
    }
}

void PanelTest::numbersAreTypedAfterAClick() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    f.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(f.window.get()));
    auto& slider = *f.window->panel().findChild<ui::NumberSlider*>("spacing");
    auto* bar = slider.findChild<QSlider*>();
    auto* box = slider.findChild<QDoubleSpinBox*>();
    const auto spacing = [&] { return f.window->settings().choice(f.window->settings().toolRow()).spacing; };
    const auto click = [&] {
        QTest::mouseClick(bar, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(box->isVisible() && box->hasFocus(), test::patience);
    };
    const ui::View view = f.window->sculptView().motion().view();
    const std::string tool = f.window->settings().tool;
    click();
    QTest::keyClicks(box, "0.37"); // 3 and 7 turn the view elsewhere
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(spacing(), 0.37f);
    QVERIFY(!box->isVisible() && bar->isVisible());
    click();
    QTest::keyClicks(box, "0.9");
    QTest::keyClick(box, Qt::Key_Escape);
    QCOMPARE(spacing(), 0.37f);
    QVERIFY(!box->isVisible());
    click();
    QTest::keyClicks(box, "3"); // farther than the bar goes, no farther than a stroke may
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(spacing(), 3.0f);
    QVERIFY(f.window->sculptView().motion().view() == view);
    QCOMPARE(f.window->settings().tool, tool);
}

void PanelTest::panelShowsWhatHasASay() {
    WindowFixture f;
    ui::PropertiesPanel& panel = f.window->panel();
    for (const char* id : {"brush", "falloff", "stroke", "symmetry", "area", "pressure", "stamp"})
        panel.findChild<ui::PanelGroup*>(QString("group-") + id)->setOpen(true);
    for (QAction* tool : f.window->toolBar().toolActions()) {
        tool->trigger();
        const auto& row = f.window->settings().toolRow();
        for (const auto& option : sculpt::strokeOptionTable()) {
            const auto shown = panel.findChildren<QWidget*>(option.id);
            if (option.scope == sculpt::Scope::Stroke) {
                QVERIFY(shown.isEmpty());
                continue;
            }
            QCOMPARE(shown.size(), 1);
            const bool applies = option.applies(row, f.window->settings().choice(row));
            QVERIFY2(shown.front()->isVisible() == applies, qPrintable(tool->text() + ": " + option.id));
            QVERIFY(shown.front()->toolTip().startsWith(option.tip));
        }
    }
}

void PanelTest::panelFitsTheWindowWithoutScrolling() {
    WindowFixture f;
    f.window->resize(1280, 800);
    for (QAction* tool : f.window->toolBar().toolActions()) {
        tool->trigger();
        QCoreApplication::processEvents();
        const int needed = f.window->panel().widget()->minimumSizeHint().height();
        QVERIFY2(needed <= f.window->panel().viewport()->height(), qPrintable(tool->text()));
        QVERIFY(f.window->panel().widget()->minimumSizeHint().width() <= f.window->panel().viewport()->width());
    }
}

void PanelTest::panelGroupsStayAsTheyWereLeft() {
    WindowFixture f;
    const auto group = [&](const char* id) {
        return f.window->panel().findChild<ui::PanelGroup*>(QString("group-") + id);
    };
    QVERIFY(group("stroke")->isOpen() && !group("pressure")->isOpen());
    group("stroke")->setOpen(false);
    group("pressure")->setOpen(true);
    f.window->close();
    f.open();
    QVERIFY(!group("stroke")->isOpen() && group("pressure")->isOpen() && group("brush")->isOpen());
}

void PanelTest::toolsKeepTheirOwnOptions() {
    WindowFixture f;
    const auto tools = f.window->toolBar().toolActions();
    const auto invert = [&] { return f.window->panel().findChild<QCheckBox*>("invert"); };
    tools[0]->trigger();
    invert()->click();
    QVERIFY(f.window->settings().choice(f.window->settings().toolRow()).invert);
    tools[1]->trigger();
    QVERIFY(!invert()->isChecked());
    tools[0]->trigger();
    QVERIFY(invert()->isChecked());
    for (auto* button : f.window->panel().findChildren<QToolButton*>())
        if (button->text() == "Reset")
            button->click();
    QVERIFY(!invert()->isChecked());
    QVERIFY(f.window->settings().tools.empty());
}

static void drag(QWidget& widget, QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton) {
    test::sendMouse(widget, QEvent::MouseMove, from, Qt::NoButton);
    test::sendMouse(widget, QEvent::MouseButtonPress, from, button);
    test::sendMouse(widget, QEvent::MouseMove, to, button);
    test::sendMouse(widget, QEvent::MouseButtonRelease, to, button);
}

void PanelTest::falloffIsDrawnByHand() {
    WindowFixture f;
    auto& curve = *f.window->panel().findChild<ui::CurveEditor*>("falloff-curve");
    const auto now = [&] { return f.window->settings().choice(f.window->settings().toolRow()); };
    QVERIFY(now().falloff == sculpt::Falloff::Smooth);
    // A touch makes the custom curve out of the one that is shown.
    drag(curve, curve.placeOf({0.5f, 0.9f}), curve.placeOf({0.5f, 0.95f}));
    QVERIFY(now().falloff == sculpt::Falloff::Custom);
    QCOMPARE(now().falloffCurve.size(), std::size_t(7));
    for (const auto& p : now().falloffCurve)
        if (p.x != 0.5f && std::abs(p.x - 0.5f) > 0.02f)
            QVERIFY(std::abs(p.y - sculpt::weight(sculpt::Falloff::Smooth, p.x)) < 1e-6f);
    // Dragged beyond its neighbours it stays between them.
    drag(curve, curve.placeOf({0.5f, 0.95f}), curve.placeOf({0.9f, 0.2f}));
    QCOMPARE(now().falloffCurve.size(), std::size_t(7));
    sculpt::BrushCurve checked(now().falloffCurve);
    // Removed by the right button and by throwing away, but never the last two.
    drag(curve, curve.placeOf(now().falloffCurve[1]), curve.placeOf(now().falloffCurve[1]), Qt::RightButton);
    QCOMPARE(now().falloffCurve.size(), std::size_t(6));
    drag(curve, curve.placeOf(now().falloffCurve[1]), {-200, -200});
    QCOMPARE(now().falloffCurve.size(), std::size_t(5));
    for (int k = 0; k < 9; ++k)
        drag(curve, curve.placeOf(now().falloffCurve[0]), curve.placeOf(now().falloffCurve[0]), Qt::RightButton);
    QCOMPARE(now().falloffCurve.size(), std::size_t(2));
    // No more points than a curve may have.
    for (int k = 0; k < 40; ++k)
        drag(curve, QPointF(curve.width() * (k + 0.5) / 40, 40), QPointF(curve.width() * (k + 0.5) / 40, 40));
    QVERIFY(now().falloffCurve.size() <= sculpt::BrushCurve::maxPoints);
    sculpt::check(ui::strokeSettings(f.window->settings(), f.window->settings().toolRow(), 1, false));
}

void PanelTest::otherButtonsLeaveAHeldPointAlone() {
    WindowFixture f;
    auto& curve = *f.window->panel().findChild<ui::CurveEditor*>("falloff-curve");
    curve.setShape({});
    curve.setPoints({{0, 1}, {0.5f, 0.5f}, {1, 0}});
    const QPointF last = curve.placeOf({1, 0});
    test::sendMouse(curve, QEvent::MouseButtonPress, last, Qt::LeftButton);
    test::sendMouse(curve, QEvent::MouseButtonPress, curve.placeOf({0.5f, 0.5f}), Qt::RightButton);
    test::sendMouse(curve, QEvent::MouseMove, last - QPointF(0, 20), Qt::LeftButton);
    test::sendMouse(curve, QEvent::MouseButtonRelease, last - QPointF(0, 20), Qt::LeftButton);
    QCOMPARE(curve.points().size(), std::size_t(3));
    QVERIFY(curve.points()[2].y > 0.05f && curve.points()[1].x == 0.5f);
    sculpt::BrushCurve checked(curve.points());
}

void PanelTest::stampsAreChosenShownAndCleared() {
    WindowFixture f;
    QImage image(20, 10, QImage::Format_Grayscale8);
    image.fill(200);
    QVERIFY(image.save(f.file("stamp.png")));
    auto& stamp = *f.window->panel().findChild<ui::StampField*>();
    const auto now = [&] { return f.window->settings().choice(f.window->settings().toolRow()).stamp; };
    stamp.choose(f.file("missing.png"));
    QVERIFY(now().empty());
    stamp.choose(f.file("stamp.png"));
    QCOMPARE(now(), f.file("stamp.png").toStdString());
    QVERIFY(!stamp.findChild<QLabel*>("stamp-picture")->pixmap().isNull());
    for (auto* button : stamp.findChildren<QToolButton*>())
        if (button->text() == "Clear")
            button->click();
    QVERIFY(now().empty());
    QVERIFY(stamp.findChild<QLabel*>("stamp-picture")->pixmap().isNull());
}

static const test::Registered<PanelTest> registered;
#include "panel_test.moc"
