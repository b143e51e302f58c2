// JPEG through libjpeg, decoded with its exact integer transform, so that all machines see the same image.
#include "core/base/error.h"
#include "core/io/grey_image.h"

#include <csetjmp>
#include <cstdio>
// after <cstdio>, which it needs
#include <jpeglib.h>

namespace io {

namespace {

/// libjpeg calls this in place of exit(); the jump crosses no destructor but those of C structures.
struct Trouble {
    jpeg_error_mgr manager;
    std::jmp_buf back;
    char message[JMSG_LENGTH_MAX];
};

void leave(j_common_ptr info) {
    auto* trouble = reinterpret_cast<Trouble*>(info->err);
    info->err->format_message(info, trouble->message);
    std::longjmp(trouble->back, 1);
}

void keepQuiet(j_common_ptr) {}

/// Plain C between setjmp and longjmp. Fills `out` where it returns true; `out.values` has room before.
bool decode(jpeg_decompress_struct& info, Trouble& trouble, std::vector<unsigned char>& row, GreyImage& out) {
    if (setjmp(trouble.back))
        return false;
    jpeg_start_decompress(&info);
    while (info.output_scanline < info.output_height) {
        float* to = out.values.data() + std::size_t(info.output_scanline) * info.output_width;
        unsigned char* rows[] = {row.data()};
        jpeg_read_scanlines(&info, rows, 1);
        for (std::size_t x = 0; x < info.output_width; ++x)
            to[x] = static_cast<float>(row[x]) / 255.0f;
    }
    jpeg_finish_decompress(&info);
    return true;
}

bool readHeader(jpeg_decompress_struct& info, Trouble& trouble, std::span<const unsigned char> bytes) {
    if (setjmp(trouble.back))
        return false;
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&info, TRUE);
    info.out_color_space = JCS_GRAYSCALE;
    info.dct_method = JDCT_ISLOW;
    jpeg_calc_output_dimensions(&info);
    return true;
}

struct Reader {
    jpeg_decompress_struct info{};
    Trouble trouble{};
    Reader() {
        info.err = jpeg_std_error(&trouble.manager);
        trouble.manager.error_exit = leave;
        trouble.manager.output_message = keepQuiet;
    }
    ~Reader() { jpeg_destroy_decompress(&info); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

} // namespace

GreyImage readJpeg(std::span<const unsigned char> bytes, const std::string& name) {
    Reader reader;
    if (!readHeader(reader.info, reader.trouble, bytes))
        throw base::Error(std::string("broken JPEG: ") + reader.trouble.message, name);
    const auto width = reader.info.output_width, height = reader.info.output_height;
    if (width > unsigned(GreyImage::maxSide) || height > unsigned(GreyImage::maxSide))
        throw base::Error("the image has more than 8192 pixels a side", name, "make it smaller");
    GreyImage out{int(width), int(height), std::vector<float>(std::size_t(width) * height)};
    std::vector<unsigned char> row(width);
    if (!decode(reader.info, reader.trouble, row, out))
        throw base::Error(std::string("broken JPEG: ") + reader.trouble.message, name);
    return out;
}

} // namespace io
