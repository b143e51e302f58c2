// What a stroke does to edges that stay sharp: some tools leave one along their way, smoothing may let those fade that
// it goes over.
//
// An edge is drawn where the stroke began to be, while the place is still as flat as it was, and the stroke goes over
// it once more: surfels carry their labels along, so that the edge is where they end up, however steep that is. Drawn
// afterwards it tore holes into the flanks of deep grooves.
#pragma once

#include "core/base/progress.h"
#include "core/sculpt/stroke/stroke.h"

#include <string>

namespace session {

/// Do the settings ask for it?
bool leavesEdge(const sculpt::StrokeSettings& settings);
bool fadesEdges(const sculpt::StrokeSettings& settings);

/// `before` with an edge along the way of the samples' rays, for each image of the stroke. What is raised or carved has
/// its crest beside that way where rays are slanting: there the edge is below where `done` bends most across it. Where
/// there can be no edge `message` says why. Throws base::Cancelled.
surface::Surface withEdges(const surface::Surface& before, const surface::Surface& done,
                           const sculpt::StrokeSettings& settings, std::span<const sculpt::StrokeSample> samples,
                           const base::Vec3d& origin, std::string& message, const base::Progress& progress);

/// `done` with edges along the same way less sharp, by strength and falloff.
surface::Surface withFadedEdges(const surface::Surface& done, const sculpt::StrokeSettings& settings,
                                std::span<const sculpt::StrokeSample> samples, const base::Vec3d& origin);

} // namespace session
