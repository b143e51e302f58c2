// What rays that leave the model see (raycast/README 4.2): the picture's own background where they go on nearly
// straight, elsewhere a room with floor and ceiling, and the lamps as bright round panels. A formula, not an image.
#pragma once

#include "core/raycast/lighting.h"

namespace raycast {

/// Who looks: directions in model coordinates, and what stands behind the model in the picture.
struct Viewer {
    base::Vec3f forward{0, 0, -1}, upright{0, 1, 0}; ///< unit; upright is the image's
    base::Vec3f up{0, 1, 0};                         ///< of the world: the ground is below
    float slope = 0.3f;                              ///< of the rays through the image's upper edge
    base::Vec3f top, bottom;                         ///< background, linear light
    bool operator==(const Viewer&) const = default;
};

class Environment {
  public:
    Environment(const Lighting& lighting, const Viewer& viewer);

    /// In model coordinates, unit.
    const std::vector<Lamp>& lamps() const { return m_lamps; }
    const base::Vec3f& up() const { return m_up; }
    /// Light from a unit direction.
    base::Vec3f from(const base::Vec3f& direction) const;
    /// What a white matte surface with normal n reflects of the room's light, without lamps.
    base::Vec3f room(const base::Vec3f& n) const;

  private:
    base::Vec3f background(const base::Vec3f& direction, float along) const;

    Viewer m_viewer;
    base::Vec3f m_up;
    base::Vec3f m_above, m_below;
    std::vector<Lamp> m_lamps;
};

} // namespace raycast
