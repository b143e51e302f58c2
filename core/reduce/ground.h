// A model on which samples are placed, looked at once for several counts. Internal to the room.
#pragma once

#include "core/reduce/places.h"
#include "core/reduce/reduce.h"
#include "core/reduce/rim_fit.h"

namespace reduce {

/// The model's feet with their areas, and their tree while it is needed.
struct Ground {
    Dense dense;
    NumberedTree tree;
    std::size_t stride = 0;
    Rims rims; ///< of the model that it is of, or a cell of
};

/// With as many feet as that count asks for. `rims`: of the model, or of that which it is a cell of. Throws base::Error
/// where the points define hardly any surface; base::Cancelled.
Ground groundFor(const surface::Surface& model, std::size_t count, Rims rims, const base::Progress& progress = {});

/// To `count` samples; the ground is looked at anew where that count asks for other feet. Without `keepTree` it is of
/// no use afterwards. REQUIRES: fewest <= count. Throws base::Error where fewer points lie on a surface.
Reduced reduced(Ground& ground, std::size_t count, Shapes shapes, bool keepTree, const base::Progress& progress = {});

/// To as few as keep `error`, as reduceToError. Throws base::Error where no number does.
Reduced reducedToError(Ground& ground, double error, Shapes shapes, const base::Progress& progress = {});

} // namespace reduce
