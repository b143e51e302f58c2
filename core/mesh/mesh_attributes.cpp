#include "core/mesh/mesh_attributes.h"

#include "core/base/parallel.h"

namespace mesh {

using base::Vec3f;

namespace {

struct Blend {
    float weight = 0;
    float channels[4] = {};
    float mask = 0;
    const surfel::AttributeLayout* layout = nullptr; ///< of the further attributes
    std::vector<double> numbers;                     ///< sums of each
    std::vector<std::uint32_t> words, heaviest;      ///< of the surfel being added; of the one that weighs most
    float most = 0;

    explicit Blend(const surfel::AttributeLayout& attributes)
        : layout(&attributes), numbers(attributes.attributes().size(), 0), words(attributes.words(), 0),
          heaviest(words) {}

    void add(const surfel::SurfelBlock& block, int slot, float theta) {
        const int cluster = slot / surfel::clusterSize, lane = slot % surfel::clusterSize;
        const surfel::Colour colour = block.words(cluster, surfel::ColourWord)[lane];
        weight += theta;
        for (int c = 0; c < 4; ++c)
            channels[c] += theta * static_cast<float>(colour >> (8 * c) & 255u);
        mask += theta * block.mask(slot);
        if (!words.empty())
            addFurther(block, slot, theta);
    }
    void addFurther(const surfel::SurfelBlock& block, int slot, float theta) {
        block.extra(slot, words);
        for (std::size_t a = 0; a < numbers.size(); ++a)
            numbers[a] += static_cast<double>(theta) * read(layout->attributes()[a], words);
        if (theta > most) {
            most = theta;
            heaviest = words;
        }
    }
    void further(std::span<std::uint32_t> out) const {
        std::copy(heaviest.begin(), heaviest.end(), out.begin());
        for (std::size_t a = 0; a < numbers.size(); ++a)
            if (isReal(layout->attributes()[a].type))
                write(layout->attributes()[a], out, numbers[a] / static_cast<double>(weight));
    }
    surfel::Colour colour() const {
        unsigned bytes[4];
        for (int c = 0; c < 4; ++c)
            bytes[c] = static_cast<unsigned>(std::lround(channels[c] / weight));
        return surfel::rgba(bytes[0], bytes[1], bytes[2], bytes[3]);
    }
};

class Blender {
  public:
    explicit Blender(const surface::Surface& surface)
        : m_tree(surface.tree()), m_oriented(m_tree.layout()->normals && m_tree.layout()->oriented) {}

    Blend at(const Vec3f& x, const Vec3f& normal) const {
        Blend out(*m_tree.layout());
        sum(x, m_oriented ? normal : Vec3f{}, out);
        if (!(out.weight > 0)) // all face away: rather those than none
            sum(x, {}, out);
        if (!(out.weight > 0))
            nearest(x, out);
        return out;
    }

  private:
    /// `towards` zero: whichever way they face.
    void sum(const Vec3f& x, const Vec3f& towards, Blend& out) const {
        const bool any = !(lengthSq(towards) > 0);
        m_tree.forClustersInSupport(x, [&](const surfel::SurfelBlock& block, int cluster) {
            const int first = cluster * surfel::clusterSize;
            const int last = std::min(first + surfel::clusterSize, block.size());
            for (int slot = first; slot < last; ++slot) {
                const float r = distance(block.position(slot), x) / block.support(slot), rest = 1 - r;
                if (rest > 0 && (any || dot(block.normal(slot), towards) > 0))
                    out.add(block, slot, rest * rest * rest * rest * (4 * r + 1));
            }
        });
    }
    void nearest(const Vec3f& x, Blend& out) const {
        std::vector<tree::Neighbour> found;
        m_tree.nearest(x, 1, found);
        out.add(*found[0].block, found[0].slot, 1);
    }

    const tree::SurfelTree& m_tree;
    bool m_oriented;
};

} // namespace

void takeAttributes(Mesh& mesh, const surface::Surface& surface) {
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    mesh.colours.assign(layout.colours ? mesh.positions.size() : 0, surfel::white);
    mesh.masks.assign(layout.masks ? mesh.positions.size() : 0, 0);
    mesh.layout = surface.tree().layout();
    mesh.extra.assign(layout.words() * mesh.positions.size(), 0);
    if (!layout.colours && !layout.masks && mesh.extra.empty())
        return;
    const Blender blender(surface);
    base::parallelFor(mesh.positions.size(), 1024, [&](std::size_t v) {
        const Blend blend = blender.at(base::cast<float>(mesh.positions[v]), mesh.normals[v]);
        if (layout.colours)
            mesh.colours[v] = blend.colour();
        if (layout.masks)
            mesh.masks[v] = blend.mask / blend.weight;
        blend.further({mesh.extra.data() + v * layout.words(), layout.words()});
    });
}

} // namespace mesh
