#include "ui/gl/gl_shaders.h"

#include "core/render/shading/shading.h"
#include "core/render/splats/splat_kernels.h"
#include "core/surfel/shape.h"
#include "ui/gl/glsl_text.h"

namespace render {

static std::string head() {
    const SharedConstant constants[] = {
        {"filterPx", filterPx},         {"layerDepth", layerDepth}, {"filterDepth", filterDepth},
        {"backBias", backBias},         {"backClip", backClip},     {"minCosine", minCosine},
        {"backFrom", backFrom},         {"backTo", backTo},         {"acrossRadius", acrossRadius},
        {"loneRadius", loneRadius},     {"cutRadius", cutRadius},   {"solidAway", solidAway},
        {"cornerRadius", cornerRadius}, {"tipRadius", tipRadius},   {"longestShape", surfel::longestShape}};
    return "#version 330 core\n" + glslConstants(constants) +
           "const int mostClips = " + std::to_string(ClipPlanes::most) + ";\n" +
           "const uint cutMask = " + std::to_string((1u << cutBits) - 1) +
           "u, twoCutMask = " + std::to_string((1u << twoCutBits) - 1) + "u, twoCuts = " + std::to_string(twoCuts) +
           "u, acrossDisc = " + std::to_string(acrossDisc) + "u, noDisc = " + std::to_string(noDisc) +
           "u, loneDisc = " + std::to_string(loneDisc) + "u;\n" + "const int lightSize = " + std::to_string(lightSize) +
           ";\n";
}

/// The view, as in ViewFrame: image place of the first pixel, pixels per unit of it, radius as a part of the support.
static constexpr const char* viewUniforms = R"(
uniform vec3 right, down, forward, eye, rest;
uniform vec4 image; // x0, y0, focalPx, radiusOfSupport
uniform vec2 size;  // pixels
uniform vec2 depthRange; // nearest depth, 1 / (farthest - nearest)
uniform bool oriented, parallel;
uniform float backsFarther; // 0: nothing of that kind
uniform vec4 clips[mostClips]; // normal x, y, constant, factor
uniform int clipCount;

float nearness(float z) { return parallel ? -z : 1.0 / z; } // w, linear across the image
float pixelSize(float z) { return parallel ? 1.0 / image.z : z / image.z; }
)";

static constexpr const char* splatVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 packedNormal;
layout(location = 2) in float support;
layout(location = 3) in vec4 colourAndMask;
layout(location = 4) in vec4 packedShape; // 0 where supports are balls
flat out vec4 centre; // image place, depth, radius
flat out vec4 plane;  // gradient of w across the image, bias, w from where it is cut
flat out vec3 normal;
flat out vec4 shape; // b of an ellipse in its plane, radius of a disc of its area
flat out vec3 edge, secondEdge; // the disc ends where (x - centre) . edge = 1
flat out vec4 attributes;

// As in disc_cuts.cpp, for a unit normal.
vec3 directionAt(vec3 n, bool yAxis, uint steps, float count) {
    vec3 u = normalize(yAxis ? vec3(n.z, 0.0, -n.x) : vec3(0.0, -n.z, n.y));
    float angle = float(steps) * (6.28318531 / count);
    return u * cos(angle) + cross(n, u) * sin(angle);
}

vec3 turn(vec3 v) { return vec3(dot(v, right), dot(v, down), dot(v, forward)); }

void main() {
    vec3 p = turn(position - eye) - rest;
    vec3 n = packedNormal.xyz;
    vec3 ray = parallel ? vec3(0.0, 0.0, 1.0) : p;
    float distance = length(ray);
    n = dot(n, n) < 0.25 ? ray / -distance : turn(normalize(n));
    uint bits = floatBitsToUint(support);
    bool two = (bits & twoCuts) != 0u;
    uint mask = two ? twoCutMask : cutMask, code = bits & mask;
    float facing = dot(n, ray), radius = uintBitsToFloat(bits & ~mask & ~twoCuts) * image.w;
    vec3 unit = normalize(packedNormal.xyz);
    edge = secondEdge = vec3(0.0);
    if (two) {
        bool yAxis = (code >> 20 & 1u) != 0u;
        vec2 parts = (vec2(code >> 4 & 15u, code & 15u) + 1.0) / 20.0;
        edge = turn(directionAt(unit, yAxis, code >> 14 & 63u, 64.0)) / (parts.x * radius);
        secondEdge = turn(directionAt(unit, yAxis, code >> 8 & 63u, 64.0)) / (parts.y * radius);
        radius *= cutRadius;
    } else if (code == noDisc) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // out of the picture
        gl_PointSize = 1.0;
        return;
    } else if (code == acrossDisc || code == loneDisc) {
        radius *= code == acrossDisc ? acrossRadius : loneRadius;
    } else {
        bool corner = (code >> 12 & 1u) != 0u; // distances end at 15 there, and are 16 more at tips
        float part = float(code & (corner ? 15u : 31u)) / 32.0;
        if (part > 0.0) {
            edge = turn(directionAt(unit, (code >> 13 & 1u) != 0u, code >> 5 & 127u, 128.0)) / (part * radius);
            radius *= !corner ? cutRadius : (code & 31u) > 16u ? tipRadius : cornerRadius;
        }
    }
    bool away = facing > 0.0;
    if (away && !oriented) {
        n = -n;
        facing = -facing;
    }
    float steep = (facing < 0.0 ? -1.0 : 1.0) * max(abs(facing), minCosine * distance);
    centre = vec4(parallel ? p.xy : p.xy / p.z, p.z, radius);
    bool behind = away && oriented;
    vec3 b = turn(packedShape.xyz * longestShape);
    b -= n * dot(n, b);
    float aspect = sqrt(1.0 + dot(b, b));
    shape = vec4(b, radius / sqrt(aspect));
    vec3 lacks = b / aspect;
    vec3 extent = radius * sqrt(max(vec3(0.0), 1.0 - n * n - lacks * lacks));
    float rise = extent.z;
    bool farther = backsFarther > 0.0 && facing > solidAway * distance;
    plane = vec4(n.xy / steep, farther ? backsFarther : behind ? (shape.w + filterPx * pixelSize(p.z)) * layerDepth * backBias : 0.0,
                 behind ? nearness(centre.z - backClip * rise) : 3e38);
    normal = n;
    attributes = colourAndMask;

    vec2 wide = parallel ? extent.xy : (extent.xy + abs(centre.xy) * extent.z) / (p.z - extent.z);
    vec2 halfPx = max(vec2(filterPx), image.z * wide);
    vec2 px = (centre.xy - image.xy) * image.z + 0.5;
    if (p.z <= 1.02 * radius || any(greaterThan(px - halfPx, size)) || any(lessThan(px + halfPx, vec2(0.0)))) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
#ifdef POINTS
        gl_PointSize = 1.0;
#endif
        return;
    }
#ifdef POINTS
    // A point whose centre lies outside is dropped whole: move it in and let it grow by as much.
    vec2 inside = clamp(px, vec2(0.0), size);
    halfPx += abs(px - inside);
    px = inside;
    gl_PointSize = 2.0 * max(halfPx.x, halfPx.y) + 1.0;
#else
    px += (halfPx + 0.5) * vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
#endif
    vec2 ndc = 2.0 * px / size - 1.0;
    gl_Position = vec4(ndc.x, -ndc.y, 0.0, 1.0);
}
)";

static constexpr const char* splatFragment = R"(
flat in vec4 centre;
flat in vec4 plane;
flat in vec3 normal;
flat in vec4 shape;
flat in vec3 edge, secondEdge;
flat in vec4 attributes;
layout(location = 0) out vec4 normalSum;
layout(location = 1) out vec4 colourSum;
layout(location = 2) out vec2 depthSum;

void main() {
    vec2 slope = image.xy + vec2(gl_FragCoord.x - 0.5, size.y - gl_FragCoord.y - 0.5) / image.z;
    vec2 d = slope - centre.xy;
    float radius = centre.w;
    float exact = nearness(centre.z) + dot(plane.xy, d);
    float pixel = filterPx * pixelSize(centre.z), range = radius + filterDepth * pixel;
    float w = clamp(exact, nearness(centre.z + range), nearness(max(centre.z - range, 0.01 * centre.z)));
    for (int k = 0; k < clipCount; ++k)
        if (dot(clips[k].xy, slope) + clips[k].z < clips[k].w * w)
            discard;
    float z = parallel ? -w : 1.0 / w, dz = z - centre.z;
    vec3 a = vec3(parallel ? d : dz * centre.xy + z * d, dz);
    float off = dot(a, shape.xyz);
    float r2 = min(exact > plane.w || max(dot(a, edge), dot(a, secondEdge)) > 1.0 ? 2.0 : (dot(a, a) + off * off) / (radius * radius),
                   dot(d, d) * image.z * image.z / (filterPx * filterPx));
    if (r2 > 1.0)
        discard;
#ifdef VISIBILITY
    gl_FragDepth = (z + layerDepth * (shape.w + pixel) + plane.z - depthRange.x) * depthRange.y;
#else
    gl_FragDepth = (z + plane.z - depthRange.x) * depthRange.y;
    float weight = exp(-2.0 * r2);
    normalSum = weight * vec4(normal, 1.0);
    colourSum = weight * attributes;
    depthSum = weight * vec2(z, 1.0);
#endif
}
)";

static constexpr const char* shadeFragment = R"(
uniform sampler2D normalSums, colourSums, depthSums, light, background;
uniform vec3 maskTint, backTint;
uniform bool useColour, useAttributes, useDepth;
layout(location = 0) out vec4 pixel;
layout(location = 1) out float rayDepth;
layout(location = 2) out vec4 geometry; // for gl_finish: normal, nearness

vec3 lightAt(vec3 n) {
    if (n.z < 0.0)
        n *= inversesqrt(dot(n.xy, n.xy) + 1e-12);
    float halfSize = 0.5 * float(lightSize - 1);
    ivec2 texel = ivec2(vec2(halfSize) + halfSize * vec2(n.x, -n.y) + 0.5);
    return texelFetch(light, clamp(texel, ivec2(0), ivec2(lightSize - 1)), 0).rgb;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int row = int(size.y) - 1 - at.y;
    vec4 sums = texelFetch(normalSums, at, 0);
    if (!(sums.w > 0.0)) {
        pixel = texelFetch(background, ivec2(at.x & 7, row), 0);
        rayDepth = uintBitsToFloat(0x7f800000u);
        geometry = vec4(vec3(0.0), parallel ? -1e18 : 0.0);
        return;
    }
    vec2 slope = parallel ? vec2(0.0) : image.xy + vec2(at.x, row) / image.z;
    float across = dot(slope, slope) + 1.0;
    vec3 n = vec3(sums.x, -sums.y, -sums.z);
    n = dot(n, n) > 0.0 ? normalize(n) : vec3(0.0, 0.0, 1.0);
    geometry.xyz = n;
    vec3 v = vec3(-slope.x, slope.y, 1.0) * inversesqrt(across);
    float facing = dot(n, v), s = (facing + n.z) / (1.0 + v.z);
    n = vec3(n.xy - s * v.xy, facing);

    vec3 colour = lightAt(n);
    float back = clamp((n.z - backFrom) / (backTo - backFrom), 0.0, 1.0);
    if (back > 0.0)
        colour = mix(colour, lightAt(-n) * backTint, back);
    float mask = 0.0;
    if (useAttributes) {
        vec4 blended = texelFetch(colourSums, at, 0) / sums.w;
        if (useColour)
            colour *= blended.rgb;
        mask = blended.a;
    }
    pixel = vec4(colour * mix(vec3(1.0), maskTint, mask), 1.0);
    if (useDepth) {
        vec2 depth = texelFetch(depthSums, at, 0).xy;
        rayDepth = depth.x / depth.y * sqrt(across);
        geometry.w = parallel ? -depth.x / depth.y : depth.y / depth.x;
    }
}
)";

std::string splatVertexShader(SplatShape shape) {
    return head() + (shape == SplatShape::Point ? "#define POINTS\n" : "") + viewUniforms + splatVertex;
}

std::string splatFragmentShader(SplatPass pass) {
    return head() + (pass == SplatPass::Visibility ? "#define VISIBILITY\n" : "") + viewUniforms + splatFragment;
}

std::string shadeVertexShader() {
    return head() + R"(
void main() {
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";
}

std::string shadeFragmentShader() {
    return head() + viewUniforms + shadeFragment;
}

} // namespace render
