#include "core/reduce/rim_rows.h"

#include "core/base/cancel_scope.h"
#include "core/reduce/rim_row.h"

namespace reduce {

namespace {

/// In supports: places so far beyond a rim are to have so much more o / h than the limit, a half of what they have
/// beyond a straight one (surface/README 5.1).
constexpr float guardedAt = 0.15F;
constexpr double guardMargin = 0.04;
/// Of the squared way: places nearer than this to another piece of a rim tell nothing: slits.
constexpr float ownRim = 0.7F;

} // namespace

FitRow RimRows::row(std::size_t i, bool oriented, double limit, std::span<FitTerm> terms) const {
    const base::Vec3d x = base::cast<double>(position[i]), n = base::cast<double>(normal[i]);
    if (i < atRims)
        return rimRow(x, n, oriented, limit, terms);
    const FitRow out = rimRow(x, n, oriented, limit + guardMargin, terms);
    if (out.residual < 0)
        return out;
    for (FitTerm& t : terms)
        t.d->fill(0);
    return {};
}

RimRows rimRowsOf(const Rims& rims, const NumberedTree& sites) {
    RimRows out{rims.position, rims.normal, rims.position.size()};
    const NumberedTree ends(rims.position, rims.normal, {});
    std::vector<tree::Neighbour> near;
    for (std::size_t i = 0; i < rims.position.size(); ++i) {
        base::CancelScope::check();
        sites.tree().nearest(rims.position[i], 1, near);
        const float aside = guardedAt * near.front().block->support(near.front().slot);
        const base::Vec3f x = rims.position[i] + rims.outward[i] * aside;
        ends.tree().nearest(x, 1, near);
        if (near.front().distanceSq > ownRim * aside * aside)
            out.position.push_back(x), out.normal.push_back(rims.normal[i]);
    }
    return out;
}

} // namespace reduce
