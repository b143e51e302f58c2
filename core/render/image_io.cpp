#include "core/render/image_io.h"

#include "core/base/error.h"
#include "core/io/safe_file.h"

#include <bit>
#include <cstring>
#include <QBuffer>
#include <QImage>

namespace render {

void savePng(const Image& image, const std::filesystem::path& path) {
    static_assert(std::endian::native == std::endian::little, "Colour's bytes are red, green, blue, alpha in memory");
    const bool opaque = std::all_of(image.colour.begin(), image.colour.end(), [](auto c) { return c >> 24 == 255; });
    const QImage picture(reinterpret_cast<const uchar*>(image.colour.data()), image.width, image.height,
                         static_cast<qsizetype>(image.width) * 4,
                         opaque ? QImage::Format_RGBX8888 : QImage::Format_RGBA8888);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, "PNG"))
        throw base::Error("the image could not be encoded as PNG", path.string(), "choose a smaller size");
    io::writeFile(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
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
