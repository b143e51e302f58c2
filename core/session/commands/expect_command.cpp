#include "core/base/error.h"
#include "core/session/commands/commands.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static void expectSurfels(const json& range, std::size_t surfels) {
    const auto least = (range.is_array() ? range[0] : range).get<std::size_t>();
    const auto most = (range.is_array() ? range[1] : range).get<std::size_t>();
    if (surfels < least || surfels > most)
        throw base::Error("expected " + std::to_string(least) + (least == most ? "" : " to " + std::to_string(most)) +
                          " surfels, the model has " + std::to_string(surfels));
}

static void expect(Context& context, const json& complete) {
    if (complete.contains("surfels"))
        expectSurfels(complete["surfels"], context.document.surface().tree().size());
    if (!complete.contains("hash"))
        return;
    const std::string hash = context.document.hash().text();
    if (complete["hash"] != hash)
        throw base::Error("expected the hash " + complete["hash"].get<std::string>() + ", the model has " + hash);
}

CommandRow expectCommand() {
    static const CommandParameter parameters[] = {
        {"surfels", "range", "surfels", "their number, or a list of the least and the greatest", "null", "", 0,
         largestCount},
        {"hash", "text", "", "content hash as `info --json` prints it", "null", "", 0, 0},
    };
    return {"expect", "Expect", "Ends the session with an error if the model differs.", parameters, false, false,
            expect,   nullptr};
}

} // namespace session
