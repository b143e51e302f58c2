#include "core/render/splats/cpu_splatter.h"

#include "core/base/parallel.h"
#include "core/base/scratch.h"
#include "core/render/shading/shading.h"
#include "core/render/splats/splat_style.h"

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
    const ShadedLayer* layer; ///< may be null
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

/// A pixel where something is seen.
struct Seen {
    surfel::Colour colour;
    float depth, z; ///< along its ray; along the direction of view
    base::Vec3f normal;
};

Seen seenInSplats(const Frame& frame, const TileSums& sums, int i, float dx, float dy) {
    const float inverse = 1 / sums.weight[i];
    const base::Vec3f n =
        normalized(base::Vec3f{sums.normal[0][i], -sums.normal[1][i], -sums.normal[2][i]}, towardsEye);
    surfel::Colour blended = surfel::white;
    float mask = 0;
    if (frame.style.colours) {
        const auto channel = [&](int k) { return static_cast<unsigned>(sums.colour[k][i] * inverse + 0.5f); };
        if (frame.style.coloured)
            blended = surfel::rgba(channel(0), channel(1), channel(2));
        mask = sums.mask[i] * inverse;
    }
    const float z = sums.depth[i] * inverse;
    // dy runs down, the shading frame's y runs up.
    return {shadePixel(frame.shading, inRayFrame(n, dx, -dy), blended, mask), z * std::sqrt(dx * dx + dy * dy + 1), z,
            n};
}

void shadeTile(const Frame& frame, const TileArea& area, const TileSums& sums) {
    const bool finish = frame.finish.wanted();
    for (int y = 0; y < area.height; ++y) {
        const int row = area.top + y;
        const float dy = frame.view.raySlopeY(row);
        const auto line = static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.out.width);
        surfel::Colour* colour = finish ? frame.finish.shaded(row) : frame.out.colour.data() + line;
        float* depth = frame.out.depth.data() + line;
        std::optional<GeometryRow> geometry;
        if (finish)
            geometry.emplace(frame.finish.geometry(), row);
        const ShadedLayer::Pixel* layer = frame.layer ? frame.layer->row(row) : nullptr;
        surfel::Colour background[8];
        backgroundRow(frame.options.backdrop, row, frame.view.height, frame.options.transparent, background);
        for (int x = area.left; x < area.left + area.width; ++x) {
            const int i = y * tileStride + x - area.left;
            const float dx = frame.view.raySlopeX(x);
            const PixelKind kind = layer ? layer[x].kind : PixelKind::Unknown;
            Seen seen;
            if (kind == PixelKind::Surface)
                seen = {over(layer[x].colour, background[x & 7]), layer[x].depth,
                        layer[x].depth / std::sqrt(dx * dx + dy * dy + 1), layer[x].normal};
            else if (kind == PixelKind::Unknown && sums.weight[i] > 0)
                seen = seenInSplats(frame, sums, i, dx, dy);
            else {
                colour[x] = layer ? over(layer[x].colour, background[x & 7]) : background[x & 7];
                depth[x] = std::numeric_limits<float>::infinity();
                if (finish)
                    geometry->set(x, nowhereOf(frame.view), {});
                continue;
            }
            colour[x] = seen.colour;
            depth[x] = seen.depth;
            if (finish)
                geometry->set(x, frame.view.nearness(seen.z), seen.normal);
        }
    }
}

TileArea tileArea(const ViewFrame& view, int column, int row) {
    const int left = column * tileWidth, top = row * tileHeight;
    return {left, top, std::min(tileWidth, view.width - left), std::min(tileHeight, view.height - top)};
}

bool wholly(const ShadedLayer& layer, const TileArea& area) {
    for (int y = area.top; y < area.top + area.height; ++y)
        for (int x = area.left; x < area.left + area.width; ++x)
            if (layer.row(y)[x].kind == PixelKind::Unknown)
                return false;
    return true;
}

/// Entries between two looks at what the tile already hides.
constexpr std::size_t entriesPerLook = 8;

void drawTile(const Frame& frame, const TileArea& area, std::span<const BinEntry> entries, Scratch& scratch) {
    if (frame.layer && wholly(*frame.layer, area))
        return shadeTile(frame, area, scratch.sums);
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
    static base::Scratch<Scratch> scratches;
    m_bins.fill(m_visible, view, setting.style.radiusOfSupport);
    const Frame frame{view, setting.style, shadingStyle(setting.options.shading), setting.options, m_drawnLayer.get(),
                      out,  m_finish};
    base::parallelFor(tiles.size(), 1, [&](std::size_t i) {
        const auto scratch = scratches.take();
        const auto t = static_cast<int>(tiles[i]);
        drawTile(frame, tileArea(view, t % m_bins.columns(), t / m_bins.columns()), m_bins.tile(t), *scratch);
    });
}

Sight CpuSplatter::sight(const tree::SurfelTree& model, const ViewFrame& view, const Setting& setting) {
    m_details.use(setting.style.radiusOfSupport, setting.style.oriented);
    const bool details = setting.options.detailPx > 0 || setting.options.closed;
    return {view,
            setting.style.radiusOfSupport,
            details ? &m_details : nullptr,
            setting.options.detailPx,
            setting.options.closed && setting.style.oriented,
            FinerBlocks::any(model, setting.options) ? finerReach : 1,
            setting.options.pixelScale};
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

/// A pixel that no layer knows, where there is none.
static const ShadedLayer::Pixel* rowOf(const ShadedLayer* layer, int y) {
    return layer ? layer->row(y) : nullptr;
}

/// Where the wanted layer is not as the one in the picture is.
void CpuSplatter::addRelayeredTiles(const ViewFrame& view, const ShadedLayer* wanted, TileMask& mask) {
    const ShadedLayer* drawn = m_drawnLayer.get();
    constexpr ShadedLayer::Pixel unknown;
    for (int top = 0, row = 0; top < view.height; top += tileHeight, ++row)
        for (int column = 0; column < mask.columns(); ++column) {
            const TileArea area = tileArea(view, column, row);
            const auto differs = [&](int y) {
                const ShadedLayer::Pixel *a = rowOf(wanted, y), *b = rowOf(drawn, y);
                for (int x = area.left; x < area.left + area.width; ++x)
                    if (!((a ? a[x] : unknown) == (b ? b[x] : unknown)))
                        return true;
                return false;
            };
            for (int y = area.top; y < area.top + area.height; ++y)
                if (differs(y)) {
                    mask.add({true, area.left, area.top, area.left, area.top, 0});
                    break;
                }
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
    const Setting setting{camera, options, splatStyle(model, options, camera)};
    const Sight seen = sight(model, view, setting);
    const bool sameSize = out.width == camera.width && out.height == camera.height;
    TileMask mask(view);
    const bool same = m_setting && m_setting->sameButColours(setting) && sameSize;
    const std::shared_ptr<const BlockColours> before = m_setting ? m_setting->options.colours : nullptr;
    const bool bounded = DiscCuts::any(options.definition);
    if (bounded)
        m_discCuts.use(options.definition, setting.style.radiusOfSupport);
    const auto recut = bounded ? m_discCuts.follow(model) : std::vector<const surfel::SurfelBlock*>{};
    const bool finer = FinerBlocks::any(model, options);
    if (finer)
        m_finer.use(options.definition, setting.style.radiusOfSupport);
    const auto remade = m_finer.follow(model);
    const bool fits = m_layer && m_layer->width == camera.width && m_layer->height == camera.height;
    const std::shared_ptr<const ShadedLayer> layer = fits ? m_layer : nullptr;
    m_setting.reset(); // for as long as the picture is neither the one nor the other
    if (same) {
        addChangedTiles(m_model, model, seen, mask);
        addTiles(recut, seen, mask);
        addTiles(remade, seen, mask);
        if (setting.options.colours != before)
            addRecolouredTiles(before, setting.options.colours, model, seen, mask);
        if (layer != m_drawnLayer)
            addRelayeredTiles(view, layer.get(), mask);
        mask.close();
        visibleBlocks(model, seen, m_visible, &mask);
    } else {
        m_details.colourBy(model, setting.style.table ? setting.options.colours : nullptr);
        if (!sameSize)
            out.resize(camera.width, camera.height);
        mask.add({true, 0, 0, camera.width - 1, camera.height - 1, 0});
        visibleBlocks(model, seen, m_visible);
    }
    m_drawnLayer = layer;
    if (bounded)
        findCuts(seen, m_discCuts, m_visible);
    if (finer)
        findFiner(seen, m_finer, m_visible);
    if (!same)
        m_finish.begin(options, camera);
    drawTiles(setting, mask.tiles(), out);
    if (m_finish.wanted())
        m_finish.tiles(mask, out);
    m_details.forget(m_model, model);
    m_details.takeDropped();
    m_finer.takeDropped();
    m_model = model;
    m_setting = setting;
}

} // namespace render
