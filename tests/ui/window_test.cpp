// The main window on any platform: what it offers comes from the tables, what the hand does reaches the model.
#include "core/process/samples.h"
#include "core/session/journal.h"
#include "core/session/session_file.h"
#include "support/registry.h"
#include "ui/command_dialog.h"
#include "ui/curve_editor.h"
#include "ui/icon.h"
#include "ui/number_slider.h"
#include "ui/panel_group.h"
#include "ui/properties_panel.h"
#include "ui/stamp_field.h"
#include "ui/status_line.h"
#include "ui/tool_bar.h"
#include "window_fixture.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QSlider>
#include <QToolButton>

using test::WindowFixture;

class WindowTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void toolButtonsAreTheToolTable();
    void newMenuIsTheSampleTable();
    void modelMenuIsTheCommandTable();
    void everyActionHasItsOwnShortcut();
    void shortcutsChooseTools();
    void everySampleOpensAndIsSeen();
    void numberedViewsTurnAndFrameShowsAll();
    void everyShadingDrawsAnotherPicture();
    void titleTellsTheFileAndWhetherItIsSaved();
    void closingAsksAboutUnsavedWork();
    void modelArgumentsMayNameSamples();
    void unreadableFilesLeaveTheModelAndSayWhy();
    void imagesAreExported();
    void figuresInTheStatusLineAreRight();
    void settingsOutliveTheWindow();
    void panelEditsReachTheSettings();
    void numbersAreTypedAfterAClick();
    void panelShowsWhatHasASay();
    void panelFitsTheWindowWithoutScrolling();
    void panelGroupsStayAsTheyWereLeft();
    void toolsKeepTheirOwnOptions();
    void falloffIsDrawnByHand();
    void stampsAreChosenShownAndCleared();
};

void WindowTest::toolButtonsAreTheToolTable() {
    WindowFixture f;
    const auto rows = sculpt::toolTable();
    const auto actions = f.window->toolBar().toolActions();
    QCOMPARE(std::size_t(actions.size()), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const QAction& action = *actions[qsizetype(i)];
        QCOMPARE(action.text(), QString(rows[i].label));
        QCOMPARE(action.shortcut(), QKeySequence(rows[i].shortcut));
        QVERIFY(action.toolTip().contains(rows[i].tip));
        QVERIFY2(!action.icon().isNull(), rows[i].icon);
        const auto buttons = f.window->toolBar().findChildren<QToolButton*>();
        QVERIFY(std::any_of(buttons.begin(), buttons.end(),
                            [&](const QToolButton* b) { return b->defaultAction() == &action; }));
        actions[qsizetype(i)]->trigger();
        QCOMPARE(f.window->settings().tool, std::string(rows[i].id));
        QVERIFY(action.isChecked());
        const auto editors = f.window->panel().findChildren<QWidget*>("tool-parameter");
        const std::size_t expected = sculpt::hasSource(rows[i]) ? 0 : rows[i].parameters.size();
        QCOMPARE(std::size_t(editors.size()), expected);
    }
}

void WindowTest::newMenuIsTheSampleTable() {
    WindowFixture f;
    const auto rows = process::sampleTable();
    const auto actions = f.window->menu("new")->actions();
    QCOMPARE(std::size_t(actions.size()), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        QCOMPARE(actions[qsizetype(i)]->data().toString(), QString(rows[i].id));
        QCOMPARE(actions[qsizetype(i)]->text(), QString(rows[i].label));
    }
    actions.front()->trigger();
    QVERIFY(f.settle());
    QVERIFY(f.surfels() > rows.front().count / 2 && f.surfels() < rows.front().count * 2);
}

void WindowTest::modelMenuIsTheCommandTable() {
    WindowFixture f;
    QStringList offered, expected;
    for (const QAction* action : f.window->menu("model")->actions())
        offered << action->data().toString();
    for (const auto& row : session::commandTable())
        if (ui::hasDialog(row)) {
            expected << row.op;
            ui::CommandDialog dialog(row);
            for (const auto& p : row.parameters)
                QVERIFY2(dialog.findChild<QWidget*>(p.id) || std::string_view(p.type) == "list", p.id);
        }
    QCOMPARE(offered, expected);
    QVERIFY(expected.contains("resample"));
    QVERIFY(!expected.contains("stroke") && !expected.contains("open"));
}

void WindowTest::everyActionHasItsOwnShortcut() {
    WindowFixture f;
    QMap<QString, QString> seen;
    for (const QAction* action : f.window->findChildren<QAction*>()) {
        const QString keys = action->shortcut().toString();
        if (keys.isEmpty())
            continue;
        QVERIFY2(!seen.contains(keys), qPrintable(keys + ": " + action->text() + ", " + seen.value(keys)));
        seen[keys] = action->text();
    }
    QVERIFY(!seen.contains("F")); // held, it changes the radius
    for (const char* keys : {"Ctrl+Z", "Ctrl+Shift+Z", "1", "3", "7", "Ctrl+1", "Ctrl+3", "Ctrl+7", "[", "]", "Home"})
        QVERIFY2(seen.contains(keys), keys);
}

void WindowTest::shortcutsChooseTools() {
    WindowFixture f;
    f.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(f.window.get()));
    f.view().setFocus();
    for (const auto& row : sculpt::toolTable()) {
        const QKeySequence keys(row.shortcut);
        if (keys.isEmpty())
            continue;
        QTest::keySequence(&f.view(), keys);
        QCOMPARE(f.window->settings().tool, std::string(row.id));
    }
}

/// Share of the picture that is not background.
static double filled(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        const QRgb ground = picture.pixel(0, y);
        for (int x = 0; x < picture.width(); ++x)
            count += picture.pixel(x, y) != ground ? 1 : 0;
    }
    return double(count) / (double(picture.width()) * picture.height());
}

static bool waitForPicture(WindowFixture& f) {
    f.window->controller().refresh();
    // A frame that is asked for after this one cannot be older than it.
    bool painted = false;
    auto shown = f.window->viewport().framePainted;
    f.window->viewport().framePainted = [&](double seconds) {
        painted = true;
        if (shown)
            shown(seconds);
    };
    const bool first = QTest::qWaitFor([&] { return painted; }, 60000);
    painted = false;
    f.window->controller().refresh();
    const bool second = first && QTest::qWaitFor([&] { return painted; }, 60000);
    f.window->viewport().framePainted = shown;
    return second;
}

void WindowTest::everySampleOpensAndIsSeen() {
    WindowFixture f;
    for (const auto& row : process::sampleTable()) {
        QVERIFY2(f.make(row.id, 5000), row.id);
        QVERIFY(waitForPicture(f));
        const double share = filled(f.window->viewport().picture());
        QVERIFY2(share > 0.04 && share < 0.9, qPrintable(QString("%1 fills %2").arg(row.id).arg(share)));
    }
}

void WindowTest::numberedViewsTurnAndFrameShowsAll() {
    WindowFixture f;
    QVERIFY(f.make("torus", 3000));
    for (const auto& row : render::namedViews()) {
        f.action("view", row.label)->trigger();
        const render::Camera camera = f.window->controller().camera();
        QVERIFY(base::length(camera.forward() + row.toEye) < 1e-12);
        QVERIFY(base::length(camera.upright() - row.up) < 1e-12);
    }
    const auto framed = [&] {
        f.action("view", "Frame All")->trigger();
        return f.window->controller().view().distance;
    };
    const double before = framed();
    f.drag(f.centre(), f.centre() + QPointF(300, 100), {}, Qt::MiddleButton);
    QVERIFY(base::length(f.window->controller().view().target) > 0.1);
    QCOMPARE(framed(), before);
}

void WindowTest::everyShadingDrawsAnotherPicture() {
    WindowFixture f;
    QVERIFY(f.make("knot", 5000));
    std::vector<QImage> pictures;
    std::size_t row = 0;
    for (QAction* action : f.window->menu("shading")->actions()) {
        if (action->isSeparator())
            continue;
        QCOMPARE(action->text(), QString(render::shadingTable()[row].label));
        action->trigger();
        QVERIFY(f.window->settings().shading == render::shadingTable()[row].shading);
        QVERIFY(waitForPicture(f));
        pictures.push_back(f.window->viewport().picture());
        QVERIFY(filled(pictures.back()) > 0.02);
        ++row;
    }
    QCOMPARE(row, render::shadingTable().size());
    QVERIFY(pictures[0] != pictures[1]);
}

void WindowTest::titleTellsTheFileAndWhetherItIsSaved() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    QVERIFY(f.window->windowTitle().startsWith("Untitled"));
    QVERIFY(!f.window->isWindowModified());
    f.drag(f.centre(), f.centre() + QPointF(40, 0));
    QVERIFY(f.window->isWindowModified());

    const base::Hash128 hash = f.hash();
    f.editor().run({{"op", "save"}, {"path", f.file("saved model.ply").toStdString()}});
    QVERIFY(f.settle());
    QVERIFY(!f.window->isWindowModified());
    QVERIFY(f.window->windowTitle().startsWith("saved model.ply"));
    QVERIFY(f.make("torus", 1000));
    f.window->files().open(std::filesystem::path(f.file("saved model.ply").toStdString()));
    QVERIFY(f.settle());
    QVERIFY(f.hash() == hash);
    QCOMPARE(f.window->settings().recentFiles.front(), f.file("saved model.ply").toStdString());
    QCOMPARE(f.window->menu("recent")->actions().front()->text(), QString("saved model.ply"));
}

/// Answers the next question on the screen.
static void answer(QMessageBox::StandardButton button) {
    QTRY_VERIFY(QApplication::activeModalWidget() != nullptr);
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    QVERIFY(box);
    QVERIFY(box->button(button));
    box->button(button)->click();
}

void WindowTest::closingAsksAboutUnsavedWork() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    f.drag(f.centre(), f.centre() + QPointF(40, 0));
    f.window->close();
    answer(QMessageBox::Cancel);
    QVERIFY(f.window->isVisible());
    f.window->close();
    answer(QMessageBox::Discard);
    QVERIFY(!f.window->isVisible());
    QVERIFY(std::filesystem::exists(f.journal()));
    f.window.reset();
    QVERIFY(!std::filesystem::exists(f.journal())); // nothing to recover from a proper end
    f.open();
    f.window->close();
    QVERIFY(!f.window->isVisible()); // nothing to lose, nothing to ask
}

void WindowTest::modelArgumentsMayNameSamples() {
    WindowFixture f;
    f.window->files().openArgument("sample:torus:3000");
    QVERIFY(f.settle());
    QCOMPARE(f.surfels(), std::size_t(3000));
    const base::Hash128 torus = f.hash();
    f.window->files().openArgument("sample:teapot");
    QVERIFY(f.settle());
    QVERIFY(f.hash() == torus);
    const auto boxes = f.window->findChildren<QMessageBox*>();
    QCOMPARE(boxes.size(), 1);
    QVERIFY(boxes.front()->informativeText().contains("torus") || boxes.front()->text().contains("torus"));
}

void WindowTest::unreadableFilesLeaveTheModelAndSayWhy() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    const base::Hash128 hash = f.hash();
    QFile bad(f.file("bad.ply"));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write("ply\nformat ascii 1.0\nelement vertex 5\n");
    bad.close();
    f.window->files().open(std::filesystem::path(bad.fileName().toStdString()));
    QVERIFY(f.settle());
    QTRY_VERIFY(QApplication::activeModalWidget() != nullptr);
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    QVERIFY(box && box->text().contains("bad.ply"));
    box->button(QMessageBox::Ok)->click();
    QVERIFY(f.window->statusLine().message().contains("bad.ply"));
    QVERIFY(f.hash() == hash);
    QVERIFY(f.window->settings().recentFiles.empty());
}

void WindowTest::imagesAreExported() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    f.window->files().writeImage(f.file("picture.png").toStdString());
    QVERIFY(f.settle());
    const QImage picture(f.file("picture.png"));
    QCOMPARE(picture.size(), f.view().size() * f.view().devicePixelRatioF());
    QVERIFY(filled(picture) > 0.1);
}

void WindowTest::figuresInTheStatusLineAreRight() {
    QCOMPARE(ui::bytesText(0), QString("0 B"));
    QCOMPARE(ui::bytesText(999), QString("999 B"));
    QCOMPARE(ui::bytesText(1234), QString("1.23 kB"));
    QCOMPARE(ui::bytesText(999999), QString("1.00 MB"));
    QCOMPARE(ui::bytesText(45600000), QString("45.6 MB"));

    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    const auto surfels = static_cast<double>(f.surfels());
    const double radius = f.editor().snapshot().surface.tree().bounds().diagonal() / 2 / std::sqrt(3.0);
    const double cell = 4 * M_PI * radius * radius / surfels; // of a hexagonal layout: s^2 sqrt(3) / 2
    const double expected = std::sqrt(cell * 2 / std::sqrt(3.0));
    QVERIFY(std::abs(double(f.editor().snapshot().spacing) / expected - 1) < 0.15);
    QCOMPARE(f.editor().snapshot().modelBytes, f.editor().snapshot().surface.tree().bytes());
    QString shown;
    for (const QLabel* label : f.window->statusLine().findChildren<QLabel*>())
        shown += label->text() + "\n";
    QVERIFY(shown.contains(QLocale::c().toString(qulonglong(f.surfels())) + " surfels"));
}

void WindowTest::settingsOutliveTheWindow() {
    WindowFixture f;
    f.window->toolBar().toolActions().back()->trigger();
    f.window->controller().scaleRadius(1.5);
    f.window->close();
    const ui::Settings before = f.window->settings();
    f.open();
    ui::Settings after = f.window->settings();
    QVERIFY(after == before);
    QCOMPARE(after.tool, std::string(sculpt::toolTable().back().id));
    QCOMPARE(after.radiusPx, 75.0);
}

void WindowTest::panelEditsReachTheSettings() {
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

void WindowTest::numbersAreTypedAfterAClick() {
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
        QTRY_VERIFY(box->isVisible() && box->hasFocus());
    };
    const ui::View view = f.window->controller().view();
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
    QVERIFY(f.window->controller().view() == view);
    QCOMPARE(f.window->settings().tool, tool);
}

void WindowTest::panelShowsWhatHasASay() {
    WindowFixture f;
    ui::PropertiesPanel& panel = f.window->panel();
    for (const char* id : {"brush", "falloff", "stroke", "symmetry", "area", "pressure", "stamp"})
        panel.findChild<ui::PanelGroup*>(QString("group-") + id)->setOpen(true);
    for (QAction* tool : f.window->toolBar().toolActions()) {
        tool->trigger();
        const auto& row = f.window->settings().toolRow();
        for (const auto& option : sculpt::strokeOptionTable()) {
            const auto shown = panel.findChildren<QWidget*>(option.id);
            QCOMPARE(shown.size(), 1);
            const bool applies = option.applies(row, f.window->settings().choice(row));
            QVERIFY2(shown.front()->isVisible() == applies, qPrintable(tool->text() + ": " + option.id));
            QCOMPARE(shown.front()->toolTip(), QString(option.tip));
        }
    }
}

void WindowTest::panelFitsTheWindowWithoutScrolling() {
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

void WindowTest::panelGroupsStayAsTheyWereLeft() {
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

void WindowTest::toolsKeepTheirOwnOptions() {
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

void WindowTest::falloffIsDrawnByHand() {
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

void WindowTest::stampsAreChosenShownAndCleared() {
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

static const test::Registered<WindowTest> registered;
#include "window_test.moc"
