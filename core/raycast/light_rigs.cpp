#include "core/raycast/light_rigs.h"

#include "core/base/row_of_id.h"

namespace raycast {

std::span<const LightRigRow> lightRigTable() {
    static const Lamp studio[] = {{{-0.55f, 0.8f, 0.62f}, 0.2f, {0.92f, 0.86f, 0.78f}},
                                  {{0.95f, 0.25f, 0.55f}, 0.35f, {0.16f, 0.19f, 0.24f}},
                                  {{0.45f, 0.6f, -0.9f}, 0.2f, {0.5f, 0.53f, 0.58f}}};
    static const Lamp threePoint[] = {{{-0.8f, 0.6f, 0.5f}, 0.12f, {1.25f, 1.18f, 1.08f}},
                                      {{0.9f, 0.15f, 0.7f}, 0.4f, {0.1f, 0.12f, 0.16f}},
                                      {{0.7f, 0.45f, -0.8f}, 0.12f, {0.9f, 0.95f, 1.05f}}};
    static const Lamp sun[] = {{{-0.62f, 0.66f, 0.42f}, 0.0093f, {1.4f, 1.3f, 1.12f}}};
    static const Lamp overcast[] = {{{-0.15f, 1, 0.3f}, 0.85f, {0.75f, 0.77f, 0.8f}}};
    static const LightRigRow rows[] = {
        {LightRig::Studio,
         "studio",
         "Studio",
         "A large soft lamp from the upper left, a weak fill light, a rim light",
         studio,
         {0.22f, 0.235f, 0.26f},
         {0.08f, 0.073f, 0.07f}},
        {LightRig::ThreePoint,
         "three-point",
         "Three Lamps",
         "Key, fill and back light, harder than the studio",
         threePoint,
         {0.14f, 0.15f, 0.17f},
         {0.06f, 0.055f, 0.05f}},
        {LightRig::Sun,
         "sun",
         "Sun",
         "One small strong light in a blue sky: shadows with sharp edges",
         sun,
         {0.27f, 0.34f, 0.46f},
         {0.12f, 0.11f, 0.095f}},
        {LightRig::Overcast,
         "overcast",
         "Overcast",
         "Light from the whole sky, hardly any shadow",
         overcast,
         {0.5f, 0.53f, 0.57f},
         {0.14f, 0.135f, 0.13f}},
    };
    return rows;
}

const LightRigRow& lightRigRow(LightRig rig) {
    return lightRigTable()[static_cast<std::size_t>(rig)];
}

LightRig lightRig(std::string_view id) {
    return base::rowOf(lightRigTable(), id, {"unknown lights '%'", "", "use one of: %"}).rig;
}

Lamp lampTowards(const base::Vec3f& direction, std::size_t count) {
    const float power = 1.2f / static_cast<float>(count);
    return {normalized(direction), 0.06f, {power, power, power}};
}

} // namespace raycast
