#include "core/mesh/restricted.h"

#include "core/mesh/restricted_types.h"
#include "core/mesh/shape.h"
#include "core/surface/rims.h"

#include <map>

namespace mesh {

using base::Vec3d;
using namespace restricted;

namespace {

/// Which facets are bad, the largest first (concept SurfaceMeshFacetsCriteria_3).
class Criteria {
  public:
    using Quality = double;
    Criteria(const surface::Surface& surface, const FacetDemand& demand) : m_surface(surface), m_demand(demand) {}

    bool is_bad(const Facet& f, Quality& quality) const {
        const double radius = ballRadius(f);
        quality = -radius;
        return radius > m_demand.floor && fails(f, radius);
    }
    bool fails(const Facet& f, double radius) const {
        if (radius > m_demand.size(ballCentre(f)))
            return true;
        const Vec3d a = corner(f, 1), b = corner(f, 2), c = corner(f, 3);
        return smallestAngle(a, b, c) < m_demand.leastAngle || isFar(f, a, b, c);
    }

  private:
    /// By the ball's centre above the facet and by f at the facet's own centre, which may be the larger distance where
    /// the surface is bumpy.
    bool isFar(const Facet& f, const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
        const Vec3d across = base::normalized(cross(b - a, c - a));
        if (std::abs(dot(ballCentre(f) - a, across)) > m_demand.distance)
            return true;
        const auto e = m_surface.evaluate(base::cast<float>((a + b + c) / 3)); // no hint, as rays have none
        if (!e.ok() && e.status != surface::Status::BeyondBoundary)
            return true;
        constexpr double margin = 0.98; // for what one evaluation leaves out
        return std::abs(double(e.value)) > margin * m_demand.distance * double(length(e.gradient));
    }

    const surface::Surface& m_surface;
    const FacetDemand& m_demand;
};

/// Vertices on rims, each knowing its neighbours along the rim.
struct RimNode {
    Vertex vertex;
    Vec3d normal;
    int previous = -1, next = -1;
};

/// CGAL's mesher for manifold edges, with boundaries; it leaves alone what has come down to the floor, and splits rims
/// where a point would come too near.
class Refiner : public CGAL::Surface_mesher::Surface_mesher_regular_edges_base<Complex, surface::SegmentCaster, Oracle,
                                                                               Criteria, true> {
  public:
    using Base = CGAL::Surface_mesher::Surface_mesher_regular_edges_base<Complex, surface::SegmentCaster, Oracle,
                                                                         Criteria, true>;
    using Base::Base;

    double floor = 0;
    std::vector<RimNode>* nodes = nullptr;
    mutable double radius = 0; ///< of the ball whose centre is to be inserted
    int encroached = -1;       ///< the node at the beginning of the rim's edge that it came too near to

    std::size_t queued() const { return facets_to_refine.size(); }
    bool criteriaDone() const { return facets_to_refine.empty(); }

    Point refinement_point_impl(const Facet& f) const {
        radius = ballRadius(f);
        return Base::refinement_point_impl(f);
    }
    CGAL::Mesher_level_conflict_status private_test_point_conflict_impl(const Point& p, Zone& zone) {
        encroached = -1;
        if (zone.locate_type == Tr::VERTEX || radius < 0.5 * floor)
            return CGAL::CONFLICT_AND_ELEMENT_SHOULD_BE_DROPPED;
        encroached = encroachedBy(vec(p), zone);
        return encroached >= 0 ? CGAL::CONFLICT_BUT_ELEMENT_CAN_BE_RECONSIDERED : CGAL::NO_CONFLICT;
    }
    void pop_next_element_impl() {
        if (!facets_to_refine.empty())
            facets_to_refine.pop_front();
        else
            bad_edges.erase(bad_edges.begin());
    }

  private:
    /// The edge of a rim whose smallest ball holds the point.
    int encroachedBy(const Vec3d& p, const Zone& zone) const {
        if (nodes->empty())
            return -1;
        for (const auto& cell : zone.cells)
            for (int k = 0; k < 4; ++k) {
                const int node = cell->vertex(k)->rim;
                if (node < 0)
                    continue;
                for (const int first : {node, (*nodes)[std::size_t(node)].previous})
                    if (first >= 0 && inBall(p, (*nodes)[std::size_t(first)]))
                        return first;
            }
        return -1;
    }
    bool inBall(const Vec3d& p, const RimNode& from) const {
        if (from.next < 0)
            return false;
        const Vec3d a = vec(from.vertex->point()), b = vec((*nodes)[std::size_t(from.next)].vertex->point());
        return dot(a - p, b - p) < 0 && distance(a, b) > 2 * floor;
    }
};

using Mesher = CGAL::Surface_mesher::Surface_mesher<Refiner>;

} // namespace

struct RestrictedDelaunay::State {
    State(const surface::Surface& surface_, FacetDemand demand_)
        : surface(surface_), demand(std::move(demand_)), caster(surface), criteria(surface, demand),
          oracle(4 * double(surface.tree().bounds().diagonal() + surface.tree().maxSupport()) +
                 length(base::cast<double>(surface.tree().bounds().centre()))),
          complex(triangulation) {
        enclose();
    }

    /// Corners of a box so far away that none is nearer to the surface than its own points: points of a plane are no
    /// special case then, and dual edges have ends.
    void enclose() {
        const base::Box3f box = surface.tree().bounds();
        const double reach = 8 * double(box.diagonal() + surface.tree().maxSupport());
        const Vec3d centre = base::cast<double>(box.centre());
        for (int k = 0; k < 8; ++k)
            triangulation
                .insert(point(centre + Vec3d{k & 1 ? reach : -reach, k & 2 ? reach : -reach * 1.01,
                                             k & 4 ? reach * 1.02 : -reach}))
                ->enclosing = true;
    }
    void begin() {
        mesher = std::make_unique<Mesher>(complex, caster, oracle, criteria);
        mesher->floor = demand.floor;
        mesher->nodes = &nodes;
        mesher->init();
    }
    /// One step; a rim that stood in the way is split.
    void step() {
        mesher->encroached = -1;
        mesher->one_step(CGAL::Null_mesh_visitor());
        if (mesher->encroached >= 0)
            split(mesher->encroached);
    }
    void settle(const base::Progress& progress);
    bool resolveVertices();
    bool keepRims();
    bool inMesh(const RimNode& from) const;
    void split(int first);
    Vertex insertLive(const Vec3d& p, Vertex near);

    const surface::Surface& surface;
    FacetDemand demand;
    surface::SegmentCaster caster;
    Criteria criteria;
    Oracle oracle;
    Triangulation triangulation;
    Complex complex;
    std::vector<RimNode> nodes;
    std::unique_ptr<Mesher> mesher;
};

RestrictedDelaunay::RestrictedDelaunay(const surface::Surface& surface, FacetDemand demand)
    : m_state(std::make_unique<State>(surface, std::move(demand))) {}
RestrictedDelaunay::~RestrictedDelaunay() = default;

void RestrictedDelaunay::add(std::span<const Vec3d> points) {
    std::vector<Point> all;
    for (const Vec3d& p : points)
        all.push_back(point(p));
    if (!m_state->mesher)
        m_state->triangulation.insert(all.begin(), all.end());
    else
        for (const Vec3d& p : points)
            m_state->insertLive(p, m_state->triangulation.finite_vertices_begin());
}

void RestrictedDelaunay::addRim(const RimChain& rim) {
    auto& nodes = m_state->nodes;
    const int first = static_cast<int>(nodes.size()), count = static_cast<int>(rim.positions.size());
    for (int i = 0; i < count; ++i) {
        const Vertex v = m_state->triangulation.insert(point(rim.positions[std::size_t(i)]));
        v->rim = first + i;
        const bool last = i + 1 == count;
        nodes.push_back({v, rim.normals[std::size_t(i)],
                         i > 0        ? first + i - 1
                         : rim.closed ? first + count - 1
                                      : -1,
                         !last        ? first + i + 1
                         : rim.closed ? first
                                      : -1});
    }
}

/// Inserts a point that is no facet's centre while the mesher runs.
Vertex RestrictedDelaunay::State::insertLive(const Vec3d& p, Vertex near) {
    const Facet nowhere;
    auto zone = mesher->conflicts_zone_impl(point(p), Facet(near->cell(), 0));
    if (zone.locate_type == Triangulation::VERTEX)
        return Vertex();
    mesher->before_insertion_impl(nowhere, point(p), zone);
    const Vertex v = mesher->insert_impl(point(p), zone);
    mesher->after_insertion_impl(v);
    return v;
}

/// At the rim point near the middle of an edge.
void RestrictedDelaunay::State::split(int first) {
    const RimNode from = nodes[std::size_t(first)], to = nodes[std::size_t(from.next)];
    const Vec3d a = vec(from.vertex->point()), b = vec(to.vertex->point()), middle = (a + b) * 0.5;
    const auto found = findRimPoint(surface, middle, {base::cast<float>(from.normal)});
    const bool good = found.ok() && distance(found.point.position, middle) < 0.5 * distance(a, b);
    const Vertex v = insertLive(good ? found.point.position : middle, from.vertex);
    const int fresh = static_cast<int>(nodes.size());
    if (v == Vertex()) { // a vertex is there already: the edge is given up
        nodes[std::size_t(from.next)].previous = -1;
        nodes[std::size_t(first)].next = -1;
        return;
    }
    v->rim = fresh;
    nodes[std::size_t(first)].next = nodes[std::size_t(from.next)].previous = fresh;
    nodes.push_back({v, good ? found.point.normal : from.normal, first, from.next});
}

bool RestrictedDelaunay::State::inMesh(const RimNode& from) const {
    const Vertex to = nodes[std::size_t(from.next)].vertex;
    Triangulation::Cell_handle cell;
    int i = 0, j = 0;
    return triangulation.is_edge(from.vertex, to, cell, i, j) &&
           complex.face_status(cell, i, j) != Complex::NOT_IN_COMPLEX;
}

/// Splits the edges of rims that are not in the mesh; false where all are.
bool RestrictedDelaunay::State::keepRims() {
    bool any = false;
    for (std::size_t i = 0, count = nodes.size(); i < count; ++i) {
        const RimNode& from = nodes[i];
        if (from.next < 0 || inMesh(from))
            continue;
        const Vec3d a = vec(from.vertex->point()), b = vec(nodes[std::size_t(from.next)].vertex->point());
        if (distance(a, b) <= 2 * demand.floor)
            continue;
        split(static_cast<int>(i));
        any = true;
    }
    return any;
}

/// Refines around vertices whose facets form no single fan; false where there is nothing to be done.
bool RestrictedDelaunay::State::resolveVertices() {
    std::vector<Vertex> bad;
    for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
        if (complex.face_status(v) == Complex::SINGULAR)
            bad.push_back(v);
    bool any = false;
    for (const Vertex& v : bad) {
        std::vector<Facet> facets;
        complex.incident_facets(v, std::back_inserter(facets));
        const auto largest = std::max_element(
            facets.begin(), facets.end(), [](const Facet& a, const Facet& b) { return ballRadius(a) < ballRadius(b); });
        if (largest == facets.end() || complex.face_status(v) != Complex::SINGULAR)
            continue;
        mesher->encroached = -1;
        any |= mesher->try_to_refine_element(*largest, CGAL::Null_mesh_visitor()) == CGAL::NO_CONFLICT;
        if (mesher->encroached >= 0) {
            split(mesher->encroached);
            any = true;
        }
    }
    return any;
}

void RestrictedDelaunay::State::settle(const base::Progress& progress) {
    for (std::size_t i = 0; !mesher->is_algorithm_done(); ++i) {
        if (i % 256 == 0) {
            const double done = static_cast<double>(triangulation.number_of_vertices());
            progress.step(done / (done + 0.7 * static_cast<double>(mesher->queued()) + 1), "Triangulating");
        }
        step();
    }
}

void RestrictedDelaunay::refine(const base::Progress& progress) {
    constexpr int rounds = 30;
    if (!m_state->mesher)
        m_state->begin();
    for (int round = 0; round < rounds; ++round) {
        m_state->settle(progress);
        const bool rims = m_state->keepRims();
        if (!rims && !m_state->resolveVertices())
            break;
    }
    m_state->settle(progress);
}

std::size_t RestrictedDelaunay::unrefined() const {
    std::size_t out = 0;
    for (auto f = m_state->complex.facets_begin(); f != m_state->complex.facets_end(); ++f)
        out += m_state->criteria.fails(*f, ballRadius(*f));
    return out;
}

Mesh RestrictedDelaunay::mesh() const {
    Mesh out;
    std::map<Vertex, std::uint32_t> numbers;
    for (auto v = m_state->triangulation.finite_vertices_begin(); v != m_state->triangulation.finite_vertices_end();
         ++v) {
        numbers.emplace(v, static_cast<std::uint32_t>(out.positions.size()));
        out.positions.push_back(vec(v->point()));
        out.kinds.push_back(v->rim >= 0 ? VertexKind::Limit : VertexKind::Inner);
    }
    for (auto f = m_state->complex.facets_begin(); f != m_state->complex.facets_end(); ++f) {
        if (m_state->criteria.fails(*f, ballRadius(*f)))
            continue;
        Triangle t{};
        for (int k = 0; k < 3; ++k)
            t[std::size_t(k)] = numbers.at(f->first->vertex((f->second + k + 1) & 3));
        out.triangles.push_back(t);
    }
    return out;
}

} // namespace mesh
