#include "app/options/light_options.h"

#include "app/options/number_list.h"
#include "app/options/option_checks.h"
#include "core/base/error.h"

namespace app {

namespace {

/// Directions as in "0,1,0;1,0,0.5"; empty where the text is none.
std::vector<base::Vec3f> directionsOf(const std::string& text) {
    std::vector<base::Vec3f> out;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(';', begin), text.size());
        double n[3];
        if (!parseNumbers(std::string_view(text).substr(begin, end - begin), ',', n))
            return {};
        const base::Vec3f d = base::cast<float>(base::Vec3d{n[0], n[1], n[2]});
        if (!isFinite(d) || !(lengthSq(d) > 0) || !std::isfinite(lengthSq(d)))
            return {};
        out.push_back(normalized(d));
        begin = end + 1;
    }
    return out;
}

std::string lightsFault(const std::string& text) {
    if (!directionsOf(text).empty())
        return "";
    try {
        raycast::lightRig(text);
        return "";
    } catch (const base::Error& error) {
        return std::string(error.what()) + ", or directions x,y,z;x,y,z;... towards lamps";
    }
}

template <class Rows>
std::string helpOf(std::string out, const Rows& rows) {
    for (const auto& row : rows)
        out += std::string("\n  ") + row.id + ": " + row.tip;
    return out;
}

void checkTogether(const LightOptions& options, bool occlusion, const render::PictureOptions& picture) {
    const bool plain = options.material == "matcap";
    const auto needsRays = [&](bool given, const char* option) {
        if (given && !picture.rayCast)
            throw UsageError(std::string(option) + " is for cast rays: add --mode raycast");
    };
    needsRays(!plain, "--material other than matcap");
    needsRays(!options.lights.empty(), "--lights");
    needsRays(options.shadows, "--shadows");
    needsRays(options.ground, "--ground");
    needsRays(options.smooth, "--antialias");
    if (!plain && picture.style.shading != render::Shading::Matcap)
        throw UsageError("--shading goes with --material matcap; " + options.material + " has its own look");
    if (plain && !options.lights.empty() && !options.shadows)
        throw UsageError("--lights: --material matcap has its own light; add --shadows or another --material");
    if (options.ground && !options.shadows && !occlusion)
        throw UsageError("--ground shows shadows and ambient occlusion: add --shadows or --ao");
}

} // namespace

std::shared_ptr<LightOptions> addLightOptions(OptionSet command) {
    auto options = std::make_shared<LightOptions>();
    command
        .add("--material", options->material,
             helpOf("material of the surface with --mode raycast", raycast::materialTable()))
        .check(idOf(raycast::materialTable()))
        .text("NAME [matcap]");
    command
        .add("--lights", options->lights,
             helpOf("lamps for --mode raycast: a name, whose lamps stand around the viewer, or directions towards "
                    "lamps in model coordinates, as in 0,1,0;1,0,0.5",
                    raycast::lightRigTable()))
        .check({lightsFault})
        .text("NAME|x,y,z;... [studio]");
    command.addFlag("--shadows", options->shadows, "the model casts shadows on itself (--mode raycast)");
    command.addFlag("--ground", options->ground,
                    "shadows and occlusion also fall on the ground below the model (--mode raycast)");
    command.addFlag("--antialias", options->smooth,
                    "nine rays per pixel at edges (--mode raycast; splats always have smooth edges)");
    return options;
}

void applyLights(const LightOptions& options, bool occlusion, render::PictureOptions& out) {
    checkTogether(options, occlusion, out);
    raycast::Lighting& lighting = out.lighting;
    lighting.material = raycast::material(options.material);
    lighting.directions = directionsOf(options.lights);
    if (!options.lights.empty() && lighting.directions.empty())
        lighting.rig = raycast::lightRig(options.lights);
    lighting.shadows = options.shadows;
    lighting.ground = options.ground;
    lighting.occlusion = occlusion && out.rayCast;
    out.smoothRays = options.smooth;
}

} // namespace app
