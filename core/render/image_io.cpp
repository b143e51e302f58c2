#include "core/render/image_io.h"

#include "core/io/pictures/colour_png.h"
#include "core/io/safe_file.h"

#include <cstring>

namespace render {

void savePng(const Image& image, const std::filesystem::path& path) {
    io::writeFile(path, io::encodePng(image.colour, image.width, image.height, path.string()));
}

void savePfm(const Image& image, const std::filesystem::path& path) {
    // Debevec's portable float map; the negative scale says little-endian.
    std::string bytes = "Pf\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
    const std::size_t line = static_cast<std::size_t>(image.width) * sizeof(float), header = bytes.size();
    bytes.resize(header + line * static_cast<std::size_t>(image.height));
    for (int row = 0; row < image.height; ++row)
        std::memcpy(bytes.data() + header + line * static_cast<std::size_t>(image.height - 1 - row),
                    image.depth.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width), line);
    io::writeFile(path, bytes);
}

} // namespace render
