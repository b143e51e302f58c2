// A monkey at the window: random events, with a printed seed, that no person would send. What it must not do is crash,
// break the model, or leave a window that no longer works. POINTCLAY_MONKEY: how many events; its moments are not those
// of a replay, so it runs by hand.
#include "core/base/random.h"
#include "core/session/recover.h"
#include "support/registry.h"
#include "window_fixture.h"

#include <map>
#include <QAbstractButton>
#include <QAction>
#include <QDialog>
#include <QTimer>
#include <QWheelEvent>

using test::WindowFixture;

class MonkeyTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aWindowSurvivesRandomEvents();
};

namespace {

class Monkey {
  public:
    explicit Monkey(std::uint64_t seed) : m_random(seed) {
        qputenv("XDG_STATE_HOME", m_fixture.folder.path().toUtf8()); // what it recovers is its own
        QObject::connect(&m_impatience, &QTimer::timeout, [this] { answerBoxes(); });
        m_impatience.start(20); // boxes that wait for an answer run loops of their own
        begin();
    }
    ~Monkey() { m_impatience.stop(); }

    /// Does one thing; returns what, for the message of a failure.
    QString act() {
        struct Deed {
            const char* name;
            unsigned weight;
            void (Monkey::*act)();
        };
        static constexpr Deed deeds[] = {
            {"move", 40, &Monkey::move},      {"press", 12, &Monkey::press},  {"release", 12, &Monkey::release},
            {"wheel", 4, &Monkey::wheel},     {"key", 12, &Monkey::key},      {"action", 8, &Monkey::action},
            {"widget", 6, &Monkey::widget},   {"undo", 3, &Monkey::undo},     {"cancel", 3, &Monkey::cancel},
            {"size", 1, &Monkey::size},       {"save", 1, &Monkey::save},     {"open", 1, &Monkey::openSaved},
            {"command", 1, &Monkey::command}, {"close", 1, &Monkey::close},   {"crash", 1, &Monkey::crash},
            {"events", 8, &Monkey::events},   {"settle", 2, &Monkey::settle},
        };
        unsigned sum = 0;
        for (const Deed& deed : deeds)
            sum += deed.weight;
        std::size_t left = m_random.below(sum);
        for (const Deed& deed : deeds) {
            if (left < deed.weight) {
                (this->*deed.act)();
                return deed.name;
            }
            left -= deed.weight;
        }
        return {};
    }
    WindowFixture& fixture() { return m_fixture; }
    void settle() { m_fixture.settle(); }
    void begin() {
        m_fixture.make("sphere", 800);
        m_held = Qt::NoButton;
    }

  private:
    QPointF somewhere() {
        const QRectF all(m_fixture.view().rect());
        if (m_random.below(3) != 0) // where the model is
            return m_fixture.centre() + QPointF(m_random.uniform(-150, 150), m_random.uniform(-150, 150));
        return {m_random.uniform(-50, all.width() + 50), m_random.uniform(-50, all.height() + 50)};
    }
    Qt::KeyboardModifiers modifiers() {
        Qt::KeyboardModifiers out;
        for (const auto each : {Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier})
            if (m_random.below(6) == 0)
                out |= each;
        return out;
    }
    void move() { test::sendMouse(m_fixture.view(), QEvent::MouseMove, somewhere(), m_held, modifiers()); }
    void press() {
        static constexpr Qt::MouseButton buttons[] = {Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton,
                                                      Qt::RightButton};
        m_held = buttons[m_random.below(std::size(buttons))];
        const auto type = m_random.below(8) == 0 ? QEvent::MouseButtonDblClick : QEvent::MouseButtonPress;
        test::sendMouse(m_fixture.view(), type, somewhere(), m_held, modifiers());
    }
    void release() {
        test::sendMouse(m_fixture.view(), QEvent::MouseButtonRelease, somewhere(),
                        m_held == Qt::NoButton ? Qt::LeftButton : m_held, modifiers());
        m_held = Qt::NoButton;
    }
    void wheel() {
        const QPointF at = somewhere();
        QWheelEvent event(at, m_fixture.view().mapToGlobal(at), {}, {0, m_random.below(2) == 0 ? 120 : -120},
                          Qt::NoButton, modifiers(), Qt::NoScrollPhase, false);
        QApplication::sendEvent(&m_fixture.view(), &event);
    }
    void key() {
        static constexpr int keys[] = {
            Qt::Key_Escape, Qt::Key_F,     Qt::Key_F,  Qt::Key_BracketLeft, Qt::Key_BracketRight,
            Qt::Key_Tab,    Qt::Key_Space, Qt::Key_U,  Qt::Key_W,           Qt::Key_X,
            Qt::Key_Delete, Qt::Key_Left,  Qt::Key_F6, Qt::Key_Return,      Qt::Key_1};
        const int which = m_random.below(2) == 0 ? keys[m_random.below(std::size(keys))]
                                                 : Qt::Key_A + static_cast<int>(m_random.below(26));
        QWidget* focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : &m_fixture.view(), static_cast<Qt::Key>(which), modifiers());
    }
    /// Any entry of any menu and any button of the bars, but for samples of their full size.
    void action() {
        const auto all = m_fixture.window->findChildren<QAction*>();
        QAction* chosen = all[static_cast<qsizetype>(m_random.below(static_cast<std::size_t>(all.size())))];
        QObject* const menu = chosen->parent();
        if (chosen->isEnabled() && !chosen->menu() && !(menu && menu->objectName() == "new") &&
            !chosen->text().contains("Close"))
            chosen->trigger();
    }
    void widget() {
        const auto all = m_fixture.window->findChildren<QWidget*>();
        QPointer<QWidget> chosen = all[static_cast<qsizetype>(m_random.below(static_cast<std::size_t>(all.size())))];
        if (!chosen->isVisible() || !chosen->isEnabled() || qobject_cast<QMenu*>(chosen) ||
            chosen->inherits("QMenuBar"))
            return;
        const QPoint at(static_cast<int>(m_random.below(static_cast<std::size_t>(std::max(1, chosen->width())))),
                        static_cast<int>(m_random.below(static_cast<std::size_t>(std::max(1, chosen->height())))));
        QTest::mousePress(chosen, Qt::LeftButton, {}, at);
        if (chosen)
            QTest::mouseMove(chosen, at + QPoint(7, 0));
        if (chosen)
            QTest::mouseRelease(chosen, Qt::LeftButton, {}, at + QPoint(7, 0));
    }
    void undo() { m_random.below(3) == 0 ? m_fixture.window->redo() : m_fixture.window->undo(); }
    void cancel() { m_fixture.window->escape(); }
    void size() {
        m_fixture.window->resize(static_cast<int>(400 + m_random.below(900)),
                                 static_cast<int>(300 + m_random.below(600)));
    }
    void save() { m_fixture.editor().run({{"op", "save"}, {"path", m_fixture.file("saved.ply").toStdString()}}); }
    void openSaved() { m_fixture.editor().run({{"op", "open"}, {"path", m_fixture.file("saved.ply").toStdString()}}); }
    void command() {
        m_fixture.editor().run({{"op", "resample"}, {"spacing", m_random.uniform(0.05, 0.2)}});
        if (m_random.below(2) == 0)
            m_fixture.editor().cancelWork();
    }
    /// By the person, with whatever answer the impatience gives.
    void close() {
        m_fixture.window->close();
        QTest::qWait(60);
        if (m_fixture.window->isVisible())
            return;
        m_fixture.open();
        begin();
    }
    /// As by kill -9: the journal stays, and the next window recovers it.
    void crash() {
        m_fixture.window.reset();
        const std::filesystem::path left = m_fixture.file("journal-left.jsonl").toStdString();
        std::error_code none;
        std::filesystem::rename(m_fixture.journal(), left, none);
        m_fixture.open();
        m_held = Qt::NoButton;
        if (none)
            return begin();
        m_fixture.editor().recover(left);
        m_fixture.settle();
        if (m_fixture.surfels() == 0)
            begin();
    }
    void events() { QTest::qWait(static_cast<int>(m_random.below(20))); }

    void answerBoxes() {
        if (QWidget* popup = QApplication::activePopupWidget())
            popup->close();
        auto* box = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!box)
            return;
        const auto buttons = box->findChildren<QAbstractButton*>();
        if (box->inherits("QFileDialog") || box->inherits("QColorDialog") || buttons.isEmpty() ||
            m_random.below(4) == 0)
            return box->reject();
        // Not from here: a timer does not fire for boxes that open while it is being heard.
        QMetaObject::invokeMethod(
            buttons[static_cast<qsizetype>(m_random.below(static_cast<std::size_t>(buttons.size())))],
            &QAbstractButton::click, Qt::QueuedConnection);
    }

    base::Random m_random;
    WindowFixture m_fixture;
    QTimer m_impatience;
    Qt::MouseButton m_held = Qt::NoButton;
};

} // namespace

void MonkeyTest::aWindowSurvivesRandomEvents() {
    bool given = false;
    const int wanted = qEnvironmentVariableIntValue("POINTCLAY_MONKEY", &given);
    if (!given)
        QSKIP("runs by hand: tests/run monkey");
    const int events = wanted;
    qInfo("%d events, seed %llu", events, test::seed());
    Monkey monkey(test::seed());
    QString last;
    std::map<QString, int> counts;
    try {
        for (int k = 0; k < events; ++k) {
            last = monkey.act();
            ++counts[last];
            if (k % 50 == 0) {
                monkey.settle();
                last += " and settling";
                monkey.fixture().editor().snapshot().surface.tree().validate();
            }
        }
    } catch (const std::exception& error) {
        QFAIL(qPrintable(QString("%1 after %2: seed %3").arg(error.what(), last).arg(test::seed())));
    }
    monkey.settle();
    WindowFixture& f = monkey.fixture();
    f.window->escape();
    QVERIFY(f.settle());
    QVERIFY(f.make("sphere", 2000));
    QCOMPARE(f.surfels(), std::size_t(2000));
    QString told;
    for (const auto& [what, count] : counts)
        told += QString(", %1 %2").arg(what).arg(count);
    qInfo("%d events survived, seed %llu%s", events, test::seed(), qPrintable(told));
}

static const test::Registered<MonkeyTest> registered;
#include "monkey_test.moc"
