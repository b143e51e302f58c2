// Measured numbers kept with the surfels: an attribute of their own, or colours.
#pragma once

#include "core/tree/surfel_tree.h"

#include <span>
#include <string>

namespace process {

/// The version with a float32 attribute of that name; an attribute that is there already gets the new numbers. Blocks
/// in which nothing changes stay shared. `values` in tree order. Throws base::Error where an attribute of that name
/// holds something else.
tree::SurfelTree withAttribute(const tree::SurfelTree& tree, const std::string& name, std::span<const float> values);

/// The version with these colours, in tree order.
tree::SurfelTree withColours(const tree::SurfelTree& tree, std::span<const surfel::Colour> colours);

} // namespace process
