#include "core/io/content_kind.h"

#include "core/io/file_name.h"
#include "core/io/record_table.h"

#include <algorithm>

namespace io {

static const char* const readable =
    "convert it to one of PLY, XYZ, TXT, CSV, PTS, PWN, OBJ, OFF, STL, PCD, LAS, LAZ, E57, PTX, GLB, glTF or 3MF";

namespace {

struct Unreadable {
    const char* extension; ///< "" where only the content tells
    const char* start;     ///< "" where only the extension tells
    const char* name;
};
constexpr Unreadable unreadables[] = {{"", "\x1f\x8b", "gzip twice over"},
                                      {"zip", "PK\x03\x04", "ZIP"},
                                      {"bz2", "BZh", "bzip2"},
                                      {"fbx", "Kaydara FBX", "FBX"},
                                      {"3ds", "", "3DS"},
                                      {"", "[Expe/PointSet", "binary Expe point set"},
                                      {"", "\x89PNG", "PNG picture"},
                                      {"", "%PDF", "PDF"},
                                      {"",
                                       "\x7f"
                                       "ELF",
                                       "program"}};

[[noreturn]] void refuse(const FileBytes& file, const char* name) {
    file.fail(std::string("is in the format ") + name + ", which cannot be read", readable);
}

/// The first word of an OFF file: OFF with prefixes ST, C, N, 4, n in that order.
bool isOffWord(std::string_view word) {
    if (!word.ends_with("OFF") || word.size() > 8)
        return false;
    word.remove_suffix(3);
    return word.find_first_not_of("STCN4n") == std::string_view::npos;
}

/// A binary STL has 50 bytes for each facet that it counts after its 80 bytes of header.
bool isBinaryStl(std::string_view bytes) {
    if (bytes.size() < 134)
        return false;
    return (bytes.size() - 84) / 50 == load<std::uint32_t, false>(bytes.data() + 80) && (bytes.size() - 84) % 50 == 0;
}

/// ZIP archives list their entries' names at their end.
bool holds3mf(std::string_view bytes) {
    return bytes.find("3dmodel.model") != std::string_view::npos;
}

} // namespace

void refuseUnreadable(const FileBytes& file, const std::string& extension) {
    for (const Unreadable& row : unreadables)
        if (*row.extension && extension == row.extension)
            refuse(file, row.name);
}

std::string contentKind(const FileBytes& file) {
    const std::string_view bytes = file.bytes();
    if (bytes.starts_with("version https://git-lfs"))
        file.fail("is only a git-lfs pointer, not the file itself", "fetch it with 'git lfs pull'");
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
        file.fail("is text in UTF-16, which cannot be read", "save it as UTF-8 or ASCII");
    if (bytes.starts_with("PK\x03\x04") && (extensionOf(file.path()) == "3mf" || holds3mf(bytes)))
        return "3mf";
    for (const Unreadable& row : unreadables)
        if (*row.start && bytes.starts_with(row.start))
            refuse(file, row.name);
    if (bytes.starts_with("# .PCD"))
        return "pcd";
    if (bytes.starts_with("LASF"))
        return "las";
    if (bytes.starts_with("glTF"))
        return "gltf";
    if (bytes.starts_with("ASTM-E57"))
        return "e57";
    const std::string_view word = bytes.substr(0, std::min<std::size_t>(bytes.find_first_of(" \t\r\n"), 16));
    if (word == "ply")
        return "ply";
    if (isOffWord(word))
        return "off";
    return isBinaryStl(bytes) ? "stl" : "";
}

} // namespace io
