#include "ui/window/select_tools.h"

#include "ui/interaction/select_ways.h"
#include "ui/panels/select_bar.h"
#include "ui/window/main_window.h"

namespace ui {

SelectTools::SelectTools(MainWindow& window, SelectBar& bar) : QObject(&bar), m_window(window), m_bar(bar) {
    connect(&bar, &SelectBar::wayChosen, this, &SelectTools::choose);
    connect(&bar, &SelectBar::wanted, this, &SelectTools::run);
    connect(&bar, &SelectBar::stepWanted, this, &SelectTools::step);
    connect(bar.toggleViewAction(), &QAction::toggled, this, &SelectTools::show);
    connect(bar.toggleViewAction(), &QAction::triggered, this, [this](bool shown) {
        if (shown && m_bar.way() < 0) // who asks for the bar wants to select: a drag would sculpt instead
            choose(m_last);
    });
}

void SelectTools::choose(int way) {
    Picker& picker = m_window.sculptView().picker();
    if (way < 0)
        return picker.end();
    const SelectWay& row = selectWays()[static_cast<std::size_t>(way)];
    picker.begin({row.shape, [this, way](const Pick& found) { pick(way, found); },
                  [this] {
                      m_bar.setWay(-1);
                      m_window.showHint();
                  }});
    m_bar.setWay(way);
    m_last = way;
    m_bar.show(); // where a key chose
    m_window.showHint(tr(row.tip) + ". " + tr("Shift adds, Ctrl subtracts, Esc goes back to sculpting."));
}

void SelectTools::pick(int way, const Pick& found) {
    const Snapshot& now = m_window.editor().snapshot();
    if (now.surface.tree().empty())
        return m_window.tell(tr("There is no model to select from. Open one, or make one with File > New."));
    const base::Vec3d place = found.contact ? found.contact->position : m_window.sculptView().motion().view().target;
    const SelectContext context{now.surface, now.origin, m_window.sculptView().sizing().radiusAt(place),
                                m_bar.visibleOnly()};
    nlohmann::json command = selectWays()[static_cast<std::size_t>(way)].command(found, context);
    command["mode"] = modeOf(found.modifiers, m_bar.mode().toLatin1().constData());
    run(command);
}

void SelectTools::step(const QString& action) {
    SculptView& view = m_window.sculptView();
    const double length = 0.5 * view.sizing().radiusAt(view.motion().view().target);
    run({{"op", "selection"}, {"do", action.toStdString()}, {"length", length}});
}

void SelectTools::run(const nlohmann::json& command) {
    m_window.editor().run(command);
}

void SelectTools::show(bool shown) {
    if (!shown && m_bar.way() >= 0)
        m_window.sculptView().picker().end();
}

} // namespace ui
