#include "core/io/text/text_preview.h"

#include "core/base/box.h"
#include "core/base/error.h"
#include "core/io/file_name.h"
#include "core/io/packed/gzip.h"
#include "core/io/readers.h"

#include <algorithm>
#include <fstream>

namespace io {

/// To the end of its last whole line. Empty for what is no file: looking into a pipe would take from it.
static std::string beginningOf(const path& path) {
    constexpr std::size_t most = std::size_t(1) << 18;
    std::error_code none;
    if (!std::filesystem::is_regular_file(path, none))
        return {};
    std::ifstream in(path, std::ios::binary);
    std::string out(most, '\0');
    in.read(out.data(), static_cast<std::streamsize>(most));
    out.resize(static_cast<std::size_t>(in.gcount()));
    if (out.size() < most)
        return out;
    const std::size_t end = out.find_last_of("\r\n");
    return out.substr(0, end == std::string::npos ? 0 : end + 1);
}

std::optional<TextPreview> previewText(const path& path, const std::vector<std::string>& columns) {
    std::string content = beginningOf(path);
    if (content.empty())
        return std::nullopt;
    const FileBytes file(path, std::move(content));
    if (isGzip(file) || !isText(file))
        return std::nullopt;
    TextRead read = readTextAs(file, {}, {columns, true});
    base::Box3f box;
    for (const surfel::Surfel& each : read.model.points.items)
        box.extend(each.position);
    return TextPreview{std::move(read.columns), std::move(read.rows), base::cast<double>(box.hi - box.lo),
                       std::move(read.model.messages), read.sure};
}

FileModel readColumns(const path& path, const std::vector<std::string>& columns, const base::Progress& progress) {
    const auto readPlain = [&](const FileBytes& file) {
        if (!isText(file))
            file.fail("tells itself what it holds", "leave out the columns, which are told of text alone");
        return readTextAs(file, progress, {columns, false}).model;
    };
    const FileBytes file(path);
    return isGzip(file) ? readPlain(unpackedGzip(file, progress)) : readPlain(file);
}

std::vector<std::string> columnNames(std::string_view text) {
    constexpr std::string_view between = " ,;\t";
    std::vector<std::string> out;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(between), text.size());
        const std::string name(text.substr(0, end));
        if (!name.empty() && name != "-" && std::find(out.begin(), out.end(), name) != out.end())
            throw base::Error("two columns are called " + inQuotes(name), "columns",
                              "give each a name of its own, and - to those to be left out");
        if (!name.empty())
            out.push_back(name);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    for (const char* wanted : {"x", "y", "z"})
        if (std::find_if(out.begin(), out.end(), [&](const auto& each) { return lowerCase(each) == wanted; }) ==
            out.end())
            throw base::Error(std::string("no column is called ") + wanted, "columns",
                              "name all of them in their order, such as x,y,z,-,red,green,blue");
    return out;
}

} // namespace io
