// PNG through libpng's simplified interface, which needs no callbacks.
#include "core/base/error.h"
#include "core/io/pictures/colour_image.h"
#include "core/io/pictures/grey_image.h"

#include <png.h>

namespace io {

namespace {

/// Frees what libpng holds, however reading ends.
struct Reader {
    png_image image{};
    Reader() { image.version = PNG_IMAGE_VERSION; }
    ~Reader() { png_image_free(&image); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

template <class Value>
GreyImage pixels(png_image& image, const std::string& name) {
    const std::size_t count = std::size_t(image.width) * image.height;
    std::vector<Value> raw(count);
    png_color black{};
    if (!png_image_finish_read(&image, &black, raw.data(), 0, nullptr))
        throw base::Error(std::string("broken PNG: ") + image.message, name);
    GreyImage out{int(image.width), int(image.height), std::vector<float>(count)};
    for (std::size_t i = 0; i < count; ++i)
        out.values[i] = static_cast<float>(raw[i]) / static_cast<float>(std::numeric_limits<Value>::max());
    return out;
}

} // namespace

static void begin(png_image& image, std::span<const unsigned char> bytes, const std::string& name) {
    if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()))
        throw base::Error(std::string("broken PNG: ") + image.message, name);
    checkSize(image.width, image.height, bytes.size(), name);
}

GreyImage readPng(std::span<const unsigned char> bytes, const std::string& name) {
    Reader reader;
    png_image& image = reader.image;
    begin(image, bytes, name);
    const bool deep = image.format & PNG_FORMAT_FLAG_LINEAR;
    image.format = deep ? PNG_FORMAT_LINEAR_Y : PNG_FORMAT_GRAY;
    return deep ? pixels<png_uint_16>(image, name) : pixels<png_byte>(image, name);
}

mesh::Picture readPngPicture(std::span<const unsigned char> bytes, const std::string& name) {
    Reader reader;
    png_image& image = reader.image;
    begin(image, bytes, name);
    image.format = PNG_FORMAT_RGBA;
    mesh::Picture out{int(image.width), int(image.height), {}};
    out.pixels.resize(std::size_t(image.width) * image.height);
    if (!png_image_finish_read(&image, nullptr, out.pixels.data(), 0, nullptr))
        throw base::Error(std::string("broken PNG: ") + image.message, name);
    for (surfel::Colour& pixel : out.pixels)
        pixel |= surfel::rgba(0, 0, 0);
    return out;
}

} // namespace io
