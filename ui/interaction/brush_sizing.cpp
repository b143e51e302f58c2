#include "ui/interaction/brush_sizing.h"

#include <algorithm>
#include <cmath>
#include <QKeyEvent>
#include <QWidget>
#include <utility>

namespace ui {

/// Pixels of a drag that multiply the radius by e.
constexpr double radiusDragPx = 150;
/// Pixels of a drag across all strengths from 0 to 1.
constexpr double strengthDragPx = 300;

BrushSizing::BrushSizing(Settings& settings, const ViewMotion& motion, const QWidget& canvas, QObject* parent)
    : QObject(parent), m_settings(settings), m_motion(motion), m_canvas(canvas) {}

double& BrushSizing::radius() const {
    return m_settings.radiusUnit == RadiusUnit::Pixels ? m_settings.radiusPx : m_settings.radiusModel;
}

float BrushSizing::strength() const {
    return m_settings.choice(m_settings.toolRow()).strength;
}

void BrushSizing::scaleRadius(double factor) {
    if (m_settings.radiusUnit == RadiusUnit::Pixels)
        m_settings.radiusPx = std::clamp(m_settings.radiusPx * factor, Settings::minRadiusPx, Settings::maxRadiusPx);
    else
        m_settings.radiusModel = std::clamp(m_settings.radiusModel * factor, 1e-30, 1e30);
    Q_EMIT changed();
}

void BrushSizing::chooseUnit(RadiusUnit unit) {
    if (unit == m_settings.radiusUnit)
        return;
    const double pixelsPerUnit =
        m_motion.pixelsPerUnitAt(m_motion.view().turningPoint()) / m_canvas.devicePixelRatioF();
    if (unit == RadiusUnit::Model)
        m_settings.radiusModel = m_settings.radiusPx / pixelsPerUnit;
    else
        m_settings.radiusPx =
            std::clamp(m_settings.radiusModel * pixelsPerUnit, Settings::minRadiusPx, Settings::maxRadiusPx);
    m_settings.radiusUnit = unit;
    Q_EMIT changed();
}

void BrushSizing::shiftStrength(double by) {
    sculpt::StrokeSettings& tool = m_settings.edit(m_settings.toolRow());
    tool.strength = static_cast<float>(std::clamp(double(tool.strength) + by, 0.0, 1.0));
    Q_EMIT changed();
}

void BrushSizing::beginDrag(Value value) {
    m_drag = Drag{value, value == Value::Radius ? radius() : double(strength()), {}};
}

bool BrushSizing::types(const QKeyEvent& key) {
    const QString text = key.text();
    return key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter || key.key() == Qt::Key_Backspace ||
           (text.size() == 1 && (text[0].isDigit() || text[0] == '.' || text[0] == ','));
}

bool BrushSizing::type(const QKeyEvent& key) {
    if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter)
        return true;
    QString& typed = m_drag->typed;
    if (key.key() == Qt::Key_Backspace)
        typed.chop(1);
    else
        typed += key.text() == "," ? QString(".") : key.text();
    bool isNumber = false;
    const double value = typed.toDouble(&isNumber);
    set(isNumber ? value : m_drag->before);
    return false;
}

/// Within what a brush can be.
void BrushSizing::set(double value) {
    if (m_drag->value == Value::Strength)
        return shiftStrength(value - double(strength()));
    if (value > 0)
        radius() = value;
    scaleRadius(1);
}

void BrushSizing::drag(double dxPx) {
    if (!m_drag->typed.isEmpty())
        return;
    if (m_drag->value == Value::Radius)
        scaleRadius(std::exp(dxPx / radiusDragPx));
    else
        shiftStrength(dxPx / strengthDragPx);
}

void BrushSizing::endDrag(bool keep) {
    const Drag drag = *std::exchange(m_drag, std::nullopt);
    if (!keep && drag.value == Value::Radius)
        radius() = drag.before;
    else if (!keep)
        m_settings.edit(m_settings.toolRow()).strength = static_cast<float>(drag.before);
    Q_EMIT changed();
}

std::optional<double> BrushSizing::draggedStrength() const {
    return m_drag && m_drag->value == Value::Strength ? std::optional(double(strength())) : std::nullopt;
}

QString BrushSizing::label() const {
    if (!m_drag)
        return {};
    if (!m_drag->typed.isEmpty())
        return (m_drag->value == Value::Radius ? tr("Radius %1_") : tr("Strength %1_")).arg(m_drag->typed);
    if (m_drag->value == Value::Radius)
        return tr("Radius %1")
            .arg(QString::number(radius(), 'g', 3) + (m_settings.radiusUnit == RadiusUnit::Pixels ? " px" : ""));
    return tr("Strength %1").arg(double(strength()), 0, 'f', 2);
}

double BrushSizing::radiusAt(const base::Vec3d& place) const {
    if (m_settings.radiusUnit == RadiusUnit::Model)
        return m_settings.radiusModel;
    return m_settings.radiusPx * m_canvas.devicePixelRatioF() / m_motion.pixelsPerUnitAt(place);
}

double BrushSizing::radiusPx() const {
    if (m_settings.radiusUnit == RadiusUnit::Pixels)
        return m_settings.radiusPx * m_canvas.devicePixelRatioF();
    return m_settings.radiusModel * m_motion.pixelsPerUnitAt(m_motion.view().turningPoint());
}

} // namespace ui
