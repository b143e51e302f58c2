#include "app/subcommands/scene_info.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace app {

using nlohmann::ordered_json;

namespace {

struct Bounds {
    base::Vec3d min{1e300, 1e300, 1e300}, max{-1e300, -1e300, -1e300};

    void extend(const base::Vec3d& x) {
        for (std::size_t k = 0; k < 3; ++k)
            min[k] = std::min(min[k], x[k]), max[k] = std::max(max[k], x[k]);
    }
    ordered_json text() const { return {{"min", {min.x, min.y, min.z}}, {"max", {max.x, max.y, max.z}}}; }
};

Bounds boundsOf(const session::SceneModel& model) {
    Bounds out;
    model.surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            out.extend(model.pose(base::cast<double>(block.position(slot)) + model.origin()));
    });
    return out;
}

} // namespace

ordered_json infoOf(const session::Scene& scene) {
    ordered_json models = ordered_json::array();
    std::size_t surfels = 0;
    Bounds all;
    for (std::size_t k = 0; k < scene.models.size(); ++k) {
        const session::SceneModel& model = scene.models[k];
        const Bounds own = boundsOf(model);
        all.extend(own.min);
        all.extend(own.max);
        surfels += model.surface.tree().size();
        models.push_back({{"name", model.name},
                          {"surfels", model.surface.tree().size()},
                          {"bounds", own.text()},
                          {"attributes", model.surface.tree().layout()->names()},
                          {"format", model.provenance->format},
                          {"visible", model.visible},
                          {"locked", model.locked},
                          {"active", k == scene.active},
                          {"matrix", session::matrixOf(model.pose)}});
    }
    return {
        {"surfels", surfels}, {"bounds", all.text()}, {"models", models}, {"hash", session::contentHash(scene).text()}};
}

} // namespace app
