// The palette finds every action of the menus, and what is dropped is taken for what it is.
#include "support/patience.h"
#include "support/registry.h"
#include "ui/panels/header_bar.h"
#include "ui/panels/number_slider.h"
#include "ui/window/command_palette.h"
#include "ui/window/dropped.h"
#include "ui/window/keys_dialog.h"
#include "ui/window/other_words.h"
#include "ui/window/status_line.h"
#include "ui/window_fixture.h"

#include <QDir>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenuBar>
#include <QMimeData>
#include <QToolButton>
#include <QUrl>

using test::WindowFixture;

class CommandPaletteTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyActionOfEveryMenuIsFound();
    void theBestComesFirst();
    void otherProgramsWordsFindWhatIsMeant();
    void enterRunsWhatIsChosen();
    void keysAreChosenTakenAndKept();
    void droppedFilesAreWhatTheyAre();
    void droppedModelsOpenAndImagesArePressedIn();
    void theHeaderAndThePanelSayTheSame();
};

void CommandPaletteTest::everyActionOfEveryMenuIsFound() {
    WindowFixture f;
    const auto entries = ui::paletteEntries(*f.window->menuBar());
    for (const char* name :
         {"file", "new", "edit", "brush", "model", "view", "shading", "effects", "navigation", "help"})
        for (QAction* action : f.window->menu(name)->actions()) {
            if (action->isSeparator() || action->menu() || action->text().isEmpty())
                continue;
            const bool known = std::any_of(entries.begin(), entries.end(),
                                           [&](const ui::PaletteEntry& each) { return each.action == action; });
            QVERIFY2(known, qPrintable(action->text()));
        }
    for (const ui::PaletteEntry& each : entries) {
        QVERIFY2(ui::fitOf(each, each.label) > 1, qPrintable(each.label));
        QVERIFY2(ui::fitOf(each, each.way.section(' ', 0, 0) + ' ' + each.label.section(' ', 0, 0)) > 0,
                 qPrintable(each.label));
        QVERIFY(ui::fitOf(each, "qqqq") == 0);
    }
}

void CommandPaletteTest::theBestComesFirst() {
    WindowFixture f;
    ui::CommandPalette palette(*f.window->menuBar(), f.window.get());
    const std::size_t all = std::size_t(palette.shown().size());
    QVERIFY(all > 60);
    auto& typed = *palette.findChild<QLineEdit*>();
    for (const auto& [text, first] : {std::pair("resam", "Resample…"), std::pair("wax", "Red Wax"),
                                      std::pair("frame al", "Frame All"), std::pair("ZEBRA", "Zebra")}) {
        typed.setText(text);
        QVERIFY2(!palette.shown().isEmpty() && palette.shown().front() == first, text);
    }
    typed.setText("glass"); // in what the true surface says of itself
    QVERIFY(!palette.shown().isEmpty());
    typed.setText("no such thing");
    QVERIFY(palette.shown().isEmpty());
    QVERIFY(palette.findChild<QTreeWidget*>()->topLevelItem(0)->text(0).startsWith("Nothing is named so"));
}

void CommandPaletteTest::otherProgramsWordsFindWhatIsMeant() {
    WindowFixture f;
    const auto entries = ui::paletteEntries(*f.window->menuBar());
    for (const ui::OtherWords& row : ui::otherWordsTable())
        for (const QString& word : QString(row.words).split(' ')) {
            const bool found = std::ranges::any_of(entries, [&](const ui::PaletteEntry& each) {
                return QString(each.label).remove("…") == row.label && ui::fitOf(each, word) > 0;
            });
            QVERIFY2(found, qPrintable(QString("%1: %2").arg(row.label, word)));
        }
}

void CommandPaletteTest::enterRunsWhatIsChosen() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    auto* palette = new ui::CommandPalette(*f.window->menuBar(), f.window.get());
    palette->setAttribute(Qt::WA_DeleteOnClose);
    palette->open();
    auto& typed = *palette->findChild<QLineEdit*>();
    typed.setText("zebra");
    QTest::keyClick(&typed, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(f.window->settings().shading == render::Shading::Zebra, test::patience);
}

void CommandPaletteTest::keysAreChosenTakenAndKept() {
    WindowFixture f;
    QAction* frame = f.window->findChild<QAction*>("frame-all");
    QAction* undo = f.window->findChild<QAction*>("undo");
    {
        ui::KeysDialog dialog(*f.window->menuBar(), f.window->settings().keys);
        QVERIFY(dialog.choose("View > frame-all"));
        dialog.give(QKeySequence("Ctrl+Z")); // undo's
        QCOMPARE(frame->shortcut(), QKeySequence("Ctrl+Z"));
        QVERIFY(undo->shortcut().isEmpty());
        QVERIFY(!dialog.choose("no such action"));
    }
    f.window->close();
    f.open();
    frame = f.window->findChild<QAction*>("frame-all"), undo = f.window->findChild<QAction*>("undo");
    QCOMPARE(frame->shortcut(), QKeySequence("Ctrl+Z"));
    QVERIFY(undo->shortcut().isEmpty());
    ui::KeysDialog dialog(*f.window->menuBar(), f.window->settings().keys);
    dialog.reset();
    QVERIFY(f.window->settings().keys.empty());
    QCOMPARE(frame->shortcut(), QKeySequence("Home"));
    QCOMPARE(undo->shortcut(), QKeySequence("Ctrl+Z"));
}

void CommandPaletteTest::droppedFilesAreWhatTheyAre() {
    const QTemporaryDir folder;
    QVERIFY(ui::droppedAs(folder.path().toStdString()) == ui::Dropped::Folder);
    for (const char* name : {"a.ply", "b.XYZ", "c.obj"})
        QVERIFY2(ui::droppedAs(name) == ui::Dropped::Model, name);
    for (const char* name : {"a.png", "b.JPG", "c.jpeg"})
        QVERIFY2(ui::droppedAs(name) == ui::Dropped::Image, name);
    for (const char* name : {"a.doc", "b", ""})
        QVERIFY2(ui::droppedAs(name) == ui::Dropped::Other, name);
}

static void drop(ui::MainWindow& window, const QStringList& files) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files)
        urls << QUrl::fromLocalFile(file);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(200, 200), Qt::CopyAction, &data, Qt::LeftButton, {}); // finds who takes the drop
    QApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted() && !window.sculptView().overlay().notice.text.isEmpty());
    QDropEvent event(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &event);
}

void CommandPaletteTest::droppedModelsOpenAndImagesArePressedIn() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    f.editor().run({{"op", "save"}, {"path", f.file("a.ply").toStdString()}});
    QVERIFY(f.settle() && f.make("torus", 1000));
    std::vector<std::filesystem::path> others;
    f.window->openAnother = [&](const std::filesystem::path& path) { others.push_back(path); };
    drop(*f.window, {f.file("a.ply"), f.file("b.ply")});
    QVERIFY(f.settle());
    QVERIFY(f.window->windowTitle().startsWith("a.ply"));
    QVERIFY(others.size() == 1 && others.front().filename() == "b.ply");
    drop(*f.window, {f.file("stamp.png")});
    QCOMPARE(f.window->settings().choice(f.window->settings().toolRow()).stamp, f.file("stamp.png").toStdString());
    drop(*f.window, {f.file("letter.doc")});
    QVERIFY(f.window->statusLine().message().contains("letter.doc"));
}

void CommandPaletteTest::theHeaderAndThePanelSayTheSame() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    auto& header = *f.window->findChild<ui::HeaderBar*>();
    auto& radius = *header.findChild<ui::NumberSlider*>("header-radius");
    Q_EMIT radius.edited(123);
    QCOMPARE(f.window->settings().radiusPx, 123.0);
    f.window->sculptView().sizing().scaleRadius(2);
    QCOMPARE(radius.value(), 246.0);
    auto& symmetry = *header.findChild<QToolButton*>("header-symmetry");
    symmetry.menu()->actions().front()->trigger();
    QVERIFY(f.window->settings().shared.symmetry.planes.x && symmetry.text().contains('X'));
    auto& method = *header.findChild<QToolButton*>("header-method");
    const std::size_t last = sculpt::methodTable().size() - 1;
    method.menu()->actions()[qsizetype(last)]->trigger();
    QVERIFY(f.window->settings().choice(f.window->settings().toolRow()).method == sculpt::methodTable()[last].value);
    QCOMPARE(method.text(), QString(sculpt::methodTable()[last].label));
    header.findChild<QToolButton*>("header-invert")->click();
    QVERIFY(f.window->settings().choice(f.window->settings().toolRow()).invert);
}

static const test::Registered<CommandPaletteTest> registered;
#include "command_palette_test.moc"
