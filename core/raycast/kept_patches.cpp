#include "core/raycast/kept_patches.h"

#include "core/base/parallel.h"

namespace raycast {

namespace {

/// Samples of redrawn samples are as far from rays as patches may be.
constexpr int mostGenerations = Lattice::mostGenerations - 1;

/// Cosine of 30 degrees: between corners that differ by more the normal could be any.
constexpr float steady = 0.87f;

constexpr std::size_t cornersOf[4][4] = {{0, 1, 3, 4}, {1, 2, 4, 5}, {3, 4, 6, 7}, {4, 5, 7, 8}};

/// Are the four corners of a quarter hits of one sheet? Where it jumps, some corner lies far above or below the tangent
/// plane at another.
bool ofOneSheet(const KeptPatch& patch, const std::array<bool, 9>& hit, std::size_t quarter) {
    for (const std::size_t i : cornersOf[quarter]) {
        if (!hit[i])
            return false;
        for (const std::size_t j : cornersOf[quarter]) {
            const base::Vec3f d = patch.position(j) - patch.position(i);
            if (hit[j] && (std::abs(dot(patch.normal(i), d)) > 0.5f * length(d) ||
                           dot(patch.normal(i), patch.normal(j)) < steady))
                return false;
        }
    }
    return true;
}

/// Does a quarter show anything that was not redrawn?
bool isNew(const CastView& view, const Split& split, int quarter) {
    const Pixel at = split.child(quarter);
    for (Pixel p = at; p.row <= at.row + split.half; ++p.row)
        for (p.column = at.column; p.column <= at.column + split.half; ++p.column)
            if (!view.lattice.redrawn(p))
                return true;
    return false;
}

/// What a corner rests on.
struct Corner {
    const Sample* sample = nullptr; ///< null: a miss
    int generation = 0;
};

/// A ray, what was redrawn, or what the picture shows between those.
Corner cornerAt(const CastView& view, const AdaptivePicture& picture, Pixel p) {
    if (const Sample* sample = view.sampleAt(p))
        return {sample->hit.hit ? sample : nullptr, view.lattice.generation(p)};
    if (!view.inImage(p))
        return {};
    const std::size_t i = static_cast<std::size_t>(p.row) * static_cast<std::size_t>(view.rays.width) +
                          static_cast<std::size_t>(p.column);
    const bool shown = picture.known()[i] != Known::Nothing && picture.samples()[i].hit.hit;
    return {shown ? &picture.samples()[i] : nullptr, 1};
}

/// Empty if nothing of it is to be kept.
KeptPatch kept(const CastView& view, const AdaptivePicture& picture, const Split& split) {
    KeptPatch out;
    for (int i = 0; i < 4; ++i)
        if ((split.shown >> i & 1) != 0 && isNew(view, split, i))
            out.shown |= static_cast<std::uint8_t>(1 << i);
    if (!out.shown)
        return out;
    std::array<bool, 9> hit{};
    Patch patch;
    std::array<double, 9> stretch{};
    for (int i = 0; i < 9; ++i) {
        const Pixel p{split.at.column + i % 3 * split.half, split.at.row + i / 3 * split.half};
        const auto k = static_cast<std::size_t>(i);
        const auto [sample, generation] = cornerAt(view, picture, p);
        if (!sample)
            continue;
        hit[k] = true;
        stretch[k] = view.lens.stretch(p.column, p.row);
        patch.knots[k] = Knot::of(*sample, view.lens, stretch[k]);
        const surface::RayHit<float>& h = sample->hit;
        const auto byte = [colour = sample->colour](int n) { return static_cast<float>(colour >> (8 * n) & 255u); };
        out.knots[k] = {h.position.x, h.position.y, h.position.z, h.normal.x, h.normal.y, h.normal.z,
                        h.unit,       h.agreement,  byte(0),      byte(1),    byte(2),    sample->mask};
        out.behind = dot(h.normal, h.outward) < 0;
        out.generation = std::max(out.generation, static_cast<std::uint8_t>(generation));
    }
    for (std::size_t i = 0; i < 4; ++i)
        if (!ofOneSheet(out, hit, i))
            out.shown &= static_cast<std::uint8_t>(~(1u << i));
    if (out.generation > mostGenerations)
        out.shown = 0;
    // Those of an outline were not predicted yet.
    out.error = split.half == 1 ? predictionError(patch, stretch, view.lens, view.kind) : split.error;
    out.half = static_cast<std::uint8_t>(split.half);
    return out;
}

} // namespace

KeptPatch::Values KeptPatch::at(float u, float v, unsigned quarter) const {
    Values out{};
    const auto add = [&](std::size_t knot, float w) {
        for (std::size_t k = 0; k < Count; ++k)
            out[k] += w * knots[knot][k];
    };
    if (half == 1) {
        const std::size_t first = cornersOf[quarter][0];
        const float x = 2 * u - static_cast<float>(quarter & 1), y = 2 * v - static_cast<float>(quarter >> 1);
        add(first, (1 - x) * (1 - y)), add(first + 1, x * (1 - y));
        add(first + 3, (1 - x) * y), add(first + 4, x * y);
        return out;
    }
    const auto a = quadraticWeights(u), b = quadraticWeights(v);
    for (std::size_t i = 0; i < 9; ++i)
        add(i, a[i % 3] * b[i / 3]);
    return out;
}

void KeptPatches::add(const CastView& view, const AdaptivePicture& picture, std::span<const Split> splits) {
    constexpr std::size_t grain = 256;
    std::vector<std::vector<KeptPatch>> parts(base::chunkCount(splits.size(), grain));
    base::parallelChunks(splits.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t i = begin; i < end; ++i)
            if (const KeptPatch patch = kept(view, picture, splits[i]); patch.shown)
                parts[chunk].push_back(patch);
    });
    for (const auto& part : parts)
        m_patches.insert(m_patches.end(), part.begin(), part.end());
}

void KeptPatches::dropNear(std::span<const base::Box3f> boxes) {
    base::Box3f all;
    for (const base::Box3f& box : boxes)
        all.extend(box);
    std::erase_if(m_patches, [&](const KeptPatch& patch) {
        base::Box3f own;
        for (std::size_t i = 0; i < 9; ++i)
            if (patch.knots[i][KeptPatch::Unit] > 0) // a hit
                own.extend(patch.position(i));
        return own.overlaps(all) &&
               std::ranges::any_of(boxes, [&](const base::Box3f& box) { return own.overlaps(box); });
    });
}

void KeptPatches::age(std::span<const std::uint8_t> seen) {
    for (std::size_t i = 0; i < m_patches.size(); ++i)
        m_patches[i].unseen = seen[i] ? 0 : static_cast<std::uint8_t>(m_patches[i].unseen + 1);
    std::erase_if(m_patches, [](const KeptPatch& patch) { return patch.unseen > patience; });
}

} // namespace raycast
