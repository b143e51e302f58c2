// Which column of a record is what, by its name (io/README 3): a fixed channel of a surfel, or a further attribute.
#pragma once

#include "core/io/record_table.h"

#include <array>

namespace io {

/// Indices into the fields of a table; `none` where the file has no such column.
struct RecordRoles {
    static constexpr int none = -1;
    std::array<int, 3> position{none, none, none};
    std::array<int, 3> normal{none, none, none};
    std::array<int, 4> colour{none, none, none, none}; ///< red, green, blue, alpha
    std::array<int, 3> local{none, none, none};        ///< our own: exact position relative to the origin
    int support = none;
    int mask = none;
    std::vector<int> attributes; ///< all others, in their order

    bool hasNormals() const { return normal[0] != none; }
    bool hasColours() const { return colour[0] != none; }
    bool hasLocals() const { return local[0] != none; }
};

/// Names of the colour channel in what we write.
constexpr const char* channelColours[4] = {"red", "green", "blue", "alpha"};
/// Names that the native format adds where an origin makes double coordinates too coarse for the floats inside.
constexpr const char* localNames[3] = {"local_x", "local_y", "local_z"};

/// Whether the writers use the name for a fixed channel, in any case of letters.
bool isChannelName(const std::string& name);

/// By the names that scanners and mesh programs use, in any case. Normals and colours count only when all three of
/// them are there. `native`: the file is ours, so that local_x, local_y, local_z are the exact positions.
RecordRoles rolesOf(const std::vector<Field>& fields, bool native);

} // namespace io
