#include "core/solid/loops/fill.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/known_rims.h"
#include "core/process/estimation/part_progress.h"
#include "core/solid/loops/obstacles.h"
#include "core/solid/loops/open_loops.h"
#include "core/solid/loops/patch_surfels.h"
#include "core/solid/loops/plane_cap.h"
#include "core/solid/loops/relief.h"
#include "core/surface/rims.h"

namespace solid {

using base::Vec3d;

namespace {

/// Rows behind the loop that tell how dense a patch is to be.
constexpr double behind = 3;

/// A loop with the patch over it.
class Hole {
  public:
    /// `edges`: the loop and those that lie in it, as edgeOf has them; empty: not looked for yet.
    Hole(const surface::Surface& surface, const surface::BoundaryCurve& curve, Loop loop, std::vector<Loop> edges,
         LoopFate& fate)
        : m_surface(surface), m_even(std::move(loop)), m_loop(m_even), m_edges(std::move(edges)), m_fate(fate),
          m_halvings(halvingsFor(areaOver(m_loop), m_loop.meanSpacing())) {
        if (m_halvings > 0)
            m_loop = evenLoop(surface, curve, std::exp2(m_halvings), behind);
        for (LoopPoint& p : m_loop.points)
            p.spacing *= std::exp2(m_halvings);
    }

    /// Shapes a patch. Nothing comes of it where none of that shape stays near its loop and clear of the model.
    void shape(Shape shape, const base::Progress& progress) {
        m_shape = shape;
        if (!isSmooth() && capped())
            return;
        if (!isSmooth())
            m_loop = edgeOf(m_surface, m_loop);
        m_patch = patchOver(m_loop, process::part(progress, 0, 0.4));
        m_filled =
            shapePatch(m_surface, m_loop, shape, m_patch, process::part(progress, 0.4, 1)) && !crossesItself(m_patch);
        if (!m_filled)
            return;
        m_fine = m_patch;
        m_normals = patchNormals(m_loop, m_patch);
        halveEdges(m_fine, m_normals, m_halvings);
        m_filled = !meetsModel(m_surface, m_loop, m_fine);
    }
    /// Flat in place of smooth, and left rather than flat.
    void giveWay(const base::Progress& progress) {
        if (isSmooth()) {
            m_fate.flattened = true;
            shape(Shape::Flat, progress);
        } else {
            m_filled = false;
        }
        if (!m_filled)
            m_fate.why = "what would fill it runs into the model or itself";
    }
    void finish(bool relief, PatchSurfels& out) {
        m_fate.filled = true;
        if (cap()) {
            m_fate.surfels = m_fine.positions.size();
            return;
        }
        if (relief && isSmooth())
            m_fate.plain = followRelief(m_surface, m_loop, m_patch, m_fine, m_normals) == ReliefFate::TooLittle;
        m_fate.surfels = out.add(m_loop, m_patch, m_halvings, m_fine, m_normals);
    }
    bool isFilled() const { return m_filled; }
    bool isSmooth() const { return m_shape == Shape::Smooth; }
    const Patch& patch() const { return m_fine; }
    /// Null where the patch is none.
    const PlaneCap* cap() const { return m_cap ? &*m_cap : nullptr; }
    /// What has no part in it does not meet the patch.
    base::Box3d reach() const {
        base::Box3d out;
        for (std::size_t v = 0; v < m_fine.positions.size(); ++v) {
            const Vec3d by = Vec3d{1, 1, 1} * m_fine.spacings[v];
            out.extend(m_fine.positions[v] - by), out.extend(m_fine.positions[v] + by);
        }
        return out;
    }

  private:
    bool capped() {
        if (m_edges.empty())
            m_edges.push_back(edgeOf(m_surface, m_even));
        m_cap = PlaneCap::over(m_surface, m_edges);
        if (!m_cap)
            return false;
        m_fine = m_cap->patch;
        m_filled = !meetsModel(m_surface, m_cap->loop, m_fine);
        return true;
    }

    const surface::Surface& m_surface;
    Loop m_even, m_loop; ///< a spacing apart; as the patch is shaped over
    std::vector<Loop> m_edges;
    LoopFate& m_fate;
    int m_halvings;
    Shape m_shape = Shape::Flat;
    bool m_filled = false;
    Patch m_patch, m_fine; ///< the fine one has the model's own spacing
    std::vector<Vec3d> m_normals;
    std::optional<PlaneCap> m_cap; ///< in place of a patch of triangles
};

/// Of patches that meet the smooth ones become flat; of two flat ones the later goes. Whatever the order, two ends of a
/// tube that look at each other are treated alike.
void keepApart(std::vector<Hole>& holes, const base::Progress& progress) {
    bool again = true;
    while (again) {
        std::vector<std::uint8_t> yields(holes.size(), 0);
        std::vector<base::Box3d> boxes;
        for (const Hole& each : holes)
            boxes.push_back(each.reach());
        for (std::size_t j = 0; j < holes.size(); ++j)
            for (std::size_t i = 0; i < j; ++i)
                if (boxes[i].overlaps(boxes[j]) && holes[i].isFilled() && holes[j].isFilled() &&
                    meet(holes[i].patch(), holes[j].patch())) {
                    yields[i] |= holes[i].isSmooth();
                    yields[j] |= holes[j].isSmooth() || !holes[i].isSmooth();
                }
        again = false;
        for (std::size_t i = 0; i < holes.size(); ++i)
            if (yields[i]) {
                holes[i].giveWay(progress);
                again = true;
            }
        base::CancelScope::check();
    }
}

/// Where every loop is filled nothing ends any more, whatever edges the patches have; a model that knew its rims knows
/// which of them are left. Of others the points tell.
surface::Surface endingAsLeft(const surface::Surface& before, const surface::Surface& filled,
                              std::span<const surface::BoundaryCurve> curves, std::span<const LoopFate> loops,
                              const base::Progress& progress) {
    std::vector<Vec3d> rims;
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (!loops[i].filled)
            for (const surface::BoundaryPoint& p : curves[i].points)
                rims.push_back(p.position);
    const bool told = rims.empty() || surface::knowsRims(before);
    if (told && process::mayKnowRims(before))
        return process::endingAt(filled, rims);
    return process::withOwnLimit(filled.tree(), filled.definition(), progress);
}

} // namespace

Filled fillHoles(const surface::Surface& surface, const FillOptions& options, const base::Progress& progress) {
    const base::CancelScope scope(progress.cancel);
    const std::vector<surface::BoundaryCurve> curves =
        openLoops(surface, "fill", "has no holes to fill", process::part(progress, 0, 0.4));
    if (options.only && *options.only >= curves.size())
        throw base::Error("there is no boundary loop number " + std::to_string(*options.only), "fill",
                          std::to_string(curves.size()) + " were found; they count from 0");
    Filled out{surface, {}};
    std::vector<Loop> loops;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        loops.push_back(evenLoop(surface, curves[i], 1, behind));
        LoopFate fate{i, loops[i].middle, curves[i].length()};
        fate.asked =
            fate.length <= options.longest && !(options.keepLargest && i == 0) && (!options.only || *options.only == i);
        if (!curves[i].closed)
            fate.why = "it does not close";
        out.loops.push_back(fate);
    }
    const std::vector<std::uint8_t> touches = touching(loops);
    const auto isToFill = [&](std::size_t i) { return out.loops[i].asked && curves[i].closed && !touches[i]; };
    std::vector<Loop> edges(curves.size());
    std::vector<std::optional<std::size_t>> within(curves.size());
    if (options.shape == Shape::Flat) {
        for (std::size_t i = 0; i < curves.size(); ++i)
            if (isToFill(i))
                edges[i] = edgeOf(surface, loops[i]);
        within = nestedLoops(edges);
    }
    std::vector<Hole> holes;
    std::vector<std::size_t> holeOf(curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
        LoopFate& fate = out.loops[i];
        if (curves[i].closed && touches[i])
            fate.why = "it touches itself or another one";
        if (!isToFill(i) || within[i])
            continue;
        const base::Progress one = process::part(progress, 0.4 + 0.5 * double(i) / double(curves.size()),
                                                 0.4 + 0.5 * double(i + 1) / double(curves.size()));
        std::vector<Loop> own;
        if (edges[i].size() > 0)
            own.push_back(std::move(edges[i]));
        for (std::size_t k = 0; k < curves.size(); ++k)
            if (within[k] == i)
                own.push_back(std::move(edges[k]));
        holeOf[i] = holes.size();
        holes.emplace_back(surface, curves[i], std::move(loops[i]), std::move(own), fate);
        holes.back().shape(options.shape, one);
        if (!holes.back().isFilled())
            holes.back().giveWay(one);
    }
    keepApart(holes, process::part(progress, 0.9, 0.9));
    PatchSurfels surfels(surface);
    std::vector<const PlaneCap*> caps;
    for (Hole& hole : holes)
        if (hole.isFilled()) {
            hole.finish(options.relief, surfels);
            if (hole.cap())
                caps.push_back(hole.cap());
        }
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (!within[i])
            continue;
        const Hole& around = holes[holeOf[*within[i]]];
        out.loops[i].filled = around.isFilled() && around.cap();
        if (!out.loops[i].filled)
            out.loops[i].why = "what lies around it in its plane could not be filled";
    }
    if (caps.empty() && surfels.surfels().size() == 0)
        return out;
    const surface::Surface whole =
        capped(withSurfels(surface, surfels.surfels()), caps, options.creases, process::part(progress, 0.9, 0.95));
    out.surface = endingAsLeft(surface, whole, curves, out.loops, process::part(progress, 0.95, 1));
    return out;
}

} // namespace solid
