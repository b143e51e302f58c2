#include "core/session/read_options.h"

#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/io/formats.h"
#include "core/io/las/las_points.h"
#include "core/io/las/las_thinning.h"
#include "core/io/text/text_preview.h"
#include "core/process/cleaning/thin.h"
#include "core/process/estimation/keep_points.h"
#include "core/process/estimation/part_progress.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/viewpoints.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

std::span<const CommandParameter> readParameters() {
    static const CommandParameter rows[] = {
        {"columns", "text", "",
         "what the columns of a text file are, each by a name, such as x,y,z,-,red,green,blue; - leaves one out; "
         "by default the file tells",
         "null", "", 0, 0},
        {"unit_scale", "number", "",
         "model units that one unit of the file is long: .001 opens millimetres as metres; 1 by default", "null", "",
         positive, largest},
        {"up_axis", "choice", "", "the axis that is upwards; by default the file tells, or the shape", "null",
         "x y z -x -y -z", 0, 0},
        {"thin_to", "number", "model units",
         "thin points to those that are no closer than this to each other; LAS while it is read, however large it is",
         "null", "", positive, largest},
    };
    return rows;
}

bool hasReadParameters(const json& parameters) {
    return std::ranges::any_of(readParameters(), [&](const CommandParameter& p) { return parameters.contains(p.id); });
}

void refuseReadParameters(const json& parameters, const std::string& where) {
    for (const CommandParameter& each : readParameters())
        if (parameters.contains(each.id))
            throw base::Error("there is no file of points to read", where,
                              "leave out " + std::string(each.id) + ", which is about such a file");
}

void thinPoints(io::FileModel& model, double spacing, const base::Progress& progress) {
    const std::vector<std::uint8_t> removed = process::thinned(
        model.points, std::max(static_cast<float>(spacing), std::numeric_limits<float>::min()), progress);
    const std::size_t before = model.points.size();
    process::keepPoints(model.points, [&](std::size_t i) { return removed[i] == 0; });
    model.polygons = {};
    model.shape = {};
    model.hasSupports = model.limitDecided = false; // they were made for what stood closer
    model.messages.push_back(std::to_string(before) + " points were thinned to " + std::to_string(model.points.size()) +
                             ".");
}

/// Lengths among attributes, supports and layers are those of our own files, which have a unit of their own already.
static void scale(io::FileModel& model, double by, const std::string& name) {
    if (model.definition || model.hasSupports || model.points.layout->find("scale_0")) // or splats
        throw base::Error("holds lengths beside its positions, and keeps its unit on opening", name,
                          "leave out the scale, and use `transform` or `unit` afterwards");
    if (by == 1)
        return;
    const auto factor = base::Vec3d{by, by, by};
    const selection::Affine map = selection::Affine::stretching(factor);
    model.comments = movedViewpoints(std::move(model.comments), *model.points.layout, map);
    std::erase_if(model.comments, [](const std::string& line) { return line.starts_with(io::lasGridComment); });
    model.origin = map(model.origin);
    bool fits = true;
    for (surfel::Surfel& each : model.points.items) {
        each.position = base::cast<float>(map(base::cast<double>(each.position)));
        fits = fits && base::isFinite(each.position);
    }
    if (!fits)
        throw base::Error("the scale takes points further than numbers reach", name, "choose a smaller one");
}

namespace {

/// LAS is thinned without all of it in memory; nothing for other files.
std::optional<io::FileModel> readThinnedLas(const std::filesystem::path& path, const std::filesystem::path& folder,
                                            double thin, const base::Progress& progress) {
    constexpr std::uint64_t memory = std::uint64_t(4) << 30;
    auto las = io::thinnedLas(path, thin, memory, process::part(progress, 0, 0.8));
    if (!las)
        return std::nullopt;
    const io::FileBytes file(path, std::move(las->content));
    io::FileModel model = io::read(file, process::part(progress, 0.8, 1), folder);
    model.messages.push_back(std::to_string(las->read) + " points were thinned to " + std::to_string(las->kept) +
                             " while they were read.");
    return model;
}

io::FileModel readAsTold(const std::filesystem::path& path, const std::filesystem::path& folder, const json& parameters,
                         const base::Progress& progress) {
    const auto columns = parameters.find("columns");
    if (columns == parameters.end())
        return io::read(path, progress, folder);
    return io::readColumns(path, io::columnNames(columns->get<std::string>()), progress);
}

} // namespace

io::FileModel readFile(const std::filesystem::path& path, const std::filesystem::path& folder, const json& parameters,
                       const base::Progress& progress) {
    const double by = parameters.value("unit_scale", 1.0), thin = parameters.value("thin_to", 0.0);
    const base::Progress reading = process::part(progress, 0, thin > 0 ? 0.6 : 1);
    std::optional<io::FileModel> thinned;
    if (thin > 0 && !parameters.contains("columns"))
        thinned = readThinnedLas(path, folder, thin / by, reading);
    io::FileModel model = thinned ? std::move(*thinned) : readAsTold(path, folder, parameters, reading);
    if (thin > 0 && model.polygons.size() > 0)
        throw base::Error("holds faces, which are sampled rather than thinned", path.string(),
                          "say how densely with sample_spacing");
    if (parameters.contains("unit_scale"))
        scale(model, by, path.string());
    if (parameters.contains("up_axis"))
        model.up = base::findRow(base::upTable(), parameters.at("up_axis").get<std::string>())->axis;
    if (thin > 0 && !thinned)
        thinPoints(model, thin, process::part(progress, 0.6, 1));
    return model;
}

} // namespace session
