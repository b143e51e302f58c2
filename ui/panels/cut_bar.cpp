#include "ui/panels/cut_bar.h"

#include <cmath>
#include <QSlider>
#include <QToolButton>

namespace ui {

static QToolButton* checkable(const QString& label, const QString& tip, const QString& name) {
    auto* out = new QToolButton;
    out->setText(label);
    out->setToolTip(tip);
    out->setObjectName(name);
    out->setCheckable(true);
    out->setFocusPolicy(Qt::NoFocus);
    return out;
}

/// Pixels of a slider; the narrow one is for small pictures.
constexpr int wideSlider = 60, narrowSlider = 24;

CutBar::CutBar(QWidget* parent) : QToolBar(tr("Clipping"), parent) {
    setObjectName("clipping");
    setMovable(false);
    build(0, tr("X"), tr("Cut the model across x"));
    build(1, tr("Y"), tr("Cut the model across y"));
    build(2, tr("Z"), tr("Cut the model across z"));
    build(3, tr("Free"), tr("Cut the model across the current direction of view"));
    addSeparator();
    m_section = checkable(tr("Section"), tr("Draw the curves where the planes meet the surface"), "section");
    addWidget(m_section);
    connect(m_section, &QToolButton::toggled, this, [this](bool on) { change([this, on] { m_cuts.section = on; }); });
    refresh();
}

void CutBar::build(std::size_t number, const QString& label, const QString& tip) {
    Row& row = m_rows[number];
    const QString name = QString("cut-%1").arg(number);
    row.on = checkable(label, tip, name);
    row.place = new QSlider(Qt::Horizontal);
    row.place->setObjectName(name + "-place");
    row.place->setRange(0, sliderSteps);
    row.place->setFocusPolicy(Qt::NoFocus);
    row.place->setMinimumWidth(wideSlider);
    row.place->setToolTip(tr("Position of the plane; moving it cuts"));
    row.flip = checkable(tr("⇄"), tr("Show the other side"), name + "-flip");
    addWidget(row.on);
    addWidget(row.place);
    row.flipShown = addWidget(row.flip);
    connect(row.on, &QToolButton::toggled, this, [this, number](bool on) {
        change([this, number, on] { m_cuts.each[number].on = on; });
        if (on && number == Cuts::free && !m_quiet)
            Q_EMIT freeWanted();
    });
    connect(row.flip, &QToolButton::toggled, this, [this, number](bool flipped) {
        change([this, number, flipped] { m_cuts.each[number].flipped = flipped; });
    });
    connect(row.place, &QSlider::valueChanged, this, [this, number](int value) {
        if (m_quiet)
            return;
        if (number == Cuts::free && !m_cuts.each[number].on) // it wants its direction first, and shows that
            Q_EMIT freeWanted();
        change([this, number, value] {
            Cut& cut = m_cuts.each[number];
            cut.on = true; // a slider that moves and does nothing would be a riddle
            const OffsetRange range = offsetRange(m_bounds, cut.normal);
            cut.offset = range.low + (range.high - range.low) * value / sliderSteps;
        });
    });
}

void CutBar::fitInto(int width) {
    const bool narrow = width < 520;
    if (narrow == m_narrow)
        return;
    m_narrow = narrow;
    for (Row& row : m_rows) {
        row.place->setMinimumWidth(narrow ? narrowSlider : wideSlider);
        row.place->setMaximumWidth(narrow ? narrowSlider : QWIDGETSIZE_MAX);
    }
    refresh();
}

void CutBar::change(const std::function<void()>& edit) {
    if (m_quiet)
        return;
    edit();
    refresh();
    Q_EMIT edited(m_cuts);
}

void CutBar::display(const Cuts& cuts, const base::Box3f& bounds) {
    m_cuts = cuts;
    m_bounds = bounds;
    refresh();
}

void CutBar::refresh() {
    m_quiet = true;
    for (std::size_t k = 0; k < m_rows.size(); ++k) {
        const Cut& cut = m_cuts.each[k];
        const OffsetRange range = offsetRange(m_bounds, cut.normal);
        const double part = range.high > range.low ? (cut.offset - range.low) / (range.high - range.low) : 0.5;
        m_rows[k].on->setChecked(cut.on);
        m_rows[k].flip->setChecked(cut.flipped);
        m_rows[k].flip->setEnabled(cut.on);
        m_rows[k].flipShown->setVisible(!m_narrow || cut.on);
        m_rows[k].place->setValue(static_cast<int>(std::lround(part * sliderSteps)));
    }
    m_section->setChecked(m_cuts.section);
    m_quiet = false;
}

} // namespace ui
