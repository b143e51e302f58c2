// GLSL of the screen effects: screen_effects.cpp line by line. For each row of the table the function of its word,
// which answers how dark or how inked a pixel is; constants, uniforms and the calls are written from the rows.
#include "core/render/effects/screen_effects.h"
#include "ui/gl/gl_finish.h"
#include "ui/gl/glsl_text.h"

namespace render {

static constexpr const char* common = R"(
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

float facing(vec3 n, vec2 ray) {
    return (n.z - n.x * ray.x + n.y * ray.y) * inversesqrt(dot(ray, ray) + 1.0);
}
)";

static constexpr const char* formulas = R"(
float dome(vec4 at, vec2 ray, float inverseUnit) {
    float sum = 0.0;
    for (int k = 0; k < domeTapCount; ++k)
        sum += clamp(bend(domeTaps[k], at.w, inverseUnit), 0.0, domeMost);
    return sum * (domeStrength / float(domeTapCount));
}

float sky(vec4 at, vec2 ray, float inverseUnit) {
    float sum = 0.0;
    for (int k = 0; k < skyTapCount; ++k) {
        float there = beside(skyTaps[k]).w;
        float grown = parallel ? 1.0 : at.w / max(there, 1e-6 * at.w);
        float deeper = parallel ? at.w - there : grown - 1.0;
        vec3 v = vec3(deeper * ray + vec2(skyTaps[k]) * image.z * grown, deeper);
        float height = at.x * v.x - at.y * v.y - at.z * v.z;
        float sine = height / sqrt(max(dot(v, v), 1e-30));
        sum += max(0.0, sine - skyBias) * max(0.0, 1.0 - dot(v, v) / skyDiscSq);
    }
    return skyStrength * (sum / float(skyTapCount));
}

float outline(vec4 at, vec2 ray, float inverseUnit) {
    float steep = 0.0;
    for (int k = 0; k < outlineTapCount; ++k)
        steep = max(steep, -bend(outlineTaps[k], at.w, inverseUnit));
    return stepOf(stepFrom, stepTo, steep);
}

float crease(vec4 at, vec2 ray, float inverseUnit) {
    float steep = 0.0, most = 0.0;
    for (int k = 0; k < creaseTapCount; ++k) {
        most = max(most, 1.0 - dot(beside(creaseTaps[k]).xyz, beside(-creaseTaps[k]).xyz));
        steep = max(steep, abs(bend(creaseTaps[k], at.w, inverseUnit)));
    }
    float turned = stepOf(creaseFacingFrom, creaseFacingTo, facing(at.xyz, ray));
    return (1.0 - stepOf(stepFrom, stepTo, steep)) * turned * stepOf(creaseFrom, creaseTo, most);
}

float contour(vec4 at, vec2 ray, float inverseUnit) {
    float middle = facing(at.xyz, ray), steep = 0.0, most = 0.0;
    for (int k = 0; k < contourTapCount; ++k) {
        vec2 off = parallel ? vec2(0.0) : vec2(contourTaps[k]) * image.z;
        float a = facing(beside(contourTaps[k]).xyz, ray + off), b = facing(beside(-contourTaps[k]).xyz, ray - off);
        most = max(most, min(a - middle, b - middle));
        steep = max(steep, abs(bend(contourTaps[k], at.w, inverseUnit)));
    }
    float turned = 1.0 - stepOf(contourFacingFrom, contourFacingTo, middle);
    return (1.0 - stepOf(stepFrom, stepTo, steep)) * turned * stepOf(contourFrom, contourTo, most);
}
)";

static std::string declarations() {
    std::string out = glslConstants(effectConstants);
    for (const EffectRow& row : effectRows) {
        const std::string word = row.word;
        out += glslConstants(row.constants) + "uniform ivec2 " + word + "Taps[" +
               std::to_string(EffectPlan::most(row)) + "];\nuniform int " + word + "TapCount;\n";
        if (row.disc > 0)
            out += "uniform float " + word + "DiscSq;\n";
    }
    return out;
}

static std::string calls() {
    std::string out;
    for (const EffectRow& row : effectRows) {
        const std::string word = row.word, value = word + "(at, ray, inverseUnit)";
        out += "    if (" + word + "TapCount > 0)\n        " +
               (row.kind == EffectKind::Dark ? "dark += " + value : "line = max(line, " + value + ")") + ";\n";
    }
    return out;
}

std::string effectShader() {
    return declarations() + common + formulas +
           "vec3 withEffects(vec3 rgb, vec4 at, vec2 ray, float inverseUnit) {\n    float dark = 0.0, line = 0.0;\n" +
           calls() +
           "    line *= lineStrength;\n"
           "    return rgb / (1.0 + dark + 0.5 * dark * dark) * (1.0 - line) + line * lineInk;\n}\n";
}

} // namespace render
