// pointclay convert: from every format that can be read to every one that can be written, with nothing estimated but
// for faces, which are sampled where their corners alone would not tell of the surface.
#include "app/open_model.h"
#include "app/options/face_options.h"
#include "app/subcommands/subcommand.h"
#include "app/writable_models.h"
#include "core/io/file_name.h"
#include "core/io/formats.h"
#include "core/io/mesh_formats.h"
#include "core/process/estimation/part_progress.h"
#include "core/session/face_options.h"

#include <nlohmann/json.hpp>

namespace app {

/// Vertices that are kept stay as the file has them.
static void sampleFaces(io::FileModel& model, const std::string& name, const nlohmann::json& parameters,
                        const base::Progress& progress) {
    const mesh::FaceOptions options = session::faceOptions(parameters);
    if (model.polygons.size() == 0)
        return session::refuseSamples(options, name);
    io::FileModel opened = model;
    auto definition = model.definition.value_or(surface::SurfaceDefinition());
    if (session::openFaces(opened, definition, options, progress).sampled) {
        model = std::move(opened);
        model.definition = definition;
        model.hasSupports = true; // those of an even sampling
    }
    if (model.polygons.size() > 0)
        model.messages.push_back("The file's faces are not written, only its points.");
}

/// What was written where.
static std::string report(const std::string& out, const io::FileModel& model, bool replaced) {
    const io::FormatRow& row = *io::rowOfExtension(io::formatTable(), io::extensionOf(out));
    const std::size_t count = model.points.size();
    std::string text = out + ": " + std::to_string(count) + (count == 1 ? " point" : " points") + " written as " +
                       row.label + (replaced ? ", in the place of what was read" : "");
    if (std::string_view(row.id) != "ply" && io::meshFormatOf(out)) // where people expect faces
        text += ", without faces; pointclay mesh makes them";
    return text;
}

Action addConvert(OptionSet command) {
    struct Options {
        std::string in, out;
        GivenParameters faces;
    };
    auto options = std::make_shared<Options>();
    command.add("IN", options->in, modelHelp).required();
    command.add("OUT", options->out, "file to write: " + writableExtensions()).required();
    addFaceOptions(command, options->faces);
    return [options](Console& console) {
        const base::Progress progress = console.progress();
        io::FileModel model = readModel(options->in, process::part(progress, 0, 0.3));
        sampleFaces(model, options->in, parametersOf(options->faces), process::part(progress, 0.3, 0.5));
        console.tell(model.messages);
        std::error_code unequal;
        const bool replaces = std::filesystem::equivalent(options->in, options->out, unequal);
        io::write(options->out, model, process::part(progress, 0.5, 1));
        if (const std::string loss = io::lossOf(options->out, model); !loss.empty())
            console.tell(loss);
        console.tell(report(options->out, model, replaces));
    };
}

} // namespace app
