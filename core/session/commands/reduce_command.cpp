#include "core/base/error.h"
#include "core/reduce/refine.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/reduce_wish.h"

#include <nlohmann/json.hpp>

namespace session {

reduce::Wish reduceWish(const nlohmann::json& complete) {
    reduce::Wish out;
    out.count = complete.value("count", std::size_t(0));
    out.ratio = complete.value("ratio", 0.0);
    out.error = complete.value("error", 0.0);
    if ((out.count > 0) + (out.ratio > 0) + (out.error > 0) != 1)
        throw base::Error("\"reduce\" needs one of count, ratio and error", {}, "give one of them, and no other");
    const auto shapes = complete.at("shapes").get<std::string>();
    out.shapes = shapes == "auto"      ? reduce::Shapes::Auto
                 : shapes == "spheres" ? reduce::Shapes::Spheres
                                       : reduce::Shapes::Ellipsoids;
    return out;
}

static void reduceModel(Context& context, const nlohmann::json& complete) {
    const reduce::Wish wish = reduceWish(complete);
    requireModel(context);
    reduce::Reduced result = reduce::reduceBy(context.document.surface(), wish, context.progress);
    context.messages.push_back(reduce::summaryOf(result.report));
    context.document.commit(std::move(result.surface), "Reduce");
}

CommandRow reduceCommand() {
    static const CommandParameter parameters[] = {
        {"count", "integer", "surfels", "how many to keep; give this, ratio or error", "null", "", 1, largestCount},
        {"ratio", "number", "", "the part of them to keep, below 1", "null", "", positive, 1},
        {"error", "number", "model units",
         "as few as keep the model's points this near to the surface, in the root mean square", "null", "", positive,
         largest},
        {"shapes", "choice", "", "of supports; auto takes ellipsoids where they bring the surface clearly nearer",
         "\"auto\"", "auto spheres ellipsoids", 0, 0},
    };
    return {"reduce",
            "Reduce",
            "Makes the same surface with fewer points, placed where the shape needs them and fitted to it.",
            parameters,
            true,
            false,
            reduceModel,
            nullptr};
}

static void refineModel(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    reduce::Refined result =
        reduce::refine(context.document.surface(), complete.at("spacing").get<float>(), context.progress);
    context.messages.push_back(reduce::refinedSummaryOf(result.report, "the surface before"));
    context.document.commit(std::move(result.surface), "Refine");
}

CommandRow refineCommand() {
    static const CommandParameter parameters[] = {
        {"spacing", "number", "model units", "distance between neighbouring points to reach", "", "", positive,
         largest},
    };
    return {"refine",
            "Refine",
            "Samples the surface of a reduced model densely and evenly, as it is, with supports of the usual size.",
            parameters,
            true,
            false,
            refineModel,
            nullptr};
}

} // namespace session
