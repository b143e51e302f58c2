#include "ui/window/notices.h"

#include "ui/window/file_actions.h"
#include "ui/window/work_progress.h"

namespace ui {

Notices::Notices(SculptView& view, const Editor& editor, const FileActions& files, const WorkProgress& progress,
                 QObject* parent)
    : QObject(parent), m_view(view) {
    connect(&files, &FileActions::began, this, &Notices::come);
    connect(&files, &FileActions::ended, this, [this] { come({}); });
    connect(&editor, &Editor::progressed, this, [this](double share, const QString& doing) {
        if (!m_coming.isEmpty()) // the bar has its patience; what is being opened is told at once
            work(doing, share);
    });
    connect(&progress, &WorkProgress::shown, this, [this](double share, const QString& doing) {
        QString what = doing;
        if (m_coming.isEmpty() && !what.isEmpty())
            what = tr("%1 – Esc stops it").arg(what.at(0).toUpper() + what.mid(1));
        work(what, share);
    });
    connect(&progress, &WorkProgress::rested, this, [this] { work({}, -1); });
}

void Notices::come(const QString& what) {
    m_coming = what;
    m_work = {};
    show();
    Q_EMIT comingChanged();
}

void Notices::work(const QString& doing, double share) {
    m_work = {doing, share};
    show();
}

void Notices::refine(const std::optional<Refinement>& refinement) {
    constexpr double patience = 0.6; // seconds
    m_refining = {};
    if (refinement && !refinement->complete && refinement->seconds > patience)
        m_refining = refinement->light > 0
                         ? Notice{tr("Light %1 %").arg(100 * refinement->light, 0, 'f', 0), refinement->light}
                         : Notice{tr("Surface to %1 px…").arg(refinement->quality, 0, 'g', 2), -1};
    show();
}

void Notices::show() {
    if (m_coming.isEmpty())
        return m_view.setNotice(m_work.text.isEmpty() ? m_refining : m_work);
    m_view.setNotice({m_work.text.isEmpty() ? m_coming + "…" : tr("%1: %2").arg(m_coming, m_work.text), m_work.share});
}

} // namespace ui
