#include "ui/panels/curve_editor.h"

#include <algorithm>
#include <cmath>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace ui {

using sculpt::BrushCurve;
using sculpt::CurvePoint;

constexpr double margin = 7, reach = 9;
/// Pixels beyond the field from which a dragged point counts as thrown away.
constexpr double away = 22;

CurveEditor::CurveEditor(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFixedHeight(sizeHint().height());
}

void CurveEditor::setPoints(const sculpt::CurvePoints& points) {
    if (m_held >= 0)
        return; // the hand knows better
    m_points = points;
    m_under = -1;
    update();
}

void CurveEditor::setShape(Shape shape) {
    m_shape = std::move(shape);
    update();
}

QRectF CurveEditor::field() const {
    return QRectF(rect()).adjusted(margin, margin, -margin, -margin);
}

QPointF CurveEditor::placeOf(CurvePoint point) const {
    const QRectF in = field();
    return {in.left() + double(point.x) * in.width(), in.bottom() - double(point.y) * in.height()};
}

CurvePoint CurveEditor::pointAt(const QPointF& place) const {
    const QRectF in = field();
    return {static_cast<float>(std::clamp((place.x() - in.left()) / in.width(), 0.0, 1.0)),
            static_cast<float>(std::clamp((in.bottom() - place.y()) / in.height(), 0.0, 1.0))};
}

int CurveEditor::nearest(const QPointF& place) const {
    int out = -1;
    double best = reach;
    for (std::size_t i = 0; i < m_points.size() && !m_shape; ++i) {
        const QPointF by = placeOf(m_points[i]) - place;
        if (const double gap = std::hypot(by.x(), by.y()); gap < best)
            best = gap, out = static_cast<int>(i);
    }
    return out;
}

int CurveEditor::insert(CurvePoint point) {
    const auto at = std::find_if(m_points.begin(), m_points.end(), [&](const CurvePoint& p) { return p.x > point.x; });
    const bool roomBefore = at == m_points.begin() || point.x - std::prev(at)->x >= BrushCurve::minGap;
    const bool roomBehind = at == m_points.end() || at->x - point.x >= BrushCurve::minGap;
    if (m_points.size() >= BrushCurve::maxPoints || !roomBefore || !roomBehind)
        return -1;
    const auto index = at - m_points.begin(); // before inserting moves them
    m_points.insert(at, point);
    return static_cast<int>(index);
}

/// Starts from the curve that is shown in place of our own.
void CurveEditor::adopt() {
    if (!m_shape)
        return;
    m_points.clear();
    for (const float x : {0.0f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f})
        m_points.push_back({x, std::clamp(m_shape(x), 0.0f, 1.0f)});
    m_shape = {};
}

void CurveEditor::changed() {
    update();
    Q_EMIT edited();
}

void CurveEditor::mousePressEvent(QMouseEvent* event) {
    if (m_held >= 0)
        return; // by another button: taking points away now would leave the hand with none
    adopt();
    const int under = nearest(event->position());
    if (event->button() == Qt::RightButton && under >= 0 && m_points.size() > 2) {
        m_points.erase(m_points.begin() + under);
        m_under = -1;
        return changed();
    }
    if (event->button() != Qt::LeftButton)
        return;
    m_held = under >= 0 ? under : insert(pointAt(event->position()));
    m_under = m_held;
    m_out = false;
    if (under < 0 && m_held >= 0)
        changed();
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event) {
    if (m_held < 0) {
        m_under = nearest(event->position());
        return update();
    }
    const auto i = static_cast<std::size_t>(m_held);
    CurvePoint to = pointAt(event->position());
    constexpr float gap = 2 * BrushCurve::minGap; // more than rounding takes
    const float least = i > 0 ? m_points[i - 1].x + gap : 0.0f;
    const float most = i + 1 < m_points.size() ? m_points[i + 1].x - gap : 1.0f;
    to.x = least <= most ? std::clamp(to.x, least, most) : m_points[i].x; // it may have been put into a gap of one
    m_points[i] = to;
    const QRectF kept = QRectF(rect()).adjusted(-away, -away, away, away);
    m_out = m_points.size() > 2 && !kept.contains(event->position());
    changed();
}

void CurveEditor::mouseReleaseEvent(QMouseEvent*) {
    const int held = std::exchange(m_held, -1);
    if (held >= 0 && m_out) {
        m_points.erase(m_points.begin() + held);
        m_under = -1;
        changed();
    }
    m_out = false;
    update();
}

void CurveEditor::leaveEvent(QEvent*) {
    m_under = -1;
    update();
}

/// A rounded ground with quarters marked.
static void paintGround(QPainter& painter, const QWidget& editor, const QRectF& in) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(editor.palette().base());
    painter.drawRoundedRect(editor.rect(), 4, 4);
    painter.setPen(QPen(QColor(255, 255, 255, 18), 1));
    for (int k = 0; k <= 4; ++k) {
        const double x = std::round(in.left() + in.width() * k / 4) + 0.5,
                     y = std::round(in.top() + in.height() * k / 4) + 0.5;
        painter.drawLine(QPointF(x, in.top()), QPointF(x, in.bottom()));
        painter.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
    }
}

/// The line, and the area under it faintly; both fainter where it is not the person's own.
static void paintLine(QPainter& painter, const QPainterPath& line, const QRectF& in, QColor accent, bool own) {
    QPainterPath under = line;
    under.lineTo(in.bottomRight());
    under.lineTo(in.bottomLeft());
    under.closeSubpath();
    accent.setAlphaF(own ? 0.2f : 0.12f);
    painter.fillPath(under, accent);
    accent.setAlphaF(own ? 1 : 0.6f);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(accent, 1.6));
    painter.drawPath(line);
}

QPainterPath CurveEditor::lineOf(const Shape& value) const {
    const double width = field().width();
    QPainterPath out;
    for (int x = 0; x <= qRound(width); ++x) {
        const auto u = static_cast<float>(x / width);
        const QPointF at = placeOf({u, value(u)});
        x == 0 ? out.moveTo(at) : out.lineTo(at);
    }
    return out;
}

void CurveEditor::paintPoints(QPainter& painter, const sculpt::CurvePoints& points) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool lit = static_cast<int>(i) == (m_held >= 0 ? m_held : m_under) && !m_out;
        painter.setPen(QPen(palette().base().color(), 1.2));
        painter.setBrush(lit ? QColor(Qt::white) : palette().text().color());
        painter.drawEllipse(placeOf(points[i]), lit ? 4.5 : 3.5, lit ? 4.5 : 3.5);
    }
}

void CurveEditor::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintGround(painter, *this, field());
    sculpt::CurvePoints shown = m_points;
    if (m_out && m_held >= 0)
        shown.erase(shown.begin() + m_held);
    const BrushCurve own(shown);
    const QPainterPath line =
        lineOf([&](float u) { return m_shape ? std::clamp(m_shape(u), 0.0f, 1.0f) : own.value(u); });
    paintLine(painter, line, field(), palette().highlight().color(), !m_shape);
    if (!m_shape)
        paintPoints(painter, shown);
}

} // namespace ui
