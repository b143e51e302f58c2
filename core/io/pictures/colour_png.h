// Colour images as PNG (libpng): the writing side of png_image.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace io {

/// 8-bit pixels, rows from top to bottom: 0xAABBGGRR, so that red, green, blue, alpha follow each other in memory. Not
/// premultiplied. Opaque images get no alpha channel. Throws base::Error naming `name` where libpng refuses the size or
/// memory runs out. REQUIRES: width * height pixels.
std::string encodePng(std::span<const std::uint32_t> pixels, int width, int height, const std::string& name);

} // namespace io
