#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"
#include "core/solid/merge.h"

#include <nlohmann/json.hpp>

namespace session {

static void merge(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    solid::Combined result =
        solid::merged(context.document.surface(), complete.at("creases").get<bool>(), context.progress);
    const char* const others = context.document.scene().models.size() > 1
                                   ? "; other models of the scene are parts of it once they are joined (scene)"
                                   : "";
    take(context, std::move(result), "Merge parts", std::string("no part of it lies inside of another") + others);
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
