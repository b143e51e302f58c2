#include "core/mesh/faces/edge_labels.h"

#include "core/base/ranked.h"
#include "core/mesh/faces/face_creases.h"
#include "core/mesh/faces/figures.h"

#include <algorithm>
#include <cmath>

namespace mesh {

/// As its vertices are apart.
static double usualSpacing(const FaceTopology& topology) {
    return std::sqrt(topology.area / static_cast<double>(topology.triangles.size()));
}

bool hasSureCreases(const FaceTopology& topology) {
    if (topology.sharpEdges.empty() || topology.oneSided)
        return false;
    return clearChains(topology, usualSpacing(topology)).sure > std::sqrt(topology.area);
}

std::vector<SharpEdge> noisyEdges(const FaceTopology& topology) {
    if (topology.sharpEdges.empty() || topology.oneSided)
        return {};
    return clearChains(topology, usualSpacing(topology)).rounded;
}

/// In the median, of each piece.
static std::vector<double> spacingsOfPieces(const FaceTopology& topology, const std::vector<FacePoint>& points,
                                            std::span<const double> spacings) {
    if (spacings.size() == 1)
        return {spacings[0]};
    std::vector<std::vector<double>> all(topology.pieceCount);
    for (std::size_t i = 0; i < points.size(); ++i)
        all[topology.pieces[points[i].triangle]].push_back(spacings[i]);
    std::vector<double> out;
    for (std::vector<double>& each : all)
        out.push_back(base::median(each));
    return out;
}

CreaseChains keptEdges(const FaceTopology& topology, const FaceOptions& options, const std::vector<FacePoint>& points,
                       std::span<const double> spacings) {
    if (topology.sharpEdges.empty())
        return {};
    if (topology.oneSided || options.creases)
        return allChains(topology);
    return clearChains(topology, spacingsOfPieces(topology, points, spacings));
}

std::string labelEdges(const FaceTopology& topology, const FaceOptions& options, const CreaseChains& kept,
                       const std::vector<FacePoint>& points, std::span<const double> spacings,
                       surfel::SurfelList& samples) {
    if (topology.sharpEdges.empty())
        return {};
    if (topology.oneSided)
        return "Sharp edges of the faces are rounded a little, over about a support: the faces have one side only.";
    if (options.creases == false)
        return "Sharp edges of the faces are rounded a little, over about a support; without --creases off they stay "
               "sharp.";
    labelCreases(topology, kept, points, spacings, samples);
    if (kept.rounded.empty())
        return {};
    return "Rounded " + grouped(kept.rounded.size()) + " of " +
           counted(topology.sharpEdges.size(), "sharp edge", "sharp edges") +
           ", which look like noise; with creases on, all stay sharp.";
}

} // namespace mesh
