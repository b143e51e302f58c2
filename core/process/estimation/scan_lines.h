// Scans in lines: where points stand much denser along a line than lines stand beside each other, the nearest
// neighbours are all of the own line, and tell nothing of the surface between the lines (process/README 1.7).
#pragma once

#include "core/process/neighbours/cloud_neighbours.h"

namespace process {

/// Gives positions whose nearest all lie on one line neighbours on the lines beside theirs: some of the 12, a spacing
/// that supports bridge the gap with, and a normal across both ways where there are normals. Others keep every bit.
/// Where nothing stands beside a line within reach, as along a curve, it stays as it is. Returns how many got some.
std::size_t lookBesideLines(const Cloud& cloud, CloudNeighbours& near, const base::Progress& progress = {});

} // namespace process
