#include "ui/render/cpu_splatter.h"

#include "core/base/parallel.h"
#include "ui/render/shading.h"
#include "ui/render/splat_style.h"

namespace render {

namespace {

struct Scratch {
    TileSums sums;
    std::vector<Splat> splats;
};

struct Frame {
    const ViewFrame& view;
    const SplatStyle& style;
    const ShadingStyle& shading;
    const RenderOptions& options;
    Image& out;
    Finish& finish;
};

/// What effects know of a pixel, in their planes.
struct GeometryRow {
    float *nearness, *normal[3];

    GeometryRow(PixelGeometry& geometry, int row) : nearness(geometry.nearness(row)) {
        for (int k = 0; k < 3; ++k)
            normal[k] = geometry.normal(k, row);
    }
    void set(int x, float w, const base::Vec3f& n) const {
        nearness[x] = w;
        normal[0][x] = n.x, normal[1][x] = n.y, normal[2][x] = n.z;
    }
};

/// The normal where none adds up: splats that cancel each other.
constexpr base::Vec3f towardsEye{0, 0, 1};

void shadeTile(const Frame& frame, const TileArea& area, const TileSums& sums) {
    for (int y = 0; y < area.height; ++y) {
        const float dy = frame.view.raySlopeY(area.top + y);
        const auto line = static_cast<std::size_t>(area.top + y) * static_cast<std::size_t>(frame.out.width);
        const bool finish = frame.finish.wanted();
        surfel::Colour* colour =
            (finish ? frame.finish.shaded(area.top + y) : frame.out.colour.data() + line) + area.left;
        std::optional<GeometryRow> geometry;
        if (finish)
            geometry.emplace(frame.finish.geometry(), area.top + y);
        float* depth = frame.out.depth.data() + line + static_cast<std::size_t>(area.left);
        surfel::Colour background[8];
        backgroundRow(frame.options.backdrop, area.top + y, frame.view.height, frame.options.transparent, background);
        for (int x = 0; x < area.width; ++x) {
            const int i = y * tileStride + x;
            const float weight = sums.weight[i];
            if (!(weight > 0)) {
                colour[x] = background[(area.left + x) & 7];
                depth[x] = std::numeric_limits<float>::infinity();
                if (finish)
                    geometry->set(area.left + x, nowhereOf(frame.view), {});
                continue;
            }
            const float dx = frame.view.raySlopeX(area.left + x), inverse = 1 / weight;
            const base::Vec3f n =
                normalized(base::Vec3f{sums.normal[0][i], -sums.normal[1][i], -sums.normal[2][i]}, towardsEye);
            surfel::Colour blended = surfel::white;
            float mask = 0;
            if (frame.style.colours) {
                const auto channel = [&](int k) { return static_cast<unsigned>(sums.colour[k][i] * inverse + 0.5f); };
                blended = surfel::rgba(channel(0), channel(1), channel(2));
                mask = sums.mask[i] * inverse;
            }
            // dy runs down, the shading frame's y runs up.
            colour[x] = shadePixel(frame.shading, inRayFrame(n, dx, -dy), blended, mask);
            const float z = sums.depth[i] * inverse;
            depth[x] = z * std::sqrt(dx * dx + dy * dy + 1);
            if (finish)
                geometry->set(area.left + x, frame.view.nearness(z), n);
        }
    }
}

/// Entries between two looks at what the tile already hides.
constexpr std::size_t entriesPerLook = 8;

void drawTile(const Frame& frame, const TileArea& area, std::span<const BinEntry> entries, Scratch& scratch) {
    clearTile(area, frame.style.colours, scratch.sums);
    std::size_t count = 0;
    for (std::size_t e = 0; e < entries.size(); ++e) {
        if (e % entriesPerLook == 0 && e > 0 && entries[e].nearest > farthestLimit(area, scratch.sums))
            break;
        if (scratch.splats.size() < count + surfel::blockCapacity)
            scratch.splats.resize(2 * count + surfel::blockCapacity);
        Splat* next = scratch.splats.data() + count;
        const auto found = static_cast<std::size_t>(gatherSplats(entries[e], frame.view, frame.style, area, next));
        splatVisibility({next, found}, frame.view, area, scratch.sums);
        count += found;
    }
    splatAttributes({scratch.splats.data(), count}, frame.view, frame.style, area, scratch.sums);
    shadeTile(frame, area, scratch.sums);
}

} // namespace

void CpuSplatter::drawTiles(const Setting& setting, std::span<const std::uint32_t> tiles, Image& out) {
    const ViewFrame view(setting.camera);
    m_bins.fill(m_visible, view, setting.style.radiusOfSupport);
    const Frame frame{view, setting.style, shadingStyle(setting.options.shading), setting.options, out, m_finish};
    base::parallelFor(tiles.size(), 1, [&](std::size_t i) {
        thread_local Scratch scratch;
        const auto t = static_cast<int>(tiles[i]);
        TileArea area{t % m_bins.columns() * tileWidth, t / m_bins.columns() * tileHeight, 0, 0};
        area.width = std::min(tileWidth, view.width - area.left);
        area.height = std::min(tileHeight, view.height - area.top);
        drawTile(frame, area, m_bins.tile(t), scratch);
    });
}

Sight CpuSplatter::sight(const ViewFrame& view, const Setting& setting) {
    m_details.use(setting.style.radiusOfSupport, setting.style.oriented);
    const bool details = setting.options.detailPx > 0 || setting.options.closed;
    return {view, setting.style.radiusOfSupport, details ? &m_details : nullptr, setting.options.detailPx,
            setting.options.closed && setting.style.oriented};
}

bool CpuSplatter::Setting::sameButColours(const Setting& o) const {
    Setting same = o;
    if (options.colours && o.options.colours) {
        same.options.colours = options.colours;
        same.style.table = style.table;
    }
    return *this == same;
}

/// What shows other colours than before; blocks that come or go are among the changed ones anyway. The version is
/// looked at twice: the choice of blocks and proxies does not depend on colours, proxies that were remade are others.
void CpuSplatter::addRecolouredTiles(const std::shared_ptr<const BlockColours>& from,
                                     const std::shared_ptr<const BlockColours>& to, const tree::SurfelTree& model,
                                     const Sight& seen, TileMask& mask) {
    std::vector<VisibleBlock> before;
    visibleBlocks(model, seen, before);
    m_details.colourBy(model, to);
    visibleBlocks(model, seen, m_visible);
    for (std::size_t i = 0; i < m_visible.size(); ++i) {
        const surfel::SurfelBlock* block = m_visible[i].block;
        if (block != before[i].block || from->of(block) != to->of(block))
            mask.add(m_visible[i].bounds);
    }
}

void CpuSplatter::render(const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options,
                         Image& out) {
    m_setting.reset();
    update(model, camera, options, out);
}

void CpuSplatter::update(const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options,
                         Image& out) {
    const ViewFrame view(camera);
    const Setting setting{camera, options, splatStyle(model, options)};
    const Sight seen = sight(view, setting);
    const bool sameSize = out.width == camera.width && out.height == camera.height;
    TileMask mask(view);
    const bool same = m_setting && m_setting->sameButColours(setting) && sameSize;
    const std::shared_ptr<const BlockColours> before = m_setting ? m_setting->options.colours : nullptr;
    const bool rims = RimCuts::any(options.definition);
    if (rims)
        m_rims.use(options.definition, setting.style.radiusOfSupport);
    const auto recut = rims ? m_rims.follow(model) : std::vector<const surfel::SurfelBlock*>{};
    m_setting.reset(); // for as long as the picture is neither the one nor the other
    if (same) {
        addChangedTiles(m_model, model, seen, mask);
        addTiles(recut, seen, mask);
        if (setting.options.colours != before)
            addRecolouredTiles(before, setting.options.colours, model, seen, mask);
        mask.close();
        visibleBlocks(model, seen, m_visible, &mask);
    } else {
        m_details.colourBy(model, setting.style.table ? setting.options.colours : nullptr);
        if (!sameSize)
            out.resize(camera.width, camera.height);
        mask.add({true, 0, 0, camera.width - 1, camera.height - 1, 0});
        visibleBlocks(model, seen, m_visible);
    }
    if (rims)
        findRims(seen, m_rims, m_visible);
    if (!same)
        m_finish.begin(options, camera);
    drawTiles(setting, mask.tiles(), out);
    if (m_finish.wanted())
        m_finish.tiles(mask, out);
    m_details.forget(m_model, model);
    m_details.takeDropped();
    m_model = model;
    m_setting = setting;
}

} // namespace render
