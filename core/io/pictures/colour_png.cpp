#include "core/io/pictures/colour_png.h"

#include "core/base/error.h"

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <new>
#include <png.h>

namespace io {

namespace {

static_assert(std::endian::native == std::endian::little, "a pixel's bytes are red, green, blue, alpha in memory");

void append(png_structp png, png_bytep data, std::size_t size) {
    bool full = false;
    try {
        static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
    } catch (const std::exception&) {
        full = true;
    }
    if (full) // outside the handler, which a jump must not leave
        png_error(png, "out of memory");
}

void leave(png_structp png, png_const_charp) {
    png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

/// libpng's structures, freed however writing ends.
struct Writer {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, ignore);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    Writer() = default;
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
};

constexpr png_uint_32 dotsPerMetre = 3937; // 100 dpi, the usual screen

/// libpng leaves by a jump to here: nothing in this frame has a destructor.
bool write(const Writer& to, std::string& bytes, const std::uint32_t* pixels, png_uint_32 width, png_uint_32 height,
           bool opaque) {
    if (setjmp(png_jmpbuf(to.png)))
        return false;
    png_set_write_fn(to.png, &bytes, append, nullptr);
    png_set_IHDR(to.png, to.info, width, height, 8, opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_pHYs(to.png, to.info, dotsPerMetre, dotsPerMetre, PNG_RESOLUTION_METER);
    png_write_info(to.png, to.info);
    if (opaque)
        png_set_filler(to.png, 0, PNG_FILLER_AFTER); // drops the fourth byte
    for (png_uint_32 row = 0; row < height; ++row)
        png_write_row(to.png, reinterpret_cast<png_const_bytep>(pixels + std::size_t(row) * width));
    png_write_end(to.png, to.info);
    return true;
}

} // namespace

std::string encodePng(std::span<const std::uint32_t> pixels, int width, int height, const std::string& name) {
    const bool opaque = std::all_of(pixels.begin(), pixels.end(), [](std::uint32_t c) { return c >> 24 == 255; });
    const Writer writer;
    std::string bytes;
    if (!writer.info || width < 1 || height < 1 ||
        !write(writer, bytes, pixels.data(), png_uint_32(width), png_uint_32(height), opaque))
        throw base::Error("the image could not be encoded as PNG", name, "choose a smaller size");
    return bytes;
}

} // namespace io
