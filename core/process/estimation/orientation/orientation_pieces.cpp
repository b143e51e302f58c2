#include "core/process/estimation/orientation/orientation_pieces.h"

#include "core/base/box.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>

namespace process {

using base::Vec3d, base::Vec3f;

namespace {

constexpr std::size_t mostBodies = 2000;
constexpr double encloses = 0.3;       ///< |mean normal| below which a piece does: half a ball has 0.5
constexpr double clearlyOutside = 0.4; ///< of votes

/// A piece that has an outside of its own.
struct Body {
    std::uint32_t first = 0; ///< of its points
    bool turned = false;     ///< the first point's normal looks inwards
    base::Box3f box;
};

} // namespace

std::vector<std::vector<std::uint32_t>> largePieces(base::ParitySets& trees, std::size_t n, std::size_t most,
                                                    std::size_t fewest) {
    std::vector<std::uint32_t> size(n);
    for (std::uint32_t i = 0; i < n; ++i)
        ++size[trees.find(i).root];
    std::vector<std::uint32_t> roots;
    const std::size_t least = std::max(fewest, n / most);
    for (std::uint32_t i = 0; i < n; ++i)
        if (size[i] >= least)
            roots.push_back(i);
    std::stable_sort(roots.begin(), roots.end(), [&](std::uint32_t a, std::uint32_t b) { return size[a] > size[b]; });
    constexpr std::uint32_t none = ~0u;
    std::vector<std::uint32_t> pieceOf(n, none);
    for (std::uint32_t p = 0; p < roots.size(); ++p)
        pieceOf[roots[p]] = p;
    std::vector<std::vector<std::uint32_t>> out(roots.size());
    for (std::uint32_t i = 0; i < n; ++i)
        if (const std::uint32_t p = pieceOf[trees.find(i).root]; p != none)
            out[p].push_back(i);
    return out;
}

/// `trees` are joined below pieceUnlike.
static void relateBodiesApart(const Cloud& cloud, std::span<const Vec3f> normals, base::ParitySets& trees) {
    const std::vector<std::vector<std::uint32_t>> pieces = largePieces(trees, cloud.size(), mostBodies);
    if (pieces.size() < 2)
        return;
    const Outside outside(cloud.positions());
    std::vector<Vec3f> agreeing(cloud.size());
    std::vector<Body> bodies;
    for (const std::vector<std::uint32_t>& piece : pieces) {
        Body body{piece.front(), false, {}};
        Vec3d mean;
        for (const std::uint32_t i : piece) {
            agreeing[i] = trees.find(i).opposite ? -normals[i] : normals[i];
            mean += base::cast<double>(agreeing[i]) / static_cast<double>(piece.size());
            body.box.extend(cloud.positions()[i]);
        }
        const double votes = length(mean) < encloses ? outside.vote(agreeing, piece) : 0;
        const bool beside =
            std::none_of(bodies.begin(), bodies.end(), [&](const Body& other) { return other.box.overlaps(body.box); });
        if (std::abs(votes) < clearlyOutside || !beside)
            continue;
        body.turned = trees.find(body.first).opposite != (votes < 0);
        bodies.push_back(body);
    }
    for (std::size_t k = 1; k < bodies.size(); ++k)
        trees.relate(bodies[0].first, bodies[k].first, bodies[0].turned != bodies[k].turned);
}

void joinPieces(const Cloud& cloud, std::span<const Vec3f> normals, OrientationTrees& trees,
                const base::Progress& progress) {
    trees.joinBelow(pieceUnlike, part(progress, 0, 0.5));
    relateBodiesApart(cloud, normals, trees.signs());
    trees.joinAll(part(progress, 0.5, 1));
}

} // namespace process
