// Images as files: colour as PNG, depth as PFM. Written beside the target and renamed when complete; errors are
// base::Error naming the file.
#pragma once

#include "core/render/renderer.h"

#include <filesystem>

namespace render {

/// 8-bit RGBA, not premultiplied; without alpha where every pixel is opaque.
void savePng(const Image& image, const std::filesystem::path& path);
/// The depth: one little-endian float32 per pixel, rows from bottom to top, +inf where nothing is.
void savePfm(const Image& image, const std::filesystem::path& path);

} // namespace render
