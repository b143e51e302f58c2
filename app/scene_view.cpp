#include "app/scene_view.h"

#include "core/process/curve_tube.h"
#include "core/selection/hidden.h"
#include "core/session/scene/shown_scene.h"

namespace app {

SceneView sceneView(const session::Document& document, const base::Progress& progress) {
    session::ShownScene shown;
    const session::Scene& scene = document.scene();
    const std::vector<session::ShownModel>& beside = shown.beside(scene, progress);
    SceneView out;
    if (scene.models[scene.active].visible || beside.empty())
        out.models.push_back(process::shownAs(selection::shownOf(document.surface()), progress));
    out.whole = shown.whole(out.models.empty() ? tree::SurfelTree() : out.models.front().tree());
    for (const session::ShownModel& each : beside)
        out.models.push_back(each.surface);
    return out;
}

} // namespace app
