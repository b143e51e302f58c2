// Resampling: lets the sampling follow a deformation, by the scheme of process/README 4.1 (merge, fill, relax, settle).
// In one call, on the surfels that an edit touched:
//
//     look    which surfels have something too near or room beside them                      resample_look.cpp
//     merge   crumbs of folds, which few of their own sheet bear, go; of two surfels closer than 0.60 s one goes
//                                                                                             resample_merge.cpp
//     fill    where a surfel has room beside it at 1.05 s, the surface gets a new one         resample_fill.cpp
//     relax   surfels near new ones and near close pairs repel each other along the surface   resample_relax.cpp
//     merge and fill once more                                                                 (in Order::FillFirst)
//     settle  what moved or is new lands exactly on the frozen surface, with its own height   resample_settle.cpp
//     fit     it is raised and tilted until the surface is the frozen one again                resample_fit.cpp
//
// Every projection is onto the frozen version, never onto the moving set, in the form without drift, so that repeated
// calls do not erode the model. What need not move keeps every bit. Fully masked surfels neither move nor vanish; open
// borders stay where they are. Colours and further attributes are interpolated on the frozen version.
//
// The result is an Edit of the version, the same bits at any thread count. s is the target spacing.
#pragma once

#include "core/process/resampling/spacing_field.h"
#include "core/tree/selection.h"

#include <functional>

namespace process {

/// Which comes first. Where surfels lie by chance a sixteenth as many go and come if they are relaxed before.
enum class Order {
    FillFirst,  ///< as above
    RelaxFirst, ///< of a sampling that is to become no coarser: once
    RelaxOnly   ///< and then only what has moved is looked at: of a sampling that is to stay as fine as it is
};

struct ResampleOptions {
    float spacing = 0;     ///< target s, model units; REQUIRES > 0
    float support = 0;     ///< reach of new and moved surfels; 0: by the definition, from the spacing
    int sweeps = 3;        ///< of relaxation
    bool relaxAll = false; ///< relax all that was touched, not only what needs it
    Order order = Order::FillFirst;
    int fitRounds = 2; ///< that what moved or is new is fitted to the surface before, against erosion; 0: none
    /// Pairs closer than this part of the spacing lose one before gaps are filled. Larger ones thin an even sampling
    /// that would pass as good enough, so that it is filled again at the spacing asked for.
    float merge = 0.60f;
    /// Targets that vary. `spacing` is then the largest of them; supports of new and moved surfels follow the target.
    std::shared_ptr<const SpacingField> field;
    /// Each surfel's own target instead, and `spacing` again the largest: a new surfel has the mean target
    /// and support of those around it; supports of others stay. Called from many threads.
    std::function<float(const surfel::SurfelBlock&, int slot)> targetOf;
    /// Where set: new ones come only beside those of which it is true, and where one went; there also along open
    /// borders, between others. From many threads.
    std::function<bool(const surfel::SurfelBlock&, int slot)> drawnApart;
    /// Off-centre values in units of h from which a place of the frozen surface belongs to an open border; 0: as where
    /// many neighbours bear it. With few they are larger everywhere.
    float border = 0;
    /// Where set: does the surface go on at a place beyond what its samples bear, seen from their centroid there, until
    /// something else ends it? From many threads.
    std::function<bool(const base::Vec3f& place, const base::Vec3f& centroid)> goesOn;
};

/// What has to change so that the touched part of `version` has the target spacing. `frozen`: the surface to stay on,
/// usually `version` itself; its blocks may be others.
tree::Edit resample(const surface::Surface& version, const tree::Selection& touched, const ResampleOptions& options,
                    const surface::Surface& frozen);
tree::Edit resample(const surface::Surface& version, const tree::Selection& touched, const ResampleOptions& options);

/// Of these surfels those that have room for another beside them, where each block's spacing is spacingOf(block); more
/// than that pass where spacings differ. In parallel.
tree::Selection withRoom(const surface::Surface& version, tree::Selection among,
                         const std::function<float(const surfel::SurfelBlock&)>& spacingOf);

/// Are the new samples of a whole model fitted to the surface before? Without it details of a few spacings wear off.
enum class Fit { Off, On };

struct ResampleResult {
    surface::Surface surface;
    int rounds = 0;       ///< done
    bool settled = false; ///< the last round changed nothing
};

/// The whole model at a spacing, on its present surface: rounds until nothing changes, at most `maxRounds` per change
/// of spacing by a factor of 1.5. Supports follow the spacing. Throws base::Error for a spacing that is not positive,
/// or so fine that the model would not fit; base::Cancelled.
ResampleResult resampleAll(const surface::Surface& surface, float spacing, int maxRounds = 12,
                           const base::Progress& progress = {}, Fit fit = Fit::On);

/// The same to about `count` surfels: the spacing is tried and corrected until their number is within a hundredth, 8
/// times at most; what came closest is returned. Throws base::Error for fewer than 4 as well.
ResampleResult resampleToCount(const surface::Surface& surface, std::size_t count, int maxRounds = 12,
                               const base::Progress& progress = {}, Fit fit = Fit::On);

/// The same with a spacing that follows the curvature. Throws as well for limits that are not 0 < finest <= coarsest.
ResampleResult resampleByCurvature(const surface::Surface& surface, const CurvatureSpacing& by, int maxRounds = 12,
                                   const base::Progress& progress = {}, Fit fit = Fit::On);

/// Reach of a surfel at spacing s, h = s sqrt(K / pi), as the definition has it; and back.
float supportOf(const surface::SurfaceDefinition& definition, float spacing);
/// REQUIRES: definition.support == 0.
float spacingOf(const surface::SurfaceDefinition& definition, float support);

/// Target spacing for edits around `x`: what the supports there were made for, or, where they follow no spacing, the
/// median spacing measured. 0 for a model of fewer than 7 surfels.
float localSpacing(const surface::Surface& surface, const base::Vec3f& x);

/// All surfels of a version.
tree::Selection selectAll(const tree::SurfelTree& tree);

} // namespace process
