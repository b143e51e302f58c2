// What hands find under the fingers: numbers typed while the brush is sized, the other end of a pen, the mask's keys
// and pie, the axes in the corner of the picture, and keys as other programs have them.
#include "reach.h"
#include "support/patience.h"
#include "support/registry.h"
#include "ui/panels/pie_menu.h"
#include "ui/panels/view_gizmo.h"
#include "ui/window/keys_dialog.h"

#include <QMenuBar>
#include <QPointingDevice>
#include <QTabletEvent>

using base::Vec3d;
using test::reachOf;
using test::WindowFixture;

class HandKeysTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aNumberTypedAfterFIsTheRadius();
    void aNumberTypedAfterShiftFIsTheStrength();
    void theEraserDoesTheOpposite();
    void maskKeysChangeTheWholeMask();
    void aPieTakesWhatLiesInTheDirection();
    void aClickOnAnAxisLooksAlongIt_data();
    void aClickOnAnAxisLooksAlongIt();
    void draggingTheAxesTurnsTheView();
    void presetsNameActionsThatAreThereAndDisturbNone();
    void keysLeaveTheMenusTheirLetters();
};

static void type(WindowFixture& f, int key, const QString& text = {}, Qt::KeyboardModifiers modifiers = {}) {
    for (const QEvent::Type each : {QEvent::KeyPress, QEvent::KeyRelease}) {
        QKeyEvent event(each, key, modifiers, text);
        QApplication::sendEvent(&f.view(), &event);
    }
}

/// An entry that is a shortcut otherwise is left alone while it is typed.
static bool takenFromShortcuts(WindowFixture& f, int key, const QString& text) {
    QKeyEvent event(QEvent::ShortcutOverride, key, Qt::NoModifier, text);
    event.ignore();
    QApplication::sendEvent(&f.view(), &event);
    return event.isAccepted();
}

void HandKeysTest::aNumberTypedAfterFIsTheRadius() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    const double before = f.window->settings().radiusPx;
    QVERIFY(!takenFromShortcuts(f, Qt::Key_1, "1")); // the front view
    type(f, Qt::Key_F);
    QVERIFY(takenFromShortcuts(f, Qt::Key_1, "1"));
    for (const QChar digit : QString("123"))
        type(f, digit.unicode(), digit);
    QCOMPARE(f.window->settings().radiusPx, 123.0);
    type(f, Qt::Key_Backspace);
    QCOMPARE(f.window->settings().radiusPx, 12.0);
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre() + QPointF(90, 0), Qt::NoButton); // means nothing now
    QCOMPARE(f.window->settings().radiusPx, 12.0);
    type(f, Qt::Key_Return);
    QVERIFY(!f.window->sculptView().sizing().dragging());
    QCOMPARE(f.window->settings().radiusPx, 12.0);
    type(f, Qt::Key_F);
    type(f, Qt::Key_9, "9");
    f.window->escape(); // as it was
    QCOMPARE(f.window->settings().radiusPx, 12.0);
    type(f, Qt::Key_F);
    for (const QChar digit : QString("99999"))
        type(f, digit.unicode(), digit);
    type(f, Qt::Key_Return);
    QCOMPARE(f.window->settings().radiusPx, ui::Settings::maxRadiusPx);
    QVERIFY(before != 12);
}

void HandKeysTest::aNumberTypedAfterShiftFIsTheStrength() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    const auto strength = [&] { return f.window->settings().choice(f.window->settings().toolRow()).strength; };
    type(f, Qt::Key_F, {}, Qt::ShiftModifier);
    for (const auto& [key, text] :
         {std::pair(Qt::Key_0, "0"), std::pair(Qt::Key_Period, "."), std::pair(Qt::Key_2, "2")})
        type(f, key, text);
    QVERIFY(std::abs(strength() - 0.2f) < 1e-6f);
    type(f, Qt::Key_Return);
    QVERIFY(std::abs(strength() - 0.2f) < 1e-6f);
}

static void penTap(WindowFixture& f, QPointingDevice::PointerType end) {
    const QPointingDevice pen("pen", 1, QInputDevice::DeviceType::Stylus, end,
                              QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 3);
    for (const QEvent::Type each : {QEvent::TabletMove, QEvent::TabletPress, QEvent::TabletRelease}) {
        const QPointF at = f.centre();
        QTabletEvent event(each, &pen, at, f.view().mapToGlobal(at), 1, 0, 0, 0, 0, 0, Qt::NoModifier, Qt::LeftButton,
                           each == QEvent::TabletPress ? Qt::LeftButton : Qt::NoButton);
        QApplication::sendEvent(&f.view(), &event);
    }
    f.settle();
}

void HandKeysTest::theEraserDoesTheOpposite() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    const test::Reach before = reachOf(f);
    penTap(f, QPointingDevice::PointerType::Pen);
    QVERIFY(reachOf(f).highest > before.highest + 0.005f);
    f.window->undo();
    QVERIFY(f.settle());
    penTap(f, QPointingDevice::PointerType::Eraser);
    QVERIFY(reachOf(f).lowest < before.lowest - 0.005f && reachOf(f).highest < before.highest + 0.001f);
}

static double masked(WindowFixture& f) {
    double sum = 0;
    for (const auto& s : f.editor().snapshot().surface.tree().surfels().items)
        sum += double(s.mask);
    return sum / double(f.surfels());
}

void HandKeysTest::maskKeysChangeTheWholeMask() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    for (const auto& [name, key, after] :
         {std::tuple("mask-invert", "Ctrl+I", 1.0), std::tuple("mask-clear", "Alt+M", 0.0)}) {
        QAction* action = f.window->findChild<QAction*>(name);
        QVERIFY(action && action->shortcut() == QKeySequence(key));
        action->trigger();
        QVERIFY(f.settle());
        QCOMPARE(masked(f), after);
    }
}

void HandKeysTest::aPieTakesWhatLiesInTheDirection() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    QList<QAction*> actions;
    QString taken;
    for (const char* name : {"north", "east", "south", "west"}) {
        actions << new QAction(name, f.window.get());
        connect(actions.back(), &QAction::triggered, f.window.get(), [&taken, name] { taken = name; });
    }
    const auto press = [&](ui::PieMenu& pie, const QPointF& by) {
        test::sendMouse(pie, QEvent::MouseMove, pie.middle() + by, Qt::NoButton);
        test::sendMouse(pie, QEvent::MouseButtonPress, pie.middle() + by, Qt::LeftButton);
    };
    for (const auto& [by, name] : {std::pair(QPointF(3, -70), "north"), std::pair(QPointF(40, 10), "east"),
                                   std::pair(QPointF(-5, 300), "south"), std::pair(QPointF(-60, -50), "west")}) {
        press(*new ui::PieMenu(f.view(), f.centre().toPoint(), actions), by);
        QCOMPARE(taken, QString(name));
    }
    taken.clear();
    press(*new ui::PieMenu(f.view(), {0, 0}, actions), QPointF(4, 4)); // in the middle
    auto* pie = new ui::PieMenu(f.view(), f.centre().toPoint(), actions);
    QTest::keyClick(pie, Qt::Key_Escape);
    QVERIFY(taken.isEmpty());
    pie = new ui::PieMenu(f.view(), f.centre().toPoint(), actions); // by its key, let go
    test::sendMouse(*pie, QEvent::MouseMove, pie->middle() + QPointF(0, 80), Qt::NoButton);

    QKeyEvent release(QEvent::KeyRelease, Qt::Key_A, Qt::NoModifier, "a");
    QApplication::sendEvent(pie, &release);
    QCOMPARE(taken, QString("south"));
    QTRY_VERIFY_WITH_TIMEOUT(!f.view().findChild<ui::PieMenu*>(), test::patience);
    QVERIFY(!f.editor().snapshot().canUndo); // none of it reached the model
}

void HandKeysTest::aClickOnAnAxisLooksAlongIt_data() {
    QTest::addColumn<QString>("up");
    for (const char* up : {"y", "z", "-x"})
        QTest::addRow("%s", up) << up;
}

void HandKeysTest::aClickOnAnAxisLooksAlongIt() {
    QFETCH(QString, up);
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    f.editor().run({{"op", "up"}, {"axis", up.toStdString()}});
    QVERIFY(f.settle());
    auto& gizmo = *f.window->findChild<ui::ViewGizmo*>();
    QVERIFY(gizmo.isVisible() && gizmo.geometry().right() > f.view().width() - 20);
    const auto click = [&](int axis, bool positive) {
        const QPointF at = gizmo.place(axis, positive);
        test::sendMouse(gizmo, QEvent::MouseButtonPress, at, Qt::LeftButton);
        test::sendMouse(gizmo, QEvent::MouseButtonRelease, at, Qt::LeftButton);
    };
    const auto toEye = [&] { return -f.window->sculptView().motion().camera().forward(); };
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3d direction{axis == 0 ? 1.0 : 0, axis == 1 ? 1.0 : 0, axis == 2 ? 1.0 : 0};
        f.window->sculptView().motion().showNewModel(); // from a corner, where every end is seen
        click(axis, true);
        QVERIFY(dot(toEye(), direction) > 1 - 1e-9);
        click(axis, true); // and from the other side
        QVERIFY(dot(toEye(), direction) < -1 + 1e-9);
    }
    QVERIFY(f.editor().snapshot().past.size() <= 1); // no dab
}

void HandKeysTest::draggingTheAxesTurnsTheView() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    auto& gizmo = *f.window->findChild<ui::ViewGizmo*>();
    const render::Camera before = f.window->sculptView().motion().camera();
    test::sendMouse(gizmo, QEvent::MouseButtonPress, {46, 46}, Qt::LeftButton);
    test::sendMouse(gizmo, QEvent::MouseMove, {76, 46}, Qt::LeftButton);
    test::sendMouse(gizmo, QEvent::MouseButtonRelease, {76, 46}, Qt::LeftButton);
    const render::Camera after = f.window->sculptView().motion().camera();
    QVERIFY(distance(after.eye, before.eye) > 0.1);
    QVERIFY(std::abs(distance(after.eye, after.target) / distance(before.eye, before.target) - 1) < 1e-9);
}

void HandKeysTest::presetsNameActionsThatAreThereAndDisturbNone() {
    WindowFixture f;
    const auto entries = ui::paletteEntries(*f.window->menuBar());
    std::map<std::string, QAction*> byId;
    for (const ui::PaletteEntry& each : entries)
        if (each.action)
            byId[ui::keyIdOf(each)] = each.action;
    ui::KeysDialog dialog(*f.window->menuBar(), f.window->settings().keys);
    for (const ui::KeyPreset& preset : ui::keyPresets()) {
        for (const auto& [id, key] : preset.keys)
            QVERIFY2(byId.contains(id) && !QKeySequence(key).isEmpty(), id);
        dialog.take(preset);
        for (const auto& [id, key] : preset.keys)
            QCOMPARE(byId[id]->shortcut(), QKeySequence(key));
        for (const ui::PaletteEntry& each : entries)
            for (const QKeySequence& key : each.action ? each.action->shortcuts() : QList<QKeySequence>())
                QVERIFY2(ui::conflictsOf(entries, *each.action, key).isEmpty(), qPrintable(each.label));
    }
    dialog.take(ui::keyPresets().front());
    QVERIFY(f.window->settings().keys.empty());
    QVERIFY(ui::disturb(QKeySequence("B"), QKeySequence("B, S, T")) &&
            !ui::disturb(QKeySequence("S"), QKeySequence("B, S")));
}

/// Alt+M was the mask's and the Model menu's, so that it did nothing at all.
void HandKeysTest::keysLeaveTheMenusTheirLetters() {
    WindowFixture f;
    const auto entries = ui::paletteEntries(*f.window->menuBar());
    QList<QKeySequence> letters;
    for (const QAction* menu : f.window->menuBar()->actions()) {
        const QKeySequence letter = QKeySequence::mnemonic(menu->text());
        QVERIFY2(!letter.isEmpty() && !letters.contains(letter), qPrintable(menu->text()));
        letters << letter;
        for (const ui::PaletteEntry& entry : entries)
            for (const QKeySequence& key : entry.action ? ui::ownKeysOf(*entry.action) : QList<QKeySequence>())
                QVERIFY2(!ui::disturb(letter, key), qPrintable(menu->text() + " and " + entry.label));
        for (const ui::KeyPreset& preset : ui::keyPresets())
            for (const auto& [id, key] : preset.keys)
                QVERIFY2(!ui::disturb(letter, QKeySequence(key)), id);
    }
}

static const test::Registered<HandKeysTest> registered;
#include "hand_keys_test.moc"
