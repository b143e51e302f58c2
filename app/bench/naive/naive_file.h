// The naive ways to read a file of points: its bytes into arrays, and on to what can be evaluated. One thread.
#pragma once

#include "core/surfel/surfel.h"

#include <filesystem>

namespace bench {

/// Where the points of a binary file are: position, normal if it has any (float x 3 each) and colour (byte x 3), one
/// after the other.
struct PointFile {
    std::filesystem::path path;
    std::size_t header = 0, points = 0;
    bool normals = true;

    std::size_t bytesPerPoint() const { return normals ? 27 : 15; }
};

/// The bytes into arrays: the least that any loader must do. Nothing is checked.
std::vector<surfel::Surfel> naiveLoad(const PointFile& file);

/// Loads, finds the spacing among the 6 nearest by nanoflann, sets supports for so many neighbours (process/README)
/// without grading them, and builds k-d trees by support (naive_cloud.h). The surfels along the curve, with supports.
std::vector<surfel::Surfel> naiveOpen(const PointFile& file, double neighbours);

/// The same for a file without normals: estimated from the 18 nearest by principal components, oriented along a minimum
/// spanning tree of the 12 nearest [Hoppe92], with the topmost point looking up.
std::vector<surfel::Surfel> naiveOpenRaw(const PointFile& file, double neighbours);

} // namespace bench
