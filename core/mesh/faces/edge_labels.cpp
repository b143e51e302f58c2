#include "core/mesh/faces/edge_labels.h"

#include "core/mesh/faces/crease_chains.h"
#include "core/mesh/faces/face_creases.h"
#include "core/mesh/faces/figures.h"

#include <cmath>

namespace mesh {

bool hasSureCreases(const FaceTopology& topology) {
    if (topology.sharpEdges.empty() || topology.oneSided)
        return false;
    const double spacing = std::sqrt(topology.area / static_cast<double>(topology.triangles.size()));
    return clearChains(topology, spacing).sure > std::sqrt(topology.area);
}

std::string labelEdges(const FaceTopology& topology, const FaceOptions& options, const std::vector<FacePoint>& points,
                       double spacing, surfel::SurfelList& samples) {
    if (topology.sharpEdges.empty())
        return {};
    if (topology.oneSided)
        return "Sharp edges of the faces are rounded a little, over about a support: the faces have one side only.";
    if (options.creases == false)
        return "Sharp edges of the faces are rounded a little, over about a support; without --creases off they stay "
               "sharp.";
    const CreaseChains chains = options.asksForCreases() ? allChains(topology) : clearChains(topology, spacing);
    labelCreases(topology, chains, points, spacing, samples);
    if (chains.leftOut == 0)
        return {};
    return "Rounded " + grouped(chains.leftOut) + " of " +
           counted(topology.sharpEdges.size(), "sharp edge", "sharp edges") +
           ", which look like noise; with creases on, all stay sharp.";
}

} // namespace mesh
