#include "core/mesh/faces/open_faces.h"

#include "core/base/box.h"
#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cells/labels.h"
#include "core/mesh/faces/edge_labels.h"
#include "core/mesh/faces/face_normals.h"
#include "core/mesh/faces/face_rims.h"
#include "core/mesh/faces/face_sampling.h"
#include "core/mesh/faces/face_spacing.h"
#include "core/mesh/faces/face_tips.h"
#include "core/mesh/faces/figures.h"
#include "core/mesh/faces/kept_vertices.h"
#include "core/mesh/faces/large_faces.h"
#include "core/mesh/faces/sample_normals.h"
#include "core/process/estimation/keep_points.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/resampling/resample.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mesh {

namespace {

using base::Vec3f;
using surfel::SurfelList;

constexpr double besideCorner = 0.01; ///< of the way to the middle of a triangle

/// The layout of surfels with oriented normals and, where there are several patches, their numbers.
surfel::AttributeLayoutPtr layoutFor(const surfel::AttributeLayoutPtr& vertices, const FaceTopology& topology,
                                     const FacePaint* paint) {
    auto out = std::make_shared<surfel::AttributeLayout>(*vertices);
    out->colours |= paint != nullptr;
    out->normals = true;
    out->oriented = !topology.oneSided;
    if (topology.patchCount > 1 && !out->find("patch"))
        out->add("patch", surfel::ScalarType::UInt32);
    return out;
}

surfel::Colour blended(const surfel::Colour (&c)[3], const std::array<float, 3>& w) {
    surfel::Colour out = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        float sum = 0;
        for (std::size_t k = 0; k < 3; ++k)
            sum += w[k] * static_cast<float>(c[k] >> shift & 255u);
        out |= static_cast<surfel::Colour>(std::lround(std::min(sum, 255.0f))) << shift;
    }
    return out;
}

/// Makes surfels of points on the faces of `vertices`.
class FaceSampler {
  public:
    FaceSampler(const SurfelList& vertices, const FaceTopology& topology, std::span<const Vec3f> positions,
                const FacePaint* paint, surfel::AttributeLayoutPtr layout)
        : m_vertices(vertices), m_topology(topology), m_positions(positions), m_paint(paint),
          m_normals(topology, positions), m_layout(std::move(layout)) {}

    struct Size {
        float support = 0;
        double spacing = 0;
    };
    /// `sizeOf`: of each point, by number.
    template <class SizeOf>
    SurfelList run(std::span<const FacePoint> points, const SizeOf& sizeOf) const {
        SurfelList out;
        out.layout = m_layout;
        out.items.resize(points.size());
        out.extra.resize(points.size() * m_layout->words());
        base::parallelFor(points.size(), 2048, [&](std::size_t i) {
            out.items[i] = surfelAt(points[i], sizeOf(i));
            writeExtra(points[i], std::span(out.extra).subspan(i * m_layout->words(), m_layout->words()));
        });
        return out;
    }

    /// Beside tips normals are those of the faces (face_tips.h): for samples with edges that stay sharp.
    template <class SizeOf>
    void straightenTips(std::span<const FacePoint> points, const SizeOf& sizeOf, SurfelList& samples) const {
        const std::vector<std::uint8_t> tips = tipFans(m_topology, m_normals.ofFans());
        base::parallelFor(points.size(), 2048, [&](std::size_t i) {
            const std::uint32_t* fans = m_topology.fans.data() + 3 * std::size_t(points[i].triangle);
            if (std::any_of(fans, fans + 3, [&](std::uint32_t fan) { return tips[fan] != 0; }))
                samples.items[i].normal = m_normals.at(points[i], sizeOf(i).spacing, tips);
        });
    }

  private:
    surfel::Surfel surfelAt(const FacePoint& point, const Size& size) const {
        const std::array<float, 3> w = point.weights();
        surfel::Surfel out;
        out.position = base::cast<float>(placeOf(point, m_topology, m_positions));
        out.support = size.support;
        surfel::Colour colours[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const surfel::Surfel& corner = m_vertices.items[m_topology.triangles[point.triangle][k]];
            out.mask += corner.mask * w[k];
            colours[k] = corner.colour;
        }
        out.normal = m_normals.at(point, size.spacing);
        out.colour = blended(colours, w);
        if (m_paint)
            if (const auto own =
                    m_paint->at(m_topology.sources[point.triangle], m_topology.triangles[point.triangle], w))
                out.colour = *own;
        return out;
    }

    /// Reals are blended, whole numbers are those of the nearest corner.
    void writeExtra(const FacePoint& point, std::span<std::uint32_t> out) const {
        const std::array<float, 3> w = point.weights();
        const auto nearest = static_cast<std::size_t>(std::ranges::max_element(w) - w.begin());
        const Triangle& t = m_topology.triangles[point.triangle];
        for (const surfel::Attribute& attribute : m_layout->attributes()) {
            if (attribute.firstWord >= m_vertices.layout->words()) {
                surfel::write(attribute, out, m_topology.patches[point.triangle]);
                continue;
            }
            double value = surfel::read(attribute, m_vertices.extraOf(t[nearest]));
            if (surfel::isReal(attribute.type)) {
                value = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    value += static_cast<double>(w[k]) * surfel::read(attribute, m_vertices.extraOf(t[k]));
            }
            surfel::write(attribute, out, value);
        }
    }

    const SurfelList& m_vertices;
    const FaceTopology& m_topology;
    std::span<const Vec3f> m_positions;
    const FacePaint* m_paint; ///< null: colours are those of the vertices
    SampleNormals m_normals;
    surfel::AttributeLayoutPtr m_layout;
};

/// Vertices that are kept leave large faces empty: points on these, where they do not lie inside of the solid, join
/// them. Who closed holes with large faces left folds at some of their edges: normals are smooth over these, and what
/// is folded over gets no points. Returns how many.
std::size_t fillLargeFaces(SurfelList& vertices, const FaceTopology& topology, std::span<const Vec3f> positions,
                           const std::vector<std::uint8_t>& over, const InnerPlaces* inside, const FacePaint* paint,
                           const base::Progress& progress) {
    std::vector<FacePoint> points = pointsOnLargeFaces(topology, positions, progress);
    std::erase_if(points, [&](const FacePoint& p) { return over[p.triangle] != 0; });
    if (inside)
        std::erase_if(points,
                      [&](const FacePoint& p) { return inside->has(placeOf(p, topology, positions), p.triangle); });
    if (points.empty())
        return 0;
    FaceTopology smooth = topology;
    joinFans(smooth, positions, noisyEdges(topology));
    const SurfelList more =
        FaceSampler(vertices, smooth, positions, paint, vertices.layout).run(points, [](std::size_t) {
            return FaceSampler::Size{};
        });
    for (std::size_t i = 0; i < more.size(); ++i)
        vertices.append(more.items[i], more.extraOf(i));
    return more.size();
}

/// Whether faces are so broken (repeated, or three and more at an edge, at more than one of 500 edges) that their sides
/// mean less than what the points tell: merged scans whose small pieces face any way.
bool broken(const FaceTopology& topology) {
    return 500 * (topology.repeated + topology.nonManifold) > topology.turns.size();
}

/// Is there a boundary, and do the faces tell where?
bool hasRims(const FaceTopology& topology) {
    return !topology.closed() && !broken(topology) && !topology.borderEdges.empty();
}

/// What had to be mended before the faces could be used, a sentence each.
std::vector<std::string> mended(const FaceTopology& topology) {
    std::vector<std::string> out;
    const auto add = [&out](const char* done, std::size_t count, const char* one, const char* many) {
        if (count > 0)
            out.push_back(done + counted(count, one, many) + ".");
    };
    add("Left out ", topology.repeated, "repeated triangle", "repeated triangles");
    add("Left out ", topology.inside, "triangle inside of the solid", "triangles inside of the solid");
    add("Reversed ", topology.reversed, "triangle that faced the other way", "triangles that faced the other way");
    add("Turned ", topology.turnedOut, "closed piece that was inside out", "closed pieces that were inside out");
    add("Found ", topology.nonManifold, "edge with more than two faces", "edges with more than two faces");
    return out;
}

/// Whether two closed pieces may run into each other, by their boxes.
bool mayCross(const FaceTopology& topology, std::span<const Vec3f> positions) {
    std::vector<base::Box3f> all(topology.sealed.size()), boxes;
    base::Box3f whole;
    for (std::size_t t = 0; t < topology.triangles.size(); ++t)
        for (std::size_t k = 0; topology.bodies[t] != noBody && k < 3; ++k)
            all[topology.bodies[t]].extend(positions[topology.triangles[t][k]]);
    for (std::size_t body = 0; body < all.size(); ++body)
        if (topology.sealed[body] != 0)
            boxes.push_back(all[body]), whole.extend(all[body]);
    if (boxes.size() < 2)
        return false;
    // Along the longest side, where the fewest lie beside each other.
    const Vec3f size = whole.size();
    const std::size_t k = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::sort(boxes.begin(), boxes.end(), [k](const auto& a, const auto& b) { return a.lo[k] < b.lo[k]; });
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        base::CancelScope::check();
        for (std::size_t j = i + 1; j < boxes.size() && boxes[j].lo[k] <= boxes[i].hi[k]; ++j)
            if (boxes[i].overlaps(boxes[j]))
                return true;
    }
    return false;
}

/// Tells which vertices lie in other closed pieces, with all of their faces. Returns how many. Beside the seams those
/// that stay are an edge apart at most: no gap for supports of some edges.
std::size_t findCrossing(const FaceTopology& topology, std::span<const Vec3f> positions, const InnerPlaces& inside,
                         std::vector<std::uint8_t>& gone) {
    std::vector<std::uint8_t> in(topology.triangles.size() * 3);
    base::parallelFor(topology.triangles.size(), 256, [&](std::size_t t) {
        base::Vec3d p[3], middle;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = base::cast<double>(positions[topology.triangles[t][k]]);
            middle += p[k] / 3;
        }
        for (std::size_t k = 0; k < 3; ++k)
            in[3 * t + k] = inside.has(p[k] + (middle - p[k]) * besideCorner, static_cast<std::uint32_t>(t)) ? 1 : 0;
    });
    std::vector<std::uint8_t> inner(gone.size()), outer(gone.size());
    for (const std::uint32_t v : topology.insideCorners)
        inner[v] = 1;
    for (std::size_t c = 0; c < in.size(); ++c)
        if (topology.areas[c / 3] > 0) // others lie nowhere
            (in[c] != 0 ? inner : outer)[topology.triangles[c / 3][c % 3]] = 1;
    std::size_t count = 0;
    for (std::size_t v = 0; v < gone.size(); ++v)
        if (inner[v] != 0 && outer[v] == 0)
            gone[v] = 1, ++count;
    return count;
}

/// 1 for each vertex that no triangle has for a corner.
std::vector<std::uint8_t> looseOf(std::size_t vertices, std::span<const Triangle> triangles) {
    std::vector<std::uint8_t> out(vertices, 1);
    for (const Triangle& t : triangles)
        for (const std::uint32_t v : t)
            out[v] = 0;
    return out;
}

} // namespace

OpenedFaces openFaces(SurfelList vertices, std::span<const Triangle> triangles,
                      const surface::SurfaceDefinition& definition, const FaceOptions& options,
                      const base::Progress& progress, const FacePaint* paint) {
    std::vector<Vec3f> positions(vertices.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] = vertices.items[i].position;
    FaceTopology topology = faceTopology(positions, triangles, options.sharpRad);
    OpenedFaces out;
    std::vector<std::uint8_t> gone = looseOf(positions.size(), triangles);
    const auto loose = static_cast<std::size_t>(std::count(gone.begin(), gone.end(), 1));
    const bool automatic = options.use == FaceUse::Auto && !options.asksForSamples() && !options.asksForCreases(),
               mostLoose = automatic && 2 * loose > positions.size();
    if (!(topology.area > 0) || mostLoose) {
        if (options.asksForSamples())
            throw base::Error("the faces have no area to sample", "", "keep the vertices");
        if (mostLoose)
            out.messages.push_back("Opened as points: " + grouped(loose) + " vertices of " + grouped(positions.size()) +
                                   " have no face; --faces sample opens the faces alone.");
        out.points = std::move(vertices);
        return out;
    }
    const auto tellLoose = [&] {
        if (loose > 0)
            out.messages.push_back("Left out " + counted(loose, "vertex", "vertices") +
                                   " of no face; --faces vertices keeps " + (loose > 1 ? "them." : "it."));
    };
    out.closed = topology.closed();
    for (std::string& what : mended(topology))
        out.messages.push_back(std::move(what));
    if (options.use == FaceUse::Vertices ||
        (options.use == FaceUse::Auto && options.count == 0 && options.spacing <= 0 &&
         sampleWell(topology, positions) && !(options.creases != false && hasSureCreases(topology)))) {
        if (broken(topology))
            out.messages.push_back("The faces are too broken to take normals from.");
        else if (completeVertices(vertices, topology, positions) && topology.turnedOut == 0)
            out.messages.push_back("Turned normals of closed faces that looked inwards.");
        if (paint)
            paintVertices(vertices, *paint);
        const bool whole = options.use == FaceUse::Auto && !broken(topology);
        std::optional<InnerPlaces> inside;
        const std::vector<std::uint8_t> over = whole ? foldedOver(topology, positions) : std::vector<std::uint8_t>();
        if (whole && (mayCross(topology, positions) || std::ranges::find(over, 1) != over.end()))
            inside.emplace(topology, positions);
        if (inside && inside->outerShare() == 1)
            inside.reset();
        if (whole)
            if (const std::size_t more =
                    fillLargeFaces(vertices, topology, positions, over, inside ? &*inside : nullptr, paint, progress);
                more > 0)
                out.messages.push_back("Large faces, which the vertices leave empty, got " +
                                       counted(more, "surfel", "surfels") +
                                       "; --faces vertices keeps the vertices alone.");
        if (whole)
            tellLoose();
        else
            gone.assign(gone.size(), 0);
        std::size_t crossing = 0;
        if (inside)
            crossing = findCrossing(topology, positions, *inside, gone);
        if (crossing > 0)
            out.messages.push_back("Left out " + counted(crossing, "vertex", "vertices") +
                                   " inside of the solid; --faces vertices keeps them.");
        else if (options.use == FaceUse::Auto)
            findInner(topology, gone);
        process::keepPoints(vertices, [&](std::size_t i) { return i >= gone.size() || gone[i] == 0; });
        if (options.asksForCreases())
            out.messages.push_back("The vertices are kept, without creases; --faces sample makes them.");
        out.points = std::move(vertices);
        if (whole && hasRims(topology))
            out.rims = markRims(topology, vertexSupports(out.points, topology, positions, definition), out.points);
        return out;
    }
    tellLoose();
    const InnerPlaces inside(topology, positions);
    const double share = inside.outerShare();
    if (share < 1)
        out.messages.push_back("Left out what lies inside of the solid, " + rounded(100 * (1 - share)) +
                               " % of the faces' area.");
    const FaceSampling sampling = sampleFaces(topology, positions, inside, definition, options, progress);
    const std::vector<FacePoint>& points = sampling.points;
    const CreaseChains kept = keptEdges(topology, options, points, sampling.spacings);
    joinFans(topology, positions, kept.rounded);
    const FaceSampler sampler(vertices, topology, positions, paint, layoutFor(vertices.layout, topology, paint));
    const auto sizeOf = [&](std::size_t i) {
        const double spacing = sampling.spacings[sampling.spacings.size() == 1 ? 0 : i];
        return FaceSampler::Size{process::supportOf(definition, static_cast<float>(spacing)), spacing};
    };
    out.points = sampler.run(points, sizeOf);
    out.sampled = true;
    const std::string edges = labelEdges(topology, options, kept, points, sampling.spacings, out.points);
    if (cells::LabelLayout::of(*out.points.layout))
        sampler.straightenTips(points, sizeOf, out.points);
    if (hasRims(topology)) {
        std::vector<float> supports(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            supports[i] = out.points.items[i].support;
        out.rims = markRims(topology, supports, out.points);
    }
    out.apart = sampling.apart;
    out.blades = hasBlades(topology, kept.edges);
    out.messages.push_back(counted(topology.triangles.size(), "triangle", "triangles") + " sampled to " +
                           counted(points.size(), "surfel", "surfels") + ", spacing " + sampling.toldSpacing() +
                           "; --faces vertices keeps the " + counted(vertices.size(), "vertex", "vertices") + ".");
    if (!edges.empty())
        out.messages.push_back(edges);
    return out;
}

} // namespace mesh
