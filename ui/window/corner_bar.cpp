#include "ui/window/main_window.h"
#include "ui/window/menus/menus.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QMenuBar>
#include <QToolButton>

namespace ui {

namespace {

/// Shows the corner only where the menus leave it room: in a narrow window it would hide the last of them, and all that
/// it does is in them.
class CornerRoom : public QObject {
  public:
    CornerRoom(QMenuBar& menus, QWidget& corner) : QObject(&menus), m_menus(menus), m_corner(corner) {
        menus.installEventFilter(this);
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Resize)
            m_corner.setVisible(wantedByMenus() + m_corner.sizeHint().width() <= m_menus.width());
        return QObject::eventFilter(watched, event);
    }

  private:
    int wantedByMenus() const {
        constexpr int around = 24; // padding and spacing of an entry
        int out = around;
        for (const QAction* action : m_menus.actions())
            out += m_menus.fontMetrics().horizontalAdvance(action->text().remove('&')) + around;
        return out;
    }
    QMenuBar& m_menus;
    QWidget& m_corner;
};

} // namespace

void addCornerBar(MainWindow& window) {
    auto* bar = new QWidget;
    bar->setObjectName("corner");
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 6, 0);
    row->setSpacing(2);
    const auto add = [&](QAction* action) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setIconSize({18, 18});
        button->setFocusPolicy(Qt::NoFocus);
        row->addWidget(button);
    };
    for (QAction* action : window.menu("file")->actions())
        if (action->shortcut() == QKeySequence::Open || action->shortcut() == QKeySequence::Save)
            add(action);
    for (const char* name : {"undo", "redo", "frame-all"})
        add(window.findChild<QAction*>(name));
    window.menuBar()->setCornerWidget(bar);
    new CornerRoom(*window.menuBar(), *bar);
}

} // namespace ui
