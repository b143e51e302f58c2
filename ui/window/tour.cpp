#include "ui/window/tour.h"

#include "ui/window/main_window.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

static TourStart now(MainWindow& window) {
    return {window.editor().snapshot().surface.tree(), window.sculptView().motion().camera().eye,
            window.sculptView().sizing().radiusPx()};
}

namespace {

bool turned(MainWindow& window, const TourStart& start) {
    return distance(now(window).eye, start.eye) > 0;
}

bool sculpted(MainWindow& window, const TourStart& start) {
    return !window.editor().busy() && window.editor().snapshot().canUndo && !(now(window).model == start.model);
}

bool smoothed(MainWindow& window, const TourStart& start) {
    return sculpted(window, start) &&
           window.editor().snapshot().undoLabel == sculpt::tool(window.settings().shiftTool).label;
}

bool resized(MainWindow& window, const TourStart& start) {
    return now(window).radius != start.radius;
}

bool undone(MainWindow& window, const TourStart&) {
    return window.editor().snapshot().canRedo;
}

bool trueShown(MainWindow& window, const TourStart&) {
    return window.settings().truth.on;
}

bool selected(MainWindow& window, const TourStart& start) {
    return window.editor().snapshot().undoLabel == "Select" && !(now(window).model == start.model);
}

constexpr TourStep steps[] = {
    {QT_TR_NOOP("Turn the model"),
     QT_TR_NOOP("Drag beside the model, or anywhere with the right button. The wheel zooms, the middle button pans; "
                "Home shows all of it again."),
     turned},
    {QT_TR_NOOP("Sculpt"), QT_TR_NOOP("Drag over the model. Ctrl held digs where it would raise."), sculpted},
    {QT_TR_NOOP("Smooth"), QT_TR_NOOP("Hold Shift and drag: whatever the tool, Shift smooths."), smoothed},
    {QT_TR_NOOP("Size of the brush"),
     QT_TR_NOOP("Press F, move the pointer, click. Shift+F does the same for the strength."), resized},
    {QT_TR_NOOP("Take it back"),
     QT_TR_NOOP("Ctrl+Z goes a step back, Ctrl+Shift+Z forward. Ctrl+H lists all steps, by name."), undone},
    {QT_TR_NOOP("The surface itself"),
     QT_TR_NOOP("Press F6: rays find the surface that the points define, and it grows out of the splats. F6 again goes "
                "back."),
     trueShown},
    {QT_TR_NOOP("Select"),
     QT_TR_NOOP(
         "Press B, choose Lasso and draw around a part: it turns orange, and commands work on it alone. Esc goes "
         "back to sculpting."),
     selected},
    {QT_TR_NOOP("Where everything is"),
     QT_TR_NOOP("F3 finds any action by a few letters. Shift+F1 lists the keys, F1 opens the manual. The line below "
                "says what the pointer does now."),
     nullptr},
};

constexpr int looksPerSecond = 8;

} // namespace

std::span<const TourStep> tourTable() {
    return steps;
}

static QToolButton* button(const QString& text) {
    auto* out = new QToolButton;
    out->setObjectName("plain");
    out->setText(text);
    return out;
}

Tour::Tour(MainWindow& window)
    : FloatingCard(*window.viewport().widget(), Place::TopLeft, {}), m_window(window), m_text(new QLabel),
      m_count(new QLabel), m_back(button(tr("Back"))), m_next(button(tr("Next"))) {
    constexpr int width = 300;
    m_text->setWordWrap(true);
    m_text->setFixedWidth(width);
    m_text->setTextInteractionFlags(Qt::NoTextInteraction);
    column().addWidget(m_text);
    m_count->setObjectName("faint");
    QToolButton* end = button(tr("End"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_count);
    row->addStretch();
    for (QToolButton* each : {m_back, m_next, end})
        row->addWidget(each);
    column().addLayout(row);
    connect(m_back, &QToolButton::clicked, this, [this] { go(m_step - 1); });
    connect(m_next, &QToolButton::clicked, this, [this] { go(m_step + 1); });
    connect(end, &QToolButton::clicked, this, &Tour::close);
    auto* clock = new QTimer(this);
    connect(clock, &QTimer::timeout, this, &Tour::look);
    clock->start(1000 / looksPerSecond);
    go(0);
}

void Tour::go(int step) {
    const auto count = static_cast<int>(tourTable().size());
    if (step >= count)
        return void(close());
    m_step = std::max(step, 0);
    m_doneFor = 0;
    m_start = now(m_window);
    const TourStep& row = tourTable()[static_cast<std::size_t>(m_step)];
    setTitle(tr(row.title));
    m_text->setText(tr(row.text));
    m_count->setText(tr("%1 of %2").arg(m_step + 1).arg(count));
    m_back->setEnabled(m_step > 0);
    m_next->setText(m_step + 1 == count ? tr("Done") : tr("Next"));
}

/// A step stays for a second after it was done, so that what came of it is seen.
void Tour::look() {
    const TourStep& row = tourTable()[static_cast<std::size_t>(m_step)];
    if (!row.done || !(m_doneFor > 0 || row.done(m_window, m_start)))
        return;
    if (m_doneFor++ == 0)
        m_count->setText(tr("%1 of %2: done").arg(m_step + 1).arg(tourTable().size()));
    else if (m_doneFor > looksPerSecond)
        go(m_step + 1);
}

} // namespace ui
