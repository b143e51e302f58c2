// Wavefront OBJ: `v x y z [r g b]` with colours of 0..1 as most programs read them, and one `vn` for each `v`.
#include "core/io/file_coordinates.h"
#include "core/io/number_text.h"
#include "core/io/readers.h"
#include "core/io/text/text_output.h"

namespace io {

static void appendPosition(std::string& out, const FileModel& model, std::size_t i) {
    for (std::size_t k = 0; k < 3; ++k) {
        out += ' ';
        if (hasOrigin(model))
            appendNumber(out, fileCoordinates(model, i)[k]);
        else
            appendNumber(out, model.points.items[i].position[k]);
    }
}

static void appendColour(std::string& out, surfel::Colour colour) {
    for (unsigned k = 0; k < 3; ++k) {
        out += ' ';
        appendNumber(out, static_cast<float>(colour >> (8 * k) & 0xff) / 255.0f);
    }
}

static void appendNormal(std::string& out, const base::Vec3f& normal) {
    out += "vn";
    for (std::size_t k = 0; k < 3; ++k) {
        out += ' ';
        appendNumber(out, normal[k]);
    }
    out += '\n';
}

void writeObj(const path& target, const FileModel& model, const base::Progress& progress) {
    const surfel::AttributeLayout& layout = *model.points.layout;
    SafeFile file(target);
    file.write("# " + std::to_string(model.points.size()) + " points\n");
    writeRows(file, model.points.size(), progress, [&](std::string& out, std::size_t i) {
        out += 'v';
        appendPosition(out, model, i);
        if (layout.colours)
            appendColour(out, model.points.items[i].colour);
        out += '\n';
        if (layout.normals)
            appendNormal(out, model.points.items[i].normal);
    });
    file.commit();
}

} // namespace io
