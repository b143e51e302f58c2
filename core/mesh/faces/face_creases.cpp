#include "core/mesh/faces/face_creases.h"

#include "core/base/box.h"
#include "core/base/cancel_scope.h"
#include "core/base/disjoint_sets.h"
#include "core/base/ranked.h"
#include "core/cells/crease_labels.h"
#include "core/mesh/faces/crease_bands.h"
#include "core/mesh/faces/near_sheets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

namespace mesh {

using base::Vec3d;

namespace {

constexpr std::size_t fewestSamples = 8; ///< of a cell
constexpr double narrow = 0.5;           ///< spacings: mean width of a strip that is no cell of its own,
constexpr double fewTurns = 70 * std::numbers::pi / 180; ///< unless it turns by more, as the sides of thin plates
constexpr double linkReach = 2.2;                        ///< spacings

/// Patches that become one another's, with the edges around them.
class PatchMerge {
  public:
    PatchMerge(const FaceTopology& topology, const CreaseChains& chains, std::span<const FacePoint> points)
        : m_chains(chains), m_sets(chains.patchCount), m_counts(chains.patchCount), m_areas(chains.patchCount),
          m_edges(chains.patchCount) {
        for (const FacePoint& point : points)
            ++m_counts[chains.patches[point.triangle]];
        for (std::size_t t = 0; t < topology.triangles.size(); ++t)
            m_areas[chains.patches[t]] += topology.areas[t];
        for (std::uint32_t e = 0; e < chains.edges.size(); ++e)
            for (const std::uint32_t triangle : {chains.edges[e].left, chains.edges[e].right})
                m_edges[chains.patches[triangle]].push_back(e);
    }

    /// Those of too few samples, and strips too narrow for them, join the neighbour that they turn to least.
    void joinSmall() {
        for (std::uint32_t p = 0; p < m_counts.size(); ++p)
            for (std::uint32_t own = m_sets.find(p);; own = m_sets.find(p)) {
                const bool few = m_counts[own] < fewestSamples;
                if (!few && !isNarrow(own))
                    break;
                const auto [other, turn] = flattest(own);
                if (other == own || (!few && turn > fewTurns))
                    break;
                join(own, other);
            }
    }
    /// Numbers from 0, in the order of the patches.
    std::vector<std::uint32_t> numbers() {
        std::vector<std::uint32_t> out(m_counts.size());
        std::uint32_t next = 0;
        for (std::uint32_t p = 0; p < out.size(); ++p) {
            const std::uint32_t root = m_sets.find(p); // the smallest of them
            out[p] = root == p ? next++ : out[root];
        }
        return out;
    }

  private:
    /// Is the mean width, twice the area over the border's length, less than a part of the samples' spacing?
    bool isNarrow(std::uint32_t own) {
        double border = 0;
        for (const std::uint32_t e : m_edges[own])
            if (setOf(m_chains.edges[e].left) != setOf(m_chains.edges[e].right))
                border += base::distance(m_chains.edges[e].from, m_chains.edges[e].to);
        return 4 * m_areas[own] * static_cast<double>(m_counts[own]) < narrow * narrow * border * border;
    }

    std::uint32_t setOf(std::uint32_t triangle) { return m_sets.find(m_chains.patches[triangle]); }

    /// The neighbour, and by how much it turns on average; itself without any.
    std::pair<std::uint32_t, double> flattest(std::uint32_t own) {
        struct Border {
            double length = 0, turn = 0;
        };
        std::map<std::uint32_t, Border> borders;
        std::erase_if(m_edges[own], [&](std::uint32_t e) { // within it for good
            return setOf(m_chains.edges[e].left) == setOf(m_chains.edges[e].right);
        });
        for (const std::uint32_t e : m_edges[own]) {
            const SharpEdge& edge = m_chains.edges[e];
            const std::uint32_t l = setOf(edge.left), r = setOf(edge.right);
            const double along = base::distance(edge.from, edge.to);
            Border& border = borders[l == own ? r : l];
            border.length += along;
            border.turn += along * edge.turn;
        }
        std::uint32_t out = own;
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [other, border] : borders)
            if (border.length > 0 && border.turn / border.length < least) {
                least = border.turn / border.length;
                out = other;
            }
        return {out, least};
    }
    void join(std::uint32_t a, std::uint32_t b) {
        m_sets.join(a, b);
        const std::uint32_t root = m_sets.find(a), child = root == a ? b : a;
        m_counts[root] += m_counts[child];
        m_areas[root] += m_areas[child];
        if (m_edges[root].size() < m_edges[child].size())
            m_edges[root].swap(m_edges[child]);
        m_edges[root].insert(m_edges[root].end(), m_edges[child].begin(), m_edges[child].end());
        m_edges[child].clear();
    }

    const CreaseChains& m_chains;
    base::DisjointSets m_sets;
    std::vector<std::size_t> m_counts;
    std::vector<double> m_areas;
    std::vector<std::vector<std::uint32_t>> m_edges;
};

/// Of each patch the cell that it belongs to.
std::vector<std::uint32_t> cellsOfPatches(const FaceTopology& topology, const CreaseChains& chains,
                                          std::span<const FacePoint> points) {
    PatchMerge merge(topology, chains, points);
    merge.joinSmall();
    return merge.numbers();
}

/// Cell of the sample nearest to `y` of a face, on the side of an edge if one is given; the face's own number without.
std::uint32_t cellBeside(const SampleGrid& grid, std::span<const std::uint32_t> cells,
                         std::span<const std::uint32_t> faces, std::uint32_t face, const Vec3d& y,
                         const std::function<bool(const Vec3d&)>& onSide) {
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t out = face;
    grid.forAround(y, [&](std::uint32_t i, double distanceSq) {
        if (faces[i] == face && distanceSq < least && onSide(grid.at(i))) {
            least = distanceSq;
            out = cells[i];
        }
    });
    return out;
}

/// Samples that know nothing of others: all, or those of one piece of the faces.
class Labelling {
  public:
    Labelling(const FaceTopology& topology, std::span<const surfel::Surfel> samples,
              std::span<const std::uint32_t> faces, double spacing)
        : m_topology(topology), m_samples(samples), m_faces(faces), m_spacing(spacing),
          m_grid(samples, linkReach * spacing) {}

    /// `edges`: between the faces of these samples; `cellOf`: faces, by patches. Bands are numbered from `firstBand`
    /// on, which becomes the next free number.
    std::vector<cells::Label> run(std::span<const SharpEdge> edges, const std::vector<std::uint32_t>& patches,
                                  const std::vector<std::uint32_t>& cellOf, std::uint32_t& firstBand) const {
        std::vector<FaceEdge> beside;
        for (const SharpEdge& edge : edges)
            beside.push_back({edge, {cellOf[patches[edge.left]], cellOf[patches[edge.right]]}});
        const EdgeCrossings crossings(m_topology, beside, m_spacing);
        const auto support = static_cast<double>(m_samples.front().support);
        const CreaseBands bands(crossings, m_grid, m_samples, m_faces, m_spacing, support, firstBand);
        for (const std::uint32_t cell : bands.cells())
            firstBand = std::max(firstBand, cell + 1);
        const NearSheets sheets(crossings, m_grid, m_samples, m_faces, bands.cells(), m_spacing, support, firstBand);
        std::vector<cells::CreasePiece> pieces;
        for (const FaceEdge& each : beside)
            addPieces(each.edge, each.faces[0], each.faces[1], sheets.cells(), pieces);
        sheets.addBorders(pieces);
        std::vector<cells::Label> labels = cells::labelsByCreases(m_samples, sheets.cells(), pieces, m_spacing);
        for (std::uint32_t i = 0; i < labels.size(); ++i)
            labels[i].face = sheets.faceOf(i);
        bands.fade(labels);
        sheets.fade(labels);
        for (const std::uint32_t cell : sheets.cells())
            firstBand = std::max(firstBand, cell + 1);
        return labels;
    }

  private:
    void addPieces(const SharpEdge& edge, std::uint32_t left, std::uint32_t right,
                   const std::vector<std::uint32_t>& cells, std::vector<cells::CreasePiece>& out) const {
        const auto parts = static_cast<std::size_t>(std::ceil(base::distance(edge.from, edge.to) / m_spacing));
        const Vec3d step = (edge.to - edge.from) / std::max(1.0, static_cast<double>(parts));
        for (std::size_t k = 0; k < parts; ++k) {
            const Vec3d from = edge.from + step * static_cast<double>(k), middle = from + step / 2;
            const auto cell = [&](std::uint32_t face, double sign) {
                return cellBeside(m_grid, cells, m_faces, face, middle, [&](const Vec3d& p) {
                    return left != right || sideOf(m_topology, edge, p) * sign > 0;
                });
            };
            const std::uint32_t l = cell(left, 1), r = cell(right, -1);
            if (l != r)
                out.push_back(
                    {from, from + step, l, r, edge.convex ? cells::Meeting::Convex : cells::Meeting::Concave});
        }
    }

    const FaceTopology& m_topology;
    std::span<const surfel::Surfel> m_samples;
    std::span<const std::uint32_t> m_faces;
    double m_spacing;
    SampleGrid m_grid;
};

/// Samples of one piece that are about as far apart: within a factor of 1.4 of each other's middle.
struct AlikeSamples {
    std::uint32_t piece = 0;
    double spacing = 0; ///< in the median
    std::vector<std::uint32_t> samples;
};

constexpr double longEdge = 1000; ///< spacings
constexpr double beyond = 64;     ///< spacings from samples, some 20 supports: no edge tells anything there

/// Edges as far as they lie near samples. Edges of a few spacings are whole: only where those of a crumb run past a
/// house's are these endless.
std::vector<SharpEdge> edgesNear(std::span<const SharpEdge> edges, std::span<const surfel::Surfel> samples,
                                 double spacing) {
    base::Box3d box;
    for (const surfel::Surfel& each : samples)
        box.extend(base::cast<double>(each.position));
    box = box.inflated(beyond * spacing);
    std::vector<SharpEdge> out;
    for (SharpEdge edge : edges) {
        const Vec3d from = edge.from, way = edge.to - from;
        double begin = 0, end = 1;
        for (std::size_t k = 0; k < 3 && length(way) > longEdge * spacing; ++k) {
            const double a = (box.lo[k] - from[k]) / way[k], b = (box.hi[k] - from[k]) / way[k];
            if (way[k] != 0)
                begin = std::max(begin, std::min(a, b)), end = std::min(end, std::max(a, b));
            else if (from[k] < box.lo[k] || from[k] > box.hi[k])
                end = -1;
        }
        if (begin > end)
            continue;
        if (begin > 0)
            edge.from = from + way * begin;
        if (end < 1)
            edge.to = from + way * end;
        out.push_back(edge);
    }
    return out;
}

/// By piece, and within it from fine to coarse: where bodies of a scene touch, one piece is sampled at many spacings.
std::vector<AlikeSamples> alike(const FaceTopology& topology, std::span<const FacePoint> points,
                                std::span<const double> spacings) {
    std::vector<std::vector<std::uint32_t>> ofPieces(topology.pieceCount);
    for (std::uint32_t i = 0; i < points.size(); ++i)
        ofPieces[topology.pieces[points[i].triangle]].push_back(i);
    const auto median = [&](const std::vector<std::uint32_t>& samples) {
        std::vector<double> all;
        for (const std::uint32_t i : samples)
            all.push_back(spacings[i]);
        return base::median(all);
    };
    std::vector<AlikeSamples> out;
    for (std::uint32_t piece = 0; piece < ofPieces.size(); ++piece) {
        if (ofPieces[piece].empty())
            continue;
        const double usual = median(ofPieces[piece]);
        std::map<long, std::vector<std::uint32_t>> octaves;
        for (const std::uint32_t i : ofPieces[piece])
            octaves[std::lround(std::log2(spacings[i] / usual))].push_back(i);
        for (auto& [octave, samples] : octaves)
            out.push_back({piece, median(samples), std::move(samples)});
    }
    return out;
}

} // namespace

void labelCreases(const FaceTopology& topology, const CreaseChains& chains, std::span<const FacePoint> points,
                  std::span<const double> spacings, surfel::SurfelList& samples) {
    if (chains.edges.empty() || samples.items.empty() || !samples.layout->oriented)
        return;
    const std::vector<std::uint32_t> cellOf = cellsOfPatches(topology, chains, points);
    std::vector<SharpEdge> edges = chains.edges;
    std::erase_if(edges, [&](const SharpEdge& edge) { // between patches that are one now
        const std::uint32_t left = chains.patches[edge.left], right = chains.patches[edge.right];
        return left != right && cellOf[left] == cellOf[right];
    });
    std::vector<std::uint32_t> faces(samples.size());
    std::uint32_t firstBand = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        faces[i] = cellOf[chains.patches[points[i].triangle]];
        firstBand = std::max(firstBand, faces[i] + 1);
    }
    if (spacings.size() == 1) {
        cells::setLabels(
            samples,
            Labelling(topology, samples.items, faces, spacings[0]).run(edges, chains.patches, cellOf, firstBand));
        return;
    }
    std::vector<std::vector<SharpEdge>> edgesOf(topology.pieceCount);
    for (const SharpEdge& edge : edges)
        edgesOf[topology.pieces[edge.left]].push_back(edge);
    std::vector<cells::Label> labels(samples.size());
    for (const AlikeSamples& group : alike(topology, points, spacings)) {
        base::CancelScope::check();
        std::vector<surfel::Surfel> own;
        std::vector<std::uint32_t> ownFaces;
        for (const std::uint32_t i : group.samples) {
            own.push_back(samples.items[i]);
            ownFaces.push_back(faces[i]);
        }
        const std::vector<cells::Label> found =
            Labelling(topology, own, ownFaces, group.spacing)
                .run(edgesNear(edgesOf[group.piece], own, group.spacing), chains.patches, cellOf, firstBand);
        for (std::size_t k = 0; k < found.size(); ++k)
            labels[group.samples[k]] = found[k];
    }
    cells::setLabels(samples, labels);
}

} // namespace mesh
