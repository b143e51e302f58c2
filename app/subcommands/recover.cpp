// pointclay recover: the model as of the last command that a journal holds.
#include "core/session/recover.h"

#include "app/options/output_names.h"
#include "app/subcommands/subcommand.h"
#include "app/writable_models.h"

#include <nlohmann/json.hpp>

namespace app {

Action addRecover(OptionSet command) {
    struct Options {
        std::string journal, out;
        bool anyway = false;
    };
    auto options = std::make_shared<Options>();
    command.add("JOURNAL", options->journal, "journal that a crash left behind; it is kept").required();
    command.add("-o,--output", options->out, "model to write").typeName("OUT").required();
    command.addFlag("--anyway", options->anyway,
                    "take the file that was opened as it is now, though it has changed since: strokes then meet "
                    "another model than they were drawn on");
    return [options](Console& console) {
        requireOutputs({{"-o", options->out}});
        requireSceneName(options->out);
        session::Document document;
        session::Context context{document, {}, console.progress(), {}, 0, {}, nullptr, options->anyway};
        const int commands = session::recover(options->journal, context).commands;
        context.folder.clear();
        session::run(context, {{"op", "save"}, {"path", options->out}});
        console.tell(context.messages);
        console.tell(options->journal + ": recovered " +
                     (commands == 1 ? "1 command" : std::to_string(commands) + " commands") + "; " + options->out +
                     " holds " + std::to_string(document.surface().tree().size()) + " points");
    };
}

} // namespace app
