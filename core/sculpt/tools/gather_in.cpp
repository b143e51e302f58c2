#include "core/sculpt/tools/gather_in.h"

#include "core/sculpt/tools/along_surface.h"

#include <algorithm>

namespace sculpt {

/// Agreement of the summed normals below which a fold counts as closing, and above which as open.
constexpr float closed = 0.75f, open = 0.95f;
/// Surfels asked in the middle, and the part of the radius that counts as the middle.
constexpr std::size_t asked = 32;
constexpr float middle = 0.25f;

GatherIn::GatherIn(const Brush& brush, const Dab& dab, const base::Vec3f& lift, float rate)
    : m_brush(brush), m_lift(lift) {
    const base::Vec3f n = dab.areaNormal, across = acrossStroke(dab);
    const bool round = across == base::Vec3f{};
    m_spread = (round ? base::Mat3f::identity() - outer(n, n) : outer(across, across)) * rate;
}

void GatherIn::operator()(const LanePlace&, const BrushLanes& at, ShiftLanes& out) const {
    alignas(64) float weight[lanes], gradient[lanes];
    m_brush.fade(at, weight, gradient);
    const float* p[3] = {at.x, at.y, at.z};
    for (std::size_t a = 0; a < 3; ++a) {
        alignas(64) float way[lanes];
        for (std::size_t i = 0; i < lanes; ++i)
            way[i] = m_lift[a] + m_spread.m[a][0] * at.x[i] + m_spread.m[a][1] * at.y[i] + m_spread.m[a][2] * at.z[i];
        for (std::size_t b = 0; b < 3; ++b)
            for (std::size_t i = 0; i < lanes; ++i)
                out.j[a][b][i] = way[i] * gradient[i] * p[b][i] + weight[i] * m_spread.m[a][b];
        for (std::size_t i = 0; i < lanes; ++i)
            out.d[a][i] = weight[i] * way[i];
    }
}

float foldBrake(const surface::Surface& version, const Dab& dab) {
    std::vector<tree::Neighbour> near;
    version.tree().nearest(dab.centre, asked, near, middle * dab.radius);
    std::vector<base::Vec3f> places;
    for (const tree::Neighbour& n : near)
        places.push_back(n.block->position(n.slot));
    std::vector<surface::Evaluationf> e(places.size());
    surface::SurfaceDefinition definition = version.definition();
    definition.oneSheet = false; // the fold's other side must have its say
    surface::Surface(version.tree(), definition).evaluate(places, surface::Need::Value, e);
    float least = 1;
    for (const surface::Evaluationf& each : e)
        if (each.samples > 0)
            least = std::min(least, each.agreement);
    return std::clamp((least - closed) / (open - closed), 0.0f, 1.0f);
}

} // namespace sculpt
