#include "core/io/pictures/grey_image.h"

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/pictures/colour_image.h"

#include <algorithm>

namespace io {

static bool startsWith(std::span<const unsigned char> bytes, std::initializer_list<unsigned char> magic) {
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

/// What the reader of the file's format makes of it.
template <class Image>
static Image imageOf(const FileBytes& file, Image (*png)(std::span<const unsigned char>, const std::string&),
                     Image (*jpeg)(std::span<const unsigned char>, const std::string&)) {
    const std::filesystem::path& path = file.path();
    const std::span bytes(reinterpret_cast<const unsigned char*>(file.bytes().data()), file.size());
    if (startsWith(bytes, {0x89, 'P', 'N', 'G'}))
        return png(bytes, path.string());
    if (startsWith(bytes, {0xff, 0xd8, 0xff}))
        return jpeg(bytes, path.string());
    file.fail("is neither PNG nor JPEG", "convert it to one of them");
}

void checkSize(std::size_t width, std::size_t height, std::size_t bytes, const std::string& name) {
    // Deflate packs 1032 bytes into one, 8 pixels each at most; JPEG's codes stay far below.
    constexpr std::size_t pixelsPerByte = 8 * 1032;
    if (width > std::size_t(GreyImage::maxSide) || height > std::size_t(GreyImage::maxSide))
        throw base::Error("the image has more than 8192 pixels a side", name, "make it smaller");
    if (width * height > pixelsPerByte * bytes)
        throw base::Error("the image claims " + std::to_string(width) + " x " + std::to_string(height) +
                              " pixels, which so short a file cannot hold",
                          name, "it is damaged or was cut off; fetch it again");
}

GreyImage readGreyImage(const std::filesystem::path& path) {
    return imageOf(FileBytes(path), readPng, readJpeg);
}

mesh::Picture readPicture(const std::filesystem::path& path) {
    return imageOf(FileBytes(path), readPngPicture, readJpegPicture);
}

mesh::Picture readPicture(std::string_view bytes, const std::string& name) {
    return imageOf(FileBytes(name, std::string(bytes)), readPngPicture, readJpegPicture);
}

} // namespace io
