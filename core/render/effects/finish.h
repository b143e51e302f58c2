// The last pass over a picture drawn on the CPU, by splats or by rays: effects, then the grid. What was shaded stays
// beside the picture, so that a part can be finished again when its neighbours change.
//
//     finish.begin(options, camera)      may do nothing: wanted()
//     ... whoever draws fills shaded() and geometry() instead of the picture ...
//     finish.tiles(tiles, out)           after which the picture is right around those tiles too
#pragma once

#include "core/render/effects/ground_grid.h"
#include "core/render/effects/screen_effects.h"
#include "core/render/renderer.h"
#include "core/render/tile_mask.h"

namespace render {

class Finish {
  public:
    void begin(const RenderOptions& options, const Camera& camera);
    bool wanted() const { return m_wanted; }
    /// Shaded pixels, row by row.
    surfel::Colour* shaded(int row) { return m_shaded.data() + static_cast<std::size_t>(row) * m_width; }
    PixelGeometry& geometry() { return m_geometry; }
    /// One pixel of both: its shaded colour, nearness and normal. Different pixels may be set by different threads.
    void set(int column, int row, surfel::Colour colour, float nearness, const base::Vec3f& normal) {
        shaded(row)[column] = colour;
        m_geometry.nearness(row)[column] = nearness;
        for (int k = 0; k < 3; ++k)
            m_geometry.normal(k, row)[column] = normal[static_cast<std::size_t>(k)];
    }
    /// Finishes what tiles of `changed` can reach. REQUIRES: all of shaded() and geometry() is right.
    void tiles(const TileMask& changed, Image& out);

  private:
    bool m_wanted = false;
    std::size_t m_width = 0;
    std::optional<ViewFrame> m_view;
    std::optional<EffectPlan> m_effects;
    std::optional<GridPlan> m_grid;
    std::vector<surfel::Colour> m_shaded;
    PixelGeometry m_geometry;
};

} // namespace render
