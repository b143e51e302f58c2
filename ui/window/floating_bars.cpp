#include "ui/window/floating_bars.h"

#include "ui/theme/icon.h"

#include <algorithm>
#include <QEvent>
#include <QToolButton>
#include <QWidget>

namespace ui {

FloatingBars::FloatingBars(QWidget& canvas, QObject* parent) : QObject(parent), m_canvas(canvas) {
    canvas.installEventFilter(this);
}

void FloatingBars::add(QWidget& bar, std::function<void(int width)> fit) {
    const bool shown = bar.isVisibleTo(bar.parentWidget());
    bar.setParent(&m_canvas);
    bar.setProperty("floating", true);
    bar.setAttribute(Qt::WA_StyledBackground);
    bar.setCursor(Qt::ArrowCursor);
    bar.installEventFilter(this);
    if (auto* more = bar.findChild<QToolButton*>("qt_toolbar_ext_button")) { // the style's own is black on dark
        more->setIcon(icon("more"));
        more->setToolTip(tr("What has no room here"));
    }
    m_bars.push_back({&bar, std::move(fit)});
    connect(&bar, &QObject::destroyed, this,
            [this, gone = &bar] { std::erase_if(m_bars, [&](const Bar& each) { return each.widget == gone; }); });
    bar.setVisible(shown);
    place();
}

void FloatingBars::place() {
    if (m_placing)
        return;
    m_placing = true; // a bar's own resizing asks for nothing more
    constexpr int margin = 10, gap = 6;
    int bottom = m_canvas.height() - margin;
    for (const auto& [bar, fit] : m_bars) {
        if (bar->isHidden())
            continue;
        if (fit)
            fit(m_canvas.width());
        const QSize wanted = bar->sizeHint();
        const int width = std::min(wanted.width(), m_canvas.width() - 2 * margin);
        bar->setGeometry((m_canvas.width() - width) / 2, bottom - wanted.height(), width, wanted.height());
        bar->raise();
        bottom -= wanted.height() + gap;
    }
    m_placing = false;
}

bool FloatingBars::eventFilter(QObject* object, QEvent* event) {
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::LayoutRequest:
        place();
        return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
    case QEvent::Wheel:
        if (object == &m_canvas)
            return false;
        event->accept();
        return true;
    default:
        return false;
    }
}

} // namespace ui
