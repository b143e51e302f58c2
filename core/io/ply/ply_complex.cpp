#include "core/io/ply/ply_complex.h"

#include "core/base/error.h"
#include "core/io/ply/ply_records.h"

#include <cstring>

namespace io {

using base::Vec3d;

static constexpr const char *cellElement = "complex_cell", *tangentElement = "complex_tangent";

static PlyElement cellsDeclared(std::size_t count) {
    return {cellElement,
            count,
            {{"dimension", ScalarType::UInt8}, {"boundary", ScalarType::UInt32, true, ScalarType::UInt32}}};
}

static PlyElement tangentsDeclared(std::size_t count) {
    PlyElement out{
        tangentElement, count, {{"at", ScalarType::UInt32}, {"cells", ScalarType::UInt32, true, ScalarType::UInt32}}};
    for (const char* name : {"x", "y", "z"})
        out.properties.push_back({name, ScalarType::Float64});
    for (const char* name : {"nx", "ny", "nz"})
        out.properties.push_back({name, ScalarType::Float32});
    return out;
}

bool isOfComplex(const PlyElement& element) {
    return element.name == cellElement || element.name == tangentElement;
}

/// A number of a cell; what is none becomes one that no complex has, and is refused with its rules.
static std::uint32_t numberIn(const PlyProperty& property, const char* bytes) {
    const std::int64_t value = loadInteger(property.type, bytes, false);
    return value >= 0 && value < std::numeric_limits<std::uint32_t>::max() ? static_cast<std::uint32_t>(value)
                                                                           : std::numeric_limits<std::uint32_t>::max();
}

void PlyComplex::take(const FileBytes& file, const PlyElement& element, std::string_view body) {
    const RecordWalker walker(file, body, element, false);
    const bool ofCells = element.name == cellElement;
    std::size_t at = 0;
    for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        surface::ComplexCell cell{-1, {}};
        surface::PrescribedTangent tangent;
        Vec3d position, direction;
        at = walker.pass(at, [&](const PlyProperty& property, std::size_t begin, std::size_t items) {
            const char* bytes = body.data() + begin;
            if (property.isList) {
                std::vector<std::uint32_t>& list = ofCells ? cell.boundary : tangent.cells;
                if (property.name == (ofCells ? "boundary" : "cells"))
                    for (std::size_t k = 0; k < items; ++k)
                        list.push_back(
                            numberIn(property, bytes + sizeOf(property.countType) + k * sizeOf(property.type)));
                return;
            }
            if (property.name == "dimension")
                cell.dimension = static_cast<int>(std::min<std::uint32_t>(numberIn(property, bytes), 99));
            if (property.name == "at")
                tangent.at = numberIn(property, bytes);
            for (std::size_t k = 0; k < 3; ++k) {
                if (property.name == std::string_view("xyz").substr(k, 1))
                    position[k] = loadReal(property.type, bytes, false);
                if (property.name == std::string("n") + "xyz"[k])
                    direction[k] = loadReal(property.type, bytes, false);
            }
        });
        if (ofCells) {
            m_connectivity.cells.push_back(std::move(cell));
            continue;
        }
        tangent.direction = base::cast<float>(normalized(direction));
        m_connectivity.tangents.push_back(std::move(tangent));
        m_positions.push_back(position);
    }
}

surface::Connectivity PlyComplex::made(const FileBytes& file, const Vec3d& origin) const {
    surface::Connectivity out = m_connectivity;
    for (std::size_t i = 0; i < out.tangents.size(); ++i) {
        out.tangents[i].position = base::cast<float>(m_positions[i] - origin);
        if (!base::isFinite(out.tangents[i].position) || out.tangents[i].direction == base::Vec3f{})
            file.fail("tangent " + std::to_string(i) + " of the complex has no place or no direction",
                      "correct the file's element complex_tangent");
    }
    try {
        requireSound(out);
    } catch (const base::Error& error) {
        throw base::Error(error.message(), file.path().string());
    }
    return out;
}

std::string complexDeclaration(const surface::Connectivity* connectivity) {
    if (!connectivity)
        return {};
    std::string out = cellsDeclared(connectivity->cells.size()).declaration();
    if (!connectivity->tangents.empty())
        out += tangentsDeclared(connectivity->tangents.size()).declaration();
    return out;
}

namespace {

template <class T>
void append(std::string& out, T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out.append(bytes, sizeof bytes);
}

void append(std::string& out, const std::vector<std::uint32_t>& list) {
    append(out, static_cast<std::uint32_t>(list.size()));
    for (const std::uint32_t each : list)
        append(out, each);
}

} // namespace

std::string complexBody(const surface::Connectivity* connectivity, const Vec3d& origin) {
    std::string out;
    if (!connectivity)
        return out;
    for (const surface::ComplexCell& cell : connectivity->cells) {
        append(out, static_cast<std::uint8_t>(cell.dimension));
        append(out, cell.boundary);
    }
    for (const surface::PrescribedTangent& tangent : connectivity->tangents) {
        append(out, tangent.at);
        append(out, tangent.cells);
        for (std::size_t k = 0; k < 3; ++k)
            append(out, static_cast<double>(tangent.position[k]) + origin[k]);
        for (std::size_t k = 0; k < 3; ++k)
            append(out, tangent.direction[k]);
    }
    return out;
}

} // namespace io
