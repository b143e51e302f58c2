// OpenEXR behind one file: a picture's depth as one float channel.
#pragma once

#include "core/render/renderer.h"

#include <filesystem>

namespace render {

/// Channel Z, float32, rows from top to bottom, +inf where nothing is; ZIP compression. Written beside the target and
/// renamed when complete. Throws base::Error naming the file.
void saveExr(const Image& image, const std::filesystem::path& path);

} // namespace render
