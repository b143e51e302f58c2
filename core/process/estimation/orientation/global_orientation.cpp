#include "core/process/estimation/orientation/global_orientation.h"

#include "core/process/estimation/orientation/orientation_pieces.h"
#include "core/process/estimation/orientation/winding_signs.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>
#include <map>

namespace process {

using base::Vec3f;

namespace {

constexpr std::size_t mostPieces = 200; ///< that are judged
constexpr double doubtfulShare = 0.25;
/// Winding numbers have a say where they make bodies, so near and better ones than what stood before, or much better
/// ones: a scan from one side is as near to a body with its parts turned at random.
constexpr double bodies = 0.2, better = 0.8, muchBetter = 0.6;
/// Where what stands is no body, so near, it is taken apart into so many patches, of a handful of points at least.
constexpr double surelyBodies = 0.05;
constexpr std::size_t patchCounts[] = {200, 800};
constexpr std::size_t leastPatch = 8;

/// The best orientation of each component so far, and others that may be better. Each surface is judged by itself:
/// whether what is inside of another bounds a hollow of it, nothing tells, and strays make no body.
class Choice {
  public:
    /// Of all that the trees have joined by now.
    Choice(const Cloud& cloud, const NeighbourTable& links, std::span<const Vec3f> normals, OrientationTrees& trees,
           const base::Progress& progress)
        : m_cloud(cloud), m_links(links), m_normals(normals), m_trees(trees),
          m_surfaceOf(surfacesOf(links, part(progress, 0, 0.3))), m_best(trees.state()),
          m_sides(sides(part(progress, 0.3, 0.7))), m_seam(trees.hasSeam(part(progress, 0.7, 1))) {}

    const std::map<std::uint32_t, WindingSide>& best() const { return m_sides; }
    bool hasSeam() const { return m_seam; }
    bool settled() const {
        return std::ranges::none_of(m_sides, [](const auto& each) { return each.second.off > surelyBodies; });
    }
    /// Of what pieces make by winding numbers, and that their neighbours join. `pieces`: as `trees` have them.
    /// What has two sides so far keeps them: patches that are wrong in themselves part it by seams.
    void judge(std::vector<std::vector<std::uint32_t>> pieces, const base::Progress& progress) {
        std::map<std::uint32_t, std::vector<std::vector<std::uint32_t>>> surfaces;
        for (std::vector<std::uint32_t>& piece : pieces)
            surfaces[m_surfaceOf[piece.front()]].push_back(std::move(piece));
        double done = 0;
        for (const auto& [first, own] : surfaces) {
            const double next = done + 0.6 * static_cast<double>(own.size()) / static_cast<double>(pieces.size());
            for (const SignRelation& each :
                 signsByWinding(m_cloud, m_links, m_normals, own, m_trees.signs(), part(progress, done, next)))
                m_trees.signs().relate(each.a, each.b, each.opposite);
            done = next;
        }
        joinPieces(m_cloud, m_normals, m_trees, part(progress, 0.6, 0.8));
        std::map<std::uint32_t, WindingSide> now = sides(part(progress, 0.8, 0.9));
        std::erase_if(now, [&](const auto& each) { return !isBetter(each.first, each.second); });
        if (now.empty())
            return;
        OrientationTrees::State turned = m_best;
        for (const auto& [root, side] : now)
            for (const std::uint32_t i : side.members)
                turned.signs.take(m_trees.signs(), i);
        m_trees.resume(turned);
        const bool seam = m_trees.hasSeam(part(progress, 0.9, 1));
        if (seam && !m_seam)
            return;
        m_best = std::move(turned);
        m_seam = seam;
        for (auto& [root, side] : now)
            m_sides[root] = std::move(side);
    }
    OrientationTrees::State take() { return std::move(m_best); }

  private:
    /// Than the best, if it is the same component: bodies apart may be of one there, and not here.
    bool isBetter(std::uint32_t root, const WindingSide& now) const {
        const auto found = m_sides.find(root);
        if (found == m_sides.end() || found->second.members != now.members)
            return false;
        const double before = found->second.off;
        return now.off <= muchBetter * before || (now.off <= bodies && now.off <= better * before);
    }
    std::map<std::uint32_t, WindingSide> sides(const base::Progress& progress) {
        return windingSides(m_cloud, m_links, m_normals, m_surfaceOf, m_trees.signs(), progress);
    }

    const Cloud& m_cloud;
    const NeighbourTable& m_links;
    std::span<const Vec3f> m_normals;
    OrientationTrees& m_trees;
    std::vector<std::uint32_t> m_surfaceOf;
    OrientationTrees::State m_best;
    std::map<std::uint32_t, WindingSide> m_sides; ///< of the best
    bool m_seam; ///< of the best: certain edges contradict it, as on what has no two sides
};

/// Pieces of what is certain; where noise leaves little that is, of what is less so. Joins them.
std::vector<std::vector<std::uint32_t>> certainPieces(const Cloud& cloud, OrientationTrees& trees,
                                                      const base::Progress& progress) {
    double done = 0;
    for (const double unlike : {0.1, 0.15, 0.2, pieceUnlike}) {
        trees.joinBelow(unlike, part(progress, done, done + 0.25));
        done += 0.25;
        std::vector<std::vector<std::uint32_t>> pieces = largePieces(trees.signs(), cloud.size(), mostPieces);
        std::size_t held = 0;
        for (const std::vector<std::uint32_t>& piece : pieces)
            held += piece.size();
        if (2 * held >= cloud.size())
            return pieces;
    }
    return {};
}

} // namespace

bool orientGlobally(const Cloud& cloud, const NeighbourTable& links, std::span<Vec3f> normals,
                    const base::Progress& progress, Sides given) {
    if (cloud.size() < 2)
        return true;
    OrientationTrees trees(cloud, links, normals, part(progress, 0, 0.5));
    std::vector<std::vector<std::uint32_t>> pieces = certainPieces(cloud, trees, part(progress, 0.5, 0.55));
    OrientationTrees::State certain = trees.state();
    joinPieces(cloud, normals, trees, part(progress, 0.55, 0.65));
    Choice choice(cloud, links, normals, trees, part(progress, 0.65, 0.7));
    if (pieces.size() > 1 && !choice.settled()) {
        trees.resume(std::move(certain));
        choice.judge(std::move(pieces), part(progress, 0.7, 0.75));
    }
    double done = 0.75;
    for (const std::size_t count : patchCounts) {
        if (choice.settled())
            break;
        trees.joinPatches(pieceUnlike, std::max(2 * cloud.size() / count, 4 * leastPatch),
                          part(progress, done, done + 0.02));
        choice.judge(largePieces(trees.signs(), cloud.size(), 2 * count, leastPatch),
                     part(progress, done + 0.02, done + 0.07));
        done += 0.07;
    }
    trees.resume(choice.take());
    trees.takeSigns(given, choice.best(), part(progress, 0.9, 1));
    return !choice.hasSeam();
}

std::vector<std::uint8_t> doubtfulSigns(const Cloud& cloud, const NeighbourTable& links, std::span<const Vec3f> normals,
                                        const base::Progress& progress) {
    std::vector<std::uint8_t> out(cloud.size());
    const NormalLinks edges(cloud.positions(), links, normals);
    progress.step(0, "Judging the orientation");
    base::parallelChunks(edges.size(), 4096, [&](std::size_t begin, std::size_t end, std::size_t) {
        edges.forRows(begin, end, [&](std::uint32_t i, const NeighbourTable::Row&, const Likeness& along) {
            double against = 0, all = 0;
            for (std::size_t k = 0; k < edges.count(); ++k) {
                const double weight = 1 - along.unlike[k] / static_cast<double>(unlikeClasses - 1);
                all += weight;
                against += along.flip[k] ? weight : 0;
            }
            out[i] = against > doubtfulShare * all;
        });
    });
    return out;
}

} // namespace process
