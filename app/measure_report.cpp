#include "app/measure_report.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace app {

using base::Vec3d;
using nlohmann::ordered_json;
using process::Primitive;
using process::Shape;

namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

ordered_json vectorOf(const Vec3d& v) {
    return {v.x, v.y, v.z};
}

/// Why there is no volume; empty where there is one.
std::string openness(const mesh::Extent& extent) {
    if (extent.closed)
        return {};
    if (!extent.orientable)
        return "the surface has no two sides";
    const bool gaps = extent.foldLoops > 0;
    return std::string("the surface is not closed: ") +
           (gaps ? "it has boundaries or gaps where sheets meet" : "it has a boundary") + "; see `pointclay boundary`";
}

/// The parameters that the shape has, by name, in the order in which they are told.
ordered_json parametersOf(const Primitive& p, const Vec3d& origin) {
    const ordered_json place = vectorOf(p.place + origin), axis = vectorOf(p.axis);
    switch (p.shape) {
    case Shape::Plane:
        return {{"point", place}, {"normal", axis}, {"d", dot(p.axis, p.place + origin)}};
    case Shape::Sphere:
        return {{"centre", place}, {"radius", p.radius}};
    case Shape::Cylinder:
        return {{"point", place}, {"axis", axis}, {"radius", p.radius}};
    case Shape::Cone:
        return {{"apex", place}, {"axis", axis}, {"angle_deg", p.angle * degrees}};
    default:
        return {{"centre", place}, {"axis", axis}, {"radius", p.radius}, {"tube", p.tube}};
    }
}

ordered_json fitJson(const process::PrimitiveFit& fit, const Vec3d& origin) {
    ordered_json out{{"shape", process::shapeTable()[static_cast<std::size_t>(fit.primitive.shape)].id}};
    out.update(parametersOf(fit.primitive, origin));
    out.update({{"rms", fit.rms},
                {"max", fit.max},
                {"inliers", fit.inliers},
                {"count", fit.inlier.size()},
                {"sigma", fit.sigma}});
    return out;
}

class Lines {
  public:
    Lines() { m_out.precision(7); }

    template <class... Parts>
    void line(const std::string& name, const Parts&... parts) {
        m_out << name << std::string(name.size() < 12 ? 12 - name.size() : 1, ' ');
        (m_out << ... << parts) << '\n';
    }
    std::string text() const { return m_out.str(); }

  private:
    std::ostringstream m_out;
};

std::string valueOf(const ordered_json& value) {
    std::ostringstream out;
    out.precision(9);
    if (!value.is_array())
        out << value.get<double>();
    for (std::size_t k = 0; value.is_array() && k < value.size(); ++k)
        out << (k > 0 ? " " : "") << value[k].get<double>();
    return out.str();
}

void tellFit(Lines& out, const process::PrimitiveFit& fit, const Vec3d& origin) {
    const std::size_t count = fit.inlier.size();
    const double share = 100 * static_cast<double>(fit.inliers) / static_cast<double>(count);
    out.line(process::shapeTable()[static_cast<std::size_t>(fit.primitive.shape)].id, "fits ", fit.inliers, " of ",
             count, " surfels (", std::round(10 * share) / 10, " %), rms ", fit.rms, ", max ", fit.max);
    const ordered_json parameters = parametersOf(fit.primitive, origin);
    for (const auto& [name, value] : parameters.items())
        out.line("  " + name, valueOf(value));
}

} // namespace

ordered_json measurementsJson(const Measurements& found) {
    ordered_json out = ordered_json::object();
    if (found.area) {
        out["area"] = found.extent->area;
        out["area_error"] = found.extent->areaError;
    }
    if (found.volume) {
        out["volume"] = found.extent->closed ? ordered_json(found.extent->volume) : ordered_json();
        out["volume_error"] = found.extent->closed ? ordered_json(found.extent->volumeError) : ordered_json();
    }
    if (found.extent)
        out["closed"] = found.extent->closed;
    if (found.deviation) {
        const process::DeviationFigures& d = *found.deviation;
        out["to"] = {{"rms", d.rms},     {"p99", d.p99},       {"max", d.max},   {"mean", d.mean},
                     {"count", d.count}, {"beyond", d.beyond}, {"lost", d.lost}, {"signed", d.sided}};
    }
    if (found.fit)
        out["fit"] = fitJson(*found.fit, found.origin);
    return out;
}

std::string measurementsText(const Measurements& found) {
    Lines out;
    if (found.area)
        out.line("area", found.extent->area, ", +- ", found.extent->areaError);
    if (found.volume) {
        const std::string why = openness(*found.extent);
        if (why.empty())
            out.line("volume", found.extent->volume, ", +- ", found.extent->volumeError);
        else
            out.line("volume", "none: ", why);
    }
    if (found.deviation) {
        const process::DeviationFigures& d = *found.deviation;
        out.line("distances", d.count, " surfels, rms ", d.rms, ", mean ", d.mean, ", 99 % within ", d.p99, ", max ",
                 d.max, d.sided ? "" : "; without sign, the other surface has no sides");
        if (d.beyond > 0)
            out.line("  beyond", d.beyond, " surfels lie where the other surface has ended; they do not count");
        if (d.lost > 0)
            out.line("  lost", d.lost, " surfels have no nearby foot on the other surface; they do not count");
    }
    if (found.fit)
        tellFit(out, *found.fit, found.origin);
    return out.text();
}

} // namespace app
