#include "ui/window/work_progress.h"

#include "ui/window/status_line.h"
#include "ui/work/editor.h"
#include "ui/work/measurer.h"
#include "ui/work/mesher.h"

namespace ui {

WorkProgress::WorkProgress(Editor& editor, Measurer& measurer, Mesher& mesher, StatusLine& status, QObject* parent)
    : QObject(parent), m_editor(editor), m_measurer(measurer), m_mesher(mesher), m_status(status) {
    connect(&editor, &Editor::progressed, this, &WorkProgress::show);
    connect(&measurer, &Measurer::progressed, this, &WorkProgress::show);
    connect(&mesher, &Mesher::progressed, this, &WorkProgress::show);
    connect(&editor, &Editor::idled, this, &WorkProgress::rest);
    connect(&measurer, &Measurer::idled, this, &WorkProgress::rest);
    connect(&mesher, &Mesher::idled, this, &WorkProgress::rest);
    connect(&status, &StatusLine::cancelled, this, &WorkProgress::stop);
}

bool WorkProgress::working() const {
    return m_editor.working() || m_measurer.busy() || m_mesher.busy();
}

void WorkProgress::show(double share, const QString& doing) {
    if (!m_since.isValid())
        m_since.start();
    if (working() && m_since.elapsed() >= patienceMs) {
        m_status.showProgress(share, doing);
        Q_EMIT shown(share, doing);
    }
}

void WorkProgress::rest() {
    if (working())
        return;
    m_since.invalidate();
    m_status.hideProgress();
    Q_EMIT rested();
}

/// A stroke is no work that may be stopped here: the cancel flag would end its dab.
void WorkProgress::stop() {
    if (m_editor.working())
        m_editor.cancelWork();
    m_measurer.cancel();
    m_mesher.cancel();
}

} // namespace ui
