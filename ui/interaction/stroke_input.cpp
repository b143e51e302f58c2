#include "ui/interaction/stroke_input.h"

#include "ui/interaction/contact.h"

namespace ui {

StrokeInput::StrokeInput(Editor& editor, const Settings& settings, const ViewMotion& motion, const BrushSizing& sizing,
                         const CloneSource& source)
    : m_editor(editor), m_settings(settings), m_motion(motion), m_sizing(sizing), m_source(source) {}

void StrokeInput::begin(const Pointer& pointer, const BrushContact& contact, std::uint64_t input) {
    const bool smoothing = pointer.modifiers.testFlag(Qt::ShiftModifier);
    const sculpt::ToolRow& row = smoothing ? sculpt::tool(m_settings.shiftTool) : m_settings.toolRow();
    const bool flip = pointer.inverts();
    const auto radius = static_cast<float>(m_sizing.radiusAt(contact.position));
    sculpt::StrokeSettings settings = strokeSettings(m_settings, row, radius, flip);
    settings.stampUpright = m_editor.snapshot().up;
    settings.fullTap = true;
    if (row.needs.source)
        m_source.addTo(settings, contact.position);
    m_start = contact.position;
    m_editor.beginStroke(settings);
    m_clock.start();
    add(pointer, input);
}

void StrokeInput::add(const Pointer& pointer, std::uint64_t input) {
    const std::optional<base::Rayf> ray = strokeRay(m_editor.snapshot().surface, m_motion.camera(), pointer.pixel);
    if (!ray)
        return;
    sculpt::StrokeSample sample;
    sample.ray = *ray;
    sample.pressure = pointer.pressure;
    sample.seconds = static_cast<float>(static_cast<double>(m_clock.nsecsElapsed()) * 1e-9);
    m_editor.addSample(sample, input);
}

void StrokeInput::end() {
    m_editor.endStroke();
}

void StrokeInput::cancel() {
    m_editor.cancelStroke();
}

} // namespace ui
