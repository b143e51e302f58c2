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

static std::string mimeOf(const io::FormatRow& row) {
    const std::string id = row.id;
    const bool registered = id == "obj" || id == "stl";
    return (registered ? "model/" : "model/x-") + id;
}

template <class Fn>
static void forReadable(const Fn& fn) {
    for (const io::FormatRow& row : io::formatTable())
        if (row.read && !ownExtensions(row).empty())
            fn(row);
}

static std::string typesList() {
    std::string types;
    forReadable([&](const io::FormatRow& row) { types += mimeOf(row) + ";"; });
    return types;
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
    forReadable([&](const io::FormatRow& row) {
        out += "  <mime-type type=\"" + mimeOf(row) + "\">\n    <comment>" + escapedMarkup(row.label) + "</comment>\n";
        for (const std::string& extension : ownExtensions(row))
            out += "    <glob pattern=\"*." + extension + "\"/>\n";
        out += "  </mime-type>\n";
    });
    return out + "</mime-info>\n";
}

std::string thumbnailer() {
    return "[Thumbnailer Entry]\nTryExec=pointclay\nExec=pointclay render %i -o %o --size %sx%s --transparent --quiet\n"
           "MimeType=" +
           typesList() + "\n";
}

std::string softwarePage() {
    std::string types;
    forReadable([&](const io::FormatRow& row) { types += "    <mediatype>" + mimeOf(row) + "</mediatype>\n"; });
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<component type=\"desktop-application\">\n"
           "  <id>pointclay.desktop</id>\n  <metadata_license>CC0-1.0</metadata_license>\n"
           "  <project_license>GPL-3.0-or-later</project_license>\n  <name>Pointclay</name>\n"
           "  <summary>Sculpt and edit point-set surfaces</summary>\n  <description>\n"
           "    <p>Opens raw scans and meshes, knows the smooth surface that their points define, and lets you clean, "
           "repair, measure and sculpt them, with undo and without a mesh in between.</p>\n  </description>\n"
           "  <launchable type=\"desktop-id\">pointclay.desktop</launchable>\n"
           "  <content_rating type=\"oars-1.1\"/>\n  <provides>\n    <binary>pointclay</binary>\n" +
           types + "  </provides>\n</component>\n";
}

} // namespace app
