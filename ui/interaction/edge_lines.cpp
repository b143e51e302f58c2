#include "ui/interaction/edge_lines.h"

#include "core/cells/any_surface.h"
#include "core/render/overlay/seam_curves.h"
#include "ui/work/post.h"

namespace ui {

using base::Vec3d;
using Curves = std::vector<surface::SectionCurve>;

/// What was traced of a version serves all views of it.
class EdgeLines::Looker {
  public:
    Seen look(const Wanted& wanted, const base::Progress& progress) {
        const void* const root = wanted.surface.tree().root().get();
        if (m_root != root) {
            m_curves = render::seamCurves(wanted.surface, progress);
            m_surface = wanted.surface;
            m_root = root;
        }
        return {root, wanted.camera, m_curves.size(), visibleParts(wanted.camera)};
    }

  private:
    /// By a ray from each point towards the eye.
    Curves visibleParts(const render::Camera& camera) const {
        std::vector<base::Rayf> rays;
        for (const surface::SectionCurve& curve : m_curves)
            for (const surface::SectionPoint& p : curve.points) {
                const Vec3d at = camera.project(p.position), towards = -camera.ray(at.x, at.y).direction;
                // edges are cut a little below where the points would have them
                const Vec3d from = p.position + (p.normal + towards) * (lift * p.unit);
                rays.push_back({base::cast<float>(from), base::cast<float>(towards)});
            }
        std::vector<std::uint8_t> hidden(rays.size());
        intersectAny(m_surface, rays, {}, hidden);
        Curves out;
        std::size_t next = 0;
        for (const surface::SectionCurve& curve : m_curves) {
            bool going = false;
            for (const surface::SectionPoint& p : curve.points) {
                const bool seen = hidden[next++] == 0;
                if (seen && !going)
                    out.emplace_back();
                if (seen)
                    out.back().points.push_back(p);
                going = seen;
            }
        }
        return out;
    }

    static constexpr double lift = 0.05; ///< of h
    const void* m_root = nullptr;
    cells::AnySurface m_surface; ///< holds the version, and so its root's address
    Curves m_curves;
};

EdgeLines::EdgeLines(const Editor& editor, QObject* parent) : QObject(parent), m_editor(editor) {}

EdgeLines::~EdgeLines() = default;

void EdgeLines::show(bool on) {
    m_shown = on;
    m_seen = {};
    m_askedRoot = nullptr;
    Q_EMIT looked();
}

const Curves& EdgeLines::visible(const render::Camera& camera) const {
    static const Curves none;
    const bool now = m_shown && m_seen.root == m_editor.snapshot().surface.tree().root().get();
    return now && m_seen.camera == camera ? m_seen.parts : none;
}

void EdgeLines::look(const render::Camera& camera) {
    const surface::Surface& surface = m_editor.snapshot().surface;
    const void* const root = surface.tree().root().get();
    if (!m_shown || surface.tree().empty() || (m_askedRoot == root && m_askedCamera == camera))
        return;
    m_askedRoot = root;
    m_askedCamera = camera;
    if (!m_worker)
        m_worker = std::make_unique<LatestWorker<Wanted>>(
            [this, looker = std::make_shared<Looker>()](const Wanted& wanted, const base::Progress& progress) {
                post(this, [this, seen = looker->look(wanted, progress)] {
                    m_seen = seen;
                    Q_EMIT looked();
                });
            },
            [this](const std::exception& error) { post(this, [this, text = textOf(error)] { Q_EMIT failed(text); }); });
    m_worker->request({surface, camera}, false);
}

} // namespace ui
