// Every entry of every menu, on no model and on one with a selection, with dialogs taken as they come up and with
// dialogs turned down: nothing breaks the model or the window, and nothing happens in silence.
#include "support/patience.h"
#include "support/registry.h"
#include "ui/theme/theme.h"
#include "ui/window/command_palette.h"
#include "ui/window/status_line.h"
#include "ui/window_fixture.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>

using test::WindowFixture;

class EveryActionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void cleanup() { ui::applyTheme(*qApp); } // entries that change the look change it for the whole process
    void everyEntryLeavesAWindowThatWorks_data();
    void everyEntryLeavesAWindowThatWorks();
    void everyCommandTellsWhatItDidOrWhyNot_data();
    void everyCommandTellsWhatItDidOrWhyNot();
};

namespace {

/// A small one: what is drawn after each of hundreds of entries costs as much as it has pixels.
struct SmallWindow : WindowFixture {
    SmallWindow() { window->resize(500, 400); }
};

/// Answers dialogs of this process: those of files and colours are turned down, others as wished.
class Answers {
  public:
    explicit Answers(bool yes) {
        QObject::connect(&m_timer, &QTimer::timeout, [this, yes] {
            if (QWidget* popup = QApplication::activePopupWidget())
                popup->close();
            for (QWidget* each : QApplication::topLevelWidgets()) {
                auto* dialog = qobject_cast<QDialog*>(each);
                if (!dialog || !dialog->isVisible())
                    continue;
                const bool file = dialog->inherits("QFileDialog") || dialog->inherits("QColorDialog");
                auto* box = dialog->findChild<QDialogButtonBox*>();
                QPushButton* ok = box && !file ? box->button(QDialogButtonBox::Ok) : nullptr;
                // Later: the timer is deaf to boxes that come up while it is being heard.
                if (yes && ok && m_asked != dialog)
                    QMetaObject::invokeMethod(ok, &QPushButton::click, Qt::QueuedConnection);
                else // has none, or does not take what stands there
                    QMetaObject::invokeMethod(dialog, &QDialog::reject, Qt::QueuedConnection);
                m_refusals += yes && ok && m_asked == dialog ? 1 : 0;
                m_asked = dialog;
            }
        });
        m_timer.start(10);
    }

    /// Of dialogs that stayed open instead of doing what they were asked for, which tell why.
    int refusals() const { return m_refusals; }

  private:
    QTimer m_timer;
    QPointer<QDialog> m_asked; ///< once; twice it is turned down
    int m_refusals = 0;
};

/// What would end the test, or make samples of their full size.
bool spared(const ui::PaletteEntry& entry) {
    return !entry.action || entry.action->objectName() == "quit" || entry.label == "Close" ||
           entry.way.startsWith("File > New");
}

/// A ball of which a part is selected.
void makeModel(WindowFixture& f) {
    QVERIFY(f.make("sphere", 900));
    f.editor().run({{"op", "select"}, {"by", "ball"}, {"at", {0, 0, 1}}, {"radius", 0.7}});
    QVERIFY(f.settle());
}

void settle(WindowFixture& f) {
    if (!QTest::qWaitFor([&] { return !f.editor().busy(); }, 5000)) {
        f.editor().cancelWork();
        QVERIFY(f.settle());
    }
}

} // namespace

void EveryActionTest::everyEntryLeavesAWindowThatWorks_data() {
    QTest::addColumn<bool>("model");
    QTest::addColumn<bool>("yes");
    QTest::addRow("without a model") << false << true;
    QTest::addRow("on a model, turned down") << true << false;
    QTest::addRow("on a model") << true << true;
}

void EveryActionTest::everyEntryLeavesAWindowThatWorks() {
    QFETCH(bool, model);
    QFETCH(bool, yes);
    SmallWindow f;
    const Answers answers(yes);
    if (model)
        makeModel(f);
    const auto entries = ui::paletteEntries(*f.window->menuBar());
    QVERIFY(entries.size() > 100);
    for (const ui::PaletteEntry& entry : entries) {
        if (spared(entry))
            continue;
        entry.action->trigger();
        QTest::qWait(15);
        settle(f);
        f.window->escape();
        f.window->escape();
        const tree::SurfelTree& tree = f.editor().snapshot().surface.tree();
        if (model && tree.size() < 100) // taken out by the command
            makeModel(f);
        try {
            tree.validate();
        } catch (const std::exception& error) {
            QFAIL(qPrintable(QString("%1 > %2: %3").arg(entry.way, entry.label, error.what())));
        }
    }
    QTRY_VERIFY_WITH_TIMEOUT(!QApplication::activeModalWidget(), test::patience);
    f.window->settings() = {};       // the tool chosen last may want a source first, and brushes have become any size
    QVERIFY(f.make("sphere", 2000)); // and it still works
    f.window->escape();
    f.window->sculptView().motion().frameAll();
    QTest::qWait(50);
    f.drag(f.centre() - QPointF(30, 0), f.centre() + QPointF(30, 0));
    QTRY_VERIFY_WITH_TIMEOUT(f.editor().snapshot().canUndo, test::patience);
}

void EveryActionTest::everyCommandTellsWhatItDidOrWhyNot_data() {
    QTest::addColumn<QString>("menu");
    QTest::addColumn<bool>("model");
    for (const char* menu : {"model", "select"})
        for (const bool model : {false, true})
            QTest::addRow("%s %s a model", menu, model ? "with" : "without") << QString(menu) << model;
}

void EveryActionTest::everyCommandTellsWhatItDidOrWhyNot() {
    QFETCH(QString, menu);
    QFETCH(bool, model);
    SmallWindow f;
    const Answers answers(true);
    const QString way = f.window->menu(menu)->title().remove('&');
    for (const ui::PaletteEntry& entry : ui::paletteEntries(*f.window->menuBar())) {
        QAction* action = entry.action;
        if (!entry.way.startsWith(way) || action->isCheckable() || action->data().toString().startsWith("trim-"))
            continue;
        if (model)
            makeModel(f);
        QTest::qWait(5);
        QSignalSpy changed(&f.editor(), &ui::Editor::changed), told(&f.editor(), &ui::Editor::told),
            failed(&f.editor(), &ui::Editor::failed);
        const QString before = f.window->statusLine().message();
        const int refused = answers.refusals();
        action->trigger();
        const auto answered = [&] {
            return changed.count() + told.count() + failed.count() > 0 || answers.refusals() > refused ||
                   f.window->statusLine().message() != before;
        };
        (void)QTest::qWaitFor([&] { return answered() || f.editor().busy(); }, test::patience);
        settle(f);
        QVERIFY2(QTest::qWaitFor(answered, test::patience),
                 qPrintable(action->text() + ": nothing was done, nothing was said"));
    }
}

static const test::Registered<EveryActionTest> registered;
#include "every_action_test.moc"
