#include "core/process/estimation/orientation/global_orientation.h"

#include "core/process/estimation/orientation/orientation_pieces.h"
#include "core/process/estimation/orientation/piece_fields.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>

namespace process {

using base::Vec3f;

namespace {

constexpr std::size_t mostPieces = 200; ///< that are judged
constexpr double doubtfulShare = 0.25;
/// What pieces say of each other has a say where it makes bodies, so near, and much more than the trees do.
constexpr double bodies = 0.2, better = 0.8;

/// By the fields of pieces of what is certain; where noise leaves little that is, of what is less so.
std::vector<SignRelation> relations(const Cloud& cloud, const NeighbourTable& links, std::span<const Vec3f> normals,
                                    OrientationTrees& trees, const base::Progress& progress) {
    for (const double unlike : {0.1, 0.15, 0.2, pieceUnlike}) {
        trees.joinBelow(unlike, part(progress, 0, 0.2));
        const std::vector<std::vector<std::uint32_t>> pieces = largePieces(trees.signs(), cloud.size(), mostPieces);
        std::size_t held = 0;
        for (const std::vector<std::uint32_t>& piece : pieces)
            held += piece.size();
        if (2 * held >= cloud.size())
            return relationsOfPieces(cloud, links, normals, pieces, trees.signs(), part(progress, 0.2, 1));
    }
    return {};
}

} // namespace

bool orientGlobally(const Cloud& cloud, const NeighbourTable& links, std::span<Vec3f> normals,
                    const base::Progress& progress, Sides given) {
    if (cloud.size() < 2)
        return true;
    OrientationTrees trees(cloud, links, normals, part(progress, 0, 0.5));
    const std::vector<SignRelation> said = relations(cloud, links, normals, trees, part(progress, 0.5, 0.7));
    const OrientationTrees::State certain = trees.state();
    joinPieces(cloud, normals, trees, part(progress, 0.7, 0.8));
    if (std::any_of(said.begin(), said.end(), [&](const SignRelation& each) {
            const auto p = trees.signs().find(each.a), q = trees.signs().find(each.b);
            return p.root == q.root && (p.opposite != q.opposite) != each.opposite;
        })) {
        OrientationTrees::State byTrees = trees.state();
        const double off = farFromBodies(cloud, links, normals, trees.signs());
        trees.resume(certain);
        for (const SignRelation& each : said)
            trees.signs().relate(each.a, each.b, each.opposite);
        joinPieces(cloud, normals, trees, part(progress, 0.8, 0.9));
        if (const double now = farFromBodies(cloud, links, normals, trees.signs()); now > bodies || now > better * off)
            trees.resume(std::move(byTrees));
    }
    const bool sided = !trees.hasSeam(part(progress, 0.9, 0.95));
    trees.takeSigns(given, part(progress, 0.95, 1));
    return sided;
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
