// When a model gets an origin of its own, and which (io/README 4).
//
// Inside, positions are float32: at a distance R from zero they are up to R 2^-24 off. Georeferenced scans lie millions
// of units out, where that is a quarter of a metre. Near zero an origin would only make coordinates harder to read.
#pragma once

#include "core/base/vec.h"

#include <span>

namespace io {

/// The origin for a cloud of `count` points, judged by `sample` of them (finite, at best spread evenly). With R the
/// largest coordinate, E the largest extent, and E / sqrt(count) standing for the spacing of points on a surface, it is
/// zero unless both
///
///     R 2^-24 > 1e-4 E / sqrt(count)     float32 would cost more than a ten-thousandth of the spacing
///     R       > 8 E                      and an origin gains at least a factor of about sixteen
///
/// Then it is the middle, rounded to the power of ten below E. Extents run between the 2nd and the 98th percentile, so
/// that a few stray points at zero do not decide.
base::Vec3d chooseOrigin(std::span<const base::Vec3d> sample, std::size_t count);

} // namespace io
