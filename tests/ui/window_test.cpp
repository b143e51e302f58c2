// The main window on any platform: what it offers comes from the tables, what the hand does reaches the model.
#include "core/process/samples/samples.h"
#include "core/session/journal.h"
#include "support/patience.h"
#include "support/registry.h"
#include "ui/panels/number_slider.h"
#include "ui/panels/properties_panel.h"
#include "ui/panels/tool_bar.h"
#include "ui/theme/icon.h"
#include "ui/window/command_dialog.h"
#include "ui/window/command_palette.h"
#include "ui/window/menus/model_groups.h"
#include "ui/window/status_line.h"
#include "window_fixture.h"

#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolButton>

using test::WindowFixture;

class WindowTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void toolButtonsAreTheToolTable();
    void newMenuIsTheSampleTable();
    void modelMenuIsTheCommandTable();
    void noMenuIsLongerThanAScreen();
    void everyActionHasItsOwnShortcut();
    void shortcutsChooseTools();
    void everySampleOpensAndIsSeen();
    void numberedViewsTurnAndFrameShowsAll();
    void everyShadingDrawsAnotherPicture();
    void coloursAreShownOfModelsThatHaveThem();
    void titleTellsTheFileAndWhetherItIsSaved();
    void closingAsksAboutUnsavedWork();
    void modelArgumentsMayNameSamples();
    void unreadableFilesLeaveTheModelAndSayWhy();
    void imagesAreExported();
    void figuresInTheStatusLineAreRight();
    void settingsOutliveTheWindow();
    void settingsOutliveACrash();
};

void WindowTest::toolButtonsAreTheToolTable() {
    WindowFixture f;
    const auto rows = sculpt::toolTable();
    const auto actions = f.window->toolBar().toolActions();
    QCOMPARE(std::size_t(actions.size()), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const QAction& action = *actions[qsizetype(i)];
        QCOMPARE(QString(action.text()).remove('&'), QString(rows[i].label));
        QCOMPARE(QKeySequence::listToString(action.shortcuts()), QString(rows[i].shortcut));
        QVERIFY(action.toolTip().contains(rows[i].tip));
        QVERIFY2(!action.icon().isNull(), rows[i].icon);
        const auto buttons = f.window->toolBar().findChildren<QToolButton*>();
        QVERIFY(std::any_of(buttons.begin(), buttons.end(),
                            [&](const QToolButton* b) { return b->defaultAction() == &action; }));
        actions[qsizetype(i)]->trigger();
        QCOMPARE(f.window->settings().tool, std::string(rows[i].id));
        QVERIFY(action.isChecked());
        const auto editors = f.window->panel().findChildren<QWidget*>("tool-parameter");
        const auto& parameters = rows[i].parameters;
        QCOMPARE(editors.size(),
                 std::count_if(parameters.begin(), parameters.end(), [](const auto& p) { return !p.chosenOnModel(); }));
    }
}

void WindowTest::newMenuIsTheSampleTable() {
    WindowFixture f;
    const auto rows = process::sampleTable();
    const auto actions = f.window->menu("new")->actions();
    QCOMPARE(std::size_t(actions.size()), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        QCOMPARE(actions[qsizetype(i)]->data().toString(), QString(rows[i].id));
        QCOMPARE(actions[qsizetype(i)]->text().remove('&'), QString(rows[i].label));
    }
    actions.front()->trigger();
    QVERIFY(f.settle());
    QVERIFY(f.surfels() > rows.front().count / 2 && f.surfels() < rows.front().count * 2);
}

void WindowTest::modelMenuIsTheCommandTable() {
    WindowFixture f;
    QStringList offered, expected;
    for (const ui::PaletteEntry& each : ui::paletteEntries(*f.window->menuBar()))
        if (each.way.startsWith("Model") && !each.action->data().toString().startsWith("trim-")) // drawn, not written
            offered << each.action->data().toString();
    for (const auto& row : session::commandTable())
        if (ui::hasDialog(row)) {
            expected << row.op;
            ui::CommandDialog dialog(row, f.editor().snapshot());
            for (const auto& p : row.parameters)
                QVERIFY2(p.recorded != (dialog.findChild<QWidget*>(p.id) != nullptr), p.id);
        }
    offered.sort(), expected.sort();
    QCOMPARE(offered, expected);
    QVERIFY(expected.contains("resample"));
    QVERIFY(!expected.contains("stroke") && !expected.contains("open"));
}

void WindowTest::noMenuIsLongerThanAScreen() {
    WindowFixture f;
    for (const QMenu* menu : f.window->menuBar()->findChildren<QMenu*>())
        QVERIFY2(menu->sizeHint().height() <= 720, qPrintable(menu->title()));
    for (const char* known : {"outliers", "fill", "solid", "drill", "transform", "register"})
        QVERIFY2(&ui::groupOf(known) != &ui::modelGroups().back(), known);
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
        for (const QKeySequence& keys : QKeySequence::listFromString(row.shortcut)) {
            if (keys.isEmpty())
                continue;
            f.window->settings().tool.clear();
            QTest::keySequence(&f.view(), keys);
            QCOMPARE(f.window->settings().tool, std::string(row.id));
        }
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
    f.window->sculptView().refresh();
    // A frame that is asked for after this one cannot be older than it.
    bool painted = false;
    auto shown = f.window->viewport().framePainted;
    f.window->viewport().framePainted = [&](double seconds) {
        painted = true;
        if (shown)
            shown(seconds);
    };
    const bool first = QTest::qWaitFor([&] { return painted; }, test::patience);
    painted = false;
    f.window->sculptView().refresh();
    const bool second = first && QTest::qWaitFor([&] { return painted; }, test::patience);
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
        const render::Camera camera = f.window->sculptView().motion().camera();
        QVERIFY(base::length(camera.forward() + row.toEye) < 1e-12);
        QVERIFY(base::length(camera.upright() - row.up) < 1e-12);
    }
    const auto framed = [&] {
        f.action("view", "Frame All")->trigger();
        return f.window->sculptView().motion().view().distance;
    };
    const double before = framed();
    f.drag(f.centre(), f.centre() + QPointF(300, 100), {}, Qt::MiddleButton);
    QVERIFY(base::length(f.window->sculptView().motion().view().target) > 0.1);
    QCOMPARE(framed(), before);
}

void WindowTest::everyShadingDrawsAnotherPicture() {
    WindowFixture f;
    QVERIFY(f.make("knot", 5000));
    std::vector<QImage> pictures;
    std::size_t row = 0;
    for (QAction* action : f.window->menu("shading")->actions()) {
        if (action->isSeparator() || action->menu())
            continue;
        QVERIFY(row < render::shadingTable().size());
        QCOMPARE(action->text().remove('&'), QString(render::shadingTable()[row].label));
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

void WindowTest::coloursAreShownOfModelsThatHaveThem() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    QVERIFY(f.window->settings().shading == render::Shading::Matcap);
    {
        QFile file(f.file("coloured.txt"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("# x y z red green blue\n");
        for (int i = 0; i < 400; ++i)
            file.write(QString("%1 %2 0 %3 9 9\n").arg(i % 20).arg(i / 20).arg(i % 200).toUtf8());
    }
    f.window->files().open(std::filesystem::path(f.file("coloured.txt").toStdString()));
    QVERIFY(f.settle());
    QCOMPARE(f.surfels(), std::size_t(400));
    QVERIFY(f.window->settings().shading == render::Shading::Colour);
    QVERIFY(f.make("torus", 1000));
    QVERIFY(f.window->settings().shading == render::Shading::Matcap);
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
    QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() != nullptr, test::patience);
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
    QTRY_VERIFY_WITH_TIMEOUT(!std::filesystem::exists(f.journal()),
                             test::patience); // at once: other windows may go on for long, and crash
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
    QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() != nullptr, test::patience);
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
    f.window->images().write(f.file("picture.png").toStdString());
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
    const auto thousands = f.surfels() / 1000, rest = f.surfels() % 1000;
    QVERIFY(shown.contains(QString("%1,%2 surfels").arg(thousands).arg(rest, 3, 10, QChar('0'))));
}

void WindowTest::settingsOutliveTheWindow() {
    WindowFixture f;
    f.window->toolBar().toolActions().back()->trigger();
    f.window->sculptView().sizing().scaleRadius(1.5);
    f.window->close();
    const ui::Settings before = f.window->settings();
    f.open();
    ui::Settings after = f.window->settings();
    QVERIFY(after == before);
    QCOMPARE(after.tool, std::string(sculpt::toolTable().back().id));
    QCOMPARE(after.radiusPx, 75.0);
}

void WindowTest::settingsOutliveACrash() {
    WindowFixture f;
    f.window->toolBar().toolActions().back()->trigger();
    f.window->sculptView().sizing().scaleRadius(1.5);
    const auto onDisk = [&] { return ui::SettingsFile(f.file("settings.ini")).read(); };
    QTRY_COMPARE_WITH_TIMEOUT(onDisk().radiusPx, 75.0, test::patience);
    QCOMPARE(onDisk().tool, std::string(sculpt::toolTable().back().id));
}

static const test::Registered<WindowTest> registered;
#include "window_test.moc"
