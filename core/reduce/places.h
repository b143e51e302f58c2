// Where a dense surface is asked what it is: the feet of a model's surfels on their own surface (reduce/README 2).
// Placement, fit and verification see the model through them alone.
#pragma once

#include "core/base/progress.h"
#include "core/reduce/numbered_tree.h"
#include "core/surface/surface.h"

namespace reduce {

/// Feet in the order of the tree that they come from, so that neighbours in the lists are mostly neighbours in space.
struct Places {
    std::vector<base::Vec3f> position, normal; ///< foot; unit gradient there, on the side of the surfel's normal
    std::vector<float> area;        ///< that each stands for, model units squared; before measureAreas the most
    std::vector<base::Vec3f> shape; ///< of the supports that samples there shall have (surfel/shape.h); empty: balls
    bool oriented = false;          ///< do normals have a common sign?

    std::size_t size() const { return position.size(); }
    base::Vec3f shapeAt(std::size_t i) const { return shape.empty() ? base::Vec3f{} : shape[i]; }
    /// Do the normals belong to one sheet, by their cosine?
    bool facing(const base::Vec3f& a, const base::Vec3f& b, float leastCosine) const {
        const float c = dot(a, b);
        return (oriented ? c : std::abs(c)) > leastCosine;
    }
};

/// A model as the reduction sees it.
struct Dense {
    surface::Surface surface;
    Places places;                    ///< feet of every `stride`-th surfel, but of those that have none
    std::vector<std::uint8_t> footed; ///< of each surfel in tree order: has it a foot on its own surface?
    std::size_t feet = 0;             ///< how many have
    double rms = 0;                   ///< distance of those to their feet
};

/// A foot farther away than this part of the surfel's support is not its own.
constexpr float farthestFoot = 0.86f;

/// In parallel; memory beside the result is a few MB. Throws base::Cancelled.
Dense denseOf(const surface::Surface& surface, std::size_t stride, const base::Progress& progress = {});

/// Feet of `from` on `surface`, into `places`: positions, normals that face as `side` does. Those that have none, or
/// one farther away than `reach`, are left out. `kept`, where not null, gets a flag for each.
void appendFeet(const surface::Surface& surface, std::span<const base::Vec3f> from, std::span<const base::Vec3f> side,
                std::span<const float> reach, Places& places, std::vector<std::uint8_t>* kept = nullptr);

/// Sets the areas where they are less than the most, from the 12 nearest of the same sheet: pi d^2 / 12.5.
void measureAreas(Places& places, const NumberedTree& tree);

} // namespace reduce
