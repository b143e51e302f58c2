#include "core/mesh/surface_parts.h"

#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/base/ranked.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace mesh {

using base::Vec3f;

namespace {

constexpr float unevenFrom = 1.5f;        ///< largest over least support: below that one size does for all
constexpr std::size_t fewestOfPart = 100; ///< surfels

/// Surfels by number, in the order of the tree.
class Reaching {
  public:
    explicit Reaching(const tree::SurfelTree& tree) : m_tree(tree) {
        tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            m_blocks.push_back(tree.block(number));
            m_first.emplace(&block, m_count);
            m_count += static_cast<std::uint32_t>(block.size());
        });
    }

    /// Of each surfel the set that it is in, by its first member.
    std::vector<std::uint32_t> sets(const base::Progress& progress) const {
        base::DisjointSets sets(m_count);
        std::vector<std::uint32_t> roots(m_count);
        for (int round = 0;; ++round) {
            progress.step(1 - std::pow(0.5, round), "looking for parts");
            for (std::uint32_t i = 0; i < m_count; ++i)
                roots[i] = sets.find(i);
            bool any = false;
            for (const Link& link : linksBetween(roots, round == 0))
                any = sets.join(link.first, link.second) || any;
            if (!any)
                return roots;
        }
    }

  private:
    using Link = std::pair<std::uint32_t, std::uint32_t>;

    /// `one`: for each surfel the first that reaches it is enough.
    std::vector<Link> linksBetween(const std::vector<std::uint32_t>& roots, bool one) const {
        constexpr std::size_t grain = 16;
        std::vector<std::vector<Link>> parts(base::chunkCount(m_blocks.size(), grain));
        base::parallelChunks(m_blocks.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            std::vector<Link>& out = parts[chunk];
            for (std::size_t b = begin; b < end; ++b) {
                const std::uint32_t first = m_first.at(m_blocks[b].get());
                for (int slot = 0; slot < m_blocks[b]->size(); ++slot)
                    addLinks(m_blocks[b]->position(slot), first + static_cast<std::uint32_t>(slot), roots, one, out);
                std::sort(out.begin(), out.end());
                out.erase(std::unique(out.begin(), out.end()), out.end());
            }
        });
        std::vector<Link> out;
        for (const std::vector<Link>& part : parts)
            out.insert(out.end(), part.begin(), part.end());
        return out;
    }

    void addLinks(const Vec3f& x, std::uint32_t self, const std::vector<std::uint32_t>& roots, bool one,
                  std::vector<Link>& out) const {
        constexpr int lanes = surfel::clusterSize;
        std::uint32_t least = self;
        m_tree.forClustersInSupport(x, [&](const surfel::SurfelBlock& block, int cluster) {
            const float *px = block.channel(cluster, surfel::X), *py = block.channel(cluster, surfel::Y),
                        *pz = block.channel(cluster, surfel::Z), *h = block.channel(cluster, surfel::Support);
            const std::uint32_t first = m_first.at(&block) + static_cast<std::uint32_t>(cluster * lanes);
            for (int k = 0; k < std::min(lanes, block.size() - cluster * lanes); ++k) {
                if (!(lengthSq(Vec3f{px[k], py[k], pz[k]} - x) < h[k] * h[k]))
                    continue;
                const std::uint32_t other = first + static_cast<std::uint32_t>(k);
                least = std::min(least, other);
                if (!one && roots[other] != roots[self])
                    out.push_back(std::minmax(roots[other], roots[self]));
            }
        });
        if (one && least != self)
            out.emplace_back(least, self);
    }

    const tree::SurfelTree& m_tree;
    std::vector<surfel::BlockPtr> m_blocks;
    std::unordered_map<const surfel::SurfelBlock*, std::uint32_t> m_first;
    std::uint32_t m_count = 0;
};

bool uneven(const tree::SurfelTree& tree) {
    float least = std::numeric_limits<float>::infinity(), most = 0;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            least = std::min(least, block.support(slot));
            most = std::max(most, block.support(slot));
        }
    });
    return most > unevenFrom * least;
}

/// Of each surfel the number of its part; how many there are.
std::uint32_t numberParts(const surfel::SurfelList& surfels, std::vector<std::uint32_t>& sets) {
    std::map<std::uint32_t, std::vector<float>> supports;
    for (std::uint32_t i = 0; i < sets.size(); ++i)
        supports[sets[i]].push_back(surfels.items[i].support);
    struct Set {
        float support;
        std::uint32_t root;
        std::size_t size;
    };
    std::vector<Set> large;
    for (auto& [root, all] : supports) {
        if (all.size() >= fewestOfPart)
            large.push_back({base::median(all), root, all.size()});
    }
    if (large.empty())
        return 1;
    std::sort(large.begin(), large.end(), [](const Set& a, const Set& b) {
        return a.support != b.support ? a.support < b.support : a.root < b.root;
    });
    std::map<std::uint32_t, std::uint32_t> numbers; // of sets
    std::vector<std::size_t> sizes;
    float least = 0;
    for (const Set& set : large) {
        if (sizes.empty() || set.support > unevenFrom * least) {
            sizes.push_back(0);
            least = set.support;
        }
        numbers[set.root] = static_cast<std::uint32_t>(sizes.size() - 1);
        sizes.back() += set.size;
    }
    const auto largest = static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    for (std::uint32_t& set : sets)
        if (const auto found = numbers.find(set); found != numbers.end())
            set = found->second;
        else
            set = largest;
    return static_cast<std::uint32_t>(sizes.size());
}

} // namespace

std::vector<surface::Surface> partsOf(const surface::Surface& surface, const base::Progress& progress) {
    if (!uneven(surface.tree()))
        return {surface};
    const surfel::SurfelList surfels = surface.tree().surfels();
    std::vector<std::uint32_t> numbers = Reaching(surface.tree()).sets(progress);
    const std::uint32_t count = numberParts(surfels, numbers);
    if (count < 2)
        return {surface};
    std::vector<surfel::SurfelList> lists(count);
    for (surfel::SurfelList& list : lists)
        list.layout = surfels.layout;
    for (std::size_t i = 0; i < surfels.size(); ++i)
        lists[numbers[i]].append(surfels.items[i], surfels.extraOf(i));
    std::vector<surface::Surface> out;
    for (const surfel::SurfelList& list : lists) {
        progress.step(1, "looking for parts");
        out.emplace_back(tree::SurfelTree::build(list, {{}, progress.cancel}), surface.definition());
    }
    return out;
}

void append(Mesh& mesh, const Mesh& more) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(mesh.positions, more.positions);
    add(mesh.normals, more.normals);
    add(mesh.colours, more.colours);
    add(mesh.masks, more.masks);
    add(mesh.extra, more.extra);
    add(mesh.kinds, more.kinds);
    mesh.layout = more.layout;
    for (const Triangle& t : more.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

} // namespace mesh
