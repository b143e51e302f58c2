// PNG through libpng's simplified interface, which needs no callbacks.
#include "core/base/error.h"
#include "core/io/grey_image.h"

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

GreyImage readPng(std::span<const unsigned char> bytes, const std::string& name) {
    Reader reader;
    png_image& image = reader.image;
    if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()))
        throw base::Error(std::string("broken PNG: ") + image.message, name);
    if (image.width > png_uint_32(GreyImage::maxSide) || image.height > png_uint_32(GreyImage::maxSide))
        throw base::Error("the image has more than 8192 pixels a side", name, "make it smaller");
    const bool deep = image.format & PNG_FORMAT_FLAG_LINEAR;
    image.format = deep ? PNG_FORMAT_LINEAR_Y : PNG_FORMAT_GRAY;
    return deep ? pixels<png_uint_16>(image, name) : pixels<png_byte>(image, name);
}

} // namespace io
