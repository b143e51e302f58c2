#include "core/mesh/faces/crease_chains.h"

#include "core/base/disjoint_sets.h"
#include "core/mesh/faces/edge_chains.h"

#include <algorithm>
#include <map>
#include <numbers>

namespace mesh {

namespace {

constexpr double leastRough = std::numbers::pi / 22.5; ///< 8 degrees: mean turn of the smooth edges of a bumpy surface
constexpr double standsOut = 6;         ///< edges of a chain with free ends turn so much more than those about them
constexpr double closedStandsOut = 4;   ///< of one without
constexpr std::size_t fewest = 40;      ///< edges of a chain among bumps, as many more for each free end
constexpr std::size_t fewestOfTip = 12; ///< edges for each free end, or at all: those of statues end sooner
constexpr double plain = std::numbers::pi / 45; ///< 4 degrees: a chain may end soon where smooth edges turn by less
constexpr std::size_t fewestOfStub = 3;         ///< edges for each free end of such a one, of a short chain
constexpr double webbed = 6;                    ///< edges for each end and each corner, where there are many of these
constexpr double manyCorners = 40;
constexpr std::size_t fewestOfSure =
    20;                         ///< edges of a chain that no scan has by chance, as many more for each free end
constexpr double shortest = 10; ///< spacings: as wide as the bands beside an edge that ends
constexpr double resolved = 8;  ///< spacings: of facets this wide samples tell each by itself

/// Sharp edges that hang together.
struct Chain {
    std::size_t edges = 0, tips = 0;        ///< a tip is a place within the surface where one sharp edge ends
    double corners = 0;                     ///< places where three and more meet
    double length = 0, turn = 0, rough = 0; ///< times length
    double width = 0;                       ///< likewise: of what is beside the edges, which are no longer than that

    /// The furrows of a brain: a web of edges among bumps, with hardly an end.
    bool isWeb() const {
        return rough >= plain * length && corners > manyCorners &&
               static_cast<double>(edges) < webbed * (static_cast<double>(tips) + corners);
    }
    bool clear(double spacing) const {
        const bool foldedOver = tips == 0 && edges <= 3; // around one triangle
        if (width >= resolved * spacing * length && !foldedOver)
            return true;
        if (isWeb())
            return false;
        const bool bumpy = rough >= leastRough * length && turn < (tips > 0 ? standsOut : closedStandsOut) * rough;
        if (bumpy && edges <= fewest * (1 + tips))
            return false;
        if (fewestOfTip * std::max(tips, std::size_t{1}) <= edges)
            return true;
        if (foldedOver)
            return false;
        return rough < plain * length && (fewestOfStub * tips < edges || length >= shortest * spacing);
    }
    bool sure() const { return !isWeb() && edges >= fewestOfSure * (1 + tips) && rough < leastRough * length; }
};

} // namespace

CreaseChains allChains(const FaceTopology& topology) {
    return {topology.sharpEdges, topology.patches, topology.patchCount, {}, 0};
}

CreaseChains clearChains(const FaceTopology& topology, std::span<const double> spacings) {
    const std::vector<SharpEdge>& edges = topology.sharpEdges;
    const std::vector<std::uint32_t> chainOf = chainsOf(edges);
    std::map<std::uint32_t, int> meeting; // sharp edges at a place
    for (const SharpEdge& edge : edges)
        for (const std::uint32_t end : edge.ends)
            ++meeting[end];
    std::vector<Chain> chains(edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        Chain& chain = chains[chainOf[e]];
        const double length = base::distance(edges[e].from, edges[e].to);
        ++chain.edges;
        chain.length += length;
        chain.turn += length * edges[e].turn;
        chain.rough += length * edges[e].rough;
        // the height of the lower triangle over it
        const double lower = std::min(topology.areas[edges[e].left], topology.areas[edges[e].right]);
        chain.width += length > 0 ? length * std::min(length, 2 * lower / length) : 0;
        for (std::size_t k = 0; k < 2; ++k) {
            const int there = meeting[edges[e].ends[k]];
            chain.tips += there == 1 && !edges[e].atBorder[k] ? 1 : 0;
            chain.corners += there > 2 ? 1.0 / there : 0;
        }
    }
    CreaseChains out;
    base::DisjointSets sets(topology.patchCount);
    const auto spacingAt = [&](const SharpEdge& edge) {
        return spacings.size() == 1 ? spacings[0] : spacings[topology.pieces[edge.left]];
    };
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (chains[chainOf[e]].clear(spacingAt(edges[chainOf[e]])))
            out.edges.push_back(edges[e]);
        else {
            out.rounded.push_back(edges[e]);
            sets.join(topology.patches[edges[e].left], topology.patches[edges[e].right]);
        }
    for (const Chain& chain : chains)
        out.sure += chain.sure() ? chain.length : 0;
    std::vector<std::uint32_t> numbers(topology.patchCount);
    for (std::uint32_t p = 0; p < numbers.size(); ++p) {
        const std::uint32_t root = sets.find(p); // the smallest of them
        numbers[p] = root == p ? static_cast<std::uint32_t>(out.patchCount++) : numbers[root];
    }
    out.patches.resize(topology.patches.size());
    for (std::size_t t = 0; t < out.patches.size(); ++t)
        out.patches[t] = numbers[topology.patches[t]];
    return out;
}

} // namespace mesh
