// pointclay render: a picture of a model, by splats or by rays.
#include "app/framing.h"
#include "app/open_model.h"
#include "app/subcommand.h"
#include "app/surface_options.h"
#include "core/io/safe_file.h"
#include "core/process/curve_tube.h"
#include "ui/render/image_io.h"
#include "ui/render/picture.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace app {

using base::Vec3d;

namespace {

struct Options {
    std::string model, image, depth, stats, mode = "splats", shading = "matcap";
    std::string size = "1280x720", eye, target, up;
    double fovDeg = 0; ///< 0: the camera's own
    double quality = 0;
    render::PictureOptions picture;
    std::shared_ptr<SurfaceOptions> surface;
};

std::string sizeFault(const std::string& text) {
    int width = 0, height = 0;
    char rest = 0;
    const bool whole = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
    return whole && width >= 1 && height >= 1 && width <= 16384 && height <= 16384
               ? ""
               : "'" + text + "' is no size; write WIDTHxHEIGHT with 1 to 16384 pixels each";
}

bool parseVector(const std::string& text, Vec3d& out) {
    char rest = 0;
    return std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &out.x, &out.y, &out.z, &rest) == 3 && base::isFinite(out);
}

std::string vectorFault(const std::string& text) {
    Vec3d v;
    return parseVector(text, v) ? "" : "'" + text + "' is no x,y,z";
}

/// The asked view in coordinates relative to the origin; what is left out is chosen to show the whole model.
render::Camera cameraOf(const Options& options, const tree::SurfelTree& model, const Vec3d& origin) {
    int width = 0, height = 0;
    std::sscanf(options.size.c_str(), "%dx%d", &width, &height);
    const base::Box3f box = model.bounds();
    render::Camera out = render::Camera::looking(box, width, height);
    if (options.fovDeg > 0)
        out.fovDeg = options.fovDeg;
    if (!options.up.empty())
        parseVector(options.up, out.up);
    if (options.eye.empty() && options.target.empty())
        return closeUp(out, model);
    Vec3d eye, target;
    const Vec3d back = out.eye - out.target;
    out.target = !options.target.empty() && parseVector(options.target, target) ? target - origin
                                                                                : base::cast<double>(box.centre());
    out.eye = !options.eye.empty() && parseVector(options.eye, eye) ? eye - origin : out.target + back;
    if (out.eye == out.target)
        throw UsageError("--eye and --target are the same place");
    return out;
}

void writeStats(const std::string& path, const render::PictureStats& stats) {
    const nlohmann::ordered_json out{
        {"rays", stats.rays}, {"pixels", stats.pixels}, {"seconds", stats.seconds}, {"evaluations", stats.evaluations}};
    io::writeFile(path, out.dump(2) + "\n");
}

void run(Options options, Console& console) {
    session::Document document;
    const base::Progress progress = console.progress();
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    options.picture.rayCast = options.mode == "raycast";
    options.picture.style.shading = render::shading(options.shading);
    openModel(context, options.model, options.surface->parameters(), console);
    const surface::Surface surface = process::shownAs(document.surface(), progress);
    const render::Camera camera = cameraOf(options, surface.tree(), document.provenance().origin);
    render::PictureStats stats;
    const render::Image image = render::drawPicture(surface, camera, options.picture, stats, progress);
    render::savePng(image, options.image);
    if (!options.depth.empty())
        render::savePfm(image, options.depth);
    if (!options.stats.empty())
        writeStats(options.stats, stats);
}

CLI::Option* addVector(CLI::App& command, const char* name, std::string& value, const char* tip) {
    return command.add_option(name, value, tip)->type_name("x,y,z")->check(CLI::Validator(vectorFault, ""));
}

std::vector<std::string> shadingNames() {
    std::vector<std::string> out;
    for (const render::ShadingRow& row : render::shadingTable())
        out.push_back(row.id);
    return out;
}

} // namespace

Action addRender(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("MODEL", options->model, modelHelp)->required();
    command.add_option("-o,--output", options->image, "picture to write")->type_name("IMAGE.png")->required();
    command.add_option("--mode", options->mode, "blended splats, or rays to the true surface")
        ->check(CLI::IsMember({"splats", "raycast"}))
        ->capture_default_str();
    command.add_option("--size", options->size, "pixels")
        ->type_name("WxH")
        ->check(CLI::Validator(sizeFault, ""))
        ->capture_default_str();
    addVector(command, "--eye", options->eye, "where the eye is, in model units; default: a view of the whole model");
    addVector(command, "--target", options->target, "what it looks at; default: the middle of the model");
    addVector(command, "--up", options->up, "what is up in the picture; default: 0,1,0");
    command.add_option("--fov", options->fovDeg, "vertical angle of view in degrees; default: 35")
        ->type_name("DEG")
        ->check(CLI::Range(1.0, 170.0));
    command.add_option("--shading", options->shading, "how the surface is coloured")
        ->check(CLI::IsMember(shadingNames()))
        ->capture_default_str();
    command.add_option("--backend", options->picture.backend, "what draws splats; the machine may lack osmesa and egl")
        ->check(CLI::IsMember({"cpu", "osmesa", "egl"}))
        ->capture_default_str();
    command
        .add_option("--detail", options->picture.style.detailPx,
                    "representatives stand for parts of the model where their splats' radius is at most this; 0 draws "
                    "every surfel, more than 1 is how a moving view looks")
        ->type_name("PX")
        ->check(CLI::Range(0.0, 64.0))
        ->capture_default_str();
    command.add_flag("--closed", options->picture.style.closed,
                     "the model has no opening: parts that face away are not drawn");
    command.add_flag("--transparent", options->picture.style.transparent, "leave the background out");
    command
        .add_option("--quality", options->quality,
                    "largest error of outlines in pixels with --mode raycast; every pixel has its own ray, which meets "
                    "any bound")
        ->type_name("PX")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command
        .add_option("--depth", options->depth,
                    "distance from the eye along each pixel's ray in model units, +inf where nothing is hit; rows from "
                    "bottom to top")
        ->type_name("OUT.pfm");
    command.add_option("--stats", options->stats, "rays, pixels, seconds and evaluations as JSON")
        ->type_name("OUT.json");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
