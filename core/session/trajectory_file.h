// Ways of a tool as people write them: text with a header that names t, x, y, z.
#pragma once

#include "core/base/progress.h"
#include "core/haptics/trajectory.h"
#include "core/io/file_bytes.h"

namespace session {

/// Rows under a header that names t, x, y, z, in any order and among others; times ascend. Throws base::Error naming
/// the line.
haptics::Trajectory readTrajectory(const io::FileBytes& file, const base::Progress& progress);

} // namespace session
