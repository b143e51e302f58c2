// Names of everything a surface definition is made of, spelt as INTERFACES has them, and definitions as words.
//
// One table of options serves the command line (--frame normals), the session's `surface` command and the comment line
// of PLY files ("comment pointclay surface frame=normals weight=wendland ..."). Numbers are written with as many digits
// as bring back the same bits.
#pragma once

#include "core/surface/projection/project.h"

#include <span>
#include <string>
#include <string_view>

namespace surface {

template <class E>
struct Named {
    E value;
    const char* name;
};

std::span<const Named<Manifold>> manifoldNames();   ///< surface, curve
std::span<const Named<Weight>> weightNames();       ///< wendland, wendland-c4, gaussian
std::span<const Named<Frame>> frameNames();         ///< normals, hyperplanes, covariance, ..., apss, rimls
std::span<const Named<Boundary>> boundaryNames();   ///< auto, limit, none; written, a limit is its number
std::span<const Named<Projector>> projectorNames(); ///< basic, almost, orthogonal; `query` puts "project-" before them

const char* nameOf(Manifold manifold);
const char* nameOf(Weight weight);
const char* nameOf(Frame frame);
const char* nameOf(Boundary boundary);
const char* nameOf(Projector projector);

/// Throw base::Error naming the known ones.
Manifold parseManifold(std::string_view name);
Weight parseWeight(std::string_view name);
Frame parseFrame(std::string_view name);
Projector parseProjector(std::string_view name);

/// Names of the options of a definition: manifold, frame, weight, support, neighbours, boundary, boundary-limit,
/// shrink-free, one-sheet, interpolating, curvature-spacings, apss-beta, rimls-sigma. `boundary` is auto, none or the
/// limit in units of h; `boundary-limit` is what auto was resolved to.
std::span<const char* const> optionNames();
/// The value of one option as text. REQUIRES: a name of optionNames().
std::string option(const SurfaceDefinition& definition, std::string_view name);
/// Sets one option. Throws base::Error for unknown names and for values out of range.
void setOption(SurfaceDefinition& definition, std::string_view name, std::string_view value);

/// All options as `name=value` words separated by blanks.
std::string toWords(const SurfaceDefinition& definition);
/// The definition of such words; what they leave out has its default. Throws base::Error as setOption does.
SurfaceDefinition definitionFromWords(std::string_view words);

} // namespace surface
