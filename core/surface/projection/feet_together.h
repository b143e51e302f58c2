// Orthogonal projections of many positions, 16 in lanes (foot_lanes.h), as far as they are of the common kind: oriented
// normals, one sheet, a surface that hardly bends over the distance. All others are handed on from where they are.
//
//     FeetTogether feet(surface, options, x);
//     feet.add(source, i);    source: prepared for x[i], until `run`
//     feet.run(tell);         when it is full, and at the end
//
// What becomes of a position depends on nothing but itself and the surface. One thread at a time. Belongs on the stack:
// its memory is only touched as far as it is used.
#pragma once

#include "core/surface/evaluation/source.h"
#include "core/surface/projection/foot_lanes.h"
#include "core/surface/projection/project.h"

namespace surface {

/// How far around a position surfels are looked for, of h. Farther would make every sum longer; a foot that lies
/// farther is looked around once more.
constexpr float packetSlack = 0.12f;

/// What became of x[index].
struct LaneFoot {
    enum class End {
        Found,  ///< `soFar` is a foot
        Resume, ///< some steps have led to where `soFar` is
        Anew,   ///< to be projected in another way
    };
    std::size_t index;
    Source& source;
    End end;
    Projection<float> soFar;
};

class FeetTogether {
  public:
    FeetTogether(const Surface& surface, const ProjectOptions& options, std::span<const base::Vec3f> x);

    /// Is this a way for these projections at all?
    bool applies() const { return m_applies; }
    bool empty() const { return m_count == 0; }
    bool full() const { return m_count == lanes; }
    /// REQUIRES: applies(), not full().
    void add(Source& source, std::size_t index);
    /// Projects those added and calls tell(LaneFoot) for each.
    template <class Fn>
    void run(const Fn& tell) {
        project();
        for (std::size_t lane = 0; lane < m_count; ++lane)
            tell(LaneFoot{m_index[lane], *m_source[lane], m_end[lane], soFar(lane)});
        m_count = 0;
    }

  private:
    static constexpr std::size_t lanes = FootLanes::lanes;
    void project();
    void pickStrayed();
    bool pick(std::size_t lane, float slack);
    void take(std::size_t lane, int steps);
    void end(std::size_t lane, LaneFoot::End end, int steps);
    Projection<float> soFar(std::size_t lane) const;

    const ProjectOptions& m_options;
    std::span<const base::Vec3f> m_x;
    SummedNormals m_plain;
    bool m_applies;
    FootOptions m_foot;

    std::size_t m_count = 0, m_index[lanes];
    Source* m_source[lanes];
    unsigned m_active = 0; ///< bits of those that have not ended
    LaneFoot::End m_end[lanes];
    int m_steps[lanes];
    float m_centre[3][lanes], m_slack[lanes]; ///< where surfels were picked, and how far around it they are all
    NearLanes m_near;
    FootLanes m_lanes;
};

} // namespace surface
