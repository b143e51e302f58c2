// Evaluation of value and gradient at many positions, 16 of them in lanes as in self-evaluation (self.h): for loops
// over batches that lie along the surface, in the order of the surfels that they come from.
//
//     std::vector<TogetherAt> at(x.size());
//     evaluateTogether(surface, x, hints, at);
//
// The numbers are those of Surface::evaluate up to rounding, since the sums run in another order: an operation takes
// always one of the two ways. Those of a position depend on nothing but itself and the surface, whatever company it has
// in its batch; the same bits at any number of threads and on AVX2 and AVX-512. Special positions (near sheets, too few
// surfels) and frames other than summed oriented normals are evaluated one by one.
#pragma once

#include "core/surface/surface.h"

#include <span>

namespace surface {

/// Of an Evaluation what such loops ask for.
struct TogetherAt {
    Status status = Status::Outside;
    float value = 0, unit = 0, offCentre = 0, agreement = 0;
    float bend = 0; ///< e^T (grad n) e with e = x - centroid
    base::Vec3f centroid, gradient;

    bool ok() const { return status == Status::Ok; }
};

/// out[i] at x[i], with hints[i] for its sign. In parallel. REQUIRES: three spans of the same size.
void evaluateTogether(const Surface& surface, std::span<const base::Vec3f> x, std::span<const base::Vec3f> hints,
                      std::span<TogetherAt> out);

} // namespace surface
