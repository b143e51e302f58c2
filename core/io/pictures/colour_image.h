// Colour images from files: the pictures that faces are painted with. PNG (libpng) and JPEG (libjpeg), within the
// limits of grey images (grey_image.h); colours as they stand, transparency left out.
#pragma once

#include "core/mesh/faces/picture.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace io {

/// Throws base::Error naming the file: unreadable, neither PNG nor JPEG, broken, or more than 8192 pixels a side.
mesh::Picture readPicture(const std::filesystem::path& path);
/// The same of bytes that lie inside of another file; `name` is for messages.
mesh::Picture readPicture(std::string_view bytes, const std::string& name);

// --- the formats, each behind one file; `name` is for messages ---
mesh::Picture readPngPicture(std::span<const unsigned char> bytes, const std::string& name);
mesh::Picture readJpegPicture(std::span<const unsigned char> bytes, const std::string& name);

} // namespace io
