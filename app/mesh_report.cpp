#include "app/mesh_report.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace app {

using nlohmann::json;

namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

class Table {
  public:
    explicit Table(double spacing) : m_spacing(spacing) { m_out.precision(4); }

    template <class T>
    Table& row(const char* name, const T& value) {
        m_out << name << std::string(26 - std::char_traits<char>::length(name), ' ') << value << '\n';
        return *this;
    }
    Table& length(const char* name, double value) {
        std::ostringstream text;
        text.precision(4);
        text << value;
        if (m_spacing > 0)
            text << "  (" << value / m_spacing << " spacings)";
        return row(name, text.str());
    }
    Table& deviation(const char* name, const mesh::Deviation& d) {
        length((std::string(name) + " distance max").c_str(), d.max);
        length((std::string(name) + " distance 99 %").c_str(), d.hundredth);
        length((std::string(name) + " distance median").c_str(), d.median);
        return d.lost > 0 ? row((std::string(name) + " without surface").c_str(), d.lost) : *this;
    }
    std::string text() const { return m_out.str(); }

  private:
    double m_spacing;
    std::ostringstream m_out;
};

const char* yes(bool value) {
    return value ? "yes" : "no";
}

json deviationJson(const mesh::Deviation& d) {
    return {{"count", d.count}, {"lost", d.lost}, {"max", d.max}, {"p99", d.hundredth}, {"median", d.median}};
}

} // namespace

std::string reportTable(const mesh::Report& report, double spacing) {
    const mesh::Topology& t = report.topology;
    Table out(spacing);
    out.row("vertices", t.vertices).row("faces", t.faces).row("components", t.components);
    out.row("boundary loops", t.boundaryLoops);
    if (t.foldLoops > 0)
        out.row("  of them at folds", t.foldLoops);
    out.row("Euler characteristic", t.euler());
    if (const auto genus = t.genus())
        out.row(t.orientable ? "genus" : "crosscaps", *genus);
    out.row("manifold", yes(t.manifold())).row("orientable", yes(t.orientable));
    if (!t.manifold())
        out.row("non-manifold edges", t.nonManifoldEdges).row("non-manifold vertices", t.nonManifoldVertices);
    if (t.orientable && t.opposedEdges > 0)
        out.row("edges facing both ways", t.opposedEdges);
    out.row("degenerate triangles", report.shape.degenerate);
    out.row("smallest angle", report.shape.leastAngle * degrees);
    out.row("smallest angle, 1 %", report.shape.hundredthAngle * degrees);
    out.length("longest edge", report.shape.longestEdge).length("shortest edge", report.shape.shortestEdge);
    out.row("self-intersections", report.selfIntersections);
    out.deviation("vertex", report.vertices).deviation("face", report.faces);
    return out.text();
}

json reportJson(const mesh::Report& report, double spacing) {
    const mesh::Topology& t = report.topology;
    const auto genus = t.genus();
    return {{"vertices", t.vertices},
            {"faces", t.faces},
            {"edges", t.edges},
            {"components", t.components},
            {"boundary_loops", t.boundaryLoops},
            {"limit_rims", t.boundaryLoops - t.foldLoops},
            {"fold_rims", t.foldLoops},
            {"euler", t.euler()},
            {"genus", genus && t.orientable ? json(*genus) : json()},
            {"crosscaps", genus && !t.orientable ? json(*genus) : json()},
            {"orientable", t.orientable},
            {"opposed_edges", t.opposedEdges},
            {"manifold", t.manifold()},
            {"non_manifold_edges", t.nonManifoldEdges},
            {"non_manifold_vertices", t.nonManifoldVertices},
            {"degenerate", report.shape.degenerate},
            {"min_angle_deg", report.shape.leastAngle * degrees},
            {"p1_angle_deg", report.shape.hundredthAngle * degrees},
            {"area", report.shape.area},
            {"shortest_edge", report.shape.shortestEdge},
            {"longest_edge", report.shape.longestEdge},
            {"max_vertex_distance", report.vertices.max},
            {"max_face_distance", report.faces.max},
            {"vertex_distance", deviationJson(report.vertices)},
            {"face_distance", deviationJson(report.faces)},
            {"self_intersections", report.selfIntersections},
            {"spacing", spacing}};
}

} // namespace app
