// Reduced cells put together again as they come, with one report, and where the model is open with its rims. Internal
// to the room.
#pragma once

#include "core/reduce/cell_parts.h"
#include "core/reduce/report_sum.h"
#include "core/reduce/rim_fit.h"

#include <deque>

namespace reduce {

class CellAssembly {
  public:
    /// Looks for the model's rims. `model` must outlive it. Throws base::Cancelled.
    explicit CellAssembly(const surface::Surface& model, const base::Progress& progress = {});

    const Rims& rims() const { return m_rims; }

    /// Fitted to these places.
    void fit(const Cell& cell, const Places& places, const Reduced& reduced);
    /// As it is; `denseRms`: distance of its surfels to its surface.
    void keep(const Cell& cell, double denseRms);
    /// So many of its surfels.
    void pick(const Cell& cell, std::size_t count);

    /// All that came. Throws base::Cancelled.
    Reduced result(const base::Progress& progress);

  private:
    void add(const Cell& cell, surfel::SurfelList list);

    const surface::Surface& m_model;
    Rims m_rims;
    ReportSum m_sum;
    std::vector<surfel::SurfelList> m_lists;
    std::size_t m_size = 0;
    Places m_places;                 ///< the surfels of all cells: what must not be lost
    std::deque<Places> m_besideRims; ///< of the fitted parts, which point to them
    std::vector<FittedPart> m_fitted;
};

} // namespace reduce
