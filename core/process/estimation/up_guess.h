// Which way up a model stands, told by its shape alone (process/README 1.4): what files do not say and people see.
#pragma once

#include "core/base/up_axis.h"
#include "core/tree/surfel_tree.h"

namespace process {

/// What the lower end of a model looks like with an axis up. Shares, 0 to 1.
struct LowerEnd {
    double flat = 0;   ///< of the model's area: a level layer there
    double spread = 0; ///< of the model's outline from above: that layer's own outline
    double rest = 0;   ///< likewise: what touches the ground, level or not
    double slope = 0;  ///< mean |cosine| between the normals of what touches the ground and the axis
};

/// Measures of a model that the guess is made of, in the order of base::upTable().
struct UpEvidence {
    std::array<LowerEnd, 6> ends;
    std::array<double, 3> extent{}; ///< along x, y, z, but for outliers
    std::array<double, 3> facing{}; ///< mean |component| of the normals
    std::array<double, 3> looks{};  ///< mean component of the normals, where their sides are known; else 0
    std::array<double, 6> sunny{};  ///< share of the area that looks that way, where sides are known; else 0
    std::array<double, 3> walls{};  ///< share of the area that stands along x, y, z
    std::array<double, 3> exact{};  ///< share of the area whose normals run along x, y, z as exactly as only built
                                    ///< models have them
};

/// Whether somebody saw on which side of the surface the outside is: who scanned it, and not an estimate.
enum class KnownSides { No, Yes };

/// From up to 32,768 surfels, whatever the model's size. REQUIRES: normals, or zeros, which tell nothing.
UpEvidence upEvidence(const tree::SurfelTree& tree, KnownSides sides = KnownSides::No);

/// A sheet lies, what was seen from above looks there, a large level plane is below; `usual` where nothing is told, and
/// for built models that would stand head down: nobody builds that way.
base::UpAxis guessedUp(const UpEvidence& evidence, base::UpAxis usual);

} // namespace process
