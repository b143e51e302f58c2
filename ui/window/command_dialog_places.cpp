// Places that are picked in the picture for a dialog's fields, and what handles say into them.
#include "ui/window/command_dialog.h"
#include "ui/window/parameter_values.h"

#include <QLineEdit>
#include <QToolButton>

namespace ui {

QString CommandDialog::placeLacking() const {
    for (const Field& field : m_fields)
        if ((isPlace(*field.parameter) || isPlaces(*field.parameter)) && !*field.parameter->fallback &&
            enteredIn(field.widget).isEmpty())
            return field.parameter->id;
    return {};
}

bool CommandDialog::takesSeveral(const QString& name) const {
    const Field* field = find(name.toStdString());
    return field && isPlaces(*field->parameter);
}

/// Where a direction is asked for beside a place, a click gives both: from just before the surface, straight in.
void CommandDialog::takePlace(const QString& name, const base::Vec3d& place, const base::Vec3d& normal) {
    const Field* field = find(name.toStdString());
    const Field* direction = find("direction");
    auto* line = field ? qobject_cast<QLineEdit*>(field->widget) : nullptr;
    if (!line)
        return;
    const bool into = direction && std::string_view(m_row.op) == "drill";
    if (into)
        qobject_cast<QLineEdit*>(direction->widget)->setText(textOf(-normal));
    if (isDirection(*field->parameter))
        return into ? void() : line->setText(textOf(normal));
    const QString text = textOf(into ? place + normal * static_cast<double>(m_model.spacing) : place,
                                static_cast<double>(m_model.surface.tree().bounds().diagonal()));
    const bool more = takesSeveral(name) && !line->text().isEmpty();
    line->setText(more ? line->text() + "; " + text : text);
    if (!more)
        line->setCursorPosition(0);
}

void CommandDialog::enter(std::string_view name, const QString& text) {
    const Field* field = find(name);
    if (auto* line = field ? qobject_cast<QLineEdit*>(field->widget) : nullptr; line && line->text() != text)
        line->setText(text);
}

void CommandDialog::setPicking(const QString& field) {
    for (const auto& [name, button] : m_picks)
        button->setChecked(name == field);
}

} // namespace ui
