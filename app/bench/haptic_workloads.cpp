// A tick of a haptic servo: a point that is pressed into the surface and pulled along it, wherever it leads.
#include "app/bench/workload.h"
#include "core/haptics/proxy.h"

#include <chrono>
#include <cstdio>
#include <vector>

namespace bench {

using base::Vec3d;

namespace {

constexpr std::size_t walks = 8, ticksPerRun = 200, mostKept = 1'000'000;
constexpr double depth = 0.2, way = 0.05; // of h: a tool that presses and slides

/// Follows its own proxy: the tool stays ahead of it and below.
struct Walk {
    haptics::Proxy proxy{haptics::ToolShape{0, 0.2}};
    Vec3d ahead;
    double unit = 0;

    void begin(const surface::Surface& surface, const surfel::Surfel& at) {
        const Vec3d n = base::normalized(base::cast<double>(at.normal), {0, 0, 1});
        unit = double(at.support);
        ahead = base::perpendicular(n);
        proxy.place(surface, base::cast<double>(at.position) + n * unit);
        proxy.move(surface, base::cast<double>(at.position) - n * (depth * unit));
    }
    Vec3d tool() {
        const Vec3d n = proxy.touches() ? proxy.normal() : Vec3d{};
        ahead = base::normalized(ahead - n * dot(n, ahead), ahead);
        return proxy.position() + ahead * (way * unit) - n * (depth * unit);
    }
};

/// Seconds of single ticks. REQUIRES: not empty.
std::string told(std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    const auto at = [&](double part) {
        return 1e6 * seconds[static_cast<std::size_t>(part * static_cast<double>(seconds.size() - 1))];
    };
    char out[120];
    std::snprintf(out, sizeof out, "a step: %.0f us, 99.9th percentile %.0f us, longest %.0f us", at(0.5), at(0.999),
                  at(1));
    return out;
}

Run sliding(Scene& scene) {
    std::vector<surfel::Surfel> places = scene.places(walks);
    auto seconds = std::make_shared<std::vector<double>>();
    return {[&surface = scene.surface(), places = std::move(places), seconds, walk = Walk(),
             next = std::size_t(0)]() mutable {
                using Clock = std::chrono::steady_clock;
                walk.begin(surface, places[next++ % places.size()]);
                for (std::size_t i = 0; i < ticksPerRun; ++i) {
                    const Vec3d x = walk.tool();
                    const auto begin = Clock::now();
                    walk.proxy.move(surface, x);
                    if (seconds->size() < mostKept)
                        seconds->push_back(std::chrono::duration<double>(Clock::now() - begin).count());
                }
                keep(walk.proxy.position());
                return ticksPerRun;
            },
            [seconds] { return seconds->empty() ? std::string() : told(*seconds); }};
}

} // namespace

std::vector<Workload> hapticWorkloads() {
    return {{"haptic-step", "tick", "one step of a haptic servo: a point pressed into the surface and pulled along it",
             "", sliding, nullptr}};
}

} // namespace bench
