#include "core/raycast/material_table.h"

#include "core/base/row_of_id.h"

namespace raycast {

std::span<const MaterialRow> materialTable() {
    static const MaterialRow rows[] = {
        {Material::Matcap,
         "matcap",
         "As Shaded",
         "The shading as displayed, with shadows and occlusion on it",
         {1, 1, 1},
         0,
         1,
         {},
         1},
        {Material::Clay,
         "clay",
         "Clay",
         "Matte clay lit by the lamps; painted models keep their colours",
         {0.56f, 0.42f, 0.335f},
         0.05f,
         1,
         {},
         1},
        {Material::Glass,
         "glass",
         "Glass",
         "Refracts and reflects; deep parts are darker and greener. Where there is no inside, a thin pane",
         {1, 1, 1},
         0,
         1.5f,
         {3.4f, 1.35f, 1.75f},
         0.55f},
        {Material::Metal,
         "metal",
         "Metal",
         "A mirror of warm metal: reflects the lamps, the room and the model itself",
         {0.93f, 0.8f, 0.62f},
         0,
         1,
         {},
         1},
    };
    return rows;
}

const MaterialRow& materialRow(Material material) {
    return materialTable()[static_cast<std::size_t>(material)];
}

Material material(std::string_view id) {
    return base::rowOf(materialTable(), id, {"unknown material '%'", "", "use one of: %"}).material;
}

} // namespace raycast
