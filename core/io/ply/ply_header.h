// The header of a PLY file (Turk 1994; io/README 2.2). It is a claim: nothing in it is believed before the bytes are
// seen.
#pragma once

#include "core/io/file_bytes.h"
#include "core/surfel/attributes.h"

#include <vector>

namespace io {

using surfel::ScalarType;

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

struct PlyProperty {
    std::string name;
    ScalarType type = ScalarType::Float32;    ///< of the value, or of a list's items
    bool isList = false;                      ///< a count, then so many items
    ScalarType countType = ScalarType::UInt8; ///< of a list's count
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;

    bool hasLists() const;
    /// Bytes of a binary record; lists are left out.
    std::size_t scalarBytes() const;
    /// Its header lines, each ended by \n.
    std::string declaration() const;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<PlyElement> elements;
    std::vector<std::string> comments; ///< in order; "obj_info ..." lines with that word, comments without theirs
    std::size_t bodyOffset = 0;
};

/// The word of a format line: "ascii", "binary_little_endian", "binary_big_endian".
const char* nameOf(PlyEncoding encoding);
/// The words of Turk's types: "uchar", "float"...
const char* plyName(ScalarType type);

/// Lines may end in LF, CRLF or CR, and may have blanks around them. Throws base::Error naming the line.
PlyHeader parsePlyHeader(const FileBytes& file);

} // namespace io
