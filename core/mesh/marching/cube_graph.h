// Vertices and segments on the faces of one cube, and the loops that they make. Internal to the room.
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

namespace mesh {

struct LoopVertex {
    std::uint32_t vertex = 0;
    std::uint8_t faces = 0; ///< a bit for each face of the cube that it lies on
};
using Loop = std::vector<LoopVertex>;

/// `most`: vertices.
template <int most>
class CubeGraphOf {
  public:
    /// Joins two vertices in a face, 0 to 5. REQUIRES: no vertex gets more than two segments.
    void segment(std::uint32_t a, std::uint32_t b, int face) {
        const int i = index(a, face), j = index(b, face);
        link(i, j);
        link(j, i);
    }

    /// Chains, whose ends are to be joined, before closed loops.
    void loops(std::vector<Loop>& out) {
        for (int pass = 0; pass < 2; ++pass)
            for (int i = 0; i < m_count; ++i) {
                if (m_done[i] || (pass == 0 && m_next[i][1] >= 0))
                    continue;
                Loop& loop = out.emplace_back();
                for (int at = i, from = -1; at >= 0 && !m_done[at];) {
                    m_done[at] = true;
                    loop.push_back(m_vertices[at]);
                    const int next = m_next[at][0] != from ? m_next[at][0] : m_next[at][1];
                    from = at;
                    at = next;
                }
            }
    }

  private:
    int index(std::uint32_t vertex, int face) {
        int i = 0;
        while (i < m_count && m_vertices[i].vertex != vertex)
            ++i;
        if (i == m_count) {
            assert(m_count < most);
            m_next[m_count][0] = m_next[m_count][1] = -1;
            m_done[m_count] = false;
            m_vertices[m_count++] = {vertex, 0};
        }
        m_vertices[i].faces |= static_cast<std::uint8_t>(1 << face);
        return i;
    }
    void link(int from, int to) {
        assert(m_next[from][1] < 0);
        m_next[from][m_next[from][0] < 0 ? 0 : 1] = to;
    }

    int m_count = 0;
    LoopVertex m_vertices[most];
    int m_next[most][2];
    bool m_done[most];
};

/// 12 crossings, each loose in both faces; in large cubes one on each of 48 small edges.
using CubeGraph = CubeGraphOf<64>;
/// One on each of 48 small edges, each loose in both faces.
using LargeCubeGraph = CubeGraphOf<144>;

} // namespace mesh
