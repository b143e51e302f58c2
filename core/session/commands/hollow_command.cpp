#include "core/solid/hollow.h"

#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"

#include <nlohmann/json.hpp>

namespace session {

static void hollow(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    tellOfGuess(context, context.document.surface());
    take(context, solid::hollowed(context.document.surface(), complete.at("thickness").get<double>(), context.progress),
         "Hollow");
}

CommandRow hollowCommand() {
    static const CommandParameter parameters[] = {
        {"thickness", "number", "model units", "of the walls", "", "", positive, largest},
    };
    return {"hollow",
            "Hollow",
            "Gives the model an inner wall and leaves it empty within; drill a hole to let out what is in there.",
            parameters,
            true,
            false,
            hollow,
            nullptr};
}

} // namespace session
