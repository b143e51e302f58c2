#include "core/session/commands/selected/limits.h"

#include "core/base/error.h"
#include "core/io/origin_choice.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/scans/viewpoints.h"
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

/// Where stored coordinates are counted from once all of the model has moved: from where they are now, unless float32
/// would lose much there, as where scans millions of units out come to zero.
static base::Vec3d originAfter(const Document& document, const selection::Affine& map) {
    constexpr std::size_t most = 4096;
    const tree::SurfelTree& tree = document.surface().tree();
    const std::size_t stride = std::max<std::size_t>(1, tree.size() / most);
    std::vector<base::Vec3d> sample;
    std::size_t next = 0, at = 0;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (; next < at + static_cast<std::size_t>(block.size()); next += stride)
            sample.push_back(map(base::cast<double>(block.position(static_cast<int>(next - at)))));
        at += static_cast<std::size_t>(block.size());
    });
    const base::Vec3d now = document.provenance().origin;
    if (io::chooseOrigin(sample, tree.size()) == base::Vec3d())
        return now;
    for (base::Vec3d& each : sample)
        each += now;
    return io::chooseOrigin(sample, tree.size());
}

static void commitWhole(Context& context, selection::Affine map, const std::string& label) {
    Document& document = context.document;
    if (map.isNothing())
        return;
    const base::Vec3d origin = originAfter(document, map);
    std::vector<std::string> comments = movedViewpoints(
        document.provenance().comments, *document.surface().tree().layout(), map.about(document.provenance().origin));
    map.shift += document.provenance().origin - origin;
    const surface::Surface next = selection::transformed(document.surface(), map, selection::Limit::Everything);
    document.commitMoved(
        {layers::mapped(next.tree(), document.layers(), map.linear, map.shift), moved(next.definition(), map)}, origin,
        label);
    const auto provenance = std::make_shared<Provenance>(document.provenance());
    provenance->comments = std::move(comments);
    Scene scene = document.scene();
    scene.models[scene.active].provenance = provenance;
    document.amend(std::move(scene)); // the same step
}

void commitMoved(Context& context, const selection::Affine& map, selection::Limit limit, const std::string& label) {
    if (limit == selection::Limit::Everything)
        return commitWhole(context, map, label);
    const surface::Surface& now = context.document.surface();
    if (now.definition().manifold == surface::Manifold::Complex)
        throw base::Error("a part of a complex cannot be moved away from the rest", {}, "move all of it");
    clean::commit(context, selection::transformed(now, map, limit), label, layers::How::Record);
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
