#include "core/mesh/faces/face_paint.h"

#include <array>
#include <cmath>

namespace mesh {

std::optional<surfel::Colour> FacePaint::at(std::size_t t, const std::array<float, 3>& weights) const {
    const std::uint32_t face = m_cut.faces[t];
    const Polygons& p = m_polygons;
    const std::uint32_t number = face < p.pictureOf.size() ? p.pictureOf[face] : Polygons::noPicture;
    if (number < p.pictures.size() && p.pictures[number] && !p.places.empty()) {
        double u = 0, v = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Polygons::Place& place = p.places[m_cut.corners[t][k]];
            u += static_cast<double>(weights[k]) * static_cast<double>(place.u);
            v += static_cast<double>(weights[k]) * static_cast<double>(place.v);
        }
        if (std::isfinite(u) && std::isfinite(v))
            return p.pictures[number]->at(u, v);
    }
    return face < p.colours.size() ? std::optional(p.colours[face]) : std::nullopt;
}

std::optional<surfel::Colour> FacePaint::at(std::size_t t, const Triangle& corners,
                                            const std::array<float, 3>& w) const {
    return corners[1] == m_cut.triangles[t][1] ? at(t, w) : at(t, {w[0], w[2], w[1]});
}

void FacePaint::paint(std::span<surfel::Surfel> vertices) const {
    struct Sum {
        std::array<std::uint64_t, 4> channels{};
        std::uint64_t count = 0;
    };
    std::vector<Sum> sums(vertices.size());
    for (std::size_t t = 0; t < m_cut.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (const auto colour = at(t, {k == 0 ? 1.0f : 0, k == 1 ? 1.0f : 0, k == 2 ? 1.0f : 0})) {
                Sum& sum = sums[m_cut.triangles[t][k]];
                for (unsigned c = 0; c < 4; ++c)
                    sum.channels[c] += *colour >> (8 * c) & 255u;
                ++sum.count;
            }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (sums[i].count == 0)
            continue;
        vertices[i].colour = 0;
        for (unsigned c = 0; c < 4; ++c) {
            const std::uint64_t mean = (sums[i].channels[c] + sums[i].count / 2) / sums[i].count;
            vertices[i].colour |= static_cast<surfel::Colour>(mean) << (8 * c);
        }
    }
}

} // namespace mesh
