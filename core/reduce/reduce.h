// Reduced sets: few samples that carry the shape of many. A tenth of the samples is as near to a scan as the surface of
// all of them (reduce/README).
//
//     feet        of the model's samples on their own surface: what the reduced set is to match       places.h
//     density     by the error that samples would make                                                density.h
//     shapes      ellipses along which they err less                                                  shapes_by_error.h
//     placement   relaxed                                                                             placement.h
//     coverage    some eight supports over every place                                                coverage.h
//     fit         offsets and tilts of normals, least squares                                         fit.h
//     again       placed, covered and fitted, by what the first samples err             density_by_result.h
//     rims        of open models, where samples beside them are fitted to end the surface             rim_fit.h
//     assembly    colours, masks and attributes; definition and boundary                              assemble.h
//     verification with the projection that everybody uses; where it misses surface, supports grow    verify.h
//
// All in parallel, with the same bits at any thread count. Memory: some 250 bytes for each of the model's surfels.
#pragma once

#include "core/reduce/verify.h"

namespace reduce {

/// Shapes of supports: Auto takes ellipsoids where they serve the model clearly better than balls.
enum class Shapes { Auto, Spheres, Ellipsoids };

struct Reduced {
    surface::Surface surface;
    Report report;
};

/// To `count` surfels. Throws base::Error for curves, for a count that is not below the model's or too small to make
/// a surface of; base::Cancelled.
Reduced reduceToCount(const surface::Surface& model, std::size_t count, Shapes shapes = Shapes::Auto,
                      const base::Progress& progress = {});
/// To the part `ratio` of them.
Reduced reduceByRatio(const surface::Surface& model, double ratio, Shapes shapes = Shapes::Auto,
                      const base::Progress& progress = {});
/// To as few as keep Report::rms at most `error`, within some 2 percent of their number. Throws base::Error as well
/// where no number does: the model's samples are no closer to their own surface.
Reduced reduceToError(const surface::Surface& model, double error, Shapes shapes = Shapes::Auto,
                      const base::Progress& progress = {});

/// What a person asked for: one of the three.
struct Wish {
    std::size_t count = 0;
    double ratio = 0, error = 0;
    Shapes shapes = Shapes::Auto;
};
/// Of models with cells each cell by itself (by_cells.h); the three above take all surfels for one surface. REQUIRES:
/// one of them is above 0.
Reduced reduceBy(const surface::Surface& model, const Wish& wish, const base::Progress& progress = {});

/// One sentence about a result: samples, distances, and what is missing.
std::string summaryOf(const Report& report);

} // namespace reduce
