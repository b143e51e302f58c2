#include "core/session/stroke_json.h"

#include "core/base/error.h"
#include "core/session/json_text.h"
#include "core/session/option_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace session {

using base::Vec3d;
using base::Vec3f;
using nlohmann::json;
using sculpt::StrokeSample;
using sculpt::StrokeSettings;

static Vec3f inside(const Vec3d& file, const Vec3d& origin) {
    return base::cast<float>(file - origin);
}

static Vec3d outside(const Vec3f& p, const Vec3d& origin) {
    return base::cast<double>(p) + origin;
}

StrokeSample recordable(const StrokeSample& sample, const Vec3d& origin) {
    StrokeSample out = sample;
    // One round puts a coordinate on the grid of the sum; a second is needed where that crosses a power of two.
    for (int round = 0; round < 4; ++round) {
        const Vec3f next = inside(outside(out.ray.origin, origin), origin);
        if (next == out.ray.origin)
            break;
        out.ray.origin = next;
    }
    return out;
}

json strokeLine(const StrokeSettings& settings, std::span<const StrokeSample> samples, const Vec3d& origin) {
    json line{{"op", "stroke"}, {"tool", settings.tool}};
    for (const sculpt::StrokeOption& option : sculpt::strokeOptionTable())
        if (json value = valueOf(option, settings); !value.is_null())
            line[option.id] = std::move(value);
    for (const auto& [id, value] : settings.parameters)
        line[id] = value;
    json& list = line["samples"] = json::array();
    for (const StrokeSample& s : samples) {
        const Vec3d o = outside(s.ray.origin, origin);
        const Vec3f& d = s.ray.direction;
        list.push_back({o.x, o.y, o.z, d.x, d.y, d.z, s.pressure, s.seconds});
        if (s.stride != 1 || s.reach != 0)
            list.back().push_back(s.stride);
        if (s.reach != 0)
            list.back().push_back(s.reach);
    }
    return line;
}

StrokeSettings strokeSettings(const json& complete) {
    StrokeSettings out;
    const sculpt::ToolRow& tool = sculpt::tool(complete.at("tool").get<std::string>());
    out.tool = tool.id;
    out.strength = static_cast<float>(tool.strength);
    for (const sculpt::StrokeOption& option : sculpt::strokeOptionTable())
        if (complete.contains(option.id))
            setValue(option, complete[option.id], out);
    for (const sculpt::ToolParameter& p : tool.parameters)
        if (complete.contains(p.id))
            out.parameters[p.id] = complete[p.id].get<double>();
    return out;
}

/// Beyond it places would overflow float32 once their distances are squared.
constexpr float farthestReach = 1e15f;

static bool isSample(const json& row) {
    if (!row.is_array() || row.size() < 8 || row.size() > 10)
        return false;
    for (const json& value : row)
        if (!value.is_number() || !std::isfinite(value.get<float>()))
            return false;
    const float pressure = row[6].get<float>(), stride = row.size() > 8 ? row[8].get<float>() : 1,
                reach = row.size() > 9 ? row[9].get<float>() : 0;
    const Vec3f direction{row[3].get<float>(), row[4].get<float>(), row[5].get<float>()};
    return base::length(direction) > 0 && pressure >= 0 && pressure <= 1 && row[7].get<float>() >= 0 && stride >= 1 &&
           stride <= StrokeSample::maxStride && reach >= 0 && reach < farthestReach;
}

std::vector<StrokeSample> strokeSamples(const json& complete, const Vec3d& origin) {
    const json& rows = complete.at("samples");
    std::vector<StrokeSample> out;
    out.reserve(rows.size());
    for (const json& row : rows) {
        if (!isSample(row))
            throw base::Error(
                "sample " + std::to_string(out.size() + 1) + " of the stroke is " + shortly(row, 200), {},
                "a sample is [ox,oy,oz,dx,dy,dz,pressure,seconds] with a direction that is not zero, "
                "pressure 0 to 1, seconds of at least 0, and optionally a stride of 1 to 10 and a reach of at "
                "least 0 and below 1e15");
        const auto at = [&row](std::size_t k) { return row[k].get<float>(); };
        const Vec3d file{row[0].get<double>(), row[1].get<double>(), row[2].get<double>()};
        out.push_back({{inside(file, origin), {at(3), at(4), at(5)}},
                       at(6),
                       at(7),
                       row.size() > 8 ? at(8) : 1,
                       row.size() > 9 ? at(9) : 0});
    }
    return out;
}

} // namespace session
