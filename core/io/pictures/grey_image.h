// Grey images from files, for brushes that press them into the surface. PNG (libpng) and JPEG (libjpeg).
//
// Colours become their luma, transparent parts black. Values are the file's as they stand, divided by the largest: a
// height map of 16 bits keeps them all.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

namespace io {

struct GreyImage {
    int width = 0, height = 0;
    std::vector<float> values; ///< 0 to 1, rows from top to bottom
    static constexpr int maxSide = 8192;
};

/// Throws base::Error naming the file: unreadable, neither PNG nor JPEG, broken or cut off, or more than 8192 pixels a
/// side.
GreyImage readGreyImage(const std::filesystem::path& path);

/// Before anything is allocated: throws for more than 8192 pixels a side, and for more than so many bytes can hold.
void checkSize(std::size_t width, std::size_t height, std::size_t bytes, const std::string& name);

// --- the formats, each behind one file; `name` is for messages ---
GreyImage readPng(std::span<const unsigned char> bytes, const std::string& name);
GreyImage readJpeg(std::span<const unsigned char> bytes, const std::string& name);

} // namespace io
