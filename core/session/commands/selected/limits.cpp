#include "core/session/commands/selected/limits.h"

#include "core/base/error.h"

#include <nlohmann/json.hpp>

namespace session {

void requireSurface(const Context& context) {
    if (context.document.surface().definition().manifold == surface::Manifold::Curve)
        throw base::Error("a curve has no such thing", {}, "use it on surfaces");
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
