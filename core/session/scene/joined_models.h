// Models of a scene made one: all surfels in the coordinates of the first, none moved against another. Where they
// overlap, surfels of both are there; the union of solids is `solid`. Inside this room only.
#pragma once

#include "core/session/scene/scene.h"

namespace session {

/// `models`: at least one; the first one's coordinates and definition are those of the result. Attributes that only
/// some have are zero for the others' surfels; supports stay. Cells keep apart. Throws base::Error for what cannot be
/// joined: layers, complexes, curves with surfaces.
surface::Surface joined(const std::vector<SceneModel>& models);

/// The layout of surfels of all of them.
std::shared_ptr<surfel::AttributeLayout> unitedLayout(const std::vector<SceneModel>& models);
/// Surfels appended under a layout that has all of their attributes, others zero.
void appendAs(surfel::SurfelList& out, const surfel::SurfelList& list);

} // namespace session
