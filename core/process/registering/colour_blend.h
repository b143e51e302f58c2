// Scans of one thing that were taken in different light, made alike in colour where they overlap (process/README 13.4).
//
// Each scan is made brighter or darker in each channel as a whole, so that pairs of points side by side of two scans
// agree as well as one factor allows (least squares over all pairs of scans; what scans agree on stays as bright as it
// was). What differs still goes to the middle where scans lie over each other, and fades out from there.
#pragma once

#include "core/base/progress.h"
#include "core/surfel/surfel.h"

#include <span>

namespace process {

struct BlendedColours {
    std::vector<surfel::Colour> colours; ///< one per point; alpha as it was
    std::vector<base::Vec3d> gains;      ///< of each scan: factors of linear red, green and blue
    std::size_t pairs = 0;               ///< of points side by side of different scans
    double before = 0, after = 0;        ///< root mean square difference of these, in levels of 255
};

/// `scanOf`: of each point the number of its scan, below `scans`. `fade`: how many neighbours far what differs fades
/// out, 0: factors alone. In parallel, the same bits at any thread count. Throws base::Cancelled.
BlendedColours blendColours(const surfel::SurfelList& points, std::span<const std::uint32_t> scanOf, std::size_t scans,
                            int fade, const base::Progress& progress = {});

} // namespace process
