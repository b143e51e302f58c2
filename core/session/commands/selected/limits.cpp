#include "core/session/commands/selected/limits.h"

#include "core/base/error.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/surface/definition_text.h"

#include <nlohmann/json.hpp>

namespace session {

void requireSurface(const Context& context) {
    if (context.document.surface().definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(context.document.surface().definition().manifold) + " has no such thing", {},
                          "use it on surfaces");
}

/// What a complex prescribes goes along: tangents of curves as such, the normals of patches as normals do.
static surface::SurfaceDefinition moved(surface::SurfaceDefinition definition, const selection::Affine& map) {
    if (!definition.connectivity || definition.connectivity->tangents.empty())
        return definition;
    auto next = std::make_shared<surface::Connectivity>(*definition.connectivity);
    const base::Mat3d forNormals = base::cofactor(map.linear);
    for (surface::PrescribedTangent& each : next->tangents) {
        const bool ofPatches = each.cells.empty() || next->cells[each.cells.front()].dimension == 2;
        each.position = base::cast<float>(map(base::cast<double>(each.position)));
        each.direction =
            base::cast<float>(normalized((ofPatches ? forNormals : map.linear) * base::cast<double>(each.direction)));
    }
    definition.connectivity = std::move(next);
    return definition;
}

void commitMoved(Context& context, const selection::Affine& map, selection::Limit limit, const std::string& label) {
    const bool whole = limit == selection::Limit::Everything;
    const surface::SurfaceDefinition& definition = context.document.surface().definition();
    if (!whole && definition.manifold == surface::Manifold::Complex)
        throw base::Error("a part of a complex cannot be moved away from the rest", {}, "move all of it");
    surface::Surface next = selection::transformed(context.document.surface(), map, limit);
    if (whole && !map.isNothing())
        next = {next.tree(), moved(definition, map)};
    if (whole && !(next.tree() == context.document.surface().tree()))
        next = {layers::mapped(next.tree(), context.document.layers(), map.linear, map.shift), next.definition()};
    clean::commit(context, std::move(next), label, whole ? layers::How::Keep : layers::How::Record);
}

void requireSelection(const Context& context) {
    if (selection::selectedIn(context.document.surface().tree()).empty())
        throw base::Error("nothing is selected", {}, "select something first");
}

selection::Limit limitOf(const Context& context, const nlohmann::json& complete) {
    const auto of = complete.at("of").get<std::string>();
    if (of == "selection")
        requireSelection(context);
    const bool all = of == "all" || selection::selectedIn(context.document.surface().tree()).empty();
    return all ? selection::Limit::Everything : selection::Limit::Selection;
}

} // namespace session
