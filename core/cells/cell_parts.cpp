#include "core/cells/cell_parts.h"

#include "core/base/parallel.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace cells {

using surfel::SurfelBlock;

namespace {

constexpr int lanes = surfel::clusterSize;
constexpr float farAway = 1e15f; ///< of slots without a surfel, as in blocks: no weight, and finite squares
constexpr std::size_t grain = 16;

std::vector<const SurfelBlock*> blocksOf(const tree::SurfelTree& tree) {
    std::vector<const SurfelBlock*> out(tree.blockCount());
    tree.forEachBlock([&](std::uint32_t number, const SurfelBlock& block) { out[number] = &block; });
    return out;
}

std::pair<std::uint32_t, std::uint32_t> pairOf(const Label& label) {
    return std::minmax(label.cell, label.partner);
}

} // namespace

/// One block's parts. Pointers into what still grows are numbers until all is there.
class CellParts::Filling {
  public:
    Filling(const SurfelBlock& block, const LabelLayout& labels, std::size_t channels, const std::vector<Pair>& fading,
            Block& out)
        : m_block(block), m_labels(labels), m_channels(channels), m_fading(fading), m_out(out) {}

    void run() {
        for (int cluster = 0; cluster < surfel::clustersPerBlock; ++cluster) {
            if (cluster < m_block.clusterCount())
                part(cluster);
            m_out.first[cluster + 1] = static_cast<std::uint16_t>(m_out.parts.size());
        }
        for (std::size_t i = 0; i < m_out.parts.size(); ++i) {
            const Numbers& numbers = m_numbers[i];
            if (numbers.copy != none)
                m_out.parts[i].channels = m_out.copies[numbers.copy].lanes;
            m_out.parts[i].beside =
                std::span<const BesideCrease>(m_out.beside).subspan(numbers.beside, numbers.besideCount);
        }
        for (std::size_t i = 0; i < m_fades.size(); ++i)
            if (m_fades[i] != none)
                m_out.beside[i].fade = m_out.copies[m_fades[i]].lanes;
    }

  private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    struct Numbers {
        std::size_t copy = none, beside = 0, besideCount = 0;
    };

    void part(int cluster) {
        const int begin = cluster * lanes, count = std::min(lanes, m_block.size() - begin);
        Label label[lanes];
        for (int lane = 0; lane < count; ++lane)
            label[lane] = m_labels.at(m_block, begin + lane);
        const unsigned whole = (1u << count) - 1;
        for (unsigned left = whole; left != 0;) {
            const std::uint32_t cell = leastCell(label, left);
            const unsigned own = lanesWhere(left, [&](int lane) { return label[lane].cell == cell; });
            left &= ~own;
            Numbers numbers;
            if (own != whole)
                numbers.copy = copy(cluster, own);
            numbers.beside = m_out.beside.size();
            beside(cluster, label, own);
            numbers.besideCount = m_out.beside.size() - numbers.beside;
            m_out.parts.push_back({m_block.channel(cluster, surfel::X), cell, label[std::countr_zero(own)].face, {}});
            m_numbers.push_back(numbers);
        }
    }
    void beside(int cluster, const Label* label, unsigned own) {
        for (unsigned left = lanesWhere(own, [&](int l) { return label[l].meeting != Meeting::None; }); left != 0;) {
            const Label& one = label[std::countr_zero(left)];
            const auto all = lanesWhere(left, [&](int lane) { return label[lane].partner == one.partner; });
            left &= ~all;
            BesideCrease out;
            out.partner = one.partner;
            out.all = static_cast<std::uint16_t>(all);
            out.convex = lanesWhere(all, [&](int lane) { return label[lane].meeting == Meeting::Convex; });
            out.faded = lanesWhere(all, [&](int lane) { return label[lane].sharpness != 255; });
            const bool fades = std::binary_search(m_fading.begin(), m_fading.end(), pairOf(one));
            m_fades.push_back(fades ? fade(cluster, label, all) : none);
            m_out.beside.push_back(out);
        }
    }
    template <class Is>
    static std::uint16_t lanesWhere(unsigned among, const Is& is) {
        unsigned out = 0;
        for (unsigned left = among; left != 0; left &= left - 1)
            if (const int lane = std::countr_zero(left); is(lane))
                out |= 1u << lane;
        return static_cast<std::uint16_t>(out);
    }
    static std::uint32_t leastCell(const Label* label, unsigned among) {
        std::uint32_t out = std::numeric_limits<std::uint32_t>::max();
        for (; among != 0; among &= among - 1)
            out = std::min(out, label[std::countr_zero(among)].cell);
        return out;
    }
    /// A copy of a cluster with these surfels alone; its number.
    std::size_t copy(int cluster, unsigned own) {
        const std::size_t out = m_out.copies.size();
        m_out.copies.resize(out + m_channels);
        const float* from = m_block.channel(cluster, surfel::X);
        float* to = m_out.copies[out].lanes;
        std::copy_n(from, m_channels * lanes, to);
        for (int lane = 0; lane < lanes; ++lane)
            if ((own >> lane & 1u) == 0) {
                for (int a = 0; a < 3; ++a)
                    to[a * lanes + lane] = farAway;
                to[surfel::Support * lanes + lane] = 1;
            }
        return out;
    }
    std::size_t fade(int cluster, const Label* label, unsigned own) {
        const std::size_t out = copy(cluster, own);
        float* normals = m_out.copies[out].lanes + surfel::NormalX * lanes;
        for (int lane = 0; lane < lanes; ++lane) {
            normals[lane] = static_cast<float>(label[lane].sharpness) / 255;
            normals[lane + lanes] = normals[lane + 2 * lanes] = 0;
        }
        return out;
    }

    const SurfelBlock& m_block;
    const LabelLayout& m_labels;
    std::size_t m_channels;
    const std::vector<Pair>& m_fading;
    Block& m_out;
    std::vector<Numbers> m_numbers;
    std::vector<std::size_t> m_fades;
};

CellParts::CellParts(const tree::SurfelTree& tree, const LabelLayout& labels) : m_blocks(tree.blockCount()) {
    const int shape = surfel::shapeChannel(*tree.layout());
    const auto channels = static_cast<std::size_t>(shape > 0 ? shape + 3 : surfel::Support + 1);
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    const std::vector<Pair> fading = fadingPairs(tree, labels);
    m_fade = !fading.empty();
    base::parallelFor(blocks.size(), grain,
                      [&](std::size_t b) { Filling(*blocks[b], labels, channels, fading, m_blocks[b]).run(); });
    if (m_fade)
        findFadingToOthers(fading);
}

void CellParts::findFadingToOthers(const std::vector<Pair>& fading) {
    std::unordered_map<std::uint32_t, std::uint32_t> faces;
    for (const Block& block : m_blocks)
        for (const CellPart& part : block.parts)
            faces.try_emplace(part.cell, part.face);
    for (const auto& [a, b] : fading)
        if (faces[a] != faces[b])
            m_fadingToOthers.insert(m_fadingToOthers.end(), {a, b});
    std::sort(m_fadingToOthers.begin(), m_fadingToOthers.end());
}

/// Pairs of cells whose crease is not quite sharp somewhere; ascending.
std::vector<CellParts::Pair> CellParts::fadingPairs(const tree::SurfelTree& tree, const LabelLayout& labels) const {
    if (!labels.hasSharpness())
        return {};
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    std::vector<std::vector<Pair>> found(base::chunkCount(blocks.size(), grain));
    base::parallelChunks(blocks.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t b = begin; b < end; ++b)
            for (int slot = 0; slot < blocks[b]->size(); ++slot)
                if (const Label label = labels.at(*blocks[b], slot);
                    label.meeting != Meeting::None && label.sharpness != 255)
                    found[chunk].push_back(pairOf(label));
    });
    std::vector<Pair> out;
    for (const std::vector<Pair>& each : found)
        out.insert(out.end(), each.begin(), each.end());
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

} // namespace cells
