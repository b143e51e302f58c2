#include "core/mesh/marching/solid_edge.h"

namespace mesh {

using base::Vec3d;
using surface::Evaluationf, surface::Need;

namespace {

constexpr double margin = 1e-3; ///< of the edge, from its ends: crossings of other edges are no nearer
constexpr double near = 0.5;    ///< of the edge
constexpr int halvings = 20;

/// Between two places on an edge of which one is inside.
class Halving {
  public:
    Halving(const Solid& solid, surface::Source& source, const Edge& edge, int way)
        : m_solid(solid), m_source(source), m_edge(edge), m_way(way) {}

    Crossing run() {
        const bool winding = byWinding();
        double in = m_way > 0 ? 0 : m_edge.length, out = m_edge.length - in;
        for (int i = 0; i < halvings; ++i) {
            const double t = 0.5 * (in + out);
            ((winding ? m_solid.byWinding(at(t)) : height(t).value) < 0 ? in : out) = t;
        }
        return crossing(0.5 * (in + out));
    }

  private:
    Vec3d at(double t) const { return m_edge.from + m_edge.direction * t; }

    Evaluationf evaluate(double t, Need need) const {
        Evaluationf out;
        m_source.evaluate(base::cast<float>(at(t)), need, {}, out);
        return out;
    }
    Solid::Height height(double t) const { return m_solid.height(at(t), evaluate(t, Need::Value), false); }

    /// Was an end's sign the winding number's, and does that know the crossing?
    bool byWinding() const {
        if (!height(0).overruled && !height(m_edge.length).overruled)
            return false;
        return m_way * m_solid.byWinding(at(0)) < 0 && m_way * m_solid.byWinding(at(m_edge.length)) >= 0;
    }

    /// Is there surface that faces the right way, so near that the vertex can be put onto it?
    bool besideSurface(const Evaluationf& here) const {
        return surface::isSurface(here) &&
               std::abs(double(here.value)) <= near * m_edge.length * double(length(here.gradient)) &&
               m_way * dot(base::cast<double>(here.gradient), m_edge.direction) > 0;
    }

    Crossing crossing(double t) const {
        const Vec3d x = at(t);
        const Evaluationf here = evaluate(t, Need::Gradient);
        if (besideSurface(here))
            return {x, base::normalized(here.gradient), here.unit, here.offCentre / here.unit, false};
        const Solid::Height height = m_solid.height(x, here, false);
        Vec3d normal = m_solid.outwards(x, here, height);
        if (m_way * dot(normal, m_edge.direction) < 0)
            normal = m_solid.outwards(x, here, {0, 1, true});
        const bool known = here.ok();
        return {x, base::cast<float>(normal), known ? here.unit : 0, known ? here.offCentre / here.unit : 1, true};
    }

    const Solid& m_solid;
    surface::Source& m_source;
    const Edge& m_edge;
    int m_way;
};

} // namespace

Crossing solidCrossing(const Solid& solid, const SurfaceTraits& traits, surface::Source& source, const Edge& edge,
                       const SolidEnds& ends) {
    const auto root = EdgeWalk(traits, source, edge, Care::Usual).facing(ends.way, ends.first, ends.last);
    Crossing out = root ? *root : Halving(solid, source, edge, ends.way).run();
    const double t = dot(out.position - edge.from, edge.direction);
    const double kept = std::clamp(t, margin * edge.length, (1 - margin) * edge.length);
    out.position = edge.from + edge.direction * kept;
    out.sided = true;
    return out;
}

} // namespace mesh
