// GLSL of the fourth pass: effects (gl_effect_shader.cpp), then the grid, which is ground_grid.cpp line by line.
#include "ui/gl/gl_finish.h"
#include "ui/gl/glsl_text.h"

namespace render {

static constexpr const char* inputs = R"(#version 330 core
uniform sampler2D shaded, geometry;
uniform vec4 image; // x0, y0, step
uniform vec2 size;
uniform bool parallel, grid;
uniform vec3 gridNormal, gridAlong, gridAcross, gridInk, gridStart, gridShape;
layout(location = 0) out vec4 pixel;

ivec2 here;
)";

static constexpr const char* gridAndMain = R"(
float coverage(float away, float perPixel) {
    return clamp(0.5 * gridShape.z + 0.5 - away / perPixel, 0.0, 1.0);
}

float linesOf(float place, float perPixel, float cell) {
    float t = place / cell, width = gridShape.z;
    float away = abs(t - roundEven(t)) * cell;
    float fade = (cell / perPixel - gridFadeFrom * width) / ((gridFadeTo - gridFadeFrom) * width);
    return coverage(away, perPixel) * clamp(fade, 0.0, 1.0);
}

// Place along an axis, and what a pixel covers there.
vec2 measure(vec3 axis, float start, vec2 s, float z, vec2 dz) {
    if (parallel)
        return vec2(dot(axis, vec3(s, z)) - start, max(length(axis.xy + axis.z * dz) * image.z, 1e-30));
    float onRay = dot(axis, vec3(s, 1.0));
    return vec2(onRay * z - start, max(length(z * (axis.xy + onRay * dz)) * image.z, 1e-30));
}

vec4 withGrid(vec4 under, vec2 s, float nearness) {
    float steep = parallel ? gridNormal.z : dot(gridNormal, vec3(s, 1.0)), inverse = 1.0 / steep;
    float z = (parallel ? gridStart.z - dot(gridNormal.xy, s) : gridStart.z) * inverse;
    if (!(z > 0.0 && (parallel ? -z : 1.0 / z) > nearness))
        return under;
    vec2 dz = -gridNormal.xy * inverse;
    vec2 u = measure(gridAlong, gridStart.x, s, z, dz), v = measure(gridAcross, gridStart.y, s, z, dz);
    float minor = max(linesOf(u.x, u.y, gridShape.x), linesOf(v.x, v.y, gridShape.x));
    float major = max(linesOf(u.x, u.y, 10.0 * gridShape.x), linesOf(v.x, v.y, 10.0 * gridShape.x));
    float red = coverage(abs(v.x), v.y), blue = coverage(abs(u.x), u.y);
    float q = max(0.0, 1.0 - (u.x * u.x + v.x * v.x) * gridShape.y);
    float cover = q * q * max(max(minor * gridMinor, major * gridMajor), max(red, blue) * gridAxis);
    float below = under.a * (1.0 - cover), alpha = cover + below;
    vec3 ink = mix(mix(gridInk, gridRed, red), gridBlue, blue);
    return alpha > 0.0 ? vec4((ink * cover + under.rgb * below) / alpha, alpha) : under;
}

void main() {
    here = ivec2(gl_FragCoord.xy);
    vec2 s = image.xy + vec2(here.x, int(size.y) - 1 - here.y) * image.z;
    vec4 at = texelFetch(geometry, here, 0);
    pixel = texelFetch(shaded, here, 0);
    if (parallel ? at.w > -0.5e18 : at.w > 0.0)
        pixel.rgb = withEffects(pixel.rgb, at, parallel ? vec2(0.0) : s, parallel ? 1.0 : 1.0 / at.w);
    if (grid)
        pixel = withGrid(pixel, s, at.w);
}
)";

std::string finishFragmentShader() {
    return inputs + effectShader() + glslConstants(gridConstants) + glslConstant("gridRed", gridRed) +
           glslConstant("gridBlue", gridBlue) + gridAndMain;
}

} // namespace render
