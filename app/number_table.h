// Tables of numbers as people write them: positions and rays in float64, one row per line.
#pragma once

#include "core/base/progress.h"
#include "core/base/ray.h"
#include "core/io/file_bytes.h"

#include <filesystem>
#include <vector>

namespace app {

/// The first three columns of every line: blank, comma or tab separated, # comments, decimal commas
/// where they are told from separators; a first line of names is passed
/// over. Other readable models (by extension) give their positions in file coordinates. Throws base::Error naming the
/// line.
std::vector<base::Vec3d> readPoints(const std::filesystem::path& path, const base::Progress& progress);
/// The same of a text that is no model.
std::vector<base::Vec3d> readPoints(const io::FileBytes& file, const base::Progress& progress);

/// Rows under a header that names ox, oy, oz, dx, dy, dz, in any order and among others; directions made unit length.
/// Throws base::Error naming the line.
std::vector<base::Rayd> readRays(const io::FileBytes& file, const base::Progress& progress);

} // namespace app
