#include "ui/panels/floating_card.h"

#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

namespace ui {

FloatingCard::FloatingCard(QWidget& canvas, Place place, const QString& title)
    : QFrame(&canvas), m_canvas(canvas), m_place(place), m_title(new QLabel), m_column(new QVBoxLayout(this)) {
    setObjectName("card");
    setAttribute(Qt::WA_DeleteOnClose);
    setAttribute(Qt::WA_StyledBackground);
    setCursor(Qt::ArrowCursor);
    m_title->setObjectName("title");
    m_column->setContentsMargins(18, 14, 18, 14);
    m_column->setSpacing(8);
    m_column->addWidget(m_title);
    setTitle(title);
    canvas.installEventFilter(this);
}

void FloatingCard::setTitle(const QString& title) {
    m_title->setText(title);
    setAccessibleName(title);
}

void FloatingCard::place() {
    constexpr int margin = 14;
    const QSize room = m_canvas.size() - QSize(2 * margin, 2 * margin);
    QSize size = sizeHint().boundedTo(room);
    if (hasHeightForWidth())
        size.setHeight(std::min(heightForWidth(size.width()), room.height()));
    const QPoint middle((m_canvas.width() - size.width()) / 2, (m_canvas.height() - size.height()) / 2);
    setGeometry(QRect(m_place == Place::Centre ? middle : QPoint(margin, margin), size));
    raise();
}

bool FloatingCard::event(QEvent* event) {
    switch (event->type()) {
    case QEvent::Show:
    case QEvent::LayoutRequest:
        place();
        break;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
        event->accept();
        return true;
    default:
        break;
    }
    return QFrame::event(event);
}

bool FloatingCard::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Resize)
        place();
    else if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::TabletPress)
        pressedBeside();
    return false;
}

} // namespace ui
