#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"
#include "core/solid/merge.h"

#include <nlohmann/json.hpp>

namespace session {

static void merge(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    solid::Combined result =
        solid::merged(context.document.surface(), complete.at("creases").get<bool>(), context.progress);
    if (result.removed == 0)
        context.messages.push_back("No part of the model lies inside of another.");
    take(context, std::move(result), "Merge parts");
}

CommandRow mergeCommand() {
    static const CommandParameter parameters[] = {creasesParameter()};
    return {"merge",
            "Merge parts",
            "Makes one solid of parts that were pushed into each other: what lies inside of another part goes.",
            parameters,
            true,
            false,
            merge,
            nullptr};
}

} // namespace session
