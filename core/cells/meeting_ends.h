// Which ends of seams meet at one corner (cells/README 9). Inside this room only.
#pragma once

#include "core/base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cells {

struct SeamEnd {
    base::Vec3d place;
    double reach = 0; ///< within it others count as at the same corner
};

struct MeetingEnds {
    std::vector<std::uint32_t> ends; ///< three or more, ascending; no end is in two corners
    base::Vec3d middle;
};

/// In the order of their first ends.
std::vector<MeetingEnds> meetingEnds(std::span<const SeamEnd> ends);

} // namespace cells
