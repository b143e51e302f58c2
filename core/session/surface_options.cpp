#include "core/session/surface_options.h"

#include "core/base/error.h"
#include "core/session/commands.h"
#include "core/surface/definition_text.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

template <class E>
static std::string namesOf(std::span<const surface::Named<E>> table) {
    std::string out;
    for (const auto& row : table)
        out += (out.empty() ? "" : " ") + std::string(row.name);
    return out;
}

std::span<const CommandParameter> surfaceParameters() {
    static const std::string manifolds = namesOf(surface::manifoldNames());
    static const std::string frames = namesOf(surface::frameNames()), weights = namesOf(surface::weightNames());
    static const CommandParameter rows[] = {
        {"manifold", "choice", "", "what the points sample", "null", manifolds.c_str(), 0, 0},
        {"frame", "choice", "", "where the normal of the local plane comes from", "null", frames.c_str(), 0, 0},
        {"weight", "choice", "", "how a point's weight falls with the distance", "null", weights.c_str(), 0, 0},
        {"support", "number", "model units",
         "one support radius for all points; for the gaussian the scale H in exp(-s^2/H^2)", "null", "", positive,
         largest},
        {"neighbours", "integer", "", "a support radius per point that holds about so many neighbours", "null", "", 3,
         10000},
        {"boundary", "number or choice", "h", "off-centre limit beyond which an open surface ends", "null", "auto none",
         positive, largest},
        {"shrink-free", "boolean", "", "symmetric form that does not erode the model", "null", "", 0, 0},
        {"one-sheet", "boolean", "", "second pass that keeps near sheets apart", "null", "", 0, 0},
        {"interpolating", "boolean", "", "weights that make the surface pass through the points", "null", "", 0, 0},
        {"curvature-spacings", "number", "spacings",
         "least support radius that curvature is taken on, for supports from neighbours", "null", "", 0, 1000},
        {"apss-beta", "number", "", "what the frame apss fits: 1 spheres, 0 planes", "null", "", 0, 1},
        {"rimls-sigma", "number", "", "how far normals may differ on one side of an edge, for the frame rimls", "null",
         "", 0.01, 100},
    };
    return rows;
}

static std::string textOf(const json& value) {
    return value.is_string() ? value.get<std::string>() : value.is_boolean() ? (value ? "on" : "off") : value.dump();
}

SurfaceChange changed(const surface::SurfaceDefinition& base, const json& complete) {
    SurfaceChange out{base, false};
    const bool support = complete.contains("support"), neighbours = complete.contains("neighbours");
    if (support && neighbours)
        throw base::Error("\"support\" and \"neighbours\" exclude each other", {}, "give one of them");
    for (const CommandParameter& p : surfaceParameters())
        if (complete.contains(p.id))
            surface::setOption(out.definition, p.id, textOf(complete[p.id]));
    if (neighbours)
        out.definition.support = 0;
    const surface::Frame frame = out.definition.frame;
    if (out.definition.manifold == surface::Manifold::Curve &&
        (frame == surface::Frame::Apss || frame == surface::Frame::Rimls))
        throw base::Error("the frame " + std::string(surface::nameOf(frame)) + " defines surfaces, not curves", {},
                          "choose covariance, covariance-at-centroid, centroid-gradient or hyperplanes");
    out.newSupports = support || neighbours || out.definition.weight != base.weight;
    return out;
}

std::vector<CommandParameter> withSurfaceParameters(std::span<const CommandParameter> own) {
    std::vector<CommandParameter> out(own.begin(), own.end());
    out.insert(out.end(), surfaceParameters().begin(), surfaceParameters().end());
    return out;
}

} // namespace session
