// One surfel with its layers, in double: how a change of what is shown goes into a layer or into the base
// (layers/README 3). Internal to this room.
#pragma once

#include "core/base/vec.h"
#include "core/layers/layer_words.h"

#include <span>

namespace layers {

/// The smallest turn that takes the unit vector a to b, applied to v; v where there is none.
base::Vec3d turned(const base::Vec3d& v, const base::Vec3d& a, const base::Vec3d& b);

class SurfelLayers {
  public:
    struct Part {
        base::Vec3d d, e;
        double q = 0, mask = 0;
    };
    struct Shown {
        base::Vec3d position, normal; ///< of unit length in double, or zero
        double support = 0;
    };

    base::Vec3d base, normal;
    double support = 0;
    std::vector<Part> parts;

    void read(const surfel::SurfelBlock& block, int slot, const Channels& channels);
    void write(surfel::SurfelBlock& block, int slot, const Channels& channels) const;
    Shown shown(std::span<const float> weights) const;

    /// Takes the difference between what is shown and `wanted` into part `target`. What a part's own mask hides wholly
    /// takes nothing. REQUIRES: |weights[target]| >= leastRecording.
    void record(std::span<const float> weights, int target, const Shown& wanted);
    /// Moves the base so that `wanted` is shown. The layers' frames turn with it where `follow`, as they do when the
    /// surface below them is sculpted; else they were made for `wanted` already.
    void rebase(std::span<const float> weights, const Shown& wanted, bool follow);

  private:
    struct Place {
        base::Vec3d up, normal;
    };
    /// The normal that what a part holds leans to, of a surface below it with this one (shown_cluster.h). A part that
    /// moves so far.
    base::Vec3d leanTo(double far, const base::Vec3d& below) const;
    base::Vec3d leanTo(const Part& part, const base::Vec3d& below) const { return leanTo(length(part.d), below); }
    Place climb(std::span<const float> weights, std::size_t from, std::size_t to, Place at) const;
    double growth(std::size_t part, double weight) const;
    double growth(std::span<const float> weights) const;
    void takeWay(std::span<const float> weights, std::size_t part, const Shown& wanted);
    void takePlace(Part& part, double strength, const Place& below, const Place& now, const base::Vec3d& displaced,
                   const base::Vec3d& area);
    bool takeSupport(double next); ///< whether it changed
    void takeNormal(std::span<const float> weights, const base::Vec3d& wanted);
    void turnOver();
};

} // namespace layers
