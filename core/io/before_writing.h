// What is known of an output by its name alone: asked before the work whose result would have no place. Both throw the
// base::Error that writing would throw in the end.
#pragma once

#include <filesystem>

namespace io {

/// Where the folder of `target` is missing. `shown`: the name that the message tells.
void requireFolder(const std::filesystem::path& target, const std::filesystem::path& shown);
/// Where no model is written to files of that extension.
void requireModelFormat(const std::filesystem::path& target);

} // namespace io
