#include "core/render/shading/light_ball.h"

#include "core/render/shading/light_terms.h"

namespace render {

using namespace light;

static const Vec3f keyLight = normalized(Vec3f{-0.62f, 0.7f, 0.5f}), fillLight = normalized(Vec3f{0.86f, 0.08f, 0.4f}),
                   rimLight = normalized(Vec3f{0.35f, 0.75f, -0.55f});

Vec3f clayLight(const Vec3f& n) {
    const float sky = 0.5f + 0.5f * n.y, graze = 1 - std::max(0.0f, n.z);
    Vec3f light = Vec3f{1.05f, 0.94f, 0.8f} * (0.86f * wrapped(n, keyLight, 0.12f));
    light += Vec3f{0.46f, 0.66f, 0.98f} * (0.2f * wrapped(n, fillLight, 0.35f));
    light += Vec3f{0.4f, 0.46f, 0.55f} * (0.15f * sky) + Vec3f{0.46f, 0.37f, 0.31f} * (0.16f * (1 - sky));
    light *= 1 - 0.3f * graze * graze; // a little less light reaches what turns away: reads as depth
    Vec3f out = times(light, {0.8f, 0.745f, 0.69f});
    out += Vec3f{1, 0.97f, 0.92f} * (0.09f * gloss(n, keyLight, 18) + 0.06f * gloss(n, keyLight, 80));
    out += Vec3f{0.75f, 0.85f, 1} * (0.32f * graze * graze * graze * std::max(0.0f, dot(n, rimLight) + 0.15f));
    return encode(out);
}

Vec3f waxLight(const Vec3f& n) {
    const float sky = 0.5f + 0.5f * n.y, graze = 1 - std::max(0.0f, n.z);
    // Light that enters comes out redder: each channel wraps as far as its light travels.
    const Vec3f key{wrapped(n, keyLight, 0.45f), wrapped(n, keyLight, 0.2f), wrapped(n, keyLight, 0.12f)};
    Vec3f light = key * 1.0f + Vec3f{0.5f, 0.62f, 0.8f} * (0.16f * wrapped(n, fillLight, 0.4f));
    light += Vec3f{0.34f, 0.3f, 0.32f} * (0.18f + 0.16f * sky);
    light *= 1 - 0.42f * graze * graze;
    Vec3f out = times(light, {0.5f, 0.135f, 0.085f});
    out += Vec3f{1, 0.86f, 0.78f} * (0.17f * gloss(n, keyLight, 24) + 0.13f * gloss(n, keyLight, 110));
    out += Vec3f{0.8f, 0.75f, 0.85f} * (0.16f * graze * graze * graze * std::max(0.0f, dot(n, rimLight) + 0.2f));
    return encode(out);
}

Vec3f porcelainLight(const Vec3f& n) {
    const float sky = 0.5f + 0.5f * n.y, graze = 1 - std::max(0.0f, n.z);
    Vec3f light = Vec3f{1, 0.985f, 0.96f} * (0.72f * wrapped(n, keyLight, 0.5f));
    light += Vec3f{0.86f, 0.93f, 1} * (0.16f * wrapped(n, fillLight, 0.5f) + 0.24f * sky) +
             Vec3f{0.95f, 0.88f, 0.8f} * (0.14f * (1 - sky));
    light *= 1 - 0.34f * graze * graze;
    // A window and its softer counterpart, mirrored in the glaze.
    const Vec3f r = reflected(n);
    const float window = step(0.88f, 0.93f, dot(r, keyLight)), lamp = step(0.9f, 0.97f, dot(r, fillLight));
    const float mirror = fresnel(n, 0.045f);
    Vec3f out = times(light, {0.88f, 0.875f, 0.86f});
    out += Vec3f{1, 1, 1} * ((0.09f + mirror) * (0.8f * window + 0.3f * lamp) + 0.32f * mirror * sky);
    return encode(out);
}

Vec3f bronzeLight(const Vec3f& n) {
    // A metal shows nothing but its surroundings: a studio of bands and lamps over a dark floor.
    const Vec3f r = reflected(n);
    const float up = r.y + 0.15f * r.x;
    float room = 0.03f + 0.16f * step(-0.1f, 0.85f, up) + 0.07f * step(-0.35f, -0.95f, up);
    room += 0.8f * step(0.62f, 0.95f, dot(r, keyLight)) + 0.26f * step(0.65f, 0.95f, dot(r, fillLight));
    room += 0.22f * step(0.3f, 0.9f, dot(r, rimLight));
    const float rough = 0.24f * wrapped(n, keyLight, 0.2f) + 0.025f;
    const float edge = fresnel(n, 0);
    const Vec3f metal = Vec3f{0.74f, 0.4f, 0.18f} * (1 - edge) + Vec3f{1, 0.9f, 0.78f} * edge;
    return encode(times(metal, Vec3f{1, 0.98f, 0.95f} * (0.72f * room + rough)));
}

Vec3f jadeLight(const Vec3f& n) {
    const float sky = 0.5f + 0.5f * n.y, facing = std::max(0.0f, n.z), graze = 1 - facing;
    // Light through the stone: strongest against the lamp at the rim, softly everywhere.
    const float through = 0.4f * wrapped(n, rimLight, 0.9f) + 0.34f * graze * sky;
    Vec3f light = Vec3f{0.9f, 0.95f, 0.85f} * (0.62f * wrapped(n, keyLight, 0.7f));
    light += Vec3f{0.7f, 0.9f, 1} * (0.14f * wrapped(n, fillLight, 0.6f) + 0.12f * sky) + Vec3f{0.1f, 0.1f, 0.1f};
    Vec3f out = times(light, {0.09f, 0.36f, 0.2f}) + Vec3f{0.2f, 0.7f, 0.34f} * (0.36f * through);
    out += Vec3f{0.95f, 1, 0.97f} * (0.2f * gloss(n, keyLight, 45) + 0.22f * gloss(n, keyLight, 260));
    out += Vec3f{0.7f, 0.9f, 0.85f} * (0.3f * fresnel(n, 0.02f) * sky);
    return encode(out);
}

Vec3f studioLight(const Vec3f& n) {
    static const Vec3f head = normalized(Vec3f{0.1f, 0.15f, 1});
    const float graze = 1 - std::max(0.0f, n.z);
    float light = 0.5f * std::max(0.0f, dot(n, keyLight)) + 0.15f * std::max(0.0f, dot(n, fillLight));
    light += 0.2f * std::max(0.0f, dot(n, head)) + 0.08f + 0.25f * graze * std::max(0.0f, dot(n, rimLight));
    return encode(Vec3f{1, 1, 1} * (0.72f * light + 0.07f * gloss(n, keyLight, 40)));
}

Vec3f zebraLight(const Vec3f& n) {
    constexpr float bands = 11, texel = 2.0f / 512;
    const float tilt = std::asin(std::clamp(n.y, -1.0f, 1.0f)), wave = std::sin(bands * tilt);
    // As sharp as the picture's texels allow: asin grows steep towards the poles.
    const float slope = bands * texel / std::sqrt(std::max(1e-3f, 1 - n.y * n.y));
    const float stripe = step(-1.2f * slope, 1.2f * slope, wave);
    const float light = 0.66f + 0.34f * std::max(0.0f, n.z);
    return encode((Vec3f{0.035f, 0.045f, 0.07f} * (1 - stripe) + Vec3f{0.85f, 0.85f, 0.83f} * stripe) * light);
}

Vec3f plainLight(const Vec3f& n) {
    static const Vec3f key = normalized(Vec3f{-0.4f, 0.6f, 0.75f});
    const float light = 0.3f + 0.62f * wrapped(n, key, 0.5f) + 0.12f * n.z + 0.06f * n.y;
    return encode(Vec3f{1.02f, 1, 0.98f} * (light * 1.22f));
}

Vec3f noLight(const Vec3f&) {
    return {1, 1, 1};
}

Vec3f measureLight(const Vec3f& n) {
    static const Vec3f key = normalized(Vec3f{-0.4f, 0.6f, 0.75f});
    const float facing = std::max(0.0f, n.z), light = 0.4f * facing + 0.48f * wrapped(n, key, 0.6f) + 0.18f;
    return encode(Vec3f{1, 1, 1} * (1.12f * light));
}

Vec3f normalColour(const Vec3f& n) {
    return (n + Vec3f{1, 1, 1}) * 0.5f;
}

} // namespace render
