#include "core/reduce/rim_fit.h"

#include "core/base/parallel.h"
#include "core/base/ranked.h"
#include "core/reduce/density.h"
#include "core/reduce/fit.h"
#include "core/reduce/fit_steps.h"
#include "core/reduce/rim_row.h"
#include "core/reduce/rim_rows.h"
#include "core/surface/curves/boundary_curves.h"

#include <algorithm>
#include <cmath>

namespace reduce {

namespace {

constexpr int rounds = 5, steps = 40;
constexpr std::size_t rowsOfPiece = 256;
constexpr double ridge = 0.03, meanShare = 0.05;
/// From row to row along a rim, in supports of the samples there: some five to a sample.
constexpr float apart = 0.125F;
/// What the middle one of the values at the rims is taken for.
constexpr double leastLimit = 0.24, mostLimit = 0.32;
/// Rims of raw scans, ragged everywhere, cannot be followed: their samples stay.
constexpr double raggedFrom = 0.26;
/// Rounds in which samples that a place is lost under go back.
constexpr int returns = 3;

/// In supports of the samples wanted there: so near to a rim they are balls, and so far off what they would be.
constexpr float roundWithin = 1, freeFrom = 2;
constexpr float supportPerSpacing = 1.6F;

/// Some of the sites, as a set of their own.
struct Some {
    std::vector<std::uint32_t> of; ///< ascending
    Sites sites;

    Some(const Sites& all, std::vector<std::uint32_t> which) : of(std::move(which)) {
        for (const std::uint32_t i : of) {
            sites.position.push_back(all.position[i]), sites.normal.push_back(all.normal[i]);
            sites.support.push_back(all.support[i]);
            if (!all.shape.empty())
                sites.shape.push_back(all.shape[i]);
        }
    }
    void putBack(Sites& all) const {
        for (std::size_t k = 0; k < of.size(); ++k) {
            all.position[of[k]] = sites.position[k], all.normal[of[k]] = sites.normal[k];
            all.support[of[k]] = sites.support[k];
            if (!all.shape.empty())
                all.shape[of[k]] = sites.shape[k];
        }
    }
};

NumberedTree treeOf(const Sites& sites) {
    return {sites.position, sites.normal, sites.support, sites.shape};
}

/// Numbers of the sites that any of the positions lies in the support of, ascending.
std::vector<std::uint32_t> supporting(const NumberedTree& tree, std::size_t size,
                                      std::span<const base::Vec3f> positions) {
    std::vector<std::uint8_t> found(size);
    for (const base::Vec3f& x : positions)
        tree.forSupporting(x, [&](std::uint32_t k, float) { found[k] = 1; });
    std::vector<std::uint32_t> out;
    for (std::uint32_t k = 0; k < size; ++k)
        if (found[k])
            out.push_back(k);
    return out;
}

/// As many of the points as the samples there can follow.
Rims thinned(const Rims& rims, const NumberedTree& sites) {
    Rims out;
    std::vector<tree::Neighbour> near;
    std::size_t begin = 0;
    for (const std::uint32_t end : rims.ends) {
        float step = 0;
        for (std::size_t i = begin; i < end; ++i) {
            if (i > begin && distance(rims.position[i], out.position.back()) < step)
                continue;
            sites.tree().nearest(rims.position[i], 1, near);
            step = apart * near.front().block->support(near.front().slot);
            out.position.push_back(rims.position[i]), out.normal.push_back(rims.normal[i]),
                out.outward.push_back(rims.outward[i]);
        }
        out.ends.push_back(static_cast<std::uint32_t>(out.position.size()));
        begin = end;
    }
    return out;
}

using Piece = FitPiece<unknownsOfBalls>;

/// fn(number of a point, terms) -> FitRow for all of them.
template <class Fn>
std::vector<Piece> rowsOf(std::span<const base::Vec3f> points, const Sites& sites, const std::vector<FitSite>& moving,
                          const Fn& fn) {
    const NumberedTree tree = treeOf(sites);
    std::vector<Piece> pieces(base::chunkCount(points.size(), rowsOfPiece));
    base::parallelChunks(points.size(), rowsOfPiece, [&](std::size_t begin, std::size_t end, std::size_t k) {
        pieces[k] = pieceOf<unknownsOfBalls>(points, tree, begin, end);
        linearise(moving, pieces[k], fn);
    });
    return pieces;
}

/// o / h at points; `none` where no site is.
std::vector<double> offCentres(std::span<const base::Vec3f> points, std::span<const base::Vec3f> normals, bool oriented,
                               const Sites& sites, double none) {
    std::vector<double> off(points.size(), none);
    rowsOf(points, sites, fitSites(sites), [&](std::size_t i, std::span<FitTerm> terms) {
        off[i] =
            offCentreAt(base::cast<double>(points[i]), base::cast<double>(normals[i]), oriented, terms).value_or(none);
        return FitRow();
    });
    return off;
}

double middleOff(const Rims& rims, bool oriented, const Sites& sites) {
    std::vector<double> off = offCentres(rims.position, rims.normal, oriented, sites, mostLimit);
    return std::clamp(base::median(off), leastLimit, mostLimit);
}

void fitEnds(const RimRows& asked, bool oriented, double limit, std::span<const std::uint8_t> held, Sites& sites) {
    std::vector<FitSite> moving = fitSites(sites);
    for (int round = 0; round < rounds; ++round) {
        const std::vector<Piece> pieces =
            rowsOf(asked.position, sites, moving, [&](std::size_t i, std::span<FitTerm> terms) {
                const FitRow row = asked.row(i, oriented, limit, terms);
                for (FitTerm& t : terms)
                    if (held[std::size_t(t.site - moving.data())])
                        t.d->fill(0);
                return row;
            });
        NormalEquations<unknownsOfBalls> equations(pieces, sites.size());
        move<unknownsOfBalls>(moving, equations.solve(movedSoFar<unknownsOfBalls>(moving), ridge, meanShare, steps));
        store(moving, sites);
    }
}

/// Those of the places that a marked site has weight at.
Places placesUnder(const Places& places, const NumberedTree& marked) {
    std::vector<std::uint8_t> under(places.size());
    base::parallelFor(places.size(), 1024, [&](std::size_t i) {
        marked.forSupporting(places.position[i], [&](std::uint32_t, float) { under[i] = 1; });
    });
    Places out;
    out.oriented = places.oriented;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (under[i])
            out.position.push_back(places.position[i]), out.normal.push_back(places.normal[i]);
    return out;
}

/// Numbers of the part's sites, or of the marked ones among them.
std::vector<std::uint32_t> sitesOf(const FittedPart& part, std::span<const std::uint8_t> marked = {}) {
    std::vector<std::uint32_t> out;
    for (std::size_t i = part.begin; i < part.end; ++i)
        if (marked.empty() || marked[i])
            out.push_back(static_cast<std::uint32_t>(i));
    return out;
}

/// The parts' places that a marked site has weight at.
Places placesOf(std::span<const FittedPart> parts, std::span<const std::uint8_t> marked, const Sites& sites) {
    Places out;
    for (const FittedPart& part : parts) {
        const Some own(sites, sitesOf(part, marked));
        if (own.of.empty())
            continue;
        const Places under = placesUnder(*part.places, treeOf(own.sites));
        out.position.insert(out.position.end(), under.position.begin(), under.position.end());
        out.normal.insert(out.normal.end(), under.normal.begin(), under.normal.end());
    }
    return out;
}

/// Where a rim is ragged, or narrow flaps have one on either side, samples that end at it lose places of the surface.
/// Those go back to where they were, and move no more: what has no rim there is better than what has a hole.
void giveBack(const Places& beside, bool oriented, const Sites& before, std::vector<std::uint8_t>& moved,
              Sites& sites) {
    for (int round = 0; round < returns; ++round) {
        const std::vector<double> off = offCentres(beside.position, beside.normal, oriented, sites, 0);
        std::vector<base::Vec3f> lost;
        for (std::size_t i = 0; i < off.size(); ++i)
            if (off[i] > double(lostAtRims))
                lost.push_back(beside.position[i]);
        std::vector<std::uint32_t> over = supporting(treeOf(sites), sites.size(), lost);
        std::erase_if(over, [&](std::uint32_t k) { return !moved[k]; });
        if (over.empty())
            return;
        for (const std::uint32_t k : over)
            moved[k] = 0;
        Some(before, std::move(over)).putBack(sites);
    }
}

void fitSurfaceAgain(const FittedPart& part, std::span<const std::uint8_t> moved, Sites& sites) {
    const std::vector<std::uint32_t> own = sitesOf(part), marked = sitesOf(part, moved);
    if (marked.empty())
        return;
    const Places places = placesUnder(*part.places, treeOf(Some(sites, marked).sites));
    const Some all(sites, own);
    std::vector<std::uint32_t> which = supporting(treeOf(all.sites), own.size(), places.position);
    for (std::uint32_t& k : which)
        k += static_cast<std::uint32_t>(part.begin);
    Some some(sites, std::move(which));
    std::vector<std::uint8_t> free;
    for (const std::uint32_t k : some.of)
        free.push_back(moved[k]);
    fitAgain(places, free, some.sites);
    some.putBack(sites);
}

} // namespace

Rims rimsOf(const surface::Surface& surface, const base::Progress& progress) {
    Rims out;
    for (const surface::BoundaryCurve& curve : surface::findBoundaryCurves(surface, progress)) {
        for (const surface::BoundaryPoint& point : curve.points)
            out.position.push_back(base::cast<float>(point.position)),
                out.normal.push_back(base::cast<float>(point.normal)),
                out.outward.push_back(base::cast<float>(point.outward));
        out.ends.push_back(static_cast<std::uint32_t>(out.position.size()));
    }
    return out;
}

Places placesBeside(const Rims& rims, const Places& places, const Sites& sites) {
    const Some beside(sites, supporting(treeOf(sites), sites.size(), rims.position));
    return beside.of.empty() ? Places() : placesUnder(places, treeOf(beside.sites));
}

void roundBesideRims(const Rims& rims, std::span<const float> shares, Places& places) {
    if (rims.empty() || places.shape.empty())
        return;
    const NumberedTree tree(rims.position, rims.normal, {});
    base::parallelFor(places.size(), 1024, [&](std::size_t i) {
        const float h = supportPerSpacing * spacingAt(places, shares, i);
        std::vector<tree::Neighbour> near;
        tree.tree().nearest(places.position[i], 1, near, freeFrom * h);
        if (near.empty())
            return;
        const float off = std::sqrt(near.front().distanceSq) / h;
        places.shape[i] *= std::clamp((off - roundWithin) / (freeFrom - roundWithin), 0.0F, 1.0F);
    });
}

float fitRims(const Rims& rims, std::span<const FittedPart> parts, bool oriented, Sites& sites,
              const base::Progress& progress) {
    progress.step(0, "Fitting rims");
    const NumberedTree tree = treeOf(sites);
    const Rims few = thinned(rims, tree);
    const RimRows asked = rimRowsOf(few, tree);
    std::vector<std::uint8_t> moved(sites.size()), held;
    for (const FittedPart& part : parts)
        for (const std::uint32_t k : supporting(tree, sites.size(), few.position))
            moved[k] |= k >= part.begin && k < part.end;
    Some around(sites, supporting(tree, sites.size(), asked.position));
    for (const std::uint32_t k : around.of)
        held.push_back(!moved[k]);
    const double limit = middleOff(few, oriented, around.sites);
    if (limit > raggedFrom)
        return static_cast<float>(limit);
    const Places beside = placesOf(parts, moved, sites);
    const Sites before = sites;
    fitEnds(asked, oriented, limit, held, around.sites);
    around.putBack(sites);
    giveBack(beside, oriented, before, moved, sites);
    for (const FittedPart& part : parts)
        fitSurfaceAgain(part, moved, sites);
    return static_cast<float>(limit);
}

} // namespace reduce
