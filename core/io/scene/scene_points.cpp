#include "core/io/scene/scene_points.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace io {

void ScenePoints::announce(std::size_t more) {
    constexpr std::size_t perByte = 32;
    const std::size_t most = std::min<std::size_t>(perByte * m_bytes, 0xfffffffeu);
    if (more > most - m_announced)
        m_file.fail("places its meshes so often that they have more than " + std::to_string(most) +
                        " points and values",
                    "take copies out of the scene, and open one of them");
    m_announced += more;
}

void ScenePoints::set(const std::string& column, ScalarType type, std::size_t first,
                      const std::vector<double>& values) {
    constexpr std::size_t mostColumns = 1000;
    if (m_columns.size() >= mostColumns && !m_columns.contains(column))
        m_file.fail("has more than " + std::to_string(mostColumns) + " attributes", "take some out of it");
    Column& to = m_columns.try_emplace(column, Column{type, {}}).first->second;
    if (to.type != type) // meshes that do not agree
        to.type = ScalarType::Float64;
    to.values.resize(first);
    to.values.insert(to.values.end(), values.begin(), values.end());
}

void ScenePoints::finish(FileModel& model, const ProgressSpan& progress) {
    announce(m_columns.size() * m_points.size()); // as every column goes through all points
    RecordTable table;
    table.data = reinterpret_cast<const char*>(m_points.data());
    table.stride = sizeof(ScenePoint);
    table.count = m_points.size();
    const auto add = [&](const char* name, ScalarType type, std::size_t offset) {
        table.fields.push_back({name, type, type, offset});
    };
    for (std::size_t k = 0; k < 3; ++k)
        add(std::array{"x", "y", "z"}[k], ScalarType::Float64, offsetof(ScenePoint, position) + k * sizeof(double));
    for (std::size_t k = 0; m_normals && k < 3; ++k)
        add(std::array{"nx", "ny", "nz"}[k], ScalarType::Float32, offsetof(ScenePoint, normal) + k * sizeof(float));
    for (std::size_t k = 0; m_colours && k < 4; ++k)
        add(std::array{"red", "green", "blue", "alpha"}[k], ScalarType::UInt8, offsetof(ScenePoint, colour) + k);
    for (auto& [name, column] : m_columns) {
        column.values.resize(m_points.size());
        Field field{name, ScalarType::Float64, column.type, 0};
        field.made = [values = column.values.data()](std::size_t i) { return values[i]; };
        table.fields.push_back(std::move(field));
    }
    makePoints(model, m_file, table, rolesOf(table.fields, false), {}, progress);
}

} // namespace io
