// pointclay convert: from every format that can be read to every one that can be written, with nothing estimated but
// for faces, which are sampled where their corners alone would not tell of the surface.
#include "app/open_model.h"
#include "app/options/batch_options.h"
#include "app/options/face_options.h"
#include "app/options/memory_option.h"
#include "app/options/option_checks.h"
#include "app/options/output_names.h"
#include "app/subcommands/subcommand.h"
#include "app/writable_models.h"
#include "core/io/file_bytes.h"
#include "core/io/file_name.h"
#include "core/io/formats.h"
#include "core/io/las/las_thinning.h"
#include "core/io/mesh_formats.h"
#include "core/process/estimation/part_progress.h"
#include "core/session/face_options.h"
#include "core/session/read_options.h"

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

namespace {

struct ConvertArguments {
    std::string in, out;
    GivenParameters faces;
    double thin = 0; ///< 0: not
    std::string memory = "4G";
    BatchOptions batch;
};

/// LAS without all of it in memory, where it is to be thinned.
io::FileModel readInput(const ConvertArguments& options, const std::string& in, bool& thinnedYet,
                        const base::Progress& progress) {
    if (options.thin > 0 && !session::hasReadParameters(parametersOf(options.faces)))
        if (auto thinned = io::thinnedLas(in, options.thin, bytesOf(options.memory), process::part(progress, 0, 0.8))) {
            thinnedYet = true;
            const io::FileBytes file(in, std::move(thinned->content));
            io::FileModel model = io::read(file, process::part(progress, 0.8, 1), {});
            model.messages.push_back(
                std::to_string(thinned->read) + " points were thinned to " + std::to_string(thinned->kept) +
                " while they were read" +
                (thinned->passes > 1 ? ", in " + std::to_string(thinned->passes) + " passes." : "."));
            return model;
        }
    return readModel(in, parametersOf(options.faces), progress);
}

void convert(const ConvertArguments& options, const BatchJob& job, Console& console) {
    requireOutputs({{"OUT", job.out}});
    requireModelName(job.out);
    const base::Progress progress = console.progress();
    bool thinned = false;
    io::FileModel model = readInput(options, job.in, thinned, process::part(progress, 0, 0.3));
    sampleFaces(model, job.in, parametersOf(options.faces), process::part(progress, 0.3, 0.5));
    if (options.thin > 0 && !thinned)
        session::thinPoints(model, options.thin, process::part(progress, 0.4, 0.5));
    console.tell(model.messages);
    std::error_code unequal;
    const bool replaces = std::filesystem::equivalent(job.in, job.out, unequal);
    io::write(job.out, model, process::part(progress, 0.5, 1));
    if (const std::string loss = io::lossOf(job.out, model); !loss.empty())
        console.tell(loss);
    console.tell(report(job.out, model, replaces));
}

void runConvert(const ConvertArguments& options, OptionSet set, Console& console) {
    if (options.batch.wanted())
        return runBatch("convert", set, options.batch, {options.in, options.out}, {"ply", isWritableModel, false},
                        console, [&](const BatchJob& job) {
                            convert(options, job, console);
                            return nlohmann::ordered_json();
                        });
    requireNoBatch(options.batch);
    if (options.out.empty())
        throw UsageError("OUT is required: the file to write");
    convert(options, {options.in, options.out}, console);
}

} // namespace

Action addConvert(OptionSet command) {
    auto options = std::make_shared<ConvertArguments>();
    command.add("IN", options->in, modelHelp).required();
    command.add("OUT", options->out, "file to write: " + writableExtensions());
    Option thin = command.add("--thin", options->thin,
                              "thin to points that are no closer than this to each other, in model units; LAS while it "
                              "is read, however large it is");
    thin.typeName("S").check(above(0));
    command.add("--memory", options->memory, "memory that thinning LAS may take; the result is the same whatever it is")
        .typeName("BYTES[K|M|G]")
        .check({memoryFault})
        .needs(thin)
        .showDefault();
    addFaceOptions(command, options->faces);
    addBatchOptions(command, options->batch);
    return [options, command](Console& console) { runConvert(*options, command, console); };
}

} // namespace app
