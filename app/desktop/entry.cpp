// The entry, types of files, thumbnails and the page in a software centre: loops over the table of formats.
#include "app/desktop/desktop_files.h"
#include "app/desktop/markup.h"
#include "core/io/formats.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace app {

static std::vector<std::string> wordsOf(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> out;
    for (std::string word; in >> word;)
        out.push_back(word);
    return out;
}

/// Extensions that are a format's own: texts and tables belong to other programs.
static std::vector<std::string> ownExtensions(const io::FormatRow& row) {
    std::vector<std::string> out = wordsOf(row.extensions);
    std::erase_if(out, [](const std::string& each) { return each == "txt" || each == "csv" || each == "asc"; });
    return out;
}

namespace {

struct Type {
    std::string mime, label;
    std::vector<std::string> extensions;
};

/// Types that the desktop knows already keep their names: a second one beside them would open nothing.
std::string mimeOf(const io::FormatRow& row, const std::string& extension) {
    static constexpr std::pair<const char*, const char*> registered[] = {{"obj", "model/obj"},
                                                                         {"stl", "model/stl"},
                                                                         {"3mf", "model/3mf"},
                                                                         {"glb", "model/gltf-binary"},
                                                                         {"gltf", "model/gltf+json"}};
    for (const auto& [known, mime] : registered)
        if (extension == known)
            return mime;
    return std::string("model/x-") + row.id;
}

/// Of all that can be read, in the order of the table of formats.
std::vector<Type> types() {
    std::vector<Type> out;
    for (const io::FormatRow& row : io::formatTable())
        for (const std::string& extension : row.read ? ownExtensions(row) : std::vector<std::string>()) {
            const std::string mime = mimeOf(row, extension);
            auto at = std::find_if(out.begin(), out.end(), [&](const Type& each) { return each.mime == mime; });
            if (at == out.end())
                at = out.insert(out.end(), {mime, row.label, {}});
            at->extensions.push_back(extension);
        }
    return out;
}

} // namespace

static std::string typesList() {
    std::string out;
    for (const Type& type : types())
        out += type.mime + ";";
    return out;
}

std::string desktopEntry() {
    return "[Desktop Entry]\nType=Application\nName=Pointclay\nGenericName=Sculptor of point-set surfaces\n"
           "Comment=Sculpts and edits point-set surfaces\nExec=pointclay %F\nIcon=pointclay\nTerminal=false\n"
           "Categories=Graphics;3DGraphics;\nStartupWMClass=pointclay\nMimeType=" +
           typesList() + "\n";
}

std::string mimeTypes() {
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                      "<mime-info xmlns=\"http://www.freedesktop.org/standards/shared-mime-info\">\n";
    for (const Type& type : types()) {
        out += "  <mime-type type=\"" + type.mime + "\">\n    <comment>" + escapedMarkup(type.label) + "</comment>\n";
        for (const std::string& extension : type.extensions)
            out += "    <glob pattern=\"*." + extension + "\"/>\n";
        out += "  </mime-type>\n";
    }
    return out + "</mime-info>\n";
}

std::string thumbnailer() {
    return "[Thumbnailer Entry]\nTryExec=pointclay\nExec=pointclay render %i -o %o --size %sx%s --transparent --quiet\n"
           "MimeType=" +
           typesList() + "\n";
}

std::string softwarePage() {
    std::string mediatypes;
    for (const Type& type : types())
        mediatypes += "    <mediatype>" + type.mime + "</mediatype>\n";
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<component type=\"desktop-application\">\n"
           "  <id>pointclay.desktop</id>\n  <metadata_license>CC0-1.0</metadata_license>\n"
           "  <project_license>GPL-3.0-or-later</project_license>\n  <name>Pointclay</name>\n"
           "  <summary>Sculpt and edit point-set surfaces</summary>\n  <description>\n"
           "    <p>Opens raw scans and meshes, knows the smooth surface that their points define, and lets you clean, "
           "repair, measure and sculpt them, with undo and without a mesh in between.</p>\n  </description>\n"
           "  <launchable type=\"desktop-id\">pointclay.desktop</launchable>\n"
           "  <content_rating type=\"oars-1.1\"/>\n  <provides>\n    <binary>pointclay</binary>\n" +
           mediatypes + "  </provides>\n</component>\n";
}

} // namespace app
