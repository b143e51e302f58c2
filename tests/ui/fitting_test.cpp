// The window on small screens, and whether what it says can be read.
#include "support/patience.h"
#include "support/registry.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/header_bar.h"
#include "ui/panels/properties_panel.h"
#include "ui/panels/tool_bar.h"
#include "ui/panels/tool_grid.h"
#include "ui/settings/settings_file.h"
#include "ui/theme/theme.h"
#include "ui/window/command_desk.h"
#include "ui/window/command_dialog.h"
#include "ui/window/status_line.h"
#include "ui/window_fixture.h"

#include <algorithm>
#include <QAbstractItemView>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QScreen>
#include <QToolButton>

using test::WindowFixture;

class FittingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase() {
        m_palette = qApp->palette();
        ui::applyTheme(*qApp); // as people see it
    }
    void cleanupTestCase() {
        qApp->setStyleSheet({});
        qApp->setPalette(m_palette);
    }
    void everyToolIsThereInALowWindow();
    void toolsHaveRoomInEveryStyle();
    void everyMenuIsThereInANarrowWindow();
    void theWindowOpensOnItsScreen();
    void narrowStatusLinesKeepTheirMessage();
    void pullDownsAreLegible();
    void leftHandsHaveToolsOnTheRightFromThenOn();
    void dialogsStayOnTheScreen();
    void dialogsGrowWithWhatTheySay();
    void maximisedWindowsComeBackOnASmallerScreen();
    void cutHintsSayThatTheyAreCut();

  private:
    QPalette m_palette;
};

void FittingTest::everyToolIsThereInALowWindow() {
    WindowFixture f;
    // 1280 x 720 at scale 1, 1.5 and 2, less a panel of the desktop.
    for (const QSize size : {QSize(1280, 690), QSize(853, 450), QSize(640, 345)}) {
        f.window->resize(size);
        QCoreApplication::processEvents();
        QVERIFY2(f.window->size() == size,
                 qPrintable(QString("%1 x %2").arg(f.window->width()).arg(f.window->height())));
        QVERIFY(f.view().width() >= 160 && f.view().height() >= 120);
        const QRect all = f.window->rect();
        std::size_t seen = 0;
        for (const QToolButton* button : f.window->toolBar().findChild<ui::ToolGrid*>()->findChildren<QToolButton*>()) {
            const QRect place(button->mapTo(f.window.get(), QPoint(0, 0)), button->size());
            QVERIFY2(all.contains(place) && button->isVisible(), qPrintable(button->text()));
            QVERIFY(!button->visibleRegion().isEmpty() &&
                    button->visibleRegion().boundingRect().size() == place.size());
            ++seen;
        }
        QCOMPARE(seen, sculpt::toolTable().size());
        QVERIFY(all.contains(f.window->statusLine().geometry()) && f.window->statusLine().height() > 10);
    }
}

/// Buttons got their size before the bar's style was theirs: in a low window the last column was cut off.
void FittingTest::toolsHaveRoomInEveryStyle() {
    WindowFixture f;
    f.window->resize(960, 540);
    auto& grid = *f.window->toolBar().findChild<ui::ToolGrid*>();
    for (const int padding : {2, 5, 3, 7, 1}) {
        grid.setStyleSheet(QString("QToolButton { padding: %1px; }").arg(padding));
        for (int k = 0; k < 3; ++k) // a layout after another
            QCoreApplication::processEvents();
        QVERIFY(f.window->toolBar().rect().contains(grid.geometry()));
        for (const QToolButton* button : grid.findChildren<QToolButton*>())
            QVERIFY2(grid.rect().contains(button->geometry()),
                     qPrintable(QString("%1, padding %2").arg(button->text()).arg(padding)));
    }
}

/// 1280 x 720 at scale 2 had neither View nor Help, nor two of the pop-overs above the picture.
void FittingTest::everyMenuIsThereInANarrowWindow() {
    WindowFixture f;
    for (const int width : {640, 800, 1280, 640}) {
        f.window->resize(width, 345);
        QCoreApplication::processEvents();
        const QMenuBar& menus = *f.window->menuBar();
        const QWidget& corner = *menus.cornerWidget();
        int right = 0;
        for (QAction* action : menus.actions()) {
            right = std::max(right, menus.actionGeometry(action).right());
            QVERIFY2(menus.rect().contains(menus.actionGeometry(action)), qPrintable(action->text()));
        }
        QVERIFY(corner.isHidden() ? width < 800 : right < corner.x());
        const auto& header = *f.window->findChild<ui::HeaderBar*>();
        for (const char* name : {"header-symmetry", "header-method", "header-pop-over"})
            for (const QToolButton* button : header.findChildren<QToolButton*>(name))
                QVERIFY2(button->isVisible() && header.rect().contains(button->geometry()),
                         qPrintable(QString("%1 at %2").arg(button->text()).arg(width)));
    }
}

void FittingTest::theWindowOpensOnItsScreen() {
    const QTemporaryDir folder;
    ui::WindowOptions options;
    options.settingsFile = folder.filePath("settings.ini");
    options.editor.journal = folder.filePath("journal.jsonl").toStdString();
    const ui::MainWindow window(options);
    const QSize room = window.screen()->availableSize();
    QVERIFY(window.width() <= room.width() && window.height() <= room.height());
}

void FittingTest::narrowStatusLinesKeepTheirMessage() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    f.drag(f.centre(), f.centre() + QPointF(40, 0));
    for (const int width : {1400, 1000, 700}) {
        f.window->resize(width, 600);
        f.window->tell("a word to the person");
        QCoreApplication::processEvents();
        QCOMPARE(f.window->statusLine().message(), QString("A word to the person."));
        const auto labels = f.window->statusLine().findChildren<QLabel*>("cell");
        const auto legible = [](const QLabel* label) {
            return !label->isVisible() || label->width() >= label->sizeHint().width();
        };
        // Pictures go on telling their time, and a new text has its room at the next layout.
        QTRY_VERIFY_WITH_TIMEOUT(std::all_of(labels.begin(), labels.end(), legible), test::patience);
        const auto cells = std::count_if(labels.begin(), labels.end(), [](const QLabel* l) { return l->isVisible(); });
        QVERIFY(cells >= 1 && (width < 1000 || cells >= 3));
    }
}

static double luminance(QRgb c) {
    const auto linear = [](int byte) {
        const double v = byte / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(c)) + 0.7152 * linear(qGreen(c)) + 0.0722 * linear(qBlue(c));
}

/// Of the lightest and the darkest pixel, as readers of small print are promised 4.5.
static double contrast(const QImage& picture) {
    double low = 1, high = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const double now = luminance(picture.pixel(x, y));
            low = std::min(low, now), high = std::max(high, now);
        }
    return (high + 0.05) / (low + 0.05);
}

void FittingTest::pullDownsAreLegible() {
    WindowFixture f;
    QComboBox list(f.window.get());
    list.addItems({"Marching cubes", "Delaunay", "Another"});
    list.setGeometry(10, 10, 200, 24);
    list.show();
    list.showPopup();
    QCoreApplication::processEvents();
    QAbstractItemView& view = *list.view();
    for (int row = 0; row < list.count(); ++row) {
        view.setCurrentIndex(list.model()->index(row, 0));
        QCoreApplication::processEvents();
        const QRect place = view.visualRect(list.model()->index(row, 0)).adjusted(6, 2, -40, -2);
        const QImage picture = view.viewport()->grab(place).toImage();
        QVERIFY2(contrast(picture) > 4.5, qPrintable(QString("%1: %2").arg(row).arg(contrast(picture))));
    }
    list.hidePopup();
}

void FittingTest::leftHandsHaveToolsOnTheRightFromThenOn() {
    WindowFixture f;
    const auto sides = [&] {
        const QPoint middle = f.view().mapTo(f.window.get(), f.view().rect().center());
        const auto sideOf = [&](const QWidget& each) { return each.geometry().center().x() > middle.x(); };
        return std::pair(sideOf(f.window->toolBar()), sideOf(*f.window->findChild<QDockWidget*>("properties")));
    };
    QTRY_VERIFY_WITH_TIMEOUT((sides() == std::pair(false, true)), test::patience);
    f.action("view", "Left-handed")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT((sides() == std::pair(true, false)), test::patience);
    QVERIFY(f.window->toolBar().isVisible() && !f.window->findChild<QDockWidget*>("history")->isVisible());
    f.window->close();
    f.open();
    QTRY_VERIFY_WITH_TIMEOUT((sides() == std::pair(true, false)), test::patience);
    f.action("view", "Left-handed")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT((sides() == std::pair(false, true)), test::patience);
}

void FittingTest::dialogsStayOnTheScreen() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 800));
    f.window->resize(700, 500);
    auto& desk = *f.window->findChild<ui::CommandDesk*>();
    for (const char* op : {"surface", "transform", "select", "outliers"}) {
        desk.open(session::command(op));
        const QRect screen = f.window->screen()->availableGeometry();
        QVERIFY2(screen.contains(desk.dialog()->geometry()), op);
        desk.dialog()->reject();
    }
}

/// A preview has told of 23 loops in a box made for one line, over the fields above it.
void FittingTest::dialogsGrowWithWhatTheySay() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 800));
    auto& desk = *f.window->findChild<ui::CommandDesk*>();
    desk.open(session::command("fill"));
    ui::CommandDialog& dialog = *desk.dialog();
    QCoreApplication::processEvents();
    QStringList said;
    for (int k = 0; k < 22; ++k)
        said
            << QString("boundary loop %1 of length 61.42 about 1202.8 -382.9 224.0 was left: it does not close").arg(k);
    dialog.sayPreviewed((said << "5 of 27 boundary loops filled with 22987 points").join('\n'));
    QCoreApplication::processEvents();
    const auto labels = dialog.findChildren<QLabel*>(Qt::FindDirectChildrenOnly);
    for (const QLabel* one : labels) {
        if (!one->isVisible())
            continue;
        QVERIFY2(one->height() >= one->heightForWidth(one->width()), qPrintable(one->text()));
        for (const QLabel* other : labels)
            QVERIFY(one == other || !other->isVisible() || !one->geometry().intersects(other->geometry()));
    }
    const auto& shown = *dialog.findChild<QLabel*>("previewed");
    QVERIFY(shown.text().contains("… and 19 more.") && shown.text().endsWith("filled with 22987 points."));
    QVERIFY(shown.toolTip().contains("loop 17 of"));
    QVERIFY(f.window->screen()->availableGeometry().contains(dialog.geometry()));
    dialog.reject();
}

void FittingTest::maximisedWindowsComeBackOnASmallerScreen() {
    WindowFixture f;
    f.window->resize(1600, 1200);
    QCoreApplication::processEvents();
    ui::Settings left = f.window->settings();
    left.windowState = f.window->saveState();
    f.window->setWindowState(Qt::WindowMaximized);
    left.geometry = f.window->saveGeometry();
    f.window->close();
    ui::SettingsFile file(f.file("settings.ini"));
    file.write(left);
    f.open();
    f.window->statusLine().showProgress(0.5, "reading"); // its layout is asked for anew
    QCoreApplication::processEvents();
    f.window->statusLine().hideProgress();
    QVERIFY(f.window->toolBar().isVisible() && f.view().isVisible());
}

void FittingTest::cutHintsSayThatTheyAreCut() {
    ui::ElidedLabel label("Drag: Draw, with Ctrl the other way, with Shift Smooth");
    label.resize(label.fontMetrics().horizontalAdvance(label.text()) + 8, 20);
    QCOMPARE(label.shownText(), label.text());
    label.resize(label.width() / 2, 20);
    QVERIFY(label.shownText().endsWith("…") && label.text().startsWith(label.shownText().chopped(1)));
}

static const test::Registered<FittingTest> registered;
#include "fitting_test.moc"
