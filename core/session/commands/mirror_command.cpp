#include "core/layers/symmetric.h"
#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"
#include "core/solid/mirror.h"

#include <nlohmann/json.hpp>

namespace session {

static void mirror(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    base::Plane plane = planeOf(complete.at("plane").get<std::string>(), context.document.provenance().origin);
    if (complete.at("keep") == "below")
        plane = plane.flipped();
    const surface::Surface& before = context.document.surface();
    const layers::Stack& stack = context.document.layers();
    if (stack.empty())
        return context.document.commit(solid::mirrored(before, plane, context.progress), "Mirror");
    const auto carried = [&](const surfel::SurfelList& half) {
        const tree::SurfelTree tree = tree::SurfelTree::build(half);
        return layers::reconciled(before.tree(), tree, stack, layers::How::Carry).surfels();
    };
    const surface::Surface next = solid::mirrored(before, plane, context.progress, carried);
    context.document.commit({layers::symmetric(next.tree(), stack, plane), next.definition()}, "Mirror",
                            layers::How::Keep);
}

CommandRow mirrorCommand() {
    static const CommandParameter parameters[] = {
        {"plane", "text", "", "the points where nx*x + ny*y + nz*z = d, as nx,ny,nz,d", "", "", 0, 0},
        {"keep", "choice", "", "which side is kept and mirrored; above is where the plane's normal points to",
         "\"above\"", "above below", 0, 0},
    };
    return {"mirror",   "Mirror", "Makes the model symmetric: one side and its mirror image, welded at a plane.",
            parameters, true,     false,
            mirror,     nullptr};
}

} // namespace session
