#include "core/render/framed_box.h"

#include "core/base/disjoint_sets.h"

#include <array>
#include <cmath>

namespace render {

namespace {

using base::Box3f;
using base::Vec3f;

constexpr std::size_t mostLookedAt = 65536;
/// Of the surfels: one piece that may be left out, and all of them.
struct Shares {
    double piece, all;
};
constexpr Shares few{0.001, 0.005}, more{0.01, 0.03};
constexpr float aDot = 0.2f;    ///< of the diagonal: what is smaller is shown in spite of more
constexpr float around = 0.05f; ///< of the diagonal: what reaches no farther beyond the rest belongs to it
constexpr int side = 24;        ///< cells along the diagonal: pieces with an empty cell between them are apart
constexpr int mostRounds = 32;  ///< outliers far beyond each other: each round takes away the farthest
constexpr std::uint32_t none = ~0u;

/// An even choice of the tree's order.
std::vector<Vec3f> chosen(const tree::SurfelTree& tree) {
    const std::size_t step = tree.size() / mostLookedAt + 1;
    std::vector<Vec3f> out;
    std::size_t at = 0;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (at++ % step == 0)
                out.push_back(block.position(slot));
    });
    return out;
}

Box3f boxOf(std::span<const Vec3f> positions) {
    Box3f out;
    for (const Vec3f& p : positions)
        out.extend(p);
    return out;
}

struct Piece {
    Box3f box;
    std::size_t count = 0;
};

/// Which piece each position belongs to: cells that touch make one.
std::vector<Piece> piecesOf(std::span<const Vec3f> positions, const Box3f& box, std::vector<std::uint32_t>& pieceOf) {
    const float cell = box.diagonal() / side;
    const auto cellOf = [&](const Vec3f& p) {
        int out = 0;
        for (std::size_t k = 0; k < 3; ++k)
            out = out * (side + 1) + std::clamp(static_cast<int>((p[k] - box.lo[k]) / cell), 0, side);
        return static_cast<std::uint32_t>(out);
    };
    constexpr int row = side + 1;
    std::vector<std::uint8_t> full(row * row * row);
    for (const Vec3f& p : positions)
        full[cellOf(p)] = 1;
    base::DisjointSets sets(full.size());
    for (int i = 0; i < row * row * row; ++i)
        for (int k = 0; full[static_cast<std::size_t>(i)] && k < 27; ++k) {
            const int x = i / (row * row) + k / 9 - 1, y = i / row % row + k / 3 % 3 - 1, z = i % row + k % 3 - 1;
            if (std::min({x, y, z}) < 0 || std::max({x, y, z}) >= row)
                continue;
            const auto other = static_cast<std::uint32_t>((x * row + y) * row + z);
            if (full[other])
                sets.join(static_cast<std::uint32_t>(i), other);
        }
    std::vector<std::uint32_t> number(full.size(), none);
    std::vector<Piece> out;
    pieceOf.clear();
    for (const Vec3f& p : positions) {
        std::uint32_t& piece = number[sets.find(cellOf(p))];
        if (piece == none) {
            piece = static_cast<std::uint32_t>(out.size());
            out.emplace_back();
        }
        out[piece].box.extend(p);
        ++out[piece].count;
        pieceOf.push_back(piece);
    }
    return out;
}

bool holds(const Box3f& box, const Box3f& other) {
    return box.contains(other.lo) && box.contains(other.hi);
}

/// Large pieces, and small ones that reach hardly beyond these.
std::vector<std::uint8_t> keptOf(std::span<const Piece> pieces, double small) {
    std::vector<std::uint8_t> out(pieces.size());
    Box3f kept;
    for (std::size_t p = 0; p < pieces.size(); ++p)
        if (static_cast<double>(pieces[p].count) > small) {
            out[p] = 1;
            kept.extend(pieces[p].box);
        }
    if (kept.empty()) // crumbs all over
        return std::vector<std::uint8_t>(pieces.size(), 1);
    const Box3f near = kept.inflated(around * kept.diagonal());
    for (std::size_t p = 0; p < pieces.size(); ++p)
        out[p] |= holds(near, pieces[p].box);
    return out;
}

/// The positions without small pieces far from the others.
std::vector<Vec3f> withoutOutliers(std::vector<Vec3f> positions, const Shares& shares) {
    const auto all = static_cast<double>(positions.size());
    const double small = std::max(1.0, shares.piece * all);
    double left = std::max(2.0, shares.all * all);
    for (int round = 0; round < mostRounds && shares.piece * all >= 0.5; ++round) {
        const Box3f box = boxOf(positions);
        if (!(box.diagonal() > 0))
            break;
        std::vector<std::uint32_t> pieceOf;
        const std::vector<Piece> pieces = piecesOf(positions, box, pieceOf);
        const std::vector<std::uint8_t> kept = keptOf(pieces, small);
        std::vector<Vec3f> rest;
        for (std::size_t i = 0; i < positions.size(); ++i)
            if (kept[pieceOf[i]])
                rest.push_back(positions[i]);
        const auto gone = static_cast<double>(positions.size() - rest.size());
        if (gone == 0 || gone > left) // more than a few: they are part of what there is to see
            break;
        left -= gone;
        positions = std::move(rest);
    }
    return positions;
}

} // namespace

base::Box3f framedBox(const tree::SurfelTree& tree) {
    const Box3f all = tree.bounds();
    if (tree.empty())
        return all;
    const std::vector<Vec3f> looked = chosen(tree);
    Box3f most = boxOf(withoutOutliers(looked, few));
    if (const Box3f rest = boxOf(withoutOutliers(looked, more)); rest.diagonal() < aDot * most.diagonal())
        most = rest;
    const Box3f near = most.inflated(around * most.diagonal());
    if (!(most.diagonal() > 0) || holds(near, all))
        return all;
    Box3f out;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (near.contains(block.position(slot)))
                out.extend(block.position(slot));
    });
    return out;
}

} // namespace render
