#include "core/mesh/finish/mesh_attributes.h"

#include "core/base/parallel.h"
#include "core/surface/evaluation/attribute_sum.h"
#include "core/surface/evaluation/weights.h"

namespace mesh {

using base::Vec3f;

namespace {

/// What faces as the normal does; where nothing does, what faces away; where nothing has weight, the nearest.
class Blender {
  public:
    explicit Blender(const surface::Surface& surface)
        : m_surface(surface), m_layout(*surface.tree().layout()), m_oriented(m_layout.normals && m_layout.oriented) {}

    surface::AttributeSum at(const Vec3f& x, const Vec3f& normal) const {
        surface::AttributeSum facing(m_layout), others(m_layout);
        const bool any = !m_oriented || !(lengthSq(normal) > 0);
        surface::forWeights(m_surface, x, [&](const surfel::SurfelBlock& block, int slot, float theta) {
            (any || dot(block.normal(slot), normal) > 0 ? facing : others).add(block, slot, theta);
        });
        if (!facing.any() && !others.any())
            addNearest(x, others);
        return facing.any() ? facing : others;
    }

  private:
    void addNearest(const Vec3f& x, surface::AttributeSum& sum) const {
        std::vector<tree::Neighbour> found;
        m_surface.tree().nearest(x, 1, found);
        sum.add(*found[0].block, found[0].slot, 1);
    }

    const surface::Surface& m_surface;
    const surfel::AttributeLayout& m_layout;
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
        const surface::AttributeSum sum = blender.at(base::cast<float>(mesh.positions[v]), mesh.normals[v]);
        if (layout.colours)
            mesh.colours[v] = sum.colour();
        if (layout.masks)
            mesh.masks[v] = sum.mask();
        sum.further({mesh.extra.data() + v * layout.words(), layout.words()});
    });
}

} // namespace mesh
