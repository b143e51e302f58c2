// Minimum spanning trees of unlikeness over the neighbour graph, with the flips along their edges (process/README 2.2),
// and what the ways to orient normals make of them: signs are judged, and taken. Inside this folder.
#pragma once

#include "core/base/disjoint_sets.h"
#include "core/base/large_array.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/orientation/normal_links.h"
#include "core/process/estimation/orientation/outside.h"
#include "core/process/estimation/orientation/winding_signs.h"

namespace process {

/// Kruskal's. Edges come by classes of likeness, those of a class in the order of the points along the curve. Chunks of
/// points first find the trees of what lies inside of them: an edge that closes a circle there is the last one of a
/// circle, in the whole as well, and is in no tree. What is left, little more than an edge a point, is sorted, and
/// joined on demand. In parallel, the same at any thread count.
class OrientationTrees {
  public:
    /// Holds on to all three. REQUIRES: two positions.
    OrientationTrees(const Cloud& cloud, const NeighbourTable& links, std::span<base::Vec3f> normals,
                     const base::Progress& progress);

    /// Joins along all edges that are less unlike, of 1, and were not asked for before.
    void joinBelow(double unlike, const base::Progress& progress);
    void joinAll(const base::Progress& progress) { joinBelow(4, progress); }
    /// Forgets what was joined, and joins anew along edges that are less unlike, the most alike first, as long as what
    /// hangs together has no more than `most` points.
    void joinPatches(double unlike, std::size_t most, const base::Progress& progress);
    /// What is known by now; more may be added.
    base::ParitySets& signs() { return m_signs; }

    /// What is known, and which edges were asked: to be gone back to.
    struct State {
        base::ParitySets signs;
        std::size_t joined;
    };
    State state() const { return {m_signs, m_joined}; }
    void resume(State state) {
        m_signs = std::move(state.signs);
        m_joined = state.joined;
    }

    /// Is there a seam, along which certain edges contradict the signs that the trees gave? Then the surface has no two
    /// sides.
    bool hasSeam(const base::Progress& progress);
    /// Turns normals as the trees say, and each component so that it looks outwards, by winding numbers where these
    /// know and by its outermost points (process/README 2.3, 2.4). The last thing to be asked for.
    void takeSigns(Sides given, const std::map<std::uint32_t, WindingSide>& known, const base::Progress& progress);

  private:
    class Edge;
    struct Joint {
        std::uint32_t a, b; ///< b << 1 | flip
    };
    /// How sure an edge is of what it says.
    enum class Alike : std::uint8_t { No, Agreed, CertainlySame, CertainlyOpposite };
    Alike alikeness(std::uint32_t i, std::size_t k) const { return static_cast<Alike>(m_alike[i] >> 2 * k & 3); }
    std::int32_t layeredBetween(std::uint32_t i, std::uint32_t j) const { return std::max(m_layered[i], m_layered[j]); }
    void lookForLayers(const base::Progress& progress);
    std::vector<Edge> candidates(std::size_t begin, std::size_t end) const;
    void sort(std::vector<std::vector<Edge>>& parts);
    void shorten();
    std::size_t edgesBelow(double unlike) const;
    std::vector<std::vector<std::uint32_t>> losing(const std::vector<std::vector<std::uint32_t>>& lost,
                                                   std::span<const std::uint16_t> alike,
                                                   std::span<std::uint8_t> borneOut) const;
    std::vector<std::uint32_t> borneOut(const base::Progress& progress) const;
    double votesFor(const Outside& outside, std::span<const std::uint32_t> component,
                    std::span<const std::uint32_t> sheetOf) const;

    std::span<const base::Vec3f> m_positions;
    std::span<base::Vec3f> m_normals;
    NormalLinks m_links;
    base::LargeArray<std::uint16_t> m_layered; ///< what edges of a point are put back by, in classes
    base::LargeArray<std::uint32_t> m_alike;   ///< two bits for each neighbour: Alike
    base::LargeArray<Joint> m_joints;
    std::vector<std::size_t> m_classEnd; ///< of joints
    std::size_t m_joined = 0;
    base::ParitySets m_signs;
};

} // namespace process
