#include "ui/window/measure_tools.h"

#include "ui/panels/measure_bar.h"
#include "ui/window/main_window.h"
#include "ui/words/words.h"

#include <QApplication>
#include <QClipboard>

namespace ui {

MeasureTools::MeasureTools(MainWindow& window, MeasureBar& bar) : QObject(&bar), m_window(window), m_bar(bar) {
    connect(&bar, &MeasureBar::rowChosen, this, &MeasureTools::choose);
    connect(&bar, &MeasureBar::clearWanted, this, &MeasureTools::clear);
    connect(&bar, &MeasureBar::copyWanted, this, &MeasureTools::copy);
    connect(bar.toggleViewAction(), &QAction::toggled, this, [this](bool shown) {
        if (!shown && m_row)
            m_window.sculptView().picker().end();
        else if (shown && !m_row)
            choose(0); // who opens the bar wants to measure: the next click must not sculpt
        m_window.viewport().widget()->update();
    });
    connect(&m_ruler, &Ruler::measured, this, &MeasureTools::receive);
    connect(&m_ruler, &Ruler::failed, this, [this](const QString& why) { m_bar.say(why); });
    connect(&m_ruler, &Ruler::progressed, this, [this](double share, const QString& doing) {
        m_bar.say(tr("%1 %2 %").arg(doing).arg(qRound(100 * share)));
    });
    connect(&window.editor(), &Editor::changed, this, [this] {
        if (std::exchange(m_models, m_window.editor().snapshot().models) != m_models)
            clear();
    });
}

void MeasureTools::choose(int row) {
    Picker& picker = m_window.sculptView().picker();
    if (row < 0)
        return picker.end();
    picker.begin({PickShape::Place, [this](const Pick& found) { pick(found); },
                  [this] {
                      m_row = nullptr;
                      m_places.clear();
                      m_ruler.cancel();
                      m_bar.setRow(-1);
                      m_bar.say(m_lines.isEmpty() ? tr("Choose what to measure, then click on the model.")
                                                  : m_lines.back());
                      m_window.showHint();
                  }});
    m_row = &rulerTable()[static_cast<std::size_t>(row)];
    m_bar.setRow(row);
    m_bar.show(); // where a key chose
    ask();
}

void MeasureTools::ask() {
    const std::size_t left = m_row->places - m_places.size();
    const QString clicks =
        left == 1 ? tr("Click one place on the model") : tr("Click %1 places on the model").arg(left);
    m_bar.say(tr("%1: %2. %3.").arg(tr(m_row->label), tr(m_row->tip), clicks));
    m_window.showHint(clicks + tr("; Esc goes back to sculpting; beside the model nothing is picked."));
    m_window.viewport().widget()->update();
}

void MeasureTools::pick(const Pick& found) {
    m_places.push_back({found.contact->position, found.contact->normal});
    if (m_places.size() < m_row->places)
        return ask();
    const Snapshot& now = m_window.editor().snapshot();
    m_bar.say(tr("Measuring…"));
    m_ruler.measure(*m_row, now.surface, std::exchange(m_places, {}), now.origin);
    m_window.viewport().widget()->update();
}

void MeasureTools::receive(const Ruled& ruled) {
    const QString value = QString::fromStdString(textOf(ruled)), more = spokenMessage(ruled.text);
    m_marks.push_back({ruled.line, value});
    m_lines << (more.isEmpty() || more == value ? value : tr("%1 (%2)").arg(value, more));
    m_bar.say(m_lines.back());
    m_window.viewport().widget()->update();
}

void MeasureTools::clear() {
    m_ruler.cancel();
    m_marks.clear();
    m_lines.clear();
    m_places.clear();
    if (m_row)
        ask();
    m_window.viewport().widget()->update();
}

void MeasureTools::copy() const {
    QApplication::clipboard()->setText(m_lines.join('\n'));
    m_window.tell(m_lines.isEmpty()     ? tr("There is nothing to copy: nothing was measured yet.")
                  : m_lines.size() == 1 ? tr("One result copied.")
                                        : tr("%1 results copied, a line each.").arg(m_lines.size()));
}

void MeasureTools::paint(QPainter& painter, const render::Camera& seen) const {
    if (!m_bar.toggleViewAction()->isChecked())
        return;
    std::vector<base::Vec3d> picked;
    for (const RuledPlace& each : m_places)
        picked.push_back(each.position);
    paintRulers(painter, m_marks, picked, seen, m_window.viewport().widget()->devicePixelRatioF());
}

} // namespace ui
