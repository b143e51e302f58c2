#include "core/raycast/adaptive_cast.h"

#include "core/raycast/edited_region.h"
#include "core/raycast/redraw.h"

#include <algorithm>
#include <chrono>
#include <optional>

namespace raycast {

/// Of the first level with outlines; each of the next is twice as fine.
constexpr double coarsest = 4;
constexpr double nothing = std::numeric_limits<double>::infinity();

/// A view with its own copy of the planes.
struct OwnRays {
    ImageRays rays;
    std::vector<base::Plane> clips;

    explicit OwnRays(const ImageRays& from) : rays(from), clips(from.clips.begin(), from.clips.end()) {
        rays.clips = clips;
    }
    OwnRays(const OwnRays&) = delete;
    OwnRays& operator=(const OwnRays&) = delete;

    bool sees(const ImageRays& o) const {
        return rays.eye == o.eye && rays.originAcross == o.originAcross && rays.originDown == o.originDown &&
               rays.corner == o.corner && rays.across == o.across && rays.down == o.down && rays.width == o.width &&
               rays.height == o.height && std::ranges::equal(clips, o.clips);
    }
};

struct AdaptiveCast::State {
    cells::AnySurface surface;
    std::optional<OwnRays> view; ///< that the rest belongs to
    SplatGuard guard;
    Lattice lattice;
    AdaptivePicture picture;
    int startCell = 4;
    double reached = nothing;    ///< the finest quality that the whole picture is of
    std::vector<Split> splits;   ///< of that
    KeptPatches kept;            ///< of earlier views
    double redrawnFor = nothing; ///< the quality that patches were chosen for
    bool guardIsOld = false;     ///< of another version of the model

    explicit State(surface::Surface model) : surface(std::move(model)) {}

    void turnTo(const ImageRays& rays, const base::Progress& progress);
    void redrawKept(double quality);
    void edit(surface::Surface next);
    void forgetNear(std::span<const base::Box3f> boxes);
    void lookAgain(const base::Progress& progress);
    void lookFor(const ImageRays& rays, const base::Progress& progress);
    CastView castView(const ViewLens& lens);
    std::size_t level(const SubdivisionOptions& options, CastCounts& counts, const base::Progress& progress);
    std::size_t everyPixel(CastCounts& counts, const base::Progress& progress);
    AdaptiveImage image(double quality, bool complete) const {
        return {picture.all(), picture.known(), quality, complete};
    }
};

static int roundedUp(int n, int to) {
    return (n + to - 1) / to * to + 1;
}

void AdaptiveCast::State::lookFor(const ImageRays& rays, const base::Progress& progress) {
    // The guard tells how large start cells are, and they how far the lattice goes: it looks as far as any would.
    constexpr int margin = SplatGuard::largestSquare;
    guard.look(surface.surface(), rays, roundedUp(rays.width, margin), roundedUp(rays.height, margin), progress);
    guardIsOld = false;
}

/// Another view: what the one before found becomes patches, for `redrawKept`.
void AdaptiveCast::State::turnTo(const ImageRays& rays, const base::Progress& progress) {
    if (view) {
        const ViewLens lens(view->rays);
        kept.add(castView(lens), picture, splits);
        if (!std::ranges::equal(view->clips, rays.clips))
            kept.clear(); // what was cut away may stand before what was seen
        splits.clear();
        view.reset();
    }
    reached = redrawnFor = nothing;
    lookFor(rays, progress);
    startCell = startCellFor(guard.spacingPx());
    lattice.reset(roundedUp(rays.width, startCell), roundedUp(rays.height, startCell));
    picture.resize(rays.width, rays.height);
    view.emplace(rays);
}

void AdaptiveCast::State::redrawKept(double quality) {
    const ViewLens lens(view->rays);
    lattice.forget([&](Pixel p) { return lattice.redrawn(p); });
    const auto seen = redraw(kept, castView(lens), quality, picture);
    if (redrawnFor == nothing)
        kept.age(seen);
    redrawnFor = quality;
}

/// The guard of an edited model, and what it says about background now.
void AdaptiveCast::State::lookAgain(const base::Progress& progress) {
    lookFor(view->rays, progress);
    lattice.forget([&](Pixel p) { return lattice.background(p) && guard.reached(p); });
}

void AdaptiveCast::State::edit(surface::Surface next) {
    const auto boxes = editedRegion(surface.tree(), next.tree());
    surface = std::move(next);
    if (boxes.empty())
        return;
    kept.dropNear(boxes);
    if (view)
        forgetNear(boxes);
    reached = nothing;
    guardIsOld = true;
}

/// Forgets the rays that come through any of the boxes before they meet the surface, by squares about what is seen of
/// the boxes.
void AdaptiveCast::State::forgetNear(std::span<const base::Box3f> boxes) {
    constexpr int tile = 8;
    const int columns = (lattice.columns() + tile - 1) / tile, rows = (lattice.rows() + tile - 1) / tile;
    std::vector<double> nearest(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), nothing);
    const ViewLens lens(view->rays);
    for (const base::Box3f& box : boxes) {
        const BoxImage seen = lens.imageOf(box);
        const auto tileAt = [](double pixel, int count) {
            return static_cast<int>(std::clamp(std::floor(pixel / tile), -1.0, static_cast<double>(count)));
        };
        const int bottom = std::min(rows - 1, tileAt(seen.bottom, rows)),
                  right = std::min(columns - 1, tileAt(seen.right, columns));
        for (int y = std::max(0, tileAt(seen.top, rows)); y <= bottom; ++y)
            for (int x = std::max(0, tileAt(seen.left, columns)); x <= right; ++x) {
                double& depth = nearest[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                                        static_cast<std::size_t>(x)];
                depth = std::min(depth, seen.depth);
            }
    }
    const CastView what = castView(lens);
    const auto touched = [&](Pixel p) {
        const double depth = nearest[static_cast<std::size_t>(p.row / tile) * static_cast<std::size_t>(columns) +
                                     static_cast<std::size_t>(p.column / tile)];
        if (depth == nothing)
            return false;
        const Sample* sample = what.sampleAt(p);
        return sample &&
               !(sample->hit.hit && static_cast<double>(sample->hit.t) < depth * lens.stretch(p.column, p.row));
    };
    std::erase_if(splits, [&](const Split& split) {
        for (int i = 0; i < 9; ++i)
            if (touched({split.at.column + i % 3 * split.half, split.at.row + i / 3 * split.half}))
                return true;
        return false;
    });
    lattice.forget(touched);
}

CastView AdaptiveCast::State::castView(const ViewLens& lens) {
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    PatchKind kind{layout.normals && layout.oriented, layout.colours || layout.masks};
    if (surface.surface().definition().weight == surface::Weight::Gaussian)
        kind.spacingOfUnit /= surface::gaussianScale;
    return {surface, view->rays, lens, guard, lattice, picture.samples(), kind, startCell};
}

/// Returns the number of hits.
std::size_t AdaptiveCast::State::level(const SubdivisionOptions& options, CastCounts& counts,
                                       const base::Progress& progress) {
    const ViewLens lens(view->rays);
    const CastView what = castView(lens);
    std::vector<Split> made = subdivide(what, options, counts, progress);
    const std::size_t hits = picture.show(what, made);
    splits = std::move(made);
    return hits;
}

/// Returns the number of hits.
std::size_t AdaptiveCast::State::everyPixel(CastCounts& counts, const base::Progress& progress) {
    CastCounts all;
    const std::vector<Sample> samples = fullCast(surface, view->rays, all, progress);
    std::ranges::copy(samples, picture.samples());
    picture.known().assign(picture.size(), Known::Exact);
    counts.rays += all.rays;
    counts.evaluations += all.evaluations;
    return all.hits;
}

/// The qualities on the way to the asked one, which is the last.
static std::vector<double> levelsTo(double quality, bool stepwise) {
    std::vector<double> out{quality};
    if (stepwise) {
        const double finest = quality > 0 ? quality : 1;
        if (quality <= 0)
            out.push_back(finest);
        for (double next = 2 * finest; next <= coarsest; next *= 2)
            out.push_back(next);
    }
    std::ranges::reverse(out);
    return out;
}

AdaptiveCast::AdaptiveCast(surface::Surface surface) : m_state(std::make_unique<State>(std::move(surface))) {}
AdaptiveCast::~AdaptiveCast() = default;
AdaptiveCast::AdaptiveCast(AdaptiveCast&&) noexcept = default;
AdaptiveCast& AdaptiveCast::operator=(AdaptiveCast&&) noexcept = default;

const surface::Surface& AdaptiveCast::surface() const {
    return m_state->surface.surface();
}

void AdaptiveCast::setSurface(surface::Surface next) {
    const auto meaning = [](const surface::Surface& model) {
        const surfel::AttributeLayout& layout = *model.tree().layout();
        return std::tuple(layout.normals, layout.oriented, layout.colours, layout.masks, model.supportScale());
    };
    const surface::Surface& now = m_state->surface.surface();
    if (next.definition() == now.definition() && meaning(next) == meaning(now))
        m_state->edit(std::move(next));
    else
        m_state = std::make_unique<State>(std::move(next));
}

AdaptiveImage AdaptiveCast::cast(const ImageRays& rays, const AdaptiveOptions& options, CastCounts& counts,
                                 const OnLevel& onLevel, const base::Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    State& s = *m_state;
    const double quality = std::max(0.0, options.quality);
    counts = {};
    if (!s.view || !s.view->sees(rays))
        s.turnTo(rays, progress);
    else if (s.guardIsOld)
        s.lookAgain(progress);
    if (quality > 0 && quality < s.redrawnFor)
        s.redrawKept(quality);
    counts.pixels = s.picture.size();
    const auto told = [&](double reached, bool complete) {
        counts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const AdaptiveImage image = s.image(reached, complete);
        if (onLevel)
            onLevel(image);
        return image;
    };
    if (s.reached <= quality)
        return told(s.reached, true);
    if (onLevel && s.reached == nothing) {
        s.level({coarsest, true}, counts, progress);
        told(coarsest, false);
    }
    for (const double next : levelsTo(quality, onLevel != nullptr)) {
        if (s.reached <= next)
            continue;
        counts.hits = next > 0 ? s.level({next, false}, counts, progress) : s.everyPixel(counts, progress);
        s.reached = next;
        if (next > quality)
            told(next, true);
    }
    return told(quality, true);
}

} // namespace raycast
