#include "core/base/error.h"
#include "core/session/commands/commands.h"
#include "core/session/number_text_list.h"
#include "core/solid/loops/bridge.h"

#include <nlohmann/json.hpp>

namespace session {

/// None where they are left to the model.
static std::optional<std::array<std::size_t, 2>> loopsOf(const nlohmann::json& complete) {
    if (!complete.contains("loops"))
        return {};
    std::array<std::size_t, 2> out{};
    const std::vector<double> given = numbersOf(complete.at("loops").get<std::string>(), "loops", 2, 2);
    for (std::size_t k = 0; k < 2; ++k) {
        if (!(given[k] >= 0 && given[k] < largestCount && given[k] == std::floor(given[k])))
            throw base::Error("\"loops\" are no numbers of boundary loops", {}, "they count from 0, the longest");
        out[k] = static_cast<std::size_t>(given[k]);
    }
    return out;
}

static void bridge(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    solid::Bridged result = solid::bridge(context.document.surface(), loopsOf(complete), context.progress);
    context.messages.push_back("boundary loops " + std::to_string(result.loops[0]) + " and " +
                               std::to_string(result.loops[1]) + " are bridged with " + std::to_string(result.surfels) +
                               " points");
    context.figures["surfels"] = static_cast<double>(result.surfels);
    context.document.commit(std::move(result.surface), "Bridge loops");
}

CommandRow bridgeCommand() {
    static const CommandParameter parameters[] = {
        {"loops", "text", "",
         "two boundary loops by number, 0,1: longest first, from 0; may be left out where there are just two", "null",
         "", 0, 0},
    };
    return {"bridge",
            "Bridge loops",
            "Joins two boundary loops by a sheet that goes on from the surface at both, with points as dense as there.",
            parameters,
            true,
            false,
            bridge,
            nullptr};
}

} // namespace session
