// A main window with its files in a temporary folder, and the hand that uses it.
#pragma once

#include "support/patience.h"
#include "ui/window/main_window.h"

#include <memory>
#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTest>

namespace test {

/// Events that a test sends itself, so that nothing depends on a window system.
inline void sendMouse(QWidget& widget, QEvent::Type type, QPointF at, Qt::MouseButton button,
                      Qt::KeyboardModifiers modifiers = {}) {
    const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button);
    QMouseEvent event(type, at, widget.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button, held,
                      modifiers);
    QApplication::sendEvent(&widget, &event);
}

class WindowFixture {
  public:
    QTemporaryDir folder;
    std::unique_ptr<ui::MainWindow> window;

    WindowFixture() { open(); }
    /// Another window; the one before is gone, with or without a proper end.
    void open() {
        window.reset();
        ui::WindowOptions options;
        options.settingsFile = folder.filePath("settings.ini");
        options.pictures = folder.filePath("pictures");
        options.editor.journal = journal();
        window = std::make_unique<ui::MainWindow>(options);
        window->sculptView().motion().navigator().setSmooth(false); // tests look at where a view leads
        window->resize(1000, 700);
        window->show();
    }
    std::filesystem::path journal() const { return folder.filePath("journal-test.jsonl").toStdString(); }
    QString file(const char* name) const { return folder.filePath(name); }

    ui::Editor& editor() { return window->editor(); }
    QWidget& view() { return *window->viewport().widget(); }
    QPointF centre() { return QRectF(view().rect()).center(); }
    std::size_t surfels() { return editor().snapshot().surface.tree().size(); }

    bool settle() {
        return QTest::qWaitFor([this] { return !editor().busy(); }, test::patience);
    }
    base::Hash128 hash() {
        const base::Hash128 out = editor().hashWhenDone();
        settle();
        return out;
    }
    bool make(const char* sample, int count) {
        editor().run({{"op", "new"}, {"sample", sample}, {"count", count}});
        return settle() && surfels() > 0;
    }
    void press(QPointF at, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButton button = Qt::LeftButton) {
        sendMouse(view(), QEvent::MouseMove, at, Qt::NoButton, modifiers);
        sendMouse(view(), QEvent::MouseButtonPress, at, button, modifiers);
    }
    /// Lets the model thread take each place, so that a test's stroke has all its samples.
    void moveTo(QPointF at, Qt::KeyboardModifiers modifiers = {}) {
        sendMouse(view(), QEvent::MouseMove, at, Qt::LeftButton, modifiers);
        settle();
    }
    void release(QPointF at, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButton button = Qt::LeftButton) {
        sendMouse(view(), QEvent::MouseButtonRelease, at, button, modifiers);
        settle();
    }
    void drag(QPointF from, QPointF to, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButton button = Qt::LeftButton) {
        constexpr int steps = 8;
        press(from, modifiers, button);
        for (int k = 1; k <= steps; ++k)
            moveTo(from + (to - from) * (static_cast<double>(k) / steps), modifiers);
        release(to, modifiers, button);
    }
    QAction* action(const QString& menu, const QString& text) {
        for (QAction* candidate : window->menu(menu)->actions())
            if (candidate->text().remove('&') == text)
                return candidate;
        return nullptr;
    }
};

} // namespace test
