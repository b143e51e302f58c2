#include "core/mesh/faces/border_rows.h"

#include "core/base/cancel_scope.h"
#include "core/mesh/faces/edge_chains.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr double shortestLoop = 8;     ///< spacings
constexpr double cornerCosine = 0.766; ///< 40 degrees: borders that turn by more have a corner
constexpr double step = 0.5;           ///< of a spacing: lengths are measured in that

/// The border edges at a place.
struct Meeting {
    std::uint32_t edges[2] = {};
    int count = 0; ///< of edges; more than two are a corner, too
    bool hasPoint = false;
};

class BorderRows {
  public:
    BorderRows(const FaceTopology& topology, std::span<const Vec3f> positions, const SpacingOnFaces& spacing)
        : m_topology(topology), m_positions(positions), m_spacing(spacing), m_used(topology.borderEdges.size()) {
        for (std::uint32_t e = 0; e < edges().size(); ++e)
            for (const std::uint32_t end : edges()[e].ends) {
                Meeting& meeting = m_meetings[end];
                if (meeting.count < 2)
                    meeting.edges[meeting.count] = e;
                ++meeting.count;
            }
        const std::vector<std::uint32_t> loops = chainsOf(edges());
        m_lengths.reserve(edges().size());
        std::vector<double> whole(edges().size());
        for (std::uint32_t e = 0; e < edges().size(); ++e) {
            m_lengths.push_back(measured(edges()[e]));
            whole[loops[e]] += m_lengths.back().back();
        }
        for (std::uint32_t e = 0; e < edges().size(); ++e)
            m_used[e] = whole[loops[e]] < shortestLoop ? 1 : 0;
    }

    std::vector<FacePoint> run() {
        for (std::uint32_t e = 0; e < edges().size(); ++e) // from corners first, then what has none
            for (int end = 0; end < 2; ++end)
                if (m_used[e] == 0 && isCorner(edges()[e].ends[end]))
                    follow(e, end);
        for (std::uint32_t e = 0; e < edges().size(); ++e)
            if (m_used[e] == 0)
                follow(e, 0);
        return std::move(m_out);
    }

  private:
    /// An edge of a way, and the end at which it comes to it.
    struct Part {
        std::uint32_t edge;
        int from;
    };

    const std::vector<BorderEdge>& edges() const { return m_topology.borderEdges; }

    /// Spacings up to the end of each of its equal steps.
    std::vector<double> measured(const BorderEdge& edge) const {
        base::CancelScope::check();
        const double length = distance(edge.from, edge.to);
        const auto at = [&](double t) { return m_spacing(edge.from + (edge.to - edge.from) * t, edge.corner / 3); };
        const double least = std::min({at(0), at(0.5), at(1)});
        const auto count = static_cast<std::size_t>(std::clamp(std::ceil(length / (step * least)), 1.0, 1e6));
        std::vector<double> out;
        double sum = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const double t = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
            out.push_back(sum += length / static_cast<double>(count) / at(t));
        }
        return out;
    }

    /// From the place where it comes to the edge on.
    static Vec3d way(const BorderEdge& edge, int from) {
        const Vec3d along = edge.to - edge.from;
        return from == 0 ? along : -along;
    }

    bool isCorner(std::uint32_t place) const {
        const Meeting& meeting = m_meetings.at(place);
        if (meeting.count != 2 || meeting.edges[0] == meeting.edges[1])
            return true;
        Vec3d out[2];
        for (int k = 0; k < 2; ++k) {
            const BorderEdge& edge = edges()[meeting.edges[k]];
            out[k] = way(edge, edge.ends[0] == place ? 0 : 1);
        }
        return -dot(out[0], out[1]) < cornerCosine * length(out[0]) * length(out[1]);
    }

    /// The way that begins with an edge, to its next corner or back to where it began.
    void follow(std::uint32_t edge, int from) {
        std::vector<Part> parts;
        const std::uint32_t first = edges()[edge].ends[from];
        double length = 0;
        std::uint32_t place = first;
        do {
            parts.push_back({edge, from});
            m_used[edge] = 1;
            length += m_lengths[edge].back();
            place = edges()[edge].ends[1 - from];
            if (isCorner(place))
                break;
            const Meeting& meeting = m_meetings.at(place);
            edge = meeting.edges[meeting.edges[0] == edge ? 1 : 0];
            from = edges()[edge].ends[0] == place ? 0 : 1;
        } while (m_used[edge] == 0);
        const double count = std::round(length);
        if (isCorner(first))
            putCorner(first, parts.front(), 0);
        if (isCorner(place))
            putCorner(place, parts.back(), 1);
        const bool corners = isCorner(first);
        double wanted = corners ? 1 : 0, before = 0;
        for (const Part& part : parts) {
            const double own = m_lengths[part.edge].back();
            for (; wanted < count && wanted * length / count <= before + own; ++wanted)
                put(part, wanted * length / count - before);
            before += own;
        }
    }

    void putCorner(std::uint32_t place, const Part& part, double end) {
        Meeting& meeting = m_meetings.at(place);
        if (std::exchange(meeting.hasPoint, true))
            return;
        put(part, end * m_lengths[part.edge].back());
    }

    /// So many spacings along an edge.
    void put(const Part& part, double along) {
        const BorderEdge& edge = edges()[part.edge];
        const std::vector<double>& lengths = m_lengths[part.edge];
        const double here = std::clamp(part.from == 0 ? along : lengths.back() - along, 0.0, lengths.back());
        const auto k = std::min<std::size_t>(
            lengths.size() - 1,
            static_cast<std::size_t>(std::lower_bound(lengths.begin(), lengths.end(), here) - lengths.begin()));
        const double begin = k > 0 ? lengths[k - 1] : 0, size = lengths[k] - begin;
        const double t =
            (static_cast<double>(k) + (size > 0 ? (here - begin) / size : 0)) / static_cast<double>(lengths.size());
        m_out.push_back(onSide(edge.corner, edge.from + (edge.to - edge.from) * t));
    }

    /// The border edge may be a part of a side.
    FacePoint onSide(std::uint32_t corner, const Vec3d& place) const {
        const std::uint32_t triangle = corner / 3, k = corner % 3;
        const Triangle& t = m_topology.triangles[triangle];
        const Vec3d from = base::cast<double>(m_positions[t[k]]);
        const Vec3d side = base::cast<double>(m_positions[t[(k + 1) % 3]]) - from;
        const double at = std::clamp(dot(place - from, side) / std::max(lengthSq(side), 1e-300), 0.0, 1.0);
        float weights[3] = {};
        weights[(k + 1) % 3] = static_cast<float>(at);
        weights[k] = 1 - weights[(k + 1) % 3];
        return {triangle, weights[1], weights[2]};
    }

    const FaceTopology& m_topology;
    std::span<const Vec3f> m_positions;
    const SpacingOnFaces& m_spacing;
    std::unordered_map<std::uint32_t, Meeting> m_meetings; ///< by place
    std::vector<std::vector<double>> m_lengths;            ///< of each edge: spacings up to the end of each step
    std::vector<std::uint8_t> m_used;
    std::vector<FacePoint> m_out;
};

} // namespace

std::vector<FacePoint> borderRows(const FaceTopology& topology, std::span<const Vec3f> positions,
                                  const SpacingOnFaces& spacing) {
    return BorderRows(topology, positions, spacing).run();
}

} // namespace mesh
