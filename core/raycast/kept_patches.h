// Patches of earlier views, kept with their samples so that another view can draw them again (raycast/README 3.2).
// Their samples are rays, or were redrawn from patches a few generations old at most, so that errors do not add up.
#pragma once

#include "core/raycast/adaptive_picture.h"

namespace raycast {

/// Nine samples in space, and which quarters between them were shown.
struct KeptPatch {
    enum : std::size_t { X, Y, Z, NormalX, NormalY, NormalZ, Unit, Agreement, Red, Green, Blue, Mask, Count };
    using Values = std::array<float, Count>;

    std::array<Values, 9> knots{}; ///< Unit is 0 at those that are misses
    float error = 0;               ///< predictionError
    std::uint8_t half = 1;         ///< pixels between samples when it was cast
    std::uint8_t shown = 0;        ///< quarters, as in Split
    std::uint8_t generation = 0;   ///< 0: all samples are rays
    std::uint8_t unseen = 0;       ///< views in a row
    bool behind = false;

    base::Vec3f position(std::size_t knot) const { return {knots[knot][X], knots[knot][Y], knots[knot][Z]}; }
    base::Vec3f normal(std::size_t knot) const {
        return {knots[knot][NormalX], knots[knot][NormalY], knots[knot][NormalZ]};
    }
    /// At (u, v) in [0, 1]^2, in one of the quarters shown: the biquadratic through the samples, or of a patch of
    /// pixels, which may lack some, what is between the quarter's corners.
    Values at(float u, float v, unsigned quarter) const;
};

class KeptPatches {
  public:
    /// Patches unseen for so many views are dropped.
    static constexpr int patience = 30;

    void clear() { m_patches.clear(); }
    std::size_t size() const { return m_patches.size(); }
    std::span<const KeptPatch> all() const { return m_patches; }
    /// Takes over the leaves of a shown view that are not redrawn ones, where they are of one sheet.
    void add(const CastView& view, const AdaptivePicture& picture, std::span<const Split> splits);
    /// Drops what comes near any of the boxes.
    void dropNear(std::span<const base::Box3f> boxes);
    /// `seen`: one number for each patch, not 0 where the view showed it.
    void age(std::span<const std::uint8_t> seen);

  private:
    std::vector<KeptPatch> m_patches;
};

} // namespace raycast
