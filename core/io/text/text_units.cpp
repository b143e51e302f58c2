#include "core/io/text/text_units.h"

#include "core/io/file_name.h"

#include <algorithm>

namespace io {

std::string_view unitOf(std::string_view text) {
    struct Unit {
        std::string_view name;
        std::string_view spellings[7];
    };
    static constexpr Unit units[] = {
        {"millimeter", {"mm", "millimeter", "millimeters", "millimetre", "millimetres"}},
        {"centimeter", {"cm", "centimeter", "centimeters", "centimetre", "centimetres", "zentimeter"}},
        {"meter", {"m", "meter", "meters", "metre", "metres"}},
        {"micron", {"um", "\xc2\xb5m", "\xce\xbcm", "micron", "microns"}},
        {"inch", {"in", "inch", "inches", "zoll"}},
        {"foot", {"ft", "foot", "feet"}},
    };
    constexpr std::string_view around = " \t[]()<>\"";
    const std::size_t first = text.find_first_not_of(around);
    if (first == std::string_view::npos)
        return {};
    const std::string bare = lowerCase(text.substr(first, text.find_last_not_of(around) + 1 - first));
    for (const Unit& unit : units)
        for (const std::string_view spelling : unit.spellings)
            if (!spelling.empty() && bare == spelling)
                return unit.name;
    return {};
}

std::string_view inBrackets(std::string_view name) {
    const std::size_t open = name.find_first_of("([");
    return open == std::string_view::npos ? std::string_view() : name.substr(open);
}

bool areUnits(std::span<const std::string_view> fields) {
    return std::count_if(fields.begin(), fields.end(), [](std::string_view f) { return !unitOf(f).empty(); }) >= 3;
}

std::optional<std::string> unitOfAxes(const std::array<std::size_t, 3>& axes, std::span<const std::string> names,
                                      std::span<const std::string> below) {
    std::array<std::string_view, 3> units;
    for (std::size_t k = 0; k < 3; ++k)
        units[k] = axes[k] < below.size()   ? unitOf(below[axes[k]])
                   : axes[k] < names.size() ? unitOf(inBrackets(names[axes[k]]))
                                            : std::string_view();
    return units[0] == units[1] && units[0] == units[2] ? std::optional(std::string(units[0])) : std::nullopt;
}

} // namespace io
