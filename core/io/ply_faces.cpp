#include "core/io/ply_faces.h"

#include "core/io/ply_records.h"

#include <algorithm>
#include <limits>

namespace io {

bool isFace(const PlyElement& element) {
    return element.name == "face" || element.name == "faces";
}

bool isStrips(const PlyElement& element) {
    return element.name == "tristrips";
}

static bool listsVertices(const PlyProperty& property) {
    return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Triangles of a strip; every other one runs the other way round.
static void addStrips(std::span<const std::int64_t> strip, mesh::Polygons& out) {
    std::size_t begin = 0;
    for (std::size_t k = 0; k < strip.size(); ++k) {
        if (strip[k] < 0)
            begin = k + 1;
        if (k < begin + 2)
            continue;
        const bool odd = (k - begin) % 2 != 0;
        for (const std::size_t corner : {odd ? k - 1 : k - 2, odd ? k - 2 : k - 1, k})
            out.corners.push_back(static_cast<std::uint32_t>(strip[corner]));
        out.close();
    }
}

mesh::Polygons polygonsOf(const FileBytes& file, std::string_view body, const PlyElement& element, std::size_t offset,
                          bool bigEndian) {
    constexpr std::int64_t none = std::numeric_limits<std::uint32_t>::max();
    mesh::Polygons out;
    if (std::none_of(element.properties.begin(), element.properties.end(), listsVertices))
        return out;
    const bool strips = isStrips(element);
    const RecordWalker walker(file, body, element, bigEndian);
    std::vector<std::int64_t> list;
    for (std::size_t i = 0; i < element.count; ++i) {
        list.clear();
        offset = walker.pass(offset, [&](const PlyProperty& property, std::size_t at, std::size_t items) {
            if (!listsVertices(property))
                return;
            at += sizeOf(property.countType);
            for (std::size_t k = 0; k < items; ++k, at += sizeOf(property.type))
                list.push_back(loadInteger(property.type, body.data() + at, bigEndian));
        });
        if (strips) {
            addStrips(list, out);
            continue;
        }
        for (const std::int64_t corner : list)
            out.corners.push_back(static_cast<std::uint32_t>(corner < 0 ? none : std::min(corner, none)));
        out.close();
    }
    return out;
}

} // namespace io
