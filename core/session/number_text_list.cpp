#include "core/session/number_text_list.h"

#include "core/base/error.h"
#include "core/io/number_text.h"

#include <cmath>

namespace session {

std::vector<double> numbersOf(const std::string& text, const std::string& what, std::size_t least, std::size_t most) {
    std::vector<double> out;
    bool good = true;
    for (std::size_t from = 0; good && from <= text.size();) {
        const std::size_t end = std::min(text.find(',', from), text.size());
        std::string_view part = std::string_view(text).substr(from, end - from);
        while (!part.empty() && part.front() == ' ')
            part.remove_prefix(1);
        while (!part.empty() && part.back() == ' ')
            part.remove_suffix(1);
        const auto number = io::numberOf(part);
        good = number && std::isfinite(*number) && std::abs(*number) < 1e30;
        out.push_back(number.value_or(0));
        from = end + 1;
    }
    if (good && out.size() >= least && out.size() <= most)
        return out;
    const std::string count = std::to_string(least) + (least == most ? std::string() : " to " + std::to_string(most));
    throw base::Error("'" + text + "' is not " + count + (most == 1 ? " number" : " numbers with commas between them"),
                      what);
}

base::Vec3d vectorOf(const std::string& text, const std::string& what) {
    const std::vector<double> n = numbersOf(text, what, 3, 3);
    return {n[0], n[1], n[2]};
}

base::Vec3d directionOf(const std::string& text, const std::string& what) {
    const base::Vec3d v = vectorOf(text, what), unit = normalized(v);
    if (unit == base::Vec3d{})
        throw base::Error("'" + text + "' has no direction", what, "give a vector longer than zero");
    return unit;
}

} // namespace session
