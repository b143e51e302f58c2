// Boxes that overlap, touching included (mesh/README 6.4): space is halved until few of them are in each part, and
// parts are worked on by all threads. Internal to the room.
#pragma once

#include "core/base/box.h"
#include "core/base/progress.h"

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace mesh {

using BoxPair = std::pair<std::uint32_t, std::uint32_t>;

/// Pairs of boxes that overlap and of which `keep` says so, each with the smaller number first, in ascending order.
/// `keep` is asked once for each pair, on any thread. REQUIRES: no box is empty. Throws base::Cancelled.
std::vector<BoxPair> overlappingBoxes(std::span<const base::Box3d> boxes,
                                      const std::function<bool(const BoxPair&)>& keep,
                                      const base::Progress& progress = {});

} // namespace mesh
