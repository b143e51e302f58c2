#include "core/render/effects/finish.h"

#include "core/base/parallel.h"

namespace render {

void Finish::begin(const RenderOptions& options, const Camera& camera) {
    m_wanted = options.effects || options.grid;
    m_view.emplace(camera);
    m_effects.reset();
    m_grid.reset();
    if (!m_wanted) {
        m_shaded = {};
        m_geometry = {};
        return;
    }
    if (options.effects)
        m_effects.emplace(options.effects, *m_view, options.pixelScale);
    if (options.grid)
        m_grid.emplace(*options.grid, camera, backdropRow(options.backdrop).ink, options.pixelScale);
    m_width = static_cast<std::size_t>(camera.width);
    m_shaded.resize(m_width * static_cast<std::size_t>(camera.height));
    m_geometry.resize(camera.width, camera.height, m_effects ? m_effects->reach : 0);
}

void Finish::tiles(const TileMask& changed, Image& out) {
    if (m_effects)
        m_geometry.fillMargin();
    const std::vector<std::uint32_t> tiles = changed.tilesWithin(m_effects ? m_effects->reach : 0);
    base::parallelFor(tiles.size(), 1, [&](std::size_t i) {
        const auto t = static_cast<int>(tiles[i]);
        const int left = t % changed.columns() * tileWidth, top = t / changed.columns() * tileHeight;
        const int right = std::min(left + tileWidth, m_view->width);
        for (int row = top; row < std::min(top + tileHeight, m_view->height); ++row) {
            const surfel::Colour* from = shaded(row) + left;
            surfel::Colour* to = out.colour.data() + (from - m_shaded.data());
            std::copy(from, from + (right - left), to);
            if (m_effects)
                applyEffects(*m_effects, *m_view, m_geometry, row, left, right, to);
            if (m_grid)
                applyGrid(*m_grid, *m_view, m_geometry, row, left, right, to);
        }
    });
}

} // namespace render
