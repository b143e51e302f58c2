#include "app/options/model_command.h"

#include "app/open_model.h"

#include <nlohmann/json.hpp>

namespace app {

void addModelAndOutput(OptionSet command, ModelCommand& options, const char* name) {
    command.add(name, options.model, modelHelp).required();
    command.add("-o,--output", options.out, "model to write; .ply keeps everything").typeName("OUT").required();
}

void runModelCommand(const ModelCommand& options, const char* op, const nlohmann::json& given, Console& console,
                     const std::function<void(const session::Context&)>& then) {
    nlohmann::json command = parametersOf(options.wish);
    command["op"] = op;
    command.update(given);
    session::Document document;
    session::Context context{document, {}, console.progress(), {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    session::run(context, command);
    session::run(context, {{"op", "save"}, {"path", options.out}});
    if (then)
        then(context);
    console.tell(context.messages);
}

} // namespace app
