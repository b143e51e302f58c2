#include "core/base/row_of_id.h"
#include "core/session/commands/commands.h"

#include <nlohmann/json.hpp>

namespace session {

static void turn(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const auto axis = complete.at("axis").get<std::string>();
    context.document.turnUp(base::findRow(base::upTable(), axis)->axis, "Up axis");
}

CommandRow upCommand() {
    static const std::string axes = idsOf(base::upTable());
    static const CommandParameter parameters[] = {
        {"axis", "choice", "", "the axis that is upwards", "", axes.c_str(), 0, 0},
    };
    return {"up",
            "Up axis",
            "Says which axis of the model is upwards: views, turntables and the ground follow, no surfel moves.",
            parameters,
            true,
            false,
            turn,
            nullptr};
}

} // namespace session
