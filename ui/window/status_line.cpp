#include "ui/window/status_line.h"

#include "ui/panels/elided_label.h"
#include "ui/theme/icon.h"
#include "ui/theme/theme.h"
#include "ui/words/counted.h"

#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QRegularExpression>
#include <QToolButton>
#include <QWidgetAction>

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

/// Three digits, and no exponents where plain digits do.
static QString lengthText(double length) {
    constexpr double large = 999.5, endless = 1e9;
    return length >= large && length < endless ? counted(static_cast<qulonglong>(std::llround(length)))
                                               : QString::number(length, 'g', 3);
}

QString sentenceOf(const QString& message) {
    QString out = message.trimmed();
    const QString first = out.section(' ', 0, 0);
    // A name stays as it is written: "bunny.ply" is a file, "max" no sentence's beginning.
    if (!out.isEmpty() && !first.contains(QRegularExpression("[./_0-9\"]")))
        out[0] = out[0].toUpper();
    const QString last = out.section(' ', -1);
    if (!out.isEmpty() && out.back().isLetterOrNumber() && !last.contains(QRegularExpression("[./]")))
        out += '.';
    return out;
}

QLabel* StatusLine::cell(const QString& tip) {
    auto* label = new QLabel;
    label->setObjectName("cell");
    label->setToolTip(tip);
    label->hide();
    addPermanentWidget(label);
    return label;
}

StatusLine::StatusLine(QWidget* parent) : QStatusBar(parent), m_message(new ElidedLabel) {
    setSizeGripEnabled(false);
    m_message->setTextFormat(Qt::PlainText);
    m_message->setIndent(8);
    m_message->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    addWidget(m_message, 1);
    m_more = new QToolButton;
    m_more->setObjectName("plain");
    m_more->setToolTip(tr("All that was told at last"));
    connect(m_more, &QToolButton::clicked, this, &StatusLine::showAll);
    m_more->hide();
    addWidget(m_more);
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
    m_frame = cell({});
    m_dab = cell(tr("Time taken by the last dab, resampling included"));
    hideProgress();
    m_stale.setSingleShot(true);
    connect(&m_stale, &QTimer::timeout, this, [this] {
        m_message->setText(m_hint);
        m_message->setToolTip(m_hint);
        m_message->setStyleSheet("color: palette(placeholder-text);");
    });
}

/// Frames that take less than this are told as "less than".
static QString milliseconds(double seconds) {
    constexpr double least = 1e-4;
    if (seconds < least)
        return QString("< %1 ms").arg(least * 1000);
    return QString("%1 ms").arg(seconds * 1000, 0, 'f', seconds < 0.01 ? 1 : 0);
}

void StatusLine::want(QLabel* cell, bool wanted, const QString& text) {
    cell->setText(text);
    if (wanted)
        m_wanted.insert(cell);
    else
        m_wanted.remove(cell);
    fit();
}

/// The most wanted first; the message keeps some room.
void StatusLine::fit() {
    constexpr int forMessage = 180, gap = 8;
    int room = width() - forMessage - (m_progress->isHidden() ? 0 : m_progress->width() + m_stop->sizeHint().width());
    for (QLabel* cell : {m_surfels, m_truth, m_dab, m_frame, m_spacing, m_memory}) {
        const int needed = cell->sizeHint().width() + gap;
        const bool shown = m_wanted.contains(cell) && needed <= room;
        if (shown)
            room -= needed;
        cell->setVisible(shown);
    }
}

void StatusLine::resizeEvent(QResizeEvent* event) {
    QStatusBar::resizeEvent(event);
    fit();
}

void StatusLine::showModel(const Snapshot& snapshot) {
    const bool model = !snapshot.surface.tree().empty();
    want(m_surfels, model, tr("%1 surfels").arg(counted(snapshot.surfels)));
    want(m_memory, model, tr("%1 + %2").arg(bytesText(snapshot.modelBytes), bytesText(snapshot.historyBytes)));
    want(m_spacing, model, tr("Spacing %1").arg(lengthText(static_cast<double>(snapshot.spacing))));
    want(m_dab, snapshot.dabSeconds > 0, tr("Dab %1").arg(milliseconds(snapshot.dabSeconds)));
}

void StatusLine::showFrame(double seconds, const QString& renderer) {
    want(m_frame, true, tr("Frame %1").arg(milliseconds(seconds)));
    m_frame->setToolTip(tr("Time to draw the last picture; %1").arg(renderer));
}

void StatusLine::showRefinement(const std::optional<Refinement>& refinement) {
    if (!refinement || refinement->quality <= 0)
        return want(m_truth, refinement.has_value(), tr("Surface …"));
    QString text =
        tr("Surface to %1 px, %2").arg(refinement->quality, 0, 'g', 2).arg(milliseconds(refinement->seconds));
    if (refinement->light > 0 && !refinement->complete)
        text += tr(", light %1 %").arg(100 * refinement->light, 0, 'f', 0);
    want(m_truth, true, refinement->complete ? text : text + " …");
}

void StatusLine::showProgress(double share, const QString& doing) {
    QString what = doing;
    if (!what.isEmpty())
        what[0] = what[0].toUpper();
    m_progress->setValue(static_cast<int>(share * 1000));
    m_progress->setFormat(what + "  %p%");
    m_progress->show();
    m_stop->show();
    fit();
}

void StatusLine::hideProgress() {
    m_progress->hide();
    m_stop->hide();
    fit();
}

void StatusLine::tell(const QString& message, bool error) {
    constexpr int toReadMs = 10000, toActMs = 60000;
    m_told = message.split('\n', Qt::SkipEmptyParts);
    for (QString& each : m_told)
        each = sentenceOf(each);
    constexpr qsizetype few = 4; // of more, the last one sums up
    const auto count = static_cast<int>(m_told.size());
    m_message->setText(m_told.size() <= few ? m_told.join(' ') : m_told.back());
    m_message->setToolTip(m_told.join('\n'));
    m_message->setStyleSheet(error ? troubleStyle(palette()) : QString());
    m_more->setVisible(count > 1);
    m_more->setText(tr("%1 messages").arg(count));
    m_stale.start(std::max(1, count) * (error ? toActMs : toReadMs));
}

QString StatusLine::allTold() const {
    return m_told.join('\n');
}

/// Above the button, until somebody clicks elsewhere.
void StatusLine::showAll() {
    constexpr int letters = 90; // a line
    QMenu menu(this);
    auto* text = new QLabel(allTold());
    text->setObjectName("allTold");
    text->setTextFormat(Qt::PlainText);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text->setWordWrap(true);
    text->setMargin(10);
    text->setFixedWidth(std::min(letters * fontMetrics().averageCharWidth(), window()->width() - 40));
    auto* action = new QWidgetAction(&menu);
    action->setDefaultWidget(text);
    menu.addAction(action);
    menu.exec(m_more->mapToGlobal(QPoint(0, -menu.sizeHint().height())));
}

void StatusLine::setHint(const QString& hint) {
    const bool shown = m_message->text().isEmpty() || m_message->text() == m_hint;
    m_hint = hint;
    if (shown)
        m_stale.start(0);
}

QString StatusLine::message() const {
    return m_message->text();
}

} // namespace ui
