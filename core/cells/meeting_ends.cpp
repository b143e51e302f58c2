#include "core/cells/meeting_ends.h"

#include "core/base/cells.h"

#include <algorithm>

namespace cells {

using base::Vec3d;

std::vector<MeetingEnds> meetingEnds(std::span<const SeamEnd> ends) {
    double reach = 0;
    for (const SeamEnd& end : ends)
        reach = std::max(reach, end.reach);
    const auto cellOf = [&](const SeamEnd& end) { return base::cellOf(end.place, Vec3d(), 1 / reach); };
    base::CellMap<std::vector<std::uint32_t>> grid;
    for (std::uint32_t k = 0; k < ends.size(); ++k)
        grid.at(cellOf(ends[k])).push_back(k);
    std::vector<std::uint8_t> used(ends.size(), 0);
    std::vector<MeetingEnds> out;
    for (std::uint32_t i = 0; i < ends.size(); ++i) {
        if (used[i])
            continue;
        MeetingEnds here;
        base::forCellsAround(cellOf(ends[i]), [&](const base::Cell& cell) {
            if (const std::vector<std::uint32_t>* there = grid.find(cell))
                for (const std::uint32_t k : *there)
                    if (!used[k] && base::distance(ends[k].place, ends[i].place) < ends[i].reach)
                        here.ends.push_back(k);
        });
        if (here.ends.size() < 3)
            continue;
        std::sort(here.ends.begin(), here.ends.end());
        for (const std::uint32_t k : here.ends) {
            used[k] = 1;
            here.middle += ends[k].place;
        }
        here.middle = here.middle / static_cast<double>(here.ends.size());
        out.push_back(std::move(here));
    }
    return out;
}

} // namespace cells
