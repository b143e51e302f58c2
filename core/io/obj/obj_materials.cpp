#include "core/io/obj/obj_materials.h"

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/file_name.h"
#include "core/io/number_text.h"
#include "core/io/text/text_lines.h"

#include <algorithm>
#include <cmath>
#include <span>

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

/// The numbers behind an option of `map_Kd`, those that are not finite as well as those that are not there left as they
/// are.
static void setPair(std::span<const double> given, double (&out)[2]) {
    for (std::size_t k = 0; k < std::min(given.size(), std::size(out)); ++k)
        out[k] = std::isfinite(given[k]) ? given[k] : out[k];
}

/// What stands behind `map_Kd`: options, which begin with '-' and have numbers, on or off behind them, then the name,
/// which may have blanks.
static void takePicture(std::string_view rest, ObjMaterial& out) {
    ObjMaterial found;
    found.colour = out.colour;
    rest = trimmed(rest);
    while (rest.starts_with('-')) {
        const std::string_view option = takeWord(rest);
        std::vector<double> given;
        for (;;) {
            std::string_view after = rest;
            const std::string_view value = takeWord(after);
            const std::optional<double> number = numberOf(value);
            if (!number && value != "on" && value != "off")
                break;
            if (number)
                given.push_back(*number);
            if (option == "-clamp")
                found.picture.clamped = value == "on";
            rest = after;
        }
        if (option == "-s")
            setPair(given, found.scale);
        else if (option == "-o")
            setPair(given, found.offset);
    }
    found.picture.file = rest;
    out = std::move(found);
}

/// Behind `Kd`: red, green and blue from 0 to 1, of which the last two may be left out; nothing for a spectrum.
static std::optional<surfel::Colour> colourOf(std::string_view rest) {
    unsigned channels[3] = {};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::optional<double> value = numberOf(takeWord(rest));
        if (!value && k == 0)
            return {};
        channels[k] = value && *value == *value ? static_cast<unsigned>(std::lround(255 * std::clamp(*value, 0.0, 1.0)))
                                                : channels[0];
    }
    return surfel::rgba(channels[0], channels[1], channels[2]);
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

std::map<std::string, ObjMaterial, std::less<>>
readMaterials(const fs::path& folder, const std::vector<std::string>& libraries, std::vector<std::string>& messages) {
    std::map<std::string, ObjMaterial, std::less<>> out;
    for (const std::string& text : libraries) {
        const std::vector<fs::path> files = librariesOf(folder, text);
        if (files.empty())
            messages.push_back("The materials " + inQuotes(text) +
                               " are not beside the model, so that colours and pictures of faces are left out.");
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
                            takePicture(line, out[material]);
                        else if (word == "kd")
                            out[material].colour = colourOf(line);
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
