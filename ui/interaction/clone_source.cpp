#include "ui/interaction/clone_source.h"

#include "core/sculpt/stroke/stroke_options.h"

namespace ui {

using base::Vec3d;

CloneSource::CloneSource(const Editor& editor, QObject* parent) : QObject(parent), m_editor(editor) {}

void CloneSource::choose(const std::optional<Vec3d>& place) {
    m_place = place;
    const Vec3d shown = place.value_or(Vec3d{}) + m_editor.snapshot().origin;
    const auto number = [](double value) { return QString::number(value, 'g', 4); };
    Q_EMIT changed(place ? QString("(%1, %2, %3)").arg(number(shown.x), number(shown.y), number(shown.z)) : QString());
}

void CloneSource::addTo(sculpt::StrokeSettings& settings, const Vec3d& contact) const {
    setSource(settings, *m_place - contact);
}

} // namespace ui
