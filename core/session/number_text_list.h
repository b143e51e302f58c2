// Several numbers in one text, as planes, places and sizes are written: "0,1,0,0.25".
#pragma once

#include "core/base/vec.h"

#include <cstddef>
#include <string>
#include <vector>

namespace session {

/// Throws base::Error naming `what` unless these are `least` to `most` finite numbers, separated by commas.
std::vector<double> numbersOf(const std::string& text, const std::string& what, std::size_t least, std::size_t most);

/// Three of them.
base::Vec3d vectorOf(const std::string& text, const std::string& what);

/// The unit vector along three of them. Throws as well where these have no direction.
base::Vec3d directionOf(const std::string& text, const std::string& what);

} // namespace session
