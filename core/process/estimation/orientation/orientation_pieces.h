// Pieces of a cloud whose normals certainly agree, and bodies among them that only strays join (process/README 2.2,
// 2.4). Inside this folder.
#pragma once

#include "core/process/estimation/orientation/orientation_trees.h"

#include <vector>

namespace process {

/// Pieces are joined by edges less unlike than this (of 1): what noise leaves certain, and what thin parts do not.
constexpr double pieceUnlike = 0.3;

/// The pieces of n points worth judging, of `fewest` points and of a share of 1 / `most` at least: the largest first,
/// each with its members in the order of the curve. The rest follows its neighbours.
std::vector<std::vector<std::uint32_t>> largePieces(base::ParitySets& trees, std::size_t n, std::size_t most,
                                                    std::size_t fewest = 50);

/// Joins all that is not joined. Bodies that enclose something each and lie beside each other look outwards each by its
/// own vote (process/README 2.3), before strays between them are asked.
void joinPieces(const Cloud& cloud, std::span<const base::Vec3f> normals, OrientationTrees& trees,
                const base::Progress& progress);

} // namespace process
