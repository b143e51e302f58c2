#include "app/subcommands/scene_info.h"

#include "core/selection/field.h"

#include <nlohmann/json.hpp>

namespace app {

using nlohmann::ordered_json;

namespace {

/// Null where there is nothing.
ordered_json textOf(const base::Box3d& box) {
    if (box.empty())
        return nullptr;
    return {{"min", {box.lo.x, box.lo.y, box.lo.z}}, {"max", {box.hi.x, box.hi.y, box.hi.z}}};
}

base::Box3d boundsOf(const session::SceneModel& model) {
    base::Box3d out;
    model.surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            out.extend(model.pose(base::cast<double>(block.position(slot)) + model.origin()));
    });
    return out;
}

} // namespace

void countParts(ordered_json& out, const tree::SurfelTree& tree) {
    using selection::Field;
    for (const auto& [key, field] : {std::pair("selected", Field::Selection), std::pair("hidden", Field::Hidden)})
        if (const surfel::Attribute* own = tree.layout()->find(selection::attributeName(field));
            own && own->type == surfel::ScalarType::Float32)
            out[key] = sizeOf(selection::selectedIn(tree, field));
}

ordered_json infoOf(const session::Scene& scene) {
    ordered_json models = ordered_json::array();
    std::size_t surfels = 0;
    base::Box3d all;
    for (std::size_t k = 0; k < scene.models.size(); ++k) {
        const session::SceneModel& model = scene.models[k];
        const base::Box3d own = boundsOf(model);
        all.extend(own);
        surfels += model.surface.tree().size();
        models.push_back({{"name", model.name},
                          {"surfels", model.surface.tree().size()},
                          {"bounds", textOf(own)},
                          {"attributes", model.surface.tree().layout()->names()},
                          {"format", model.provenance->format},
                          {"visible", model.visible},
                          {"locked", model.locked},
                          {"active", k == scene.active},
                          {"matrix", session::matrixOf(model.pose)}});
        countParts(models.back(), model.surface.tree());
    }
    return {{"surfels", surfels},
            {"bounds", textOf(all)},
            {"models", models},
            {"hash", session::contentHash(scene).text()}};
}

} // namespace app
