// The naive ways to index surfels and to edit them. One thread.
#pragma once

#include "app/bench/brush_edit.h"

namespace bench {

/// Sorts the surfels along a curve and builds k-d trees over them (naive_cloud.h); how many there are afterwards.
std::size_t naiveBuild(std::span<const surfel::Surfel> surfels);

/// nanoflann's dynamic adaptor, changed in place: what an edit inserts, the next one at the same brush removes.
class NaiveEdits {
  public:
    /// REQUIRES: edits that remove surfels of the list.
    NaiveEdits(std::span<const surfel::Surfel> surfels, std::span<const BrushEdit> edits);
    ~NaiveEdits();

    /// Does the next edit, round and round.
    void next();
    /// Squared distances of the k nearest points, ascending.
    std::vector<float> nearest(const base::Vec3f& x, std::size_t k) const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace bench
