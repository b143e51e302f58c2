#include "core/surface/rays/intersect.h"

#include "core/base/parallel.h"
#include "core/surface/rays/ray_order.h"
#include "core/surface/rays/ray_policy.h"

#include <cassert>

namespace surface {

namespace {

constexpr std::size_t packetSize = 32, packetsPerTask = 8;

/// A packet of rays with its first guesses, which are found together and share one neighbourhood.
class RayPacket {
  public:
    explicit RayPacket(const RaySetting& setting) : m_setting(setting), m_sources(setting.surface) {}

    /// Calls fn(i, policy) for every ray of the packet.
    template <class Fn>
    void run(std::span<const base::Rayf> rays, const Fn& fn) {
        const std::size_t found = m_setting.discs ? guess(rays) : 0;
        for (std::size_t i = 0, k = 0; i < rays.size(); ++i) {
            const bool known = k < found && m_which[k] == i;
            RayPolicy<float> policy(m_setting, m_sources, rays[i], known ? &m_hits[k++] : nullptr);
            fn(i, policy);
        }
    }

    /// Calls fn(i, blocked) for every ray: first each leaves what lies about its start, then all look for discs
    /// together.
    template <class Fn>
    void runAny(std::span<const base::Rayf> rays, const Fn& fn) {
        if (!m_setting.discs || m_setting.options.tMin != 0) {
            run(rays, [&](std::size_t i, RayPolicy<float>& policy) { fn(i, policy.any()); });
            return;
        }
        expectStarts(rays);
        std::size_t count = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            double from = 0;
            RayPolicy<float> start(m_setting, m_sources, rays[i]);
            if (start.far()) {
                fn(i, start.any());
                continue;
            }
            const bool blocked = !(lengthSq(rays[i].direction) > 0) || start.blockedNear(from);
            if (blocked || !(from <= double(m_setting.options.tMax))) {
                fn(i, blocked && lengthSq(rays[i].direction) > 0);
                continue;
            }
            const base::Vec3f d = rounded(rays[i].direction);
            m_which[count] = i;
            m_from[count] = static_cast<float>(from);
            m_rays[count] = {rays[i].origin + d * m_from[count], d};
            ++count;
        }
        nearestDiscs(m_setting.surface.tree(), {m_rays, count}, {0, m_setting.discMost(), m_setting.maxSupport},
                     {m_hits, count});
        share(count);
        for (std::size_t k = 0; k < count; ++k) {
            RayHit<float> hit;
            RayPolicy<float>(m_setting, m_sources, m_rays[k], &m_hits[k]).first(hit);
            fn(m_which[k], hit.hit && hit.t + m_from[k] <= m_setting.options.tMax);
        }
    }

  private:
    /// Neighbouring starts share what lies about them.
    void expectStarts(std::span<const base::Rayf> rays) {
        constexpr float reach = 0.5f; // of the support: how far rays look about their starts
        base::Box3f box;
        std::size_t count = 0;
        for (const base::Rayf& ray : rays)
            if (m_setting.bounds.contains(ray.origin)) {
                box.extend(ray.origin);
                ++count;
            }
        if (count > 0)
            m_sources.guesses.expect(box, reach, count);
    }
    /// Discs of the rays that start outside; returns their number.
    std::size_t guess(std::span<const base::Rayf> rays) {
        const float tMin = m_setting.options.tMin;
        std::size_t count = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const base::Rayf unit{rays[i].origin, rounded(rays[i].direction)};
            if (!(lengthSq(unit.direction) > 0) || m_setting.bounds.contains(unit.at(tMin)))
                continue;
            m_which[count] = i;
            m_rays[count++] = unit;
        }
        nearestDiscs(m_setting.surface.tree(), {m_rays, count}, {tMin, m_setting.discMost(), m_setting.maxSupport},
                     {m_hits, count});
        share(count);
        return count;
    }
    /// The direction as a RayProbe has it.
    static base::Vec3f rounded(const base::Vec3f& d) {
        return base::cast<float>(base::normalized(base::cast<double>(d)));
    }
    void share(std::size_t count) {
        constexpr float slack = 0.1f; // of the support: how far first guesses move
        base::Box3f box;
        std::size_t crossed = 0;
        for (std::size_t k = 0; k < count; ++k)
            if (m_hits[k].crossed()) {
                box.extend(m_rays[k].at(m_hits[k].guess));
                ++crossed;
            }
        if (crossed > 0)
            m_sources.guesses.expect(box, slack, crossed);
    }

    const RaySetting& m_setting;
    RaySources m_sources;
    std::size_t m_which[packetSize];
    float m_from[packetSize]; ///< of rays that have left what lies about their starts
    base::Rayf m_rays[packetSize];
    DiscHit m_hits[packetSize];
};

/// Calls fn(packet, rays, number) for packets of rays; number(i) is the place of the i-th of them in the list.
template <class Fn>
void forPackets(const RaySetting& setting, std::span<const base::Rayf> rays, const Fn& fn) {
    const std::vector<std::uint32_t> order = viewOrder(rays, setting.surface.tree().bounds());
    base::parallelChunks(rays.size(), packetSize * packetsPerTask,
                         [&](std::size_t begin, std::size_t end, std::size_t) {
                             RayPacket packet(setting);
                             base::Rayf ordered[packetSize];
                             for (std::size_t first = begin; first < end; first += packetSize) {
                                 const std::size_t count = std::min(packetSize, end - first);
                                 const auto number = [&](std::size_t i) {
                                     return order.empty() ? first + i : static_cast<std::size_t>(order[first + i]);
                                 };
                                 for (std::size_t i = 0; i < count; ++i)
                                     ordered[i] = rays[number(i)];
                                 fn(packet, std::span<const base::Rayf>(ordered, count), number);
                             }
                         });
}

/// fn(i, policy) of every ray.
template <class Fn>
void forRays(const RaySetting& setting, std::span<const base::Rayf> rays, const Fn& fn) {
    forPackets(setting, rays, [&](RayPacket& packet, std::span<const base::Rayf> some, const auto& number) {
        packet.run(some, [&](std::size_t i, RayPolicy<float>& policy) { fn(number(i), policy); });
    });
}

/// fn(policy) of one ray.
template <class T, class Fn>
auto alone(const RaySetting& setting, const base::Ray<T>& ray, const Fn& fn) {
    RaySources sources(setting.surface);
    RayPolicy<T> policy(setting, sources, ray);
    return fn(policy);
}

template <class T>
RayHit<T> firstOf(RayPolicy<T>& policy) {
    RayHit<T> out;
    policy.first(out);
    return out;
}

} // namespace

RayHit<float> intersect(const Surface& surface, const base::Rayf& ray, const IntersectOptions& options) {
    return alone({surface, options}, ray, [](auto& policy) { return firstOf<float>(policy); });
}

RayHit<double> intersectReference(const Surface& surface, const base::Rayd& ray, const IntersectOptions& options) {
    return alone({surface, options}, ray, [](auto& policy) { return firstOf<double>(policy); });
}

void intersect(const Surface& surface, std::span<const base::Rayf> rays, const IntersectOptions& options,
               std::span<RayHit<float>> out) {
    assert(rays.size() == out.size());
    forRays({surface, options}, rays, [&](std::size_t i, auto& policy) { policy.first(out[i]); });
}

std::vector<RayHit<float>> intersectAll(const Surface& surface, const base::Rayf& ray,
                                        const IntersectOptions& options) {
    return alone({surface, options}, ray, [](auto& policy) { return policy.all(); });
}

std::vector<RayHit<double>> intersectAllReference(const Surface& surface, const base::Rayd& ray,
                                                  const IntersectOptions& options) {
    return alone({surface, options}, ray, [](auto& policy) { return policy.all(); });
}

void intersectAll(const Surface& surface, std::span<const base::Rayf> rays, const IntersectOptions& options,
                  std::span<std::vector<RayHit<float>>> out) {
    assert(rays.size() == out.size());
    forRays({surface, options}, rays, [&](std::size_t i, auto& policy) { out[i] = policy.all(); });
}

bool intersectAny(const Surface& surface, const base::Rayf& ray, const IntersectOptions& options) {
    const RaySetting setting(surface, options, false);
    RayPacket packet(setting);
    bool out = false;
    packet.runAny({&ray, 1}, [&](std::size_t, bool blocked) { out = blocked; });
    return out;
}

bool intersectAnyReference(const Surface& surface, const base::Rayd& ray, const IntersectOptions& options) {
    return alone({surface, options, false}, ray, [](auto& policy) { return policy.any(); });
}

RayHit<float> rounded(const RayHit<double>& hit) {
    RayHit<float> out;
    out.hit = hit.hit;
    out.t = static_cast<float>(hit.t);
    out.position = base::cast<float>(hit.position);
    out.normal = base::cast<float>(hit.normal);
    out.outward = base::cast<float>(hit.outward);
    out.unit = static_cast<float>(hit.unit);
    out.agreement = static_cast<float>(hit.agreement);
    out.evaluations = hit.evaluations;
    return out;
}

void intersectAny(const Surface& surface, std::span<const base::Rayf> rays, const IntersectOptions& options,
                  std::span<std::uint8_t> out) {
    assert(rays.size() == out.size());
    forPackets({surface, options, false}, rays,
               [&](RayPacket& packet, std::span<const base::Rayf> some, const auto& number) {
                   packet.runAny(some, [&](std::size_t i, bool blocked) { out[number(i)] = blocked ? 1 : 0; });
               });
}

} // namespace surface
