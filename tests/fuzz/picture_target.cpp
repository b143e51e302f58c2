// PNG and JPEG: stamps of brushes and pictures of faces.
#include "core/io/pictures/colour_image.h"
#include "core/io/pictures/grey_image.h"
#include "fuzz/fuzzed.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const unsigned char> bytes(data, size);
    const bool png = size > 0 && data[0] == 0x89;
    fuzz::tried([&] {
        const io::GreyImage image = png ? io::readPng(bytes, "a.png") : io::readJpeg(bytes, "a.jpg");
        fuzz::require(image.values.size() == std::size_t(image.width) * std::size_t(image.height), "all grey pixels");
        for (const float value : image.values)
            fuzz::require(value >= 0 && value <= 1, "grey is 0 to 1");
    });
    fuzz::tried([&] {
        const mesh::Picture image = png ? io::readPngPicture(bytes, "a.png") : io::readJpegPicture(bytes, "a.jpg");
        fuzz::require(image.pixels.size() == std::size_t(image.width) * std::size_t(image.height), "all pixels");
    });
    return 0;
}
