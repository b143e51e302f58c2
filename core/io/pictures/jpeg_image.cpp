// JPEG through libjpeg, decoded with its exact integer transform, so that all machines see the same image.
#include "core/base/error.h"
#include "core/io/pictures/colour_image.h"
#include "core/io/pictures/grey_image.h"

#include <csetjmp>
#include <cstdio>
// after <cstdio>, which it needs
#include <jerror.h>
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

/// Warnings stay quiet but for one: what lies behind the end of the file would be grey.
void warn(j_common_ptr info, int level) {
    if (level < 0 && info->err->msg_code == JWRN_JPEG_EOF)
        leave(info);
}

/// Plain C between setjmp and longjmp: calls `take(line, samples)` for each line of pixels. `row` has room for one.
template <class Take>
bool decode(jpeg_decompress_struct& info, Trouble& trouble, std::vector<unsigned char>& row, const Take& take) {
    if (setjmp(trouble.back))
        return false;
    jpeg_start_decompress(&info);
    while (info.output_scanline < info.output_height) {
        const std::size_t line = info.output_scanline;
        unsigned char* rows[] = {row.data()};
        jpeg_read_scanlines(&info, rows, 1);
        take(line, row.data());
    }
    jpeg_finish_decompress(&info);
    return true;
}

bool readHeader(jpeg_decompress_struct& info, Trouble& trouble, std::span<const unsigned char> bytes,
                J_COLOR_SPACE colours) {
    if (setjmp(trouble.back))
        return false;
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&info, TRUE);
    info.out_color_space = colours;
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
        trouble.manager.emit_message = warn;
    }
    ~Reader() { jpeg_destroy_decompress(&info); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

/// Reads an image of that many samples per pixel; `prepare(width, height)` makes room.
template <class Prepare, class Take>
void readLines(std::span<const unsigned char> bytes, const std::string& name, J_COLOR_SPACE colours,
               std::size_t samples, const Prepare& prepare, const Take& take) {
    Reader reader;
    const auto broken = [&] { return base::Error(std::string("broken JPEG: ") + reader.trouble.message, name); };
    if (!readHeader(reader.info, reader.trouble, bytes, colours))
        throw broken();
    const auto width = reader.info.output_width, height = reader.info.output_height;
    checkSize(width, height, bytes.size(), name);
    prepare(int(width), int(height));
    std::vector<unsigned char> row(samples * width);
    if (!decode(reader.info, reader.trouble, row, take))
        throw broken();
}

} // namespace

GreyImage readJpeg(std::span<const unsigned char> bytes, const std::string& name) {
    GreyImage out;
    readLines(
        bytes, name, JCS_GRAYSCALE, 1,
        [&](int width, int height) {
            out = {width, height, std::vector<float>(std::size_t(width) * std::size_t(height))};
        },
        [&](std::size_t line, const unsigned char* row) {
            float* to = out.values.data() + line * std::size_t(out.width);
            for (int x = 0; x < out.width; ++x)
                to[x] = static_cast<float>(row[x]) / 255.0f;
        });
    return out;
}

mesh::Picture readJpegPicture(std::span<const unsigned char> bytes, const std::string& name) {
    mesh::Picture out;
    readLines(
        bytes, name, JCS_RGB, 3,
        [&](int width, int height) {
            out.width = width, out.height = height;
            out.pixels.resize(std::size_t(width) * std::size_t(height));
        },
        [&](std::size_t line, const unsigned char* row) {
            surfel::Colour* to = out.pixels.data() + line * std::size_t(out.width);
            for (int x = 0; x < out.width; ++x, row += 3)
                to[x] = surfel::rgba(row[0], row[1], row[2]);
        });
    return out;
}

} // namespace io
