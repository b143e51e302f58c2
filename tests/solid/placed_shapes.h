// Primitives as surfels in a pose.
#pragma once

#include "core/solid/combine.h"
#include "core/solid/primitive.h"

namespace test {

inline surfel::SurfelList placed(surfel::SurfelList list, const solid::Pose& pose) {
    for (surfel::Surfel& s : list.items) {
        s.position = base::cast<float>(pose.place(base::cast<double>(s.position)));
        s.normal = base::cast<float>(normalized(pose.turn * base::cast<double>(s.normal)));
    }
    return list;
}

inline surface::Surface shapeAt(const char* id, const solid::Size& size, double spacing, const solid::Pose& pose = {}) {
    return {tree::SurfelTree::build(placed(solid::surfelsOf(solid::primitive(id), size, spacing, {}), pose)), {}};
}

} // namespace test
