#include "core/io/obj_materials.h"

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/file_name.h"
#include "core/io/number_text.h"
#include "core/io/text_lines.h"

namespace io {

namespace fs = std::filesystem;

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

/// The first word of `line`, which becomes what follows.
static std::string_view takeWord(std::string_view& line) {
    line = trimmed(line);
    std::size_t size = 0;
    while (size < line.size() && !isBlank(line[size]))
        ++size;
    const std::string_view out = line.substr(0, size);
    line = trimmed(line.substr(size));
    return out;
}

/// What stands behind `map_Kd`: options, which begin with '-' and have numbers, on or off behind them, then the name,
/// which may have blanks.
static PictureName pictureName(std::string_view rest) {
    PictureName out;
    rest = trimmed(rest);
    while (rest.starts_with('-')) {
        const std::string_view option = takeWord(rest);
        for (std::string_view after = rest; !after.empty(); rest = after) {
            const std::string_view value = takeWord(after);
            if (!numberOf(value) && value != "on" && value != "off")
                break;
            if (option == "-clamp")
                out.clamped = value == "on";
            if (after.empty())
                rest = after;
        }
    }
    out.file = rest;
    return out;
}

/// A name that may have blanks, or several without.
static std::vector<fs::path> librariesOf(const fs::path& folder, const std::string& text) {
    std::error_code none;
    if (const fs::path whole = besideModel(folder, text); fs::is_regular_file(whole, none))
        return {whole};
    std::vector<fs::path> out;
    std::string_view rest = text;
    while (!rest.empty())
        if (const fs::path path = besideModel(folder, takeWord(rest)); fs::is_regular_file(path, none))
            out.push_back(path);
    return out;
}

std::map<std::string, PictureName, std::less<>>
readMaterials(const fs::path& folder, const std::vector<std::string>& libraries, std::vector<std::string>& messages) {
    std::map<std::string, PictureName, std::less<>> out;
    for (const std::string& text : libraries) {
        const std::vector<fs::path> files = librariesOf(folder, text);
        if (files.empty())
            messages.push_back("The materials " + inQuotes(text) +
                               " are not beside the model, so that pictures of faces are left out.");
        for (const fs::path& path : files) {
            try {
                const FileBytes file(path);
                const TextLines lines(file, 0);
                std::string material;
                for (std::size_t chunk = 0; chunk < lines.chunks(); ++chunk)
                    lines.forLines(chunk, [&](std::size_t, std::string_view line) {
                        const std::string word = lowerCase(takeWord(line));
                        if (word == "newmtl")
                            material = line;
                        else if (word == "map_kd")
                            out[material] = pictureName(line);
                        return true;
                    });
            } catch (const base::Error& error) {
                messages.push_back("The materials of faces were left out: " + error.message() + ".");
            }
        }
    }
    return out;
}

} // namespace io
