#include "core/session/stroke_json.h"

#include "core/base/error.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

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

static json pointsJson(const sculpt::CurvePoints& points) {
    json out = json::array();
    for (const sculpt::CurvePoint& point : points)
        out.push_back({point.x, point.y});
    return out;
}

static sculpt::CurvePoints pointsOf(const json& complete, const char* id) {
    sculpt::CurvePoints out;
    for (const json& point : complete.at(id)) {
        if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number())
            throw base::Error("\"" + std::string(id) + "\" holds " + point.dump(), {},
                              "it is a list of points [x,y] between 0 and 1, as [[0,1],[0.5,0.8],[1,0]]");
        out.push_back({point[0].get<float>(), point[1].get<float>()});
    }
    sculpt::BrushCurve(out, id);
    return out;
}

constexpr const char* axes[] = {"x", "y", "z"};

/// Degrees in lines and in the interface. In double, so that what was read is what is written.
static double degreesOf(float radians) {
    return double(radians) * 180 / std::numbers::pi;
}
static float radiansOf(double degrees) {
    return static_cast<float>(degrees * std::numbers::pi / 180);
}

json strokeLine(const StrokeSettings& settings, std::span<const StrokeSample> samples, const Vec3d& origin) {
    json symmetry = json::array();
    for (const auto& [axis, on] :
         {std::pair{"x", settings.symmetry.x}, {"y", settings.symmetry.y}, {"z", settings.symmetry.z}})
        if (on)
            symmetry.push_back(axis);
    json line{{"op", "stroke"},
              {"tool", settings.tool},
              {"radius", settings.radius},
              {"strength", settings.strength},
              {"invert", settings.invert},
              {"falloff", sculpt::row(settings.falloff).id},
              {"symmetry", std::move(symmetry)},
              {"resample", settings.resample},
              {"graded", settings.graded},
              {"spacing", settings.spacing},
              {"method", sculpt::row(settings.method).id},
              {"rate", settings.rate},
              {"stabiliser", settings.stabiliser},
              {"pressure-strength", pointsJson(settings.pressureStrength)},
              {"pressure-radius", pointsJson(settings.pressureRadius)},
              {"falloff-curve", pointsJson(settings.falloffCurve)},
              {"radial", settings.symmetry.copies},
              {"radial-axis", axes[settings.symmetry.axis]},
              {"accumulate", settings.accumulate},
              {"auto-smooth", settings.autoSmooth},
              {"front-facing", settings.frontFacing},
              {"connected", settings.connected},
              {"normal-radius", settings.normalRadius},
              {"plane-radius", settings.planeRadius},
              {"stamp-angle", degreesOf(settings.stampAngleRad)},
              {"stamp-follows", settings.stampFollows}};
    if (!settings.stamp.empty())
        line["stamp"] = settings.stamp;
    for (const auto& [id, value] : settings.parameters)
        line[id] = value;
    json& list = line["samples"] = json::array();
    for (const StrokeSample& s : samples) {
        const Vec3d o = outside(s.ray.origin, origin);
        const Vec3f& d = s.ray.direction;
        list.push_back({o.x, o.y, o.z, d.x, d.y, d.z, s.pressure, s.seconds});
        if (s.stride != 1)
            list.back().push_back(s.stride);
    }
    return line;
}

static sculpt::Symmetry symmetryOf(const json& planes) {
    sculpt::Symmetry out;
    for (const json& axis : planes)
        if (axis == "x")
            out.x = true;
        else if (axis == "y")
            out.y = true;
        else if (axis == "z")
            out.z = true;
        else
            throw base::Error("\"symmetry\" holds " + axis.dump(), {}, R"(it is a list of "x", "y" and "z")");
    return out;
}

StrokeSettings strokeSettings(const json& complete) {
    StrokeSettings out;
    const sculpt::ToolRow& tool = sculpt::tool(complete.at("tool").get<std::string>());
    out.tool = tool.id;
    out.radius = complete.at("radius").get<float>();
    out.strength = complete.value("strength", static_cast<float>(tool.strength));
    out.invert = complete.at("invert").get<bool>();
    out.falloff = sculpt::falloff(complete.at("falloff").get<std::string>());
    out.symmetry = symmetryOf(complete.at("symmetry"));
    out.symmetry.copies = complete.at("radial").get<int>();
    out.symmetry.axis = complete.at("radial-axis") == "x" ? 0 : complete.at("radial-axis") == "y" ? 1 : 2;
    out.resample = complete.at("resample").get<bool>();
    out.graded = complete.at("graded").get<bool>();
    out.spacing = complete.at("spacing").get<float>();
    out.method = sculpt::method(complete.at("method").get<std::string>());
    out.rate = complete.at("rate").get<float>();
    out.stabiliser = complete.at("stabiliser").get<float>();
    out.pressureStrength = pointsOf(complete, "pressure-strength");
    out.pressureRadius = pointsOf(complete, "pressure-radius");
    out.falloffCurve = pointsOf(complete, "falloff-curve");
    out.accumulate = complete.at("accumulate").get<bool>();
    out.autoSmooth = complete.at("auto-smooth").get<float>();
    out.frontFacing = complete.at("front-facing").get<bool>();
    out.connected = complete.at("connected").get<bool>();
    out.normalRadius = complete.at("normal-radius").get<float>();
    out.planeRadius = complete.at("plane-radius").get<float>();
    out.stamp = complete.value("stamp", std::string());
    out.stampAngleRad = radiansOf(complete.at("stamp-angle").get<double>());
    out.stampFollows = complete.at("stamp-follows").get<bool>();
    for (const sculpt::ToolParameter& p : tool.parameters)
        if (complete.contains(p.id))
            out.parameters[p.id] = complete[p.id].get<double>();
    return out;
}

static bool isSample(const json& row) {
    if (!row.is_array() || row.size() < 8 || row.size() > 9)
        return false;
    for (const json& value : row)
        if (!value.is_number() || !std::isfinite(value.get<float>()))
            return false;
    const float pressure = row[6].get<float>(), stride = row.size() == 9 ? row[8].get<float>() : 1;
    const Vec3f direction{row[3].get<float>(), row[4].get<float>(), row[5].get<float>()};
    return base::length(direction) > 0 && pressure >= 0 && pressure <= 1 && row[7].get<float>() >= 0 && stride >= 1 &&
           stride <= StrokeSample::maxStride;
}

std::vector<StrokeSample> strokeSamples(const json& complete, const Vec3d& origin) {
    const json& rows = complete.at("samples");
    std::vector<StrokeSample> out;
    out.reserve(rows.size());
    for (const json& row : rows) {
        if (!isSample(row))
            throw base::Error("sample " + std::to_string(out.size() + 1) + " of the stroke is " + row.dump(), {},
                              "a sample is [ox,oy,oz,dx,dy,dz,pressure,seconds] with a direction that is not zero, "
                              "pressure 0 to 1, seconds of at least 0, and perhaps a stride of 1 to 10");
        const auto at = [&row](std::size_t k) { return row[k].get<float>(); };
        const Vec3d file{row[0].get<double>(), row[1].get<double>(), row[2].get<double>()};
        out.push_back({{inside(file, origin), {at(3), at(4), at(5)}}, at(6), at(7), row.size() == 9 ? at(8) : 1});
    }
    return out;
}

} // namespace session
