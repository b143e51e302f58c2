// GLSL of the fourth pass: screen_effects.cpp and ground_grid.cpp line by line.
#include "ui/gl/gl_finish.h"

namespace render {

static std::string constant(const char* name, float value) {
    return std::string("const float ") + name + " = " + std::to_string(value) + ";\n";
}

static std::string constants() {
    std::string out;
    for (const auto& [name, value] :
         std::initializer_list<std::pair<const char*, float>>{{"domeStrength", domeStrength},
                                                              {"domeMost", domeMost},
                                                              {"skyStrength", skyStrength},
                                                              {"skyBias", skyBias},
                                                              {"stepFrom", stepFrom},
                                                              {"stepTo", stepTo},
                                                              {"creaseFrom", creaseFrom},
                                                              {"creaseTo", creaseTo},
                                                              {"creaseFacingFrom", creaseFacingFrom},
                                                              {"creaseFacingTo", creaseFacingTo},
                                                              {"contourFrom", contourFrom},
                                                              {"contourTo", contourTo},
                                                              {"contourFacing", contourFacing},
                                                              {"lineInk", lineInk},
                                                              {"lineStrength", lineStrength},
                                                              {"gridMinor", gridMinor},
                                                              {"gridMajor", gridMajor},
                                                              {"gridAxis", gridAxis},
                                                              {"gridFadeFrom", gridFadeFrom},
                                                              {"gridFadeTo", gridFadeTo}})
        out += constant(name, value);
    const auto colour = [](const char* name, const float(&c)[3]) {
        return std::string("const vec3 ") + name + " = vec3(" + std::to_string(c[0]) + ", " + std::to_string(c[1]) +
               ", " + std::to_string(c[2]) + ");\n";
    };
    return out + colour("gridRed", gridRed) + colour("gridBlue", gridBlue);
}

static constexpr const char* effectsText = R"(
uniform sampler2D shaded, geometry;
uniform vec4 image; // x0, y0, step
uniform vec2 size;
uniform bool parallel, outline, grid;
uniform ivec2 dome[12], sky[32], lines[4], creases[4], contours[4];
uniform int domeCount, skyCount, linesCount, creasesCount, contoursCount;
uniform float skyRadiusSq;
uniform vec3 gridNormal, gridAlong, gridAcross, gridInk, gridStart, gridShape;
layout(location = 0) out vec4 pixel;

ivec2 here;

// Normal, and nearness in w; tap y runs down.
vec4 beside(ivec2 tap) {
    return texelFetch(geometry, clamp(here + ivec2(tap.x, -tap.y), ivec2(0), ivec2(size) - 1), 0);
}

float stepOf(float from, float to, float x) {
    float t = clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

float bend(ivec2 tap, float middle, float inverseUnit) {
    float sum = beside(tap).w + beside(-tap).w;
    return (0.5 * sum - middle) * inverseUnit * inversesqrt(dot(vec2(tap), vec2(tap))) / image.z;
}

float occlusion(vec4 at, vec2 ray) {
    float sum = 0.0;
    for (int k = 0; k < skyCount; ++k) {
        float there = beside(sky[k]).w;
        float grown = parallel ? 1.0 : at.w / max(there, 1e-6 * at.w);
        float deeper = parallel ? at.w - there : grown - 1.0;
        vec3 v = vec3(deeper * ray + vec2(sky[k]) * image.z * grown, deeper);
        float height = at.x * v.x - at.y * v.y - at.z * v.z;
        float sine = height / sqrt(max(dot(v, v), 1e-30));
        sum += max(0.0, sine - skyBias) * max(0.0, 1.0 - dot(v, v) / skyRadiusSq);
    }
    return sum / float(max(skyCount, 1));
}

float facing(vec3 n, vec2 ray) {
    return (n.z - n.x * ray.x + n.y * ray.y) * inversesqrt(dot(ray, ray) + 1.0);
}

float inkOf(vec4 at, vec2 ray, float inverseUnit) {
    float line = 0.0, steep = 0.0, most = 0.0;
    if (outline) {
        for (int k = 0; k < linesCount; ++k)
            steep = max(steep, -bend(lines[k], at.w, inverseUnit));
        line = stepOf(stepFrom, stepTo, steep);
    }
    if (creasesCount > 0) {
        steep = 0.0;
        for (int k = 0; k < creasesCount; ++k) {
            most = max(most, 1.0 - dot(beside(creases[k]).xyz, beside(-creases[k]).xyz));
            steep = max(steep, abs(bend(creases[k], at.w, inverseUnit)));
        }
        float turned = stepOf(creaseFacingFrom, creaseFacingTo, facing(at.xyz, ray));
        line = max(line, (1.0 - stepOf(stepFrom, stepTo, steep)) * turned * stepOf(creaseFrom, creaseTo, most));
    }
    if (contoursCount > 0) {
        float middle = facing(at.xyz, ray);
        steep = most = 0.0;
        for (int k = 0; k < contoursCount; ++k) {
            vec2 off = parallel ? vec2(0.0) : vec2(contours[k]) * image.z;
            float a = facing(beside(contours[k]).xyz, ray + off), b = facing(beside(-contours[k]).xyz, ray - off);
            most = max(most, min(a - middle, b - middle));
            steep = max(steep, abs(bend(contours[k], at.w, inverseUnit)));
        }
        float turned = 1.0 - stepOf(contourFacing - 0.25, contourFacing, middle);
        line = max(line, (1.0 - stepOf(stepFrom, stepTo, steep)) * turned * stepOf(contourFrom, contourTo, most));
    }
    return line * lineStrength;
}
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
    vec2 ray = parallel ? vec2(0.0) : s;
    vec4 at = texelFetch(geometry, here, 0);
    pixel = texelFetch(shaded, here, 0);
    if (parallel ? at.w > -0.5e18 : at.w > 0.0) {
        float inverseUnit = parallel ? 1.0 : 1.0 / at.w, dark = 0.0;
        for (int k = 0; k < domeCount; ++k)
            dark += clamp(bend(dome[k], at.w, inverseUnit), 0.0, domeMost);
        dark *= domeStrength / float(max(domeCount, 1));
        if (skyCount > 0)
            dark += skyStrength * occlusion(at, ray);
        float line = inkOf(at, ray, inverseUnit);
        pixel.rgb = pixel.rgb / (1.0 + dark + 0.5 * dark * dark) * (1.0 - line) + line * lineInk;
    }
    if (grid)
        pixel = withGrid(pixel, s, at.w);
}
)";

std::string finishFragmentShader() {
    return "#version 330 core\n" + constants() + effectsText + gridAndMain;
}

} // namespace render
