#include "core/io/record_roles.h"

#include "core/io/file_name.h"

#include <algorithm>
#include <span>

namespace io {

namespace {

/// Finds columns by name and remembers which are taken.
class Columns {
  public:
    explicit Columns(const std::vector<Field>& fields) : m_taken(fields.size(), false) {
        for (const Field& field : fields)
            m_names.push_back(lowerCase(field.name));
    }
    int take(const std::string& name) {
        for (std::size_t i = 0; i < m_names.size(); ++i)
            if (!m_taken[i] && m_names[i] == name) {
                m_taken[i] = true;
                return static_cast<int>(i);
            }
        return RecordRoles::none;
    }
    /// All of the names or none of them.
    bool takeAll(std::span<const char* const> names, std::span<int> out) {
        for (const char* name : names)
            if (std::find(m_names.begin(), m_names.end(), name) == m_names.end())
                return false;
        for (std::size_t k = 0; k < names.size(); ++k)
            out[k] = take(names[k]);
        return true;
    }
    std::vector<int> rest() const {
        std::vector<int> out;
        for (std::size_t i = 0; i < m_taken.size(); ++i)
            if (!m_taken[i])
                out.push_back(static_cast<int>(i));
        return out;
    }

  private:
    std::vector<std::string> m_names;
    std::vector<bool> m_taken;
};

constexpr const char* normalNames[][3] = {
    {"nx", "ny", "nz"}, {"normal_x", "normal_y", "normal_z"}, {"normalx", "normaly", "normalz"}};
constexpr const char* colourNames[][4] = {{"red", "green", "blue", "alpha"},
                                          {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
                                          {"r", "g", "b", "a"}};

} // namespace

bool isChannelName(const std::string& name) {
    static constexpr std::string_view names[] = {
        "x",     "y",    "z",     "nx",      "ny",      "nz",      "red",
        "green", "blue", "alpha", "local_x", "local_y", "local_z", "support_radius",
        "mask"};
    return std::find(std::begin(names), std::end(names), lowerCase(name)) != std::end(names);
}

RecordRoles rolesOf(const std::vector<Field>& fields, bool native) {
    Columns columns(fields);
    RecordRoles roles;
    for (std::size_t k = 0; k < 3; ++k)
        roles.position[k] = columns.take(std::string(1, "xyz"[k]));
    for (const auto& names : normalNames)
        if (columns.takeAll(names, roles.normal))
            break;
    for (const auto& names : colourNames)
        if (columns.takeAll(std::span(names).first(3), std::span(roles.colour).first(3))) {
            roles.colour[3] = columns.take(names[3]);
            break;
        }
    const bool complete =
        std::find(roles.position.begin(), roles.position.end(), RecordRoles::none) == roles.position.end();
    if (native && complete)
        columns.takeAll(localNames, roles.local);
    roles.support = columns.take("support_radius");
    // An integer mask is some program's label, not our share between free and protected.
    const int mask = columns.take("mask");
    if (mask != RecordRoles::none && surfel::isReal(fields[static_cast<std::size_t>(mask)].declared))
        roles.mask = mask;
    roles.attributes = columns.rest();
    if (mask != RecordRoles::none && roles.mask == RecordRoles::none)
        roles.attributes.insert(std::lower_bound(roles.attributes.begin(), roles.attributes.end(), mask), mask);
    return roles;
}

} // namespace io
