// Copies, versions, opening with a say in it, and the pictures of what was open lately.
#include "support/patience.h"
#include "support/registry.h"
#include "ui/window/command_dialog.h"
#include "ui/window/thumbnails.h"
#include "ui/window_fixture.h"

#include <fstream>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>

using test::WindowFixture;

class SavingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aCopyChangesNothing();
    void versionsNeverWriteOverEachOther();
    void openWithTakesWhatTheCommandTakes();
    void recentFilesHavePicturesUntilOthersChangeThem();
};

namespace fs = std::filesystem;

static fs::path pathOf(WindowFixture& f, const char* name) {
    return f.file(name).toStdString();
}

void SavingTest::aCopyChangesNothing() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1500));
    f.window->files().open(pathOf(f, "none.ply")); // there is nothing to lose, and nothing there
    f.editor().run({{"op", "save"}, {"path", pathOf(f, "own.ply").string()}});
    f.editor().run({{"op", "mask"}, {"do", "invert"}});
    QVERIFY(f.settle());
    const base::Hash128 before = f.hash();
    f.window->files().saveCopy(pathOf(f, "copy.ply"));
    QVERIFY(f.settle() && fs::exists(pathOf(f, "copy.ply")));
    QVERIFY(f.editor().snapshot().path == pathOf(f, "own.ply") && f.editor().snapshot().modified);
    QVERIFY(f.hash() == before && f.editor().snapshot().canUndo);
    f.editor().run({{"op", "open"}, {"path", pathOf(f, "copy.ply").string()}});
    QVERIFY(f.settle());
    QVERIFY(f.hash() == before);
}

void SavingTest::versionsNeverWriteOverEachOther() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 900));
    f.editor().run({{"op", "save"}, {"path", pathOf(f, "bust.ply").string()}});
    QVERIFY(f.settle());
    std::ofstream(pathOf(f, "bust_003.ply")) << "somebody's";
    for (const char* name : {"bust_002.ply", "bust_004.ply", "bust_005.ply"}) {
        f.window->files().saveVersion();
        QVERIFY(f.settle());
        QCOMPARE(f.editor().snapshot().path.filename().string(), std::string(name));
        QVERIFY(fs::file_size(pathOf(f, name)) > 1000);
    }
    QCOMPARE(fs::file_size(pathOf(f, "bust_003.ply")), std::uintmax_t(10));
    QCOMPARE(ui::nextVersion("a/b_1.ply").string(), std::string("a/b_1_002.ply")); // a name, no number
    QCOMPARE(ui::nextVersion("a/b_999.ply").string(), std::string("a/b_1000.ply"));
}

void SavingTest::openWithTakesWhatTheCommandTakes() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1200));
    f.editor().run({{"op", "save"}, {"path", pathOf(f, "a.ply").string()}});
    QVERIFY(f.settle() && f.make("torus", 800));
    f.editor().run({{"op", "save"}, {"path", pathOf(f, "b.ply").string()}});
    QVERIFY(f.settle());
    f.window->files().openWith();
    auto* dialog = f.window->findChild<ui::CommandDialog*>();
    QVERIFY(dialog);
    dialog->findChild<QLineEdit*>("path")->setText(f.file("a.ply"));
    dialog->findChild<QLineEdit*>("neighbours")->setText("24");
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    QVERIFY(f.settle());
    QCOMPARE(f.surfels(), std::size_t(1200));
    QCOMPARE(f.window->settings().recentFiles.front(), pathOf(f, "a.ply").string());
}

void SavingTest::recentFilesHavePicturesUntilOthersChangeThem() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1200));
    f.editor().run({{"op", "save"}, {"path", pathOf(f, "a.ply").string()}});
    QVERIFY(f.settle());
    QVERIFY(f.window->thumbnails().of(pathOf(f, "a.ply").string()).isNull());
    f.window->files().open(pathOf(f, "a.ply"));
    QVERIFY(f.settle());
    QTRY_VERIFY_WITH_TIMEOUT(!f.window->thumbnails().of(pathOf(f, "a.ply").string()).isNull(), test::patience);
    const QImage picture =
        f.window->thumbnails().of(pathOf(f, "a.ply").string()).pixmap(ui::Thumbnails::size).toImage();
    QVERIFY(picture.size() == ui::Thumbnails::size);
    QVERIFY(picture.pixelColor(picture.rect().center()) != picture.pixelColor(0, 0)); // the ball
    fs::last_write_time(pathOf(f, "a.ply"), fs::file_time_type::clock::now() + std::chrono::seconds(5));
    QVERIFY(f.window->thumbnails().of(pathOf(f, "a.ply").string()).isNull());
}

static const test::Registered<SavingTest> registered;
#include "saving_test.moc"
