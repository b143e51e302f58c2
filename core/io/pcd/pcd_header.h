// The header of a PCD file of the Point Cloud Library (io/README 2.11): what it claims, checked against itself alone.
#pragma once

#include "core/io/file_bytes.h"
#include "core/io/record_table.h"

#include <optional>

namespace io {

enum class PcdData { Ascii, Binary, Compressed };

/// What one of FIELDS says; `elements` values of one type lie side by side.
struct PcdField {
    std::string name;
    char type = 'F'; ///< I, U or F
    std::size_t size = 4;
    std::size_t elements = 1;
    std::size_t offset = 0; ///< in a record

    bool isPadding() const { return name == "_"; }
    bool isPackedColour() const { return (name == "rgb" || name == "rgba") && size == 4 && elements == 1; }
    /// Nothing for integers of 8 bytes, which have no type of their own.
    std::optional<ScalarType> scalar() const;
};

struct PcdHeader {
    std::vector<PcdField> fields;
    std::size_t width = 0, height = 1, points = 0;
    std::size_t stride = 0; ///< bytes of a record
    PcdData data = PcdData::Ascii;
    std::string viewpoint; ///< "tx ty tz qw qx qy qz" as the file has it; empty where it says nothing
    std::vector<std::string> comments;
    std::size_t bodyOffset = 0;

    /// The points are the cells of a grid of `width` columns.
    bool isGrid() const { return height > 1 && width > 1 && points == width * height; }
};

/// Throws base::Error where the header is no header or contradicts itself.
PcdHeader parsePcdHeader(const FileBytes& file);

} // namespace io
