// Where a path that began beside the model comes onto it: found between samples, so that it does not depend on where
// samples happen to lie.
#pragma once

#include "core/sculpt/stroke/stroke_dabs.h"

namespace sculpt {

/// Where a path meets the model.
struct Entrance {
    StrokeSample sample;
    Contact contact;
};

/// The sample itself where its ray meets the model.
std::optional<Entrance> entranceAt(const Dabs& dabs, const StrokeSample& sample);
/// The first place on the way from `from`, which met nothing, to `to`, which does; by halving, so that of several one
/// is found. `from` null: `to` itself.
std::optional<Entrance> entranceBetween(const Dabs& dabs, const std::optional<StrokeSample>& from,
                                        const StrokeSample& to);

} // namespace sculpt
