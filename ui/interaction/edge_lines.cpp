#include "ui/interaction/edge_lines.h"

#include "core/render/overlay/seam_curves.h"
#include "ui/work/post.h"

namespace ui {

EdgeLines::EdgeLines(const Editor& editor, QObject* parent) : QObject(parent), m_editor(editor) {}

EdgeLines::~EdgeLines() = default;

void EdgeLines::show(bool on) {
    m_shown = on;
    trace();
    Q_EMIT traced();
}

void EdgeLines::trace() {
    const surface::Surface& surface = m_editor.snapshot().surface;
    if (!m_shown || surface.tree().empty()) {
        m_curves.clear();
        m_tracedRoot = nullptr;
        return;
    }
    if (m_tracedRoot == surface.tree().root().get())
        return;
    m_tracedRoot = surface.tree().root().get();
    if (!m_worker)
        m_worker = std::make_unique<LatestWorker<surface::Surface>>(
            [this](const surface::Surface& wanted, const base::Progress& progress) {
                post(this, [this, found = render::seamCurves(wanted, progress)] {
                    m_curves = m_shown ? found : Curves();
                    Q_EMIT traced();
                });
            },
            [this](const std::exception& error) { post(this, [this, text = textOf(error)] { Q_EMIT failed(text); }); });
    m_worker->request(surface, true);
}

} // namespace ui
