#include "core/solid/cut.h"

#include "core/base/error.h"
#include "core/process/cleaning/list_change.h"
#include "core/process/estimation/part_limit.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/resampling/resample.h"
#include "core/solid/cap_rims.h"
#include "core/solid/map_places.h"
#include "core/solid/primitive.h"
#include "core/solid/spacing_beside.h"

#include <algorithm>
#include <cmath>

namespace solid {

using base::Vec3d;

namespace {

/// Places in the plane about the model's edge there, as far apart as its surfels are at the nearest place.
class CapSampler {
  public:
    CapSampler(const surface::Surface& model, const base::Plane& plane)
        : m_definition(model.definition()), m_pose(poseAlong(plane.normal * plane.offset, plane.normal)),
          m_beside(model.tree(), HalfSpaceSide(plane.normal, plane.offset)) {
        if (m_beside.empty())
            return;
        m_beside.forPlaces([&](const Vec3d& x) { m_box.extend(m_pose.local(x)); });
        auto layout = std::make_shared<surfel::AttributeLayout>();
        layout->normals = layout->oriented = true;
        m_out.layout = layout;
        m_normal = base::cast<float>(plane.normal);
        sample();
    }
    surfel::SurfelList result() { return std::move(m_out); }

  private:
    /// Of the plane, in the pose's frame.
    struct Map {
        const CapSampler& cap;
        base::Point2 lo, hi;

        double unit(double /*v*/) const { return 1; }
        double spacing(double u, double v) const { return cap.m_beside.at(cap.m_pose.place({u, v, 0})); }
    };
    void sample() {
        const Map map{*this, {m_box.lo.x, m_box.lo.y}, {m_box.hi.x, m_box.hi.y}};
        double least = std::numeric_limits<double>::infinity(), most = 0;
        constexpr int looks = 32;
        for (int i = 0; i < looks; ++i)
            for (int j = 0; j < looks; ++j) {
                const double spacing = map.spacing(map.lo.x + (i + 0.5) / looks * m_box.size().x,
                                                   map.lo.y + (j + 0.5) / looks * m_box.size().y);
                least = std::min(least, spacing), most = std::max(most, spacing);
            }
        forPlaces(map, least, most, [&](double u, double v, double spacing) { add(u, v, spacing); });
    }
    void add(double u, double v, double spacing) {
        surfel::Surfel s;
        s.position = base::cast<float>(m_pose.place({u, v, 0}));
        s.normal = m_normal;
        s.support = process::supportOf(m_definition, static_cast<float>(spacing));
        m_out.append(s, {});
    }

    surface::SurfaceDefinition m_definition;
    Pose m_pose;
    SpacingBeside m_beside;
    base::Box3d m_box;
    base::Vec3f m_normal;
    surfel::SurfelList m_out;
};

} // namespace

Combined leftOpen(const surface::Surface& model, std::span<const std::int8_t> sides, int gone,
                  const base::Progress& progress) {
    std::vector<std::uint8_t> goes(sides.size());
    std::ranges::transform(sides, goes.begin(), [&](std::int8_t each) { return each * gone > 0; });
    Combined out;
    out.removed = static_cast<std::size_t>(std::ranges::count(goes, 1));
    out.surface = process::partOf(model, process::changed(model.tree(), {goes, {}, {}, {}, {}}),
                                  process::part(progress, 0.5, 1), true);
    return out;
}

Combined cutByPlane(const surface::Surface& model, const base::Plane& plane, const CutOptions& options,
                    const base::Progress& progress) {
    const HalfSpaceSide side(plane.normal, plane.offset);
    const std::vector<std::int8_t> sides = sidesOf(model.tree(), side);
    if (std::count_if(sides.begin(), sides.end(), [](std::int8_t s) { return s >= 0; }) < 4)
        throw base::Error("nothing would be left", "cut", "move the plane, or keep the other side");
    if (options.cap)
        return endingAsBefore(model, side, 1,
                              combine(model, {side, CapSampler(model, plane).result(), sides}, Operation::Difference,
                                      {options.creases}, process::part(progress, 0, 0.8)),
                              process::part(progress, 0.8, 1));
    return leftOpen(model, sides, -1, progress);
}

} // namespace solid
