// Lost work is shown before it is brought back, and what is on its way has its name from the first moment.
#include "core/session/recover.h"
#include "support/patience.h"
#include "support/registry.h"
#include "ui/window/recovery_dialog.h"
#include "ui/window/status_line.h"
#include "ui/window_fixture.h"

#include <QLabel>
#include <QPushButton>

using test::WindowFixture;

class RecoveryDialogTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void picturesShowWhatComesBack();
    void unreadableJournalsSayWhy();
    void closingStopsTheReplay();
    void titlesNameWhatIsBeingOpened();
};

/// A journal of two strokes, left by a window that ended without a word.
static session::LeftJournal left(WindowFixture& f) {
    f.make("torus", 3000);
    f.drag(f.centre() + QPointF(120, 0), f.centre() + QPointF(120, 60));
    f.drag(f.centre() + QPointF(-120, 0), f.centre() + QPointF(-120, 60));
    f.window.reset();
    const auto all = session::findLeftJournals(f.folder.path().toStdString());
    return all.empty() ? session::LeftJournal{} : all.front();
}

void RecoveryDialogTest::picturesShowWhatComesBack() {
    WindowFixture f;
    const session::LeftJournal journal = left(f);
    QCOMPARE(journal.commands, 2);
    ui::RecoveryDialog dialog(journal);
    QTRY_VERIFY_WITH_TIMEOUT(!dialog.picture().isNull(), test::patience);
    // The model stands in its middle, the background at its rim.
    const QImage picture = dialog.picture();
    QSet<QRgb> colours;
    for (int x = 0; x < picture.width(); ++x)
        colours.insert(picture.pixel(x, picture.height() / 2));
    QVERIFY2(colours.size() > 30, qPrintable(QString::number(colours.size())));
    QVERIFY(dialog.findChild<QLabel*>("recovered-steps")->text().contains("2 × Draw"));
    QVERIFY(std::filesystem::exists(journal.path)); // looking changes nothing
    bool told = false;
    f.open();
    f.editor().recover(journal.path, [&](bool done, const session::Recovery& found) {
        told = done && found.steps == std::vector<std::pair<std::string, int>>{{"Draw", 2}};
    });
    QVERIFY(f.settle() && told);
}

void RecoveryDialogTest::unreadableJournalsSayWhy() {
    WindowFixture f;
    session::LeftJournal journal = left(f);
    std::filesystem::remove(journal.path);
    ui::RecoveryDialog dialog(journal);
    QTRY_VERIFY_WITH_TIMEOUT(!dialog.findChild<QLabel*>("recovered-steps")->text().isEmpty(), test::patience);
    QVERIFY(dialog.picture().isNull());
    dialog.findChild<QPushButton*>("discard")->click();
    QCOMPARE(dialog.result(), int(ui::RecoveryDialog::Discard));
}

void RecoveryDialogTest::closingStopsTheReplay() {
    WindowFixture f;
    const session::LeftJournal journal = left(f);
    for (int k = 0; k < 5; ++k)
        ui::RecoveryDialog(journal).reject(); // ends at once, whatever runs
}

void RecoveryDialogTest::titlesNameWhatIsBeingOpened() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 20000));
    f.editor().run({{"op", "save"}, {"path", f.file("a head.ply").toStdString()}});
    QVERIFY(f.settle());
    f.open();
    QVERIFY(f.window->windowTitle().startsWith("Untitled"));
    f.window->files().open(std::filesystem::path(f.file("a head.ply").toStdString()));
    QVERIFY(f.window->windowTitle().startsWith("Opening a head.ply"));
    QVERIFY(f.window->sculptView().overlay().notice.text.startsWith("Opening a head.ply"));
    QVERIFY(f.settle());
    QVERIFY(f.window->windowTitle().startsWith("a head.ply"));
    QVERIFY(f.window->sculptView().overlay().notice.text.isEmpty());
    // What cannot be opened leaves nothing behind either.
    f.window->files().open(std::filesystem::path(f.file("none.ply").toStdString()));
    QVERIFY(f.settle());
    QVERIFY(f.window->windowTitle().startsWith("a head.ply"));
    QVERIFY(f.window->sculptView().overlay().notice.text.isEmpty());
}

static const test::Registered<RecoveryDialogTest> registered;
#include "recovery_dialog_test.moc"
