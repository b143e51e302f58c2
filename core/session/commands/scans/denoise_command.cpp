#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"

#include <nlohmann/json.hpp>

namespace session {

static void runDenoise(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface surface = context.document.surface();
    clean::commit(context, clean::denoise(context, surface, complete.at("sigma")), "Denoise", layers::How::Keep);
}

CommandRow denoiseCommand() {
    static const CommandParameter parameters[] = {
        {"sigma", "number or choice", "model units", clean::sigmaTip, "\"auto\"", "auto", positive, largest},
    };
    return {
        "denoise",
        "Denoise",
        "Moves points onto the surface that they and their neighbours mean, without shrinking it; masked ones stay.",
        parameters,
        true,
        false,
        runDenoise,
        nullptr};
}

} // namespace session
