#include "core/raycast/adaptive_cast.h"

#include "core/raycast/adaptive_picture.h"

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
    surface::Surface surface;
    std::optional<OwnRays> view; ///< that the rest belongs to
    SplatGuard guard;
    Lattice lattice;
    AdaptivePicture picture;
    int startCell = 4;
    double reached = nothing; ///< the finest quality that the whole picture is of

    explicit State(surface::Surface model) : surface(std::move(model)) {}

    void begin(const ImageRays& rays, const base::Progress& progress);
    CastView castView(const ViewLens& lens);
    std::size_t level(const SubdivisionOptions& options, CastCounts& counts, const base::Progress& progress);
    std::size_t everyPixel(CastCounts& counts, const base::Progress& progress);
    AdaptiveImage image(double quality, bool complete) const {
        return {picture.all(), picture.known(), quality, complete};
    }
};

void AdaptiveCast::State::begin(const ImageRays& rays, const base::Progress& progress) {
    view.reset();
    reached = nothing;
    // The guard tells how large start cells are, and they how far the lattice goes: it looks as far as any would.
    constexpr int margin = SplatGuard::largestSquare;
    const auto rounded = [](int n, int to) { return (n + to - 1) / to * to + 1; };
    guard.look(surface, rays, rounded(rays.width, margin), rounded(rays.height, margin), progress);
    startCell = startCellFor(guard.spacingPx());
    lattice.reset(rounded(rays.width, startCell), rounded(rays.height, startCell));
    picture.resize(rays.width, rays.height);
    view.emplace(rays);
}

CastView AdaptiveCast::State::castView(const ViewLens& lens) {
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    PatchKind kind{layout.normals && layout.oriented, layout.colours || layout.masks};
    if (surface.definition().weight == surface::Weight::Gaussian)
        kind.spacingOfUnit /= surface::gaussianScale;
    return {surface, view->rays, lens, guard, lattice, picture.samples(), kind, startCell};
}

/// Returns the number of hits.
std::size_t AdaptiveCast::State::level(const SubdivisionOptions& options, CastCounts& counts,
                                       const base::Progress& progress) {
    const ViewLens lens(view->rays);
    const CastView what = castView(lens);
    const std::vector<Split> splits = subdivide(what, options, counts, progress);
    return picture.show(what, splits);
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
    return m_state->surface;
}

void AdaptiveCast::setSurface(surface::Surface next) {
    if (next.tree() == m_state->surface.tree() && next.definition() == m_state->surface.definition())
        return;
    m_state->surface = std::move(next);
    m_state->view.reset();
}

AdaptiveImage AdaptiveCast::cast(const ImageRays& rays, const AdaptiveOptions& options, CastCounts& counts,
                                 const OnLevel& onLevel, const base::Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    State& s = *m_state;
    const double quality = std::max(0.0, options.quality);
    counts = {};
    if (!s.view || !s.view->sees(rays))
        s.begin(rays, progress);
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
