// pointclay convert: from every format that can be read to every one that can be written, with nothing estimated.
#include "app/open_model.h"
#include "app/subcommand.h"
#include "core/io/formats.h"
#include "core/process/estimation/part_progress.h"

#include <sstream>

namespace app {

static std::string writableExtensions() {
    std::string out;
    for (const io::FormatRow& row : io::formatTable()) {
        std::istringstream in(row.extensions);
        for (std::string extension; row.write && in >> extension;)
            out += (out.empty() ? "." : " .") + extension;
    }
    return out;
}

Action addConvert(CLI::App& command) {
    struct Options {
        std::string in, out;
    };
    auto options = std::make_shared<Options>();
    command.add_option("IN", options->in, modelHelp)->required();
    command.add_option("OUT", options->out, "file to write: " + writableExtensions())->required();
    return [options](Console& console) {
        const base::Progress progress = console.progress();
        const io::FileModel model = readModel(options->in, process::part(progress, 0, 0.5));
        console.tell(model.messages);
        io::write(options->out, model, process::part(progress, 0.5, 1));
    };
}

} // namespace app
