// LAS files larger than memory, thinned while they are read: to points that are no closer than a spacing, of which none
// that went had none that close (process/README 11.4). Records are read in blocks, several times where the memory is
// small; what is left is a LAS file of its own with every bit of the records that stay.
//
// Points take their turns by chance, a hash of their whole numbers, in the order of that hash over all of the file,
// whatever the number of passes: the memory changes nothing in the result, and there are no tiles to be seen.
#pragma once

#include "core/base/progress.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace io {

struct ThinnedLas {
    std::string content; ///< the file
    std::uint64_t read = 0, kept = 0;
    int passes = 0;
};

/// `memory`: bytes that may be taken, those of what is opened afterwards included. None where the file is no
/// uncompressed LAS or is damaged, which its reader tells. Throws base::Error where more points stay than the memory
/// holds, or the file cannot be read to its end; base::Cancelled. REQUIRES: spacing > 0.
std::optional<ThinnedLas> thinnedLas(const std::filesystem::path& path, double spacing, std::uint64_t memory,
                                     const base::Progress& progress = {});

} // namespace io
