#include "core/session/number_lists.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace session {

using base::Vec3d;
using nlohmann::json;

std::vector<double> numbersOf(const json& complete, const char* id, std::size_t count, const char* wish) {
    const json& list = complete.at(id);
    std::vector<double> out;
    for (std::size_t i = 0; list.is_array() && i < list.size(); ++i)
        if (list[i].is_number() && std::abs(list[i].get<double>()) <= CommandParameter::largest)
            out.push_back(list[i].get<double>());
    if (out.size() != count || out.size() != list.size())
        throw base::Error("\"" + std::string(id) + "\" of \"" + complete.at("op").get<std::string>() +
                              "\" is no list of " + std::to_string(count) + " numbers",
                          {}, std::string("write ") + wish);
    return out;
}

std::optional<Vec3d> vectorOf(const json& complete, const char* id) {
    if (!complete.contains(id))
        return {};
    const std::vector<double> v = numbersOf(complete, id, 3, "[x,y,z]");
    return Vec3d{v[0], v[1], v[2]};
}

std::optional<Vec3d> placeOf(const Context& context, const json& complete, const char* id) {
    const std::optional<Vec3d> out = vectorOf(complete, id);
    return out ? std::optional(*out - context.document.provenance().origin) : out;
}

std::vector<Vec3d> placesOf(const Context& context, const json& complete, const char* id) {
    std::vector<double> numbers;
    const auto wrong = [&] {
        return base::Error("\"" + std::string(id) + "\" of \"" + complete.at("op").get<std::string>() +
                               "\" is no list of places",
                           {}, "give three numbers for each place");
    };
    const auto take = [&](const json& number) {
        if (!number.is_number() || !(std::abs(number.get<double>()) <= CommandParameter::largest))
            throw wrong();
        numbers.push_back(number.get<double>());
    };
    for (const json& each : complete.at(id))
        if (!each.is_array())
            take(each);
        else if (each.size() == 3)
            std::for_each(each.begin(), each.end(), take);
        else
            throw wrong();
    if (numbers.empty() || numbers.size() % 3 != 0)
        throw wrong();
    std::vector<Vec3d> out;
    for (std::size_t i = 0; i < numbers.size(); i += 3)
        out.push_back(Vec3d{numbers[i], numbers[i + 1], numbers[i + 2]} - context.document.provenance().origin);
    return out;
}

base::Plane planeOf(const Context& context, const json& complete, const char* id) {
    const std::vector<double> v = numbersOf(complete, id, 4, "[nx,ny,nz,d]");
    const Vec3d n{v[0], v[1], v[2]};
    if (!(length(n) > 0))
        throw base::Error("\"" + std::string(id) + "\" has no direction", {}, "give it a normal that is not zero");
    return base::Plane{n / length(n), v[3] / length(n)}.relativeTo(context.document.provenance().origin);
}

std::optional<Turn> turnOf(const json& complete) {
    if (complete.contains("axis") != complete.contains("angle"))
        throw base::Error("\"axis\" and \"angle\" belong together", {}, "give both or none");
    const std::optional<Vec3d> axis = vectorOf(complete, "axis");
    if (!axis)
        return {};
    if (!(length(*axis) > 0))
        throw base::Error("\"axis\" is zero", {}, "give it a length");
    return Turn{*axis, complete.at("angle").get<double>() * (std::numbers::pi / 180)};
}

surfel::Colour colourOf(const json& complete, const char* id) {
    const std::vector<double> c = numbersOf(complete, id, 3, "[red,green,blue] from 0 to 255");
    for (const double part : c)
        if (part < 0 || part > 255)
            throw base::Error("\"" + std::string(id) + "\" is no colour", {}, "write [red,green,blue] from 0 to 255");
    const auto byte = [&](std::size_t k) { return static_cast<unsigned>(std::lround(c[k])); };
    return surfel::rgba(byte(0), byte(1), byte(2));
}

} // namespace session
