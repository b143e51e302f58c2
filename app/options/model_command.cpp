#include "app/options/model_command.h"

#include "app/open_model.h"
#include "app/options/output_names.h"
#include "app/writable_models.h"
#include "core/process/estimation/part_progress.h"

#include <nlohmann/json.hpp>

namespace app {

void addModelAndOutput(OptionSet command, ModelCommand& options, const char* name) {
    command.add(name, options.model, modelHelp).required();
    command.add("-o,--output", options.out, "model to write; .ply keeps everything").typeName("OUT").required();
}

Action addModelCommand(OptionSet command, const char* op) {
    auto options = std::make_shared<ModelCommand>();
    addModelAndOutput(command, *options);
    for (const session::CommandParameter& p : session::command(op).parameters) {
        if (p.id == std::string_view("creases"))
            continue;
        Option option = addParameter(command, op, p, helpOf(p), options->wish);
        if (!*p.fallback)
            option.required();
    }
    options->surface = addSurfaceOptions(command, false);
    return [options, op](Console& console) { runModelCommand(*options, op, nlohmann::json::object(), console); };
}

void runModelCommand(const ModelCommand& options, const char* op, const nlohmann::json& given, Console& console,
                     const std::function<void(const session::Context&)>& then) {
    requireOutputs({{"-o", options.out}});
    requireModelName(options.out);
    nlohmann::json command = parametersOf(options.wish);
    command["op"] = op;
    command.update(given);
    const base::Progress progress = console.progress();
    session::Document document;
    session::Context context{document, {}, process::part(progress, 0, 0.3), {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    context.progress = process::part(progress, 0.3, 0.8);
    session::run(context, command);
    session::run(context, {{"op", "save"}, {"path", options.out}});
    context.progress = process::part(progress, 0.8, 1);
    if (then)
        then(context);
    console.tell(context.messages);
}

} // namespace app
