#include "core/io/ply/ply_comments.h"

#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/io/file_bytes.h"
#include "core/io/number_text.h"
#include "core/surface/definition_text.h"

#include <algorithm>

namespace io {

static constexpr std::string_view prefix = "pointclay ";

static std::optional<base::Vec3d> vectorOf(std::string_view words) {
    base::Vec3d out;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t end = k < 2 ? words.find(' ') : words.size();
        if (end == std::string_view::npos)
            return {};
        const auto value = numberOf(words.substr(0, end));
        if (!value || !std::isfinite(*value))
            return {};
        out[k] = *value;
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return out;
}

/// Returns whether the line was understood.
static bool takeLine(std::string_view line, NativeComments& out) {
    const std::size_t blank = line.find(' ');
    const std::string_view word = line.substr(0, blank);
    const std::string_view rest = blank == std::string_view::npos ? std::string_view() : line.substr(blank + 1);
    if (word == "origin")
        return (out.origin = vectorOf(rest)).has_value();
    if (word == "normals" && (rest == "oriented" || rest == "unoriented")) {
        out.oriented = rest == "oriented";
        return true;
    }
    if (word == "up") {
        const base::UpRow* row = base::findRow(base::upTable(), rest);
        if (row)
            out.up = row->axis;
        return row != nullptr;
    }
    if (word != "surface")
        return false;
    try {
        out.definition = surface::definitionFromWords(rest);
        out.limitDecided = rest.find("boundary-limit=") != std::string_view::npos;
    } catch (const base::Error&) {
        return false; // told in the caller's message: the points are still good
    }
    return true;
}

NativeComments takeNativeComments(std::vector<std::string>& comments, std::vector<std::string>& messages) {
    NativeComments out;
    std::erase_if(comments, [&](const std::string& comment) {
        if (!std::string_view(comment).starts_with(prefix))
            return false;
        if (!takeLine(std::string_view(comment).substr(prefix.size()), out))
            messages.push_back("The comment line " + inQuotes(comment) + " is not understood and was left out.");
        return true;
    });
    return out;
}

std::string nativeCommentLines(const NativeComments& native) {
    std::string out = "comment pointclay origin";
    for (std::size_t k = 0; k < 3; ++k) {
        out += ' ';
        appendNumber(out, (*native.origin)[k]);
    }
    out += '\n';
    if (native.oriented)
        out += std::string("comment pointclay normals ") + (*native.oriented ? "oriented" : "unoriented") + "\n";
    if (native.up)
        out += std::string("comment pointclay up ") + base::upRow(*native.up).id + "\n";
    if (native.definition)
        out += "comment pointclay surface " + surface::toWords(*native.definition, native.limitDecided) + "\n";
    return out;
}

} // namespace io
