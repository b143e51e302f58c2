// What a tool touches or is about to: its feet, at most four, kept from step to step and followed along the surface
// (haptics/README 2.2). A plain value.
#pragma once

#include "core/haptics/foot.h"
#include "core/haptics/half_spaces.h"

#include <vector>

namespace haptics {

/// How close counts as touching, in units of h. The force sees less than this.
constexpr double touching = 1e-5;

class Contacts {
  public:
    static constexpr std::size_t most = 4;

    std::span<const Foot> feet() const { return {m_feet.data(), m_count}; }
    bool empty() const { return m_count == 0; }
    void clear() { m_count = 0; }
    /// Adds a foot unless it is there already; the farthest from `centre` gives way where there is no more room. Tells
    /// whether it was new.
    bool add(const Foot& foot, const base::Vec3d& centre);
    /// Keeps the feet for which keep(foot) is true; it may change them.
    template <class Keep>
    void refresh(const Keep& keep) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < m_count; ++i)
            if (keep(m_feet[i]))
                m_feet[kept++] = m_feet[i];
        m_count = kept;
    }

  private:
    std::array<Foot, most> m_feet{};
    std::size_t m_count = 0;
};

/// How far the centre of a tool is from touching this foot's sheet; negative where the tool is in it.
inline double gapOf(const Foot& foot, const base::Vec3d& centre, double radius) {
    return foot.height(centre) - radius;
}

/// Where a tool with a radius looks for what else it is close to: the sheets about the nearest surfels. Its memory is
/// kept from call to call; one thread at a time.
class Surroundings {
  public:
    /// Adds the feet within `radius` and a little more of `centre`.
    void collect(const surface::Surface& surface, const base::Vec3d& centre, double radius, Contacts& contacts);
    /// After `collect`: how far the centre may go anywhere without touching anything.
    double room() const { return m_room; }
    /// The support of the nearest surfel.
    double unit() const { return m_unit; }

  private:
    std::vector<tree::Neighbour> m_found;
    double m_room = 0, m_unit = 0;
};

} // namespace haptics
