// The edges that stay sharp as lines over the picture: traced, and looked at by rays for what hides them, in the
// background whenever model and view rest. While either moves there are none. Interface's thread only.
#pragma once

#include "core/render/overlay/section_lines.h"
#include "ui/work/editor.h"
#include "ui/work/latest_worker.h"

#include <memory>

namespace ui {

class EdgeLines : public QObject {
    Q_OBJECT
  public:
    /// The editor outlives it.
    explicit EdgeLines(const Editor& editor, QObject* parent = nullptr);
    ~EdgeLines() override;

    void show(bool on);
    bool shown() const { return m_shown; }
    /// How many the model has, as it was traced last.
    std::size_t count() const { return m_shown ? m_seen.count : 0; }
    /// Those parts that the camera sees of the model as it is; empty until somebody has looked.
    const std::vector<surface::SectionCurve>& visible(const render::Camera& camera) const;
    /// Asks for what this camera sees of the model as it is now, unless that is there or on its way.
    void look(const render::Camera& camera);

  Q_SIGNALS:
    void looked();                ///< there is something new
    void failed(QString message); ///< tracing stopped, and why

  private:
    struct Wanted {
        surface::Surface surface;
        render::Camera camera;
    };
    struct Seen {
        const void* root = nullptr; ///< of the version
        render::Camera camera;
        std::size_t count = 0;
        std::vector<surface::SectionCurve> parts;
    };
    class Looker; ///< on the worker's thread

    const Editor& m_editor;
    bool m_shown = false;
    Seen m_seen;
    const void* m_askedRoot = nullptr;
    render::Camera m_askedCamera;
    std::unique_ptr<LatestWorker<Wanted>> m_worker; ///< last: its thread ends first
};

} // namespace ui
