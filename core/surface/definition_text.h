// Names of everything a surface definition is made of, and definitions as words: what the comment line of PLY files
// says ("comment pointclay surface frame=normals weight=wendland ..."), a loop over the options (definition_options.h).
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

std::span<const Named<Manifold>> manifoldNames();   ///< surface, curve, complex
std::span<const Named<Weight>> weightNames();       ///< wendland, wendland-c4, gaussian
std::span<const Named<Frame>> frameNames();         ///< those of frame_table.h
std::span<const Named<Boundary>> boundaryNames();   ///< auto, limit, none; written, a limit is its number
std::span<const Named<Projector>> projectorNames(); ///< basic, almost, orthogonal; `query` puts "project-" before them

const char* nameOf(Manifold manifold);
std::string nounOf(Manifold manifold); ///< "a surface", "a curve"...
const char* nameOf(Weight weight);
const char* nameOf(Frame frame);
const char* nameOf(Boundary boundary);
const char* nameOf(Projector projector);

/// Throw base::Error naming the known ones.
Manifold parseManifold(std::string_view name);
Weight parseWeight(std::string_view name);
Frame parseFrame(std::string_view name);
Projector parseProjector(std::string_view name);

/// All options as `name=value` words separated by blanks; the limit that auto was resolved to only where that is
/// decided.
std::string toWords(const SurfaceDefinition& definition, bool decided = true);
/// The definition of such words; what they leave out has its default. Throws base::Error for words
/// that are no option=value.
SurfaceDefinition definitionFromWords(std::string_view words);

} // namespace surface
