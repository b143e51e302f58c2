// pointclay render: a picture of a model, by splats or by rays.
#include "app/open_model.h"
#include "app/options/look_options.h"
#include "app/options/option_checks.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/options/view_options.h"
#include "app/scene_view.h"
#include "app/subcommands/subcommand.h"
#include "core/io/safe_file.h"
#include "core/render/depth_exr.h"
#include "core/render/image_io.h"
#include "core/render/scene_picture.h"
#include "core/selection/field.h"
#include "ui/gl/backends.h"

#include <nlohmann/json.hpp>

namespace app {

namespace {

struct RenderArguments {
    std::string model, image, depth, stats, mode = "splats", backend = "cpu";
    std::shared_ptr<ViewOptions> view;
    render::PictureOptions picture;
    std::shared_ptr<LookOptions> look;
    std::shared_ptr<SurfaceOptions> surface;
};

void writeStats(const std::string& path, bool rayCast, const render::PictureStats& stats) {
    nlohmann::ordered_json out{
        {"rays", stats.rays}, {"pixels", stats.pixels}, {"seconds", stats.seconds}, {"evaluations", stats.evaluations}};
    if (rayCast) {
        out["antialias_rays"] = stats.edgeRays;
        out["shadow_rays"] = stats.light.shadowRays;
        out["occlusion_rays"] = stats.light.occlusionRays;
        out["path_rays"] = stats.light.pathRays;
    }
    io::writeFile(path, out.dump(2) + "\n");
}

bool isExr(const std::filesystem::path& path) {
    return path.extension() == ".exr" || path.extension() == ".EXR";
}

void saveDepth(const render::Image& image, const std::filesystem::path& path) {
    if (isExr(path))
        render::saveExr(image, path);
    else
        render::savePfm(image, path);
}

/// A picture lacks them, and does not look so.
void tellOfHidden(const session::Scene& scene, Console& console) {
    std::size_t count = 0;
    for (const session::SceneModel& model : scene.models)
        if (model.visible)
            count += sizeOf(selection::selectedIn(model.surface.tree(), selection::Field::Hidden));
    if (count > 0)
        console.tell(std::to_string(count) + (count == 1 ? " surfel is" : " surfels are") +
                     " hidden in the model, and not drawn; the command `show` of sessions shows them.");
}

void runRender(RenderArguments options, Console& console) {
    requireOutputs({{"-o", options.image}, {"--depth", options.depth}, {"--stats", options.stats}});
    session::Document document;
    const base::Progress progress = console.progress();
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    options.picture.rayCast = options.mode == "raycast";
    openModel(context, options.model, options.surface->parameters(), console, SceneUse::All);
    tellOfHidden(document.scene(), console);
    const SceneView scene = sceneView(document, progress);
    const auto cameras = camerasOf(*options.view, scene.whole, document.provenance().origin, document.up());
    const int count = static_cast<int>(cameras.size());
    applyLook(*options.look, document, options.surface->parameters(), upwards(*options.view, document.up()), console,
              options.picture);
    options.picture.renderer = [&options] { return render::makeRenderer(options.backend); };
    render::ScenePictureMaker maker(scene.models, options.picture);
    render::PictureStats stats;
    for (int k = 0; k < count; ++k) {
        render::PictureStats one;
        const render::Image image = maker.draw(cameras[static_cast<std::size_t>(k)], one, progress);
        stats += one;
        render::savePng(image, numberedPath(options.image, k, count));
        if (!options.depth.empty())
            saveDepth(image, numberedPath(options.depth, k, count));
    }
    if (!options.stats.empty())
        writeStats(options.stats, options.picture.rayCast, stats);
}

} // namespace

Action addRender(OptionSet command) {
    auto options = std::make_shared<RenderArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    command.add("-o,--output", options->image, "picture to write")
        .typeName("IMAGE.png")
        .required()
        .check(pictureName());
    command.add("--mode", options->mode, "blended splats, or rays to the true surface")
        .check(oneOf({"splats", "raycast"}))
        .showDefault();
    options->view = addViewOptions(command);
    options->look = addLookOptions(command);
    command.add("--backend", options->backend, "renderer of splats; the machine may lack osmesa and egl")
        .check(idOf(render::backendTable()))
        .showDefault();
    command
        .add("--detail", options->picture.style.detailPx,
             "draw parts of the model by representatives whose splats have at most this radius; 0 draws every "
             "surfel, more than 1 is how a moving view looks")
        .typeName("PX")
        .check(between(0, 64))
        .showDefault();
    command.addFlag("--closed", options->picture.style.closed,
                    "the model has no openings: do not draw parts that face away");
    command.addFlag("--section", options->picture.sections,
                    "draw the curves where the planes of --clip meet the surface");
    command.addFlag("--seams", options->picture.seams, "draw the edges that stay sharp, of models that have some");
    command
        .add("--quality", options->picture.quality,
             "with --mode raycast: 1 interpolates between rays where normals stay within 2 degrees and depths "
             "within 0.2 spacings, outlines exact to the pixel; 2 within twice that; 0 casts a ray for every pixel")
        .typeName("PX")
        .check(atLeast(0))
        .showDefault();
    command
        .add("--depth", options->depth,
             "distance from the eye along each pixel's ray in model units, +inf where nothing is hit; rows from "
             "bottom to top; a name that ends in .exr writes OpenEXR, channel Z")
        .typeName("OUT.pfm|OUT.exr");
    command
        .add("--stats", options->stats,
             "rays (of pixels), pixels, seconds and evaluations as JSON; with --mode raycast also counts of other "
             "rays: antialias_rays, shadow_rays, occlusion_rays, path_rays (reflected and refracted)")
        .typeName("OUT.json");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { runRender(*options, console); };
}

} // namespace app
