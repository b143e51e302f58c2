#include "ui/window/status_line.h"

#include "ui/theme/icon.h"

#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QToolButton>

namespace ui {

QString bytesText(std::size_t bytes) {
    static const char* const units[] = {"B", "kB", "MB", "GB", "TB"};
    double value = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; value >= 999.5 && unit + 1 < std::size(units); ++unit)
        value /= 1000;
    const int decimals = unit == 0 || value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
    return QString("%1 %2").arg(value, 0, 'f', decimals).arg(units[unit]);
}

QLabel* StatusLine::cell(const QString& tip) {
    auto* label = new QLabel;
    label->setObjectName("cell");
    label->setToolTip(tip);
    addPermanentWidget(label);
    return label;
}

StatusLine::StatusLine(QWidget* parent) : QStatusBar(parent), m_message(new QLabel) {
    setSizeGripEnabled(false);
    m_message->setTextFormat(Qt::PlainText);
    m_message->setIndent(8);
    m_message->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    addWidget(m_message, 1);
    m_progress = new QProgressBar;
    m_progress->setFixedWidth(260);
    m_progress->setRange(0, 1000);
    m_stop = new QToolButton;
    m_stop->setIcon(icon("stop"));
    m_stop->setToolTip(tr("Stop; the model stays as it is  (Esc)"));
    connect(m_stop, &QToolButton::clicked, this, &StatusLine::cancelled);
    addPermanentWidget(m_progress);
    addPermanentWidget(m_stop);
    m_surfels = cell(tr("Number of surfels in the model"));
    m_memory = cell(tr("Memory used by the model + by its history"));
    m_spacing = cell(tr("Typical distance between neighbouring surfels, in model units"));
    m_truth = cell(tr("The true surface: accuracy reached, and time since the view came to rest"));
    m_truth->hide();
    m_frame = cell({});
    m_dab = cell(tr("Time taken by the last dab, resampling included"));
    hideProgress();
}

static QString milliseconds(double seconds) {
    return QString("%1 ms").arg(seconds * 1000, 0, 'f', seconds < 0.01 ? 1 : 0);
}

void StatusLine::showModel(const Snapshot& snapshot) {
    for (QLabel* label : {m_surfels, m_memory, m_spacing})
        label->setVisible(!snapshot.surface.tree().empty());
    m_surfels->setText(tr("%1 surfels").arg(QLocale::c().toString(qulonglong(snapshot.surfels))));
    m_memory->setText(tr("%1 + %2").arg(bytesText(snapshot.modelBytes), bytesText(snapshot.historyBytes)));
    m_spacing->setText(tr("spacing %1").arg(static_cast<double>(snapshot.spacing), 0, 'g', 3));
    m_dab->setVisible(snapshot.dabSeconds > 0);
    m_dab->setText(tr("dab %1").arg(milliseconds(snapshot.dabSeconds)));
}

void StatusLine::showFrame(double seconds, const QString& renderer) {
    m_frame->setText(tr("frame %1").arg(milliseconds(seconds)));
    m_frame->setToolTip(tr("Time to draw the last picture; %1").arg(renderer));
}

void StatusLine::showRefinement(const std::optional<Refinement>& refinement) {
    m_truth->setVisible(refinement.has_value());
    if (!refinement || refinement->quality <= 0)
        return m_truth->setText(tr("surface …"));
    QString text =
        tr("surface to %1 px, %2").arg(refinement->quality, 0, 'g', 2).arg(milliseconds(refinement->seconds));
    if (refinement->light > 0 && !refinement->complete)
        text += tr(", light %1 %").arg(100 * refinement->light, 0, 'f', 0);
    m_truth->setText(refinement->complete ? text : text + " …");
}

void StatusLine::showProgress(double share, const QString& doing) {
    m_progress->setValue(static_cast<int>(share * 1000));
    m_progress->setFormat(doing + "  %p%");
    m_progress->show();
    m_stop->show();
}

void StatusLine::hideProgress() {
    m_progress->hide();
    m_stop->hide();
}

void StatusLine::tell(const QString& message, bool error) {
    m_message->setText(message);
    m_message->setToolTip(message);
    m_message->setStyleSheet(error ? "color: #ff8a75;" : QString());
}

QString StatusLine::message() const {
    return m_message->text();
}

} // namespace ui
