#include "core/io/packed/gzip.h"

#include "core/io/file_name.h"
#include "core/io/packed/inflate.h"

namespace io {

static constexpr std::string_view magic = "\x1f\x8b";

bool isGzip(const FileBytes& file) {
    return file.bytes().starts_with(magic);
}

/// "model.ply" of "model.ply.gz"; other names stay, and what is inside must tell by itself.
static std::filesystem::path innerName(const std::filesystem::path& path) {
    return extensionOf(path) == "gz" ? path.parent_path() / path.stem() : path;
}

FileBytes unpackedGzip(const FileBytes& file, const base::Progress& progress) {
    const std::size_t most = mostInflated(file.size());
    std::string content;
    std::string_view left = file.bytes();
    while (left.starts_with(magic)) {
        const Inflated part = inflate(left, Wrapping::Gzip, most - content.size(), progress,
                                      [&](std::string_view piece) { content.append(piece); });
        if (part.end == InflateEnd::TooLong)
            file.fail("becomes more than " + std::to_string(most >> 20) + " MiB when it is unpacked",
                      "unpack it with gunzip and open that, if you trust it");
        if (part.end != InflateEnd::Whole)
            file.fail(part.end == InflateEnd::CutOff ? "the packed bytes break off" : "the packed bytes are damaged",
                      "fetch it again");
        left.remove_prefix(part.used);
    }
    if (content.empty())
        file.fail("is packed and holds nothing", "choose a file that holds points");
    return {innerName(file.path()), std::move(content), file.path()};
}

} // namespace io
