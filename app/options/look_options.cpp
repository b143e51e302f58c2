#include "app/options/look_options.h"

#include "app/open_model.h"
#include "app/options/number_list.h"
#include "app/options/option_checks.h"
#include "core/base/error.h"
#include "core/render/effects/effect_rows.h"
#include "core/render/shading/own_colours.h"

#include <nlohmann/json.hpp>

namespace app {

namespace {

bool parseRange(const std::string& text, std::pair<float, float>& out) {
    double numbers[2];
    if (!parseNumbers(text, ',', numbers))
        return false;
    out = {static_cast<float>(numbers[0]), static_cast<float>(numbers[1])};
    return out.first < out.second && std::isfinite(out.first) && std::isfinite(out.second);
}

std::string rangeFault(const std::string& text) {
    std::pair<float, float> range;
    return parseRange(text, range) ? "" : "'" + text + "' is not a range; write LOW,HIGH as in --range=-0.5,0.5";
}

std::string effectsFault(const std::string& text) {
    try {
        render::effects(text);
        return "";
    } catch (const base::Error& error) {
        return error.what();
    }
}

template <class Rows>
std::string helpOf(std::string out, const Rows& rows) {
    for (const auto& row : rows)
        out += std::string("\n  ") + row.id + ": " + row.tip;
    return out;
}

/// Both models are kept relative to their own origins; the reference's moves to the model's.
surface::Surface referenceOf(const std::string& path, const session::Document& document,
                             const nlohmann::json& parameters, Console& console) {
    session::Document other;
    session::Context context{other, {}, console.progress(), {}, 0, {}, nullptr};
    openModel(context, path, parameters, console);
    const base::Vec3d shift = other.provenance().origin - document.provenance().origin;
    return shifted(other.surface(), shift);
}

} // namespace

std::shared_ptr<LookOptions> addLookOptions(OptionSet command) {
    auto options = std::make_shared<LookOptions>();
    command.add("--shading", options->shading, helpOf("how the surface is coloured", render::shadingTable()))
        .check(idOf(render::shadingTable()))
        .text("NAME [colour for a model with colours, else matcap]");
    command
        .add("--attribute", options->attribute,
             "which number --shading attribute shows; `info` lists what a model carries")
        .typeName("NAME");
    command
        .add("--range", options->range,
             "values at the ends of the colour scale, for shadings that measure (write --range=-1,1 where the "
             "first is negative); default: those that cover most of the model")
        .typeName("LOW,HIGH")
        .check({rangeFault});
    command
        .add("--reference", options->reference,
             "model that --shading deviation measures distances from, positive on the side of its normals")
        .typeName("MODEL");
    command.add("--background", options->backdrop, helpOf("background of the picture", render::backdropTable()))
        .check(idOf(render::backdropTable()))
        .text("NAME [studio]");
    command
        .add("--effects", options->effects,
             helpOf("comma-separated list of effects, drawn from depths and normals over the shaded picture",
                    render::effectTable()))
        .typeName("LIST")
        .check({effectsFault});
    options->light = addLightOptions(command);
    command.addFlag(
        "--ao", options->occlusion,
        "ambient occlusion: by rays with --mode raycast, otherwise the same as --effects ambient-occlusion");
    command.addFlag("--grid", options->grid, "a grid on the ground below the model, with lines at round coordinates");
    for (const render::AnnotationRow& row : render::annotationTable()) {
        const bool usual = options->annotated & row.annotation;
        const std::string name = usual ? "--" + std::string(row.id) + ",!--no-" + row.id : "--" + std::string(row.id);
        command.addFlag(
            name,
            [options, bit = row.annotation](bool on) {
                options->annotated = on ? options->annotated | bit : options->annotated & ~render::Annotated(bit);
            },
            std::string(row.tip) + (usual ? " (drawn unless --no-" + std::string(row.id) + ")" : ""));
    }
    command.addFlag("--transparent", options->transparent, "leave out the background");
    return options;
}

/// As asked, else what suits the model: its colours, unless a material hides them.
static render::Shading shadingOf(const LookOptions& options, const tree::SurfelTree& model) {
    if (!options.shading.empty())
        return render::shading(options.shading);
    if (!options.attribute.empty())
        return render::Shading::Attribute;
    return options.light->material == "matcap" ? render::usualShading(model) : render::Shading::Matcap;
}

/// Throws UsageError, or base::Error where the model carries no such number.
static void requireAttribute(const LookOptions& options, render::Shading shading,
                             const surfel::AttributeLayout& layout) {
    const auto& measure = render::shadingRow(shading).measure;
    if ((measure && measure->named()) != !options.attribute.empty())
        throw UsageError(options.attribute.empty() ? "--shading attribute needs --attribute NAME to show"
                                                   : "--attribute is for --shading attribute");
    if (options.attribute.empty() || layout.find(options.attribute))
        return;
    std::string names;
    for (const surfel::Attribute& each : layout.attributes())
        names += (names.empty() ? "" : ", ") + each.name;
    throw base::Error("the model carries no attribute '" + options.attribute + "'", {},
                      names.empty() ? "it carries none" : "use one of: " + names);
}

void applyLook(const LookOptions& options, const session::Document& document, const nlohmann::json& surface,
               const base::Vec3d& up, Console& console, render::PictureOptions& out) {
    out.style.shading = shadingOf(options, document.surface().tree());
    out.style.backdrop = render::backdrop(options.backdrop);
    out.style.transparent = options.transparent;
    out.annotated = options.annotated;
    const bool onScreen = options.occlusion && !out.rayCast;
    out.style.effects = render::effects(options.effects) | (onScreen ? render::Effects(render::Occlusion) : 0);
    applyLights(*options.light, options.occlusion, out);
    if (options.grid)
        out.style.grid = render::gridBelow(document.surface().tree().bounds(), up, document.provenance().origin);
    const auto& measure = render::shadingRow(out.style.shading).measure;
    const bool deviates = measure && measure->quantity == process::Quantity::Deviation;
    if (!options.range.empty()) {
        if (!measure)
            throw UsageError(std::string("--range: --shading ") + render::shadingRow(out.style.shading).id +
                             " measures nothing");
        parseRange(options.range, out.range.emplace());
    }
    requireAttribute(options, out.style.shading, *document.surface().tree().layout());
    out.attribute = options.attribute;
    if (deviates != !options.reference.empty())
        throw UsageError(deviates ? "--shading deviation needs --reference MODEL to measure from"
                                  : "--reference is for --shading deviation");
    if (deviates)
        out.reference = referenceOf(options.reference, document, surface, console);
}

} // namespace app
