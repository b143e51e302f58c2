// glTF: a cloud with all that it has and the format can hold, or a mesh (io/README 2.15).
#include "core/io/gltf/gltf_output.h"
#include "core/io/mesh_writers.h"
#include "core/io/readers.h"
#include "core/io/record_table.h"

#include <cstring>
#include <memory>

namespace io {

using gltf::Component;
using gltf::OutputList;

/// Attributes of whole numbers of 32 bits and doubles have no place in it.
static bool componentOf(ScalarType type, Component& out) {
    switch (type) {
    case ScalarType::Int8:
        out = Component::Int8;
        return true;
    case ScalarType::UInt8:
        out = Component::UInt8;
        return true;
    case ScalarType::Int16:
        out = Component::Int16;
        return true;
    case ScalarType::UInt16:
        out = Component::UInt16;
        return true;
    case ScalarType::Float32:
        out = Component::Float32;
        return true;
    case ScalarType::Int32:
    case ScalarType::UInt32:
    case ScalarType::Float64:
        break;
    }
    return false;
}

/// Words of integers hold them widened: the low bytes are the value. Each stands on 4 bytes, as vertices have to.
static OutputList wordList(const std::string& name, Component component, std::size_t count,
                           const std::function<std::uint32_t(std::size_t)>& word) {
    OutputList out{"_" + name, component, "SCALAR", 4, count};
    const std::size_t size = component == Component::Float32                                 ? 4
                             : component == Component::Int8 || component == Component::UInt8 ? 1
                                                                                             : 2;
    out.put = [word, size](std::size_t i, char* to) {
        const std::uint32_t value = word(i);
        std::memcpy(to, &value, size);
    };
    return out;
}

void writeGltf(const path& file, const FileModel& model, const base::Progress& progress) {
    const auto& items = model.points.items;
    const surfel::AttributeLayout& layout = *model.points.layout;
    const std::size_t n = items.size();
    std::vector<OutputList> lists{gltf::positionList(n, [&](std::size_t i) { return items[i].position; })};
    if (layout.normals)
        lists.push_back(gltf::normalList(n, [&](std::size_t i) { return items[i].normal; }));
    if (layout.colours)
        lists.push_back(gltf::colourList(n, [&](std::size_t i) { return items[i].colour; }));
    if (model.hasSupports)
        lists.push_back(wordList("support_radius", Component::Float32, n,
                                 [&](std::size_t i) { return std::bit_cast<std::uint32_t>(items[i].support); }));
    if (layout.masks)
        lists.push_back(wordList("mask", Component::Float32, n,
                                 [&](std::size_t i) { return std::bit_cast<std::uint32_t>(items[i].mask); }));
    const std::size_t words = layout.words();
    for (const surfel::Attribute& attribute : layout.attributes())
        if (Component component{}; componentOf(attribute.type, component)) {
            const std::uint32_t* const first = model.points.extra.data() + attribute.firstWord;
            lists.push_back(
                wordList(attribute.name, component, n, [first, words](std::size_t i) { return first[i * words]; }));
        }
    gltf::writeLists(file, std::move(lists), model.origin, progress);
}

void writeMeshGltf(const path& file, const mesh::Mesh& mesh, const base::Vec3d& origin,
                   const base::Progress& progress) {
    const std::size_t n = mesh.positions.size();
    std::vector<OutputList> lists{
        gltf::positionList(n, [&](std::size_t i) { return base::cast<float>(mesh.positions[i]); })};
    if (!mesh.normals.empty())
        lists.push_back(gltf::normalList(n, [&](std::size_t i) { return mesh.normals[i]; }));
    if (!mesh.colours.empty())
        lists.push_back(gltf::colourList(n, [&](std::size_t i) { return mesh.colours[i]; }));
    OutputList corners{"", Component::UInt32, "SCALAR", 12, mesh.triangles.size()};
    corners.put = [&](std::size_t i, char* to) { std::memcpy(to, mesh.triangles[i].data(), sizeof mesh.triangles[i]); };
    lists.push_back(corners);
    gltf::writeLists(file, std::move(lists), origin, progress);
}

} // namespace io
