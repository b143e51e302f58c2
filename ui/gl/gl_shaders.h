// GLSL of the three passes: the formulas of splat_kernels.cpp and shading.h, with their constants.
#pragma once

#include <string>

namespace render {

/// How a splat becomes pixels: a point sprite, or a quad of four vertices where it is larger than points can be.
enum class SplatShape { Point, Quad };
/// Pass 1 writes the depth up to which splats belong to the nearest layer; pass 2 adds up that layer.
enum class SplatPass { Visibility, Attributes };

std::string splatVertexShader(SplatShape shape);
std::string splatFragmentShader(SplatPass pass);
/// Pass 3: one triangle over the image; normalise, shade, background.
std::string shadeVertexShader();
std::string shadeFragmentShader();

} // namespace render
