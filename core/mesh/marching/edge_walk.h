// Where an edge of the grid crosses the surface: once, or not at all (RULES-4 B2). Internal to the room.
//
// Between two samples f has no root where both values are far larger than the distance, and as many as their signs say
// where values, slopes and normals at both ends tell of one smooth sheet. Elsewhere the edge is walked in steps of a
// quarter of a spacing, with the sign of the frame carried along; where unoriented frames turn, in shorter ones. Roots
// count where the ray caster's do (surface::isSurface). An odd number of them is a crossing, the one with the least
// off-centre value, an even number is none.
#pragma once

#include "core/surface/evaluation/source.h"
#include "core/surface/rays/intersect.h"

#include <optional>

namespace mesh {

/// What all edges of a surface have in common.
struct WalkSetting {
    explicit WalkSetting(const surface::Surface& surface);

    bool oriented;          ///< do the surfels' normals give f a sign?
    bool distances;         ///< |f| is like a distance (cov is none off the surface, alg. 3.2.3)
    double spacingsPerUnit; ///< s / h
};

/// What evaluations at nodes and on edges are kept for.
struct NodeValue {
    float f = 0;
    base::Vec3f normal;
    float unit = 0; ///< h; 0 where the frame is not valid
    float agreement = 0;

    bool usable() const { return unit > 0; }
    static NodeValue of(const surface::Evaluationf& at);
};

struct Crossing {
    base::Vec3d position;
    base::Vec3f normal;  ///< unit gradient; without orientation of either sign
    float unit = 0;      ///< h there
    float offCentre = 0; ///< in units of h
};

/// Edges are walked on trust where it is due; `Thorough` ones in short steps all along.
enum class Care { Usual, Thorough };

struct Edge {
    base::Vec3d from, direction; ///< unit
    double length = 0;
};

class EdgeWalk {
  public:
    EdgeWalk(const WalkSetting& setting, surface::Source& source, const Edge& edge, Care care)
        : m_setting(setting), m_source(source), m_edge(edge), m_care(care) {}

    /// With the values at its ends.
    std::optional<Crossing> run(const NodeValue& first, const NodeValue& last);
    /// Do the values at the ends tell, without looking further, that it does not cross?
    static bool passes(const WalkSetting& setting, const Edge& edge, const NodeValue& first, const NodeValue& last);

  private:
    struct Sample {
        double t = 0;
        NodeValue at;
    };
    Sample sample(double t);
    void between(const Sample& a, const Sample& b, int halvings);
    double sign(const Sample& a, const Sample& b) const;
    void refine(Sample a, Sample b);
    bool jumps(const Sample& a, const Sample& b) const;
    bool onOwnSheet(double t, const surface::Evaluationf& at);
    void accept(double t, const surface::Evaluationf& at);

    const WalkSetting& m_setting;
    surface::Source& m_source;
    const Edge m_edge;
    Care m_care;
    int m_roots = 0;
    Crossing m_best;
};

} // namespace mesh
