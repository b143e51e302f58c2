#include "ui/window/menus/menu_tools.h"

#include "ui/theme/icon.h"

#include <QActionGroup>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace ui {

QMenu* addMenu(QMainWindow& window, const QString& name, const QString& title, QMenu* parent) {
    QMenu* out = parent ? parent->addMenu(title) : window.menuBar()->addMenu(title);
    out->setObjectName(name);
    out->setToolTipsVisible(true);
    return out;
}

QAction* addEntry(QMenu& menu, const char* iconName, const QString& text, const QKeySequence& shortcut,
                  const std::function<void()>& work) {
    QAction* out = menu.addAction(icon(iconName), text);
    out->setShortcut(shortcut);
    QObject::connect(out, &QAction::triggered, out, [work] { work(); });
    return out;
}

QAction* addChoice(QMenu& menu, QActionGroup& group, const char* id, const QString& label, const QString& tip,
                   bool chosen, const std::function<void()>& choose) {
    QAction* out = addEntry(menu, "", label, {}, choose);
    out->setToolTip(tip);
    out->setData(id);
    out->setCheckable(true);
    out->setChecked(chosen);
    group.addAction(out);
    return out;
}

namespace {

class StayOpen : public QObject {
  public:
    using QObject::QObject;
    bool eventFilter(QObject* object, QEvent* event) override {
        auto& menu = static_cast<QMenu&>(*object);
        QAction* action = nullptr;
        if (event->type() == QEvent::MouseButtonRelease)
            action = menu.actionAt(static_cast<QMouseEvent*>(event)->position().toPoint());
        else if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space)
            action = menu.activeAction();
        if (!action || !action->isEnabled() || !action->isCheckable() || action->menu())
            return false;
        action->trigger();
        return true;
    }
};

} // namespace

void stayOpen(QMenu& menu) {
    menu.installEventFilter(new StayOpen(&menu));
}

QAction* addSwitch(QMenu& menu, const char* id, const QString& label, const QString& tip, bool on,
                   const std::function<void(bool)>& turn) {
    QAction* out = menu.addAction(label);
    out->setToolTip(tip);
    out->setData(id);
    out->setCheckable(true);
    out->setChecked(on);
    QObject::connect(out, &QAction::toggled, out, turn);
    return out;
}

} // namespace ui
