// The triangulation that CGAL's surface mesher refines, and what it asks of our surface. Internal to restricted.cpp: no
// other file shall wait for these headers.
#pragma once

#include "core/base/vec.h"
#include "core/surface/segments.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_with_circumcenter_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/make_surface_mesh.h>
#include <CGAL/Robust_circumcenter_traits_3.h>
#include <CGAL/Surface_mesh_cell_base_3.h>
#include <CGAL/Surface_mesh_complex_2_in_triangulation_3.h>
#include <CGAL/Surface_mesh_vertex_base_3.h>

namespace mesh::restricted {

using base::Vec3d;

/// Handles compare by these numbers where they would by address otherwise: the same bits in every run.
class Stamped {
  public:
    using Has_timestamp = CGAL::Tag_true;
    std::size_t time_stamp() const { return m_stamp; }
    void set_time_stamp(const std::size_t& stamp) { m_stamp = stamp; }

  private:
    std::size_t m_stamp = std::size_t(-1);
};

template <class Traits, class Base = CGAL::Surface_mesh_vertex_base_3<Traits>>
class RimVertex : public Base, public Stamped {
  public:
    template <class Tds>
    struct Rebind_TDS {
        using Other = RimVertex<Traits, typename Base::template Rebind_TDS<Tds>::Other>;
    };
    using Base::Base;
    int rim = -1; ///< its node, of vertices on rims
    bool enclosing = false;
};

template <class Traits, class Base>
class StampedCell : public Base, public Stamped {
  public:
    template <class Tds>
    struct Rebind_TDS {
        using Other = StampedCell<Traits, typename Base::template Rebind_TDS<Tds>::Other>;
    };
    using Base::Base;
};

using Traits = CGAL::Robust_circumcenter_traits_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using CellBase =
    CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<Traits, CGAL::Surface_mesh_cell_base_3<Traits>>;
using Structure = CGAL::Triangulation_data_structure_3<RimVertex<Traits>, StampedCell<Traits, CellBase>>;
using Triangulation = CGAL::Delaunay_triangulation_3<Traits, Structure>;
using Complex = CGAL::Surface_mesh_complex_2_in_triangulation_3<Triangulation>;
using Point = Triangulation::Point;
using Facet = Triangulation::Facet;
using Vertex = Triangulation::Vertex_handle;

inline Vec3d vec(const Point& p) {
    return {p.x(), p.y(), p.z()};
}
inline Point point(const Vec3d& v) {
    return {v.x, v.y, v.z};
}
inline Vec3d corner(const Facet& f, int k) {
    return vec(f.first->vertex((f.second + k) & 3)->point());
}
inline Vec3d ballCentre(const Facet& f) {
    return vec(f.first->get_facet_surface_center(f.second));
}
inline double ballRadius(const Facet& f) {
    return distance(ballCentre(f), corner(f, 1));
}

/// What CGAL asks of a surface: a place where a dual edge meets it (concept SurfaceMeshTraits_3).
class Oracle {
  public:
    using Surface_3 = surface::SegmentCaster;
    using Intersection_point = Point;

    explicit Oracle(double longest) : m_longest(longest) {}

    class Intersect_3 {
      public:
        explicit Intersect_3(double longest) : m_longest(longest) {}
        using Caster = const surface::SegmentCaster&;
        CGAL::Object operator()(Caster caster, const Traits::Segment_3& s) const {
            return meet(caster, vec(s.source()), vec(s.target()));
        }
        CGAL::Object operator()(Caster caster, const Traits::Ray_3& r) const {
            const Vec3d from = vec(r.source()), along = base::normalized(vec(r.second_point()) - from);
            return meet(caster, from, from + along * (m_longest + length(from)));
        }
        CGAL::Object operator()(Caster caster, const Traits::Line_3& l) const {
            const Vec3d on = vec(l.projection(CGAL::ORIGIN)),
                        along = base::normalized(vec(l.point(1)) - vec(l.point(0)));
            return meet(caster, on - along * m_longest, on + along * m_longest);
        }

      private:
        static CGAL::Object meet(Caster caster, const Vec3d& a, const Vec3d& b) {
            const auto found = caster.meet(a, b);
            return found ? CGAL::make_object(point(*found)) : CGAL::Object();
        }
        double m_longest;
    };
    Intersect_3 intersect_3_object() const { return Intersect_3(m_longest); }

    struct Construct_initial_points {}; // ours are put in before
    Construct_initial_points construct_initial_points_object() const { return {}; }

  private:
    double m_longest; ///< longer than what of any line could be near the surface
};

} // namespace mesh::restricted
