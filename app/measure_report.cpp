#include "app/measure_report.h"

#include <algorithm>
#include <cmath>
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

/// How much of a way the boundary holds.
double alongRim(const process::Geodesic& way) {
    double out = 0;
    for (std::size_t i = 1; i < way.points.size(); ++i)
        if (way.points[i - 1].rim && way.points[i].rim)
            out += distance(way.points[i - 1].position, way.points[i].position);
    return out;
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

static ordered_json numberOrNull(double value) {
    return std::isnan(value) ? ordered_json() : ordered_json(value);
}

static void addPlaces(ordered_json& out, const Measurements& found) {
    if (const auto& d = found.distance)
        out["distance"] = {{"from", vectorOf(d->from)},
                           {"to", vectorOf(d->to)},
                           {"length", distance(d->from, d->to)},
                           {"delta", vectorOf(d->to - d->from)}};
    if (const auto& g = found.geodesic) {
        const Vec3d from = g->points.front().position, to = g->points.back().position;
        out["geodesic"] = {{"from", vectorOf(from + found.origin)},
                           {"to", vectorOf(to + found.origin)},
                           {"length", g->length},
                           {"straight", distance(from, to)},
                           {"along_rim", alongRim(*g)}};
    }
    if (const auto& a = found.angle) {
        out["angle"] = {{"degrees", a->rad * degrees}, {"places", ordered_json::array()}};
        for (const Vec3d& place : a->places)
            out["angle"]["places"].push_back(vectorOf(place));
    }
}

static void addThickness(ordered_json& out, const Measurements& found) {
    if (found.model.thickness) {
        const process::ThicknessFigures& t = found.model.thickness->figures;
        const auto figure = [&](double value) { return t.count > 0 ? ordered_json(value) : ordered_json(); };
        out["thickness"] = {
            {"count", t.count},           {"none", t.none},         {"min", figure(t.min)}, {"p1", figure(t.p1)},
            {"median", figure(t.median)}, {"mean", figure(t.mean)}, {"max", figure(t.max)}};
    }
    for (const process::ThicknessAt& at : found.thicknessAt) {
        const bool met = !std::isnan(at.thickness);
        out["thickness_at"].push_back({{"foot", vectorOf(at.foot.position + found.origin)},
                                       {"thickness", numberOrNull(at.thickness)},
                                       {"opposite", met ? vectorOf(at.opposite + found.origin) : ordered_json()},
                                       {"lean_deg", numberOrNull(at.leanRad * degrees)}});
    }
}

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
    addPlaces(out, found);
    if (found.model.deviation) {
        const process::DeviationFigures& d = found.model.deviation->figures;
        out["to"] = {{"rms", d.rms},     {"p99", d.p99},       {"max", d.max},   {"mean", d.mean},
                     {"count", d.count}, {"beyond", d.beyond}, {"lost", d.lost}, {"signed", d.sided}};
        if (const auto& h = found.histogram)
            out["to"]["histogram"] = {
                {"low", h->low}, {"high", h->high}, {"counts", h->counts}, {"below", h->below}, {"above", h->above}};
    }
    addThickness(out, found);
    if (found.fit)
        out["fit"] = fitJson(*found.fit, found.origin);
    return out;
}

static void tellPlaces(Lines& out, const Measurements& found) {
    if (const auto& d = found.distance)
        out.line("distance", distance(d->from, d->to), ", by ", valueOf(vectorOf(d->to - d->from)));
    if (const auto& g = found.geodesic) {
        out.line("geodesic", g->length, " along the surface, ",
                 distance(g->points.front().position, g->points.back().position), " straight");
        if (const double rim = alongRim(*g); rim > 0)
            out.line("  rim", rim, " of it along the boundary");
    }
    if (const auto& a = found.angle)
        out.line("angle", a->rad * degrees, a->places.size() == 2 ? " degrees between the normals" : " degrees");
}

static void tellHistogram(Lines& out, const process::Histogram& histogram) {
    std::size_t most = 1;
    for (const std::size_t count : histogram.counts)
        most = std::max(most, count);
    if (histogram.below > 0)
        out.line("  below", histogram.below);
    for (std::size_t k = 0; k < histogram.counts.size(); ++k) {
        std::ostringstream edge;
        edge.precision(4);
        edge << "  from " << histogram.edge(k);
        const std::string bar(40 * histogram.counts[k] / most, '#');
        out.line(edge.str() + std::string(edge.str().size() < 20 ? 20 - edge.str().size() : 0, ' '),
                 histogram.counts[k], bar.empty() ? "" : " ", bar);
    }
    if (histogram.above > 0)
        out.line("  above", histogram.above);
}

static void tellThickness(Lines& out, const Measurements& found) {
    if (found.model.thickness)
        out.line("thickness", session::sentenceOf(found.model.thickness->figures));
    for (const process::ThicknessAt& at : found.thicknessAt)
        if (std::isnan(at.thickness))
            out.line("  at", valueOf(vectorOf(at.foot.position + found.origin)), ": nothing lies opposite");
        else
            out.line("  at", valueOf(vectorOf(at.foot.position + found.origin)), ": ", at.thickness,
                     ", the other side leans by ", at.leanRad * degrees, " degrees");
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
    tellPlaces(out, found);
    if (found.model.deviation) {
        const process::DeviationFigures& d = found.model.deviation->figures;
        out.line("distances", session::sentenceOf(d));
        if (d.beyond > 0)
            out.line("  beyond", d.beyond, " surfels lie where the other surface has ended; they do not count");
        if (d.lost > 0)
            out.line("  lost", d.lost, " surfels have no nearby foot on the other surface; they do not count");
        if (found.histogram)
            tellHistogram(out, *found.histogram);
    }
    tellThickness(out, found);
    if (found.fit)
        tellFit(out, *found.fit, found.origin);
    return out.text();
}

} // namespace app
