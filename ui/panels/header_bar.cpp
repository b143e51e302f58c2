#include "ui/panels/header_bar.h"

#include "ui/panels/radius_range.h"
#include "ui/words/words.h"

#include <algorithm>
#include <QMenu>
#include <QToolButton>

namespace ui {

constexpr std::pair<const char*, bool sculpt::MirrorPlanes::*> planeRows[] = {
    {"X", &sculpt::MirrorPlanes::x}, {"Y", &sculpt::MirrorPlanes::y}, {"Z", &sculpt::MirrorPlanes::z}};

/// All of the bar has room at 800 pixels, and at 640.
constexpr int wideSlider = 122, narrowSlider = 56;

HeaderBar::HeaderBar(Settings& settings, QWidget* parent) : QToolBar(tr("Header"), parent), m_settings(settings) {
    setObjectName("header");
    setMovable(false);
    addSliders();
    addSymmetry();
    addMethods();
    addSeparator();
    refresh();
}

QToolButton* HeaderBar::button(const QString& label, const char* name, const QString& tip) {
    auto* out = new QToolButton;
    out->setText(label);
    out->setObjectName(name);
    out->setToolTip(tip);
    out->setFocusPolicy(Qt::NoFocus);
    addWidget(out);
    return out;
}

void HeaderBar::addSliders() {
    m_radius = new NumberSlider(tr("Radius"), tr("Radius of the brush  (F)"), {});
    m_radius->setObjectName("header-radius");
    m_radius->setFixedWidth(wideSlider);
    addWidget(m_radius);
    connect(m_radius, &NumberSlider::edited, this, [this](double value) {
        (m_settings.radiusUnit == RadiusUnit::Pixels ? m_settings.radiusPx : m_settings.radiusModel) = value;
        Q_EMIT edited();
    });
    m_strength = new NumberSlider(tr("Strength"), tr("How much each dab does  (Shift+F)"), {0, 1, false, 2, {}});
    m_strength->setObjectName("header-strength");
    m_strength->setFixedWidth(wideSlider);
    addWidget(m_strength);
    connect(m_strength, &NumberSlider::edited, this, [this](double value) {
        m_settings.edit(m_settings.toolRow()).strength = static_cast<float>(value);
        Q_EMIT edited();
    });
    m_invert = button(tr("+"), "header-invert", tr("The other way: digs instead of builds, as with Ctrl"));
    m_invert->setCheckable(true);
    connect(m_invert, &QToolButton::clicked, this, [this](bool on) {
        m_settings.edit(m_settings.toolRow()).invert = on;
        refresh();
        Q_EMIT edited();
    });
}

void HeaderBar::addSymmetry() {
    m_planes = new QMenu(this);
    for (const auto& [label, plane] : planeRows) {
        QAction* action = m_planes->addAction(tr("Mirror at %1 = 0").arg(QString(label).toLower()));
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [this, plane = plane](bool on) {
            m_settings.shared.symmetry.planes.*plane = on;
            refresh();
            Q_EMIT edited();
        });
    }
    m_symmetry = button(tr("Symmetry"), "header-symmetry", tr("Every dab is made on both sides of these planes"));
    m_symmetry->setMenu(m_planes);
    m_symmetry->setPopupMode(QToolButton::InstantPopup);
}

void HeaderBar::addMethods() {
    m_methods = new QMenu(this);
    m_methods->setToolTipsVisible(true);
    for (const sculpt::MethodRow& row : sculpt::methodTable()) {
        QAction* action = m_methods->addAction(spoken(row.label, "option"));
        action->setToolTip(tr(row.tip));
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [this, method = row.value] {
            m_settings.edit(m_settings.toolRow()).method = method;
            refresh();
            Q_EMIT edited();
        });
    }
    m_method = button({}, "header-method", tr("How the way of the pointer becomes dabs; each tool keeps its own"));
    m_method->setMenu(m_methods);
    m_method->setPopupMode(QToolButton::InstantPopup);
}

void HeaderBar::addPopOver(QMenu& menu, const QString& label) {
    QToolButton* out = button(label, "header-pop-over", menu.title().remove('&'));
    out->setMenu(&menu);
    out->setPopupMode(QToolButton::InstantPopup);
}

void HeaderBar::resizeEvent(QResizeEvent* event) {
    const int wanted = sizeHint().width() + 2 * (wideSlider - m_radius->width());
    const int each = std::clamp(wideSlider - (wanted - width() + 1) / 2, narrowSlider, wideSlider);
    for (NumberSlider* slider : {m_radius, m_strength})
        slider->setFixedWidth(each);
    QToolBar::resizeEvent(event);
}

void HeaderBar::setModelSize(double diagonal) {
    if (diagonal > 0 && std::isfinite(diagonal))
        m_diagonal = diagonal;
    refresh();
}

void HeaderBar::refresh() {
    const sculpt::StrokeSettings choice = m_settings.choice(m_settings.toolRow());
    m_radius->setRange(radiusRange(m_settings, m_diagonal));
    m_radius->setValue(radiusOf(m_settings));
    m_strength->setValue(static_cast<double>(choice.strength));
    m_invert->setChecked(choice.invert);
    m_invert->setText(choice.invert ? tr("−") : tr("+"));
    const auto methods = sculpt::methodTable();
    for (std::size_t k = 0; k < methods.size(); ++k)
        m_methods->actions()[qsizetype(k)]->setChecked(methods[k].value == choice.method);
    m_method->setText(spoken(sculpt::row(choice.method).label, "option"));
    m_method->setEnabled(!sculpt::holds(m_settings.toolRow())); // what is held goes with the pointer
    QString on;
    for (std::size_t k = 0; k < std::size(planeRows); ++k) {
        const bool mirrored = choice.symmetry.planes.*planeRows[k].second;
        m_planes->actions()[qsizetype(k)]->setChecked(mirrored);
        on += mirrored ? planeRows[k].first : "";
    }
    m_symmetry->setText(on.isEmpty() ? tr("Symmetry") : tr("Symmetry %1").arg(on));
}

} // namespace ui
