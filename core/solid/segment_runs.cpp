#include "core/solid/segment_runs.h"

namespace solid {

SegmentRuns::SegmentRuns(std::span<const base::Box3d> pieces)
    : m_count(pieces.size()), m_runs((pieces.size() + together - 1) / together) {
    for (std::size_t k = 0; k < pieces.size(); ++k)
        m_runs[k / together].extend(pieces[k]);
}

} // namespace solid
