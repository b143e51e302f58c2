// What a view that frames the model has to show, as boxes: see View::frame. Cost: one pass over the blocks.
#pragma once

#include "core/tree/surfel_tree.h"

#include <vector>

namespace ui {

/// All of the model but outliers far away (framed_box.h), a box per block.
std::vector<base::Box3f> boxesOf(const tree::SurfelTree& tree);
/// What is less than half masked, a box per block; empty where nothing is masked more than that.
std::vector<base::Box3f> unmaskedBoxes(const tree::SurfelTree& tree);
/// Of what is selected; none where nothing is.
std::vector<base::Box3f> selectedBoxes(const tree::SurfelTree& tree);
/// The cube about a ball.
base::Box3f boxAround(const base::Vec3d& centre, double radius);

} // namespace ui
