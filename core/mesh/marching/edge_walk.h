// Decides whether an edge of the grid crosses the surface: once, or not at all (mesh/README 3.2). Internal to the room.
//
// Between two samples f has no root if both values are far larger than the distance; if values, slopes and normals at
// both ends describe one smooth sheet, their signs decide. Other edges are walked in steps of a quarter of a spacing,
// shorter where unoriented frames turn, carrying the sign of the frame along. Roots count as they do for rays
// (surface::isSurface). With an odd number of them the edge crosses, at the root with the least off-centre value; with
// an even number it does not.
#pragma once

#include "core/mesh/surface_traits.h"
#include "core/surface/evaluation/source.h"
#include "core/surface/rays/intersect.h"

#include <optional>

namespace mesh {

/// The part of an evaluation that nodes and edges keep.
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
    base::Vec3f normal;  ///< unit gradient; of either sign without orientation
    float unit = 0;      ///< h there
    float offCentre = 0; ///< in units of h
    bool bridge = false; ///< no root of f: a closed surface goes on there as its winding number says
    bool sided = false;  ///< between an inside and an outside
};

/// Usual: trust ends that describe one smooth sheet. Thorough: short steps all along.
enum class Care { Usual, Thorough };

struct Edge {
    base::Vec3d from, direction; ///< unit
    double length = 0;
};

class EdgeWalk {
  public:
    EdgeWalk(const SurfaceTraits& traits, surface::Source& source, const Edge& edge, Care care)
        : m_traits(traits), m_source(source), m_edge(edge), m_care(care) {}

    /// Given the values at its ends.
    std::optional<Crossing> run(const NodeValue& first, const NodeValue& last);
    /// The best root where the surface faces along the edge (`way` 1) or against it (-1), however many there are.
    std::optional<Crossing> facing(int way, const NodeValue& first, const NodeValue& last);
    /// Do the values at the ends alone prove that it does not cross?
    static bool passes(const SurfaceTraits& traits, const Edge& edge, const NodeValue& first, const NodeValue& last);

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

    const SurfaceTraits& m_traits;
    surface::Source& m_source;
    const Edge m_edge;
    Care m_care;
    int m_way = 0; ///< 0: roots count whichever way the surface faces
    int m_roots = 0;
    Crossing m_best;
};

} // namespace mesh
