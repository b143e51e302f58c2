#include "core/process/cleaning/eye_view.h"

#include <numeric>

namespace process {

using base::Vec3d;

std::vector<surfel::Surfel> EyeView::look(const surfel::SurfelList& points, const Vec3d& eye) {
    const auto wayTo = [&](std::uint32_t i) { return base::cast<double>(points.items[i].position) - eye; };
    std::erase_if(m_numbers, [&](std::uint32_t i) { return !(length(wayTo(i)) > 0); });
    std::vector<surfel::Surfel> out(m_numbers.size());
    m_ways.resize(m_numbers.size());
    for (std::size_t k = 0; k < out.size(); ++k) {
        m_ways[k] = wayTo(m_numbers[k]);
        out[k].position = base::cast<float>(m_ways[k] / length(m_ways[k]));
    }
    return out;
}

EyeView::EyeView(const surfel::SurfelList& points, std::vector<std::uint32_t> numbers, const Vec3d& eye,
                 const base::Progress& progress)
    : m_numbers(std::move(numbers)), m_directions(look(points, eye), progress), m_begin(m_directions.size() + 1),
      m_seen(m_numbers.size()) {
    const PointPlaces places = m_directions.places();
    for (std::size_t k = 0; k < m_seen.size(); ++k)
        ++m_begin[places[k] + 1];
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    std::vector<std::uint32_t> at(m_begin.begin(), m_begin.end() - 1);
    for (std::uint32_t k = 0; k < m_seen.size(); ++k)
        m_seen[at[places[k]]++] = k;
}

void EyeView::sights(std::uint32_t seen, const Neighbours& near, std::vector<Sight>& out) const {
    const double range = length(m_ways[seen]);
    const Vec3d d = m_ways[seen] / range;
    const Vec3d u = base::normalized(cross(d, std::abs(d.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0})), v = cross(d, u);
    out.clear();
    for (const std::uint32_t j : near.index) {
        const Vec3d& q = m_ways[m_seen[m_begin[j]]];
        if (const double depth = dot(q, d); depth > 0)
            out.push_back({dot(q, u) / depth, dot(q, v) / depth, range / depth});
    }
}

} // namespace process
