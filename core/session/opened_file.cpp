#include "core/session/opened_file.h"

#include "core/base/error.h"
#include "core/complexes/complex.h"
#include "core/process/estimation/drawn_lines.h"
#include "core/process/estimation/orientation/contradictions.h"
#include "core/process/estimation/prepare.h"
#include "core/process/estimation/up_guess.h"
#include "core/surface/frames/frame_table.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

/// What the work throws, in the name of the file.
template <class Work>
static auto inNameOf(const std::string& name, const Work& work) {
    try {
        return work();
    } catch (const base::Error& error) {
        throw base::Error(error.message(), name);
    }
}

OpenedFile opened(const std::string& name, io::FileModel model, const json& parameters,
                  const base::Progress& progress) {
    OpenedFile out{name, std::move(model), {}, {}, false, false};
    out.ownNormals = out.model.points.layout->normals;
    out.ownSides = out.ownNormals && out.model.points.layout->oriented;
    out.surface = changed(out.model.definition.value_or(surface::SurfaceDefinition()), parameters);
    surface::SurfaceDefinition& definition = out.surface.definition;
    const mesh::FaceOptions options = faceOptions(parameters);
    out.faces = inNameOf(name, [&] { return openFaces(out.model, definition, options, progress); });
    // What samples resolve needs no second pass; whoever asks for it gets it. Tips of blades have near sheets however
    // fine samples are, and frames that put two solids together harm no edges.
    const bool tips = out.faces.blades && surface::rowOf(definition.frame).solids;
    if (out.faces.apart && !tips && !parameters.contains("one-sheet"))
        definition.oneSheet = false;
    return out;
}

static base::UpAxis upOf(const OpenedFile& file, const surface::Surface& surface) {
    const io::FileModel& model = file.model;
    const bool curve = surface.definition().manifold != surface::Manifold::Surface;
    if (model.up || curve)
        return model.up.value_or(model.usualUp);
    // Scanners see the side that they scan; faces wind as programs like.
    const bool seen = file.ownSides && model.faces == 0 && surface.tree().layout()->oriented;
    const auto sides = seen ? process::KnownSides::Yes : process::KnownSides::No;
    return process::guessedUp(process::upEvidence(surface.tree(), sides), model.usualUp);
}

static std::string mergedMessage(std::size_t merged) {
    return merged == 1 ? "A point that stands in the place of another was merged with it."
                       : std::to_string(merged) + " points that stand in the place of others were merged with them.";
}

/// Where the file's normals contradict each other; empty where hardly any do.
static std::string contradictionMessage(const tree::SurfelTree& tree) {
    constexpr double many = 0.05;
    const double share = tree.layout()->oriented ? process::contradictions(tree) : 0;
    if (share < many)
        return {};
    return "Of points side by side, " + std::to_string(static_cast<int>(std::lround(100 * share))) +
           " % have normals that look opposite ways, and the surface breaks there; `clean --orient global` makes them "
           "agree.";
}

/// Where the file has colours, and they are black over much of it: those of labels, where nothing is labelled.
static std::string blackMessage(const tree::SurfelTree& tree) {
    constexpr double many = 0.3;
    std::size_t black = 0;
    if (tree.layout()->colours)
        tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot) {
                constexpr surfel::Colour rgb = 0xffffff;
                black += (block.surfel(slot).colour & rgb) == 0;
            }
        });
    const double share = static_cast<double>(black) / static_cast<double>(std::max<std::size_t>(tree.size(), 1));
    if (share < many || black == tree.size()) // all black: nobody takes that for colours
        return {};
    return std::to_string(static_cast<int>(std::lround(100 * share))) +
           " % of the points are black in the file: as clay (View > Shading, or `--shading matcap`) they show their "
           "shape.";
}

MadeModel made(OpenedFile& file, const base::Progress& progress) {
    io::FileModel& model = file.model;
    const surface::SurfaceDefinition& definition = file.surface.definition;
    const bool kept = file.faces.sampled || (model.hasSupports && !file.surface.newSupports);
    std::size_t merged = 0, disagreed = 0;
    bool turned = false;
    process::PrepareOptions options;
    options.definition = definition;
    options.keepSupports = kept;
    options.keepShapes = !kept && !file.surface.newSupports;
    options.keepLimit = model.limitDecided && definition == model.definition;
    options.keepSides = !model.shape.empty(); // saved from a surface, whose last strip may have two sides now
    options.merged = file.faces.sampled || model.hasSupports ? nullptr : &merged;
    options.turned = file.ownNormals && model.faces == 0 && !model.hasSupports ? &turned : nullptr;
    options.disagreed = options.turned ? &disagreed : nullptr;
    options.shape = &model.shape;
    surface::Surface surface =
        inNameOf(file.name, [&] { return process::prepare(std::move(model.points), options, progress); });
    inNameOf(file.name, [&] { return complexes::Complex::of(surface); }); // one that is none is refused
    if (merged > 0)
        model.messages.push_back(mergedMessage(merged));
    if (disagreed > 0)
        model.messages.push_back("The file's normals look out here and in beside it: " + std::to_string(disagreed) +
                                 " of them were turned, so that all agree.");
    if (turned)
        model.messages.push_back("The normals looked inwards, and were turned: the surface is closed.");
    const auto tell = [&](std::string told) {
        if (!told.empty())
            model.messages.push_back(std::move(told));
    };
    const bool cloud = definition.manifold == surface::Manifold::Surface && model.faces == 0 && !model.hasSupports;
    if (cloud && process::drawsLines(surface.tree()))
        tell("The points draw lines in a plane and are torn as a surface: open them with `--manifold curve`, or choose "
             "Curve under Model > Further > Surface.");
    else if (options.turned && definition.manifold == surface::Manifold::Surface)
        tell(contradictionMessage(surface.tree()));
    tell(blackMessage(surface.tree()));
    const base::UpAxis up = upOf(file, surface);
    return {std::move(surface), up, merged};
}

layers::Stack layersIn(std::vector<std::string>& comments, surface::Surface& surface,
                       std::vector<std::string>& messages) {
    layers::Stack out = layers::takeLines(comments);
    if (out.empty())
        return out;
    const auto words = layers::Channels::of(*surface.tree().layout(), out);
    if (!words || !layers::areSound(surface.tree(), *words)) {
        messages.push_back(words ? "The file's layers hold numbers that are none or lead far away: they were left out."
                                 : "The file tells of layers and lacks what they hold: they were left out.");
        return {};
    }
    surface = {layers::reconciled({}, surface.tree(), out, layers::How::Keep), surface.definition()};
    return out;
}

} // namespace session
