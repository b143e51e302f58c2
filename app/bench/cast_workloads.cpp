// Pictures of cast rays: adaptive against full, the first level, turned views and edits.
#include "app/bench/workload.h"
#include "core/raycast/adaptive_cast.h"

#include <array>
#include <atomic>
#include <numbers>

namespace bench {

using base::Vec3d;
using raycast::AdaptiveCast, raycast::CastCounts, raycast::ImageRays;

namespace {

/// Pixels along a side; small models get small pictures.
int sideOf(const Scene& scene) {
    return scene.size() < 10'000 ? 128 : 1024;
}

/// A square picture that the model fills, turned about the upright axis.
ImageRays view(const Scene& scene, double degrees) {
    constexpr double distance = 5; // radii
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3d back{std::sin(angle), 0, std::cos(angle)}, right{std::cos(angle), 0, -std::sin(angle)}, down{0, -1, 0};
    ImageRays out;
    out.width = out.height = sideOf(scene);
    out.eye = scene.centre() + back * (distance * scene.radius());
    const double focal = 0.46 * out.width * (distance - 0.5);
    out.corner = back * -focal + (right + down) * (0.5 - 0.5 * out.width);
    out.across = right, out.down = down;
    return out;
}

Run fully(Scene& scene) {
    return [&scene] {
        CastCounts counts;
        keep(raycast::fullCast(scene.surface(), view(scene, 0), counts));
        return counts.pixels;
    };
}

Run afresh(Scene& scene) {
    return [&scene] {
        AdaptiveCast cast(scene.surface());
        CastCounts counts;
        keep(cast.cast(view(scene, 0), {}, counts));
        return counts.pixels;
    };
}

/// Until the first level is there.
Run firstLevel(Scene& scene) {
    return [&scene] {
        AdaptiveCast cast(scene.surface());
        CastCounts counts;
        std::atomic<bool> stop = false;
        try {
            cast.cast(view(scene, 0), {}, counts, [&](const raycast::AdaptiveImage&) { stop = true; }, {{}, &stop});
        } catch (const base::Cancelled&) {
        }
        return counts.pixels;
    };
}

/// The next view, `degrees` on; by one caster, or by a fresh one each time.
Run turning(Scene& scene, double degrees, bool keeping) {
    auto cast = std::make_shared<AdaptiveCast>(scene.surface());
    CastCounts first;
    cast->cast(view(scene, 0), {}, first);
    return [&scene, cast, degrees, keeping, at = 0.0]() mutable {
        at = std::fmod(at + degrees, 360);
        if (!keeping)
            *cast = AdaptiveCast(scene.surface());
        CastCounts counts;
        keep(cast->cast(view(scene, at), {}, counts));
        return counts.pixels;
    };
}

/// The same view after a dab that moves a hundredth of the surfels, there and back again.
Run dabbing(Scene& scene, bool keeping) {
    struct State {
        std::array<surface::Surface, 2> versions;
        AdaptiveCast cast;
        std::size_t next = 1;
    };
    const tree::SurfelTree& model = scene.surface().tree();
    const Vec3d front = scene.centre() + Vec3d{0, 0, 1} * scene.radius();
    std::vector<tree::Neighbour> found;
    model.nearest(base::cast<float>(front), std::max<std::size_t>(1, scene.size() / 100), found);
    tree::Edit edit;
    std::ranges::sort(found, {}, [](const tree::Neighbour& n) { return std::pair(n.blockNumber, n.slot); });
    surfel::MutableBlockPtr changed;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const tree::Neighbour& n = found[i];
        if (i == 0 || n.blockNumber != found[i - 1].blockNumber)
            changed = n.block->clone();
        const float height = 0.2f * n.block->support(n.slot);
        changed->setPosition(n.slot, n.block->position(n.slot) + n.block->normal(n.slot) * height);
        if (i + 1 == found.size() || found[i + 1].blockNumber != n.blockNumber) {
            changed->seal();
            edit.blocks.push_back({n.blockNumber, changed, {}});
        }
    }
    const surface::Surface edited{model.apply(edit), scene.surface().definition()};
    auto state = std::make_shared<State>(State{{scene.surface(), edited}, AdaptiveCast(scene.surface())});
    CastCounts first;
    state->cast.cast(view(scene, 0), {}, first);
    return [&scene, state, keeping] {
        const surface::Surface& version = state->versions[std::exchange(state->next, 1 - state->next)];
        if (keeping)
            state->cast.setSurface(version);
        else
            state->cast = AdaptiveCast(version);
        CastCounts counts;
        keep(state->cast.cast(view(scene, 0), {}, counts));
        return counts.pixels;
    };
}

} // namespace

std::vector<Workload> castWorkloads() {
    constexpr const char *full = "ours: a ray for every pixel", *fresh = "ours: the same with nothing kept from before";
    return {
        {"raycast-adaptive", "pixel", "1024 x 1024 pixels of cast rays at quality 1", full, afresh, fully, true},
        {"raycast-first", "pixel", "the same until the first level can be shown", full, firstLevel, fully, true, false},
        {"raycast-turned-1", "pixel", "the next picture of a view that turns by 1 degree", fresh,
         [](Scene& scene) { return turning(scene, 1, true); }, [](Scene& scene) { return turning(scene, 1, false); },
         true},
        {"raycast-turned-10", "pixel", "the next picture of a view that turns by 10 degrees", fresh,
         [](Scene& scene) { return turning(scene, 10, true); }, [](Scene& scene) { return turning(scene, 10, false); },
         true},
        {"raycast-dab", "pixel", "the same picture after a dab that moves a hundredth of the surfels", fresh,
         [](Scene& scene) { return dabbing(scene, true); }, [](Scene& scene) { return dabbing(scene, false); }, true},
    };
}

} // namespace bench
