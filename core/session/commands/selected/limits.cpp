#include "core/session/commands/selected/limits.h"

#include "core/base/error.h"
#include "core/session/commands/scans/clean_steps.h"

#include <nlohmann/json.hpp>

namespace session {

void requireSurface(const Context& context) {
    if (context.document.surface().definition().manifold == surface::Manifold::Curve)
        throw base::Error("a curve has no such thing", {}, "use it on surfaces");
}

void commitMoved(Context& context, const selection::Affine& map, selection::Limit limit, const std::string& label) {
    surface::Surface next = selection::transformed(context.document.surface(), map, limit);
    const bool whole = limit == selection::Limit::Everything;
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
