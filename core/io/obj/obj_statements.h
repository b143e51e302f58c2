// What the lines of a Wavefront OBJ file say, one at a time; obj_reader.cpp makes vertices and faces of it.
#pragma once

#include "core/io/text/text_lines.h"

#include <cstdint>
#include <string>

namespace io {

enum class Statement { Other, Vertex, Normal, Texture, Face, Material, Library };

inline void skipBlanks(std::string_view& line) {
    while (!line.empty() && isBlank(line.front()))
        line.remove_prefix(1);
}

/// What a line says; `line` becomes what follows the word.
Statement takeStatement(std::string_view& line);

/// Up to `most` numbers; returns how many there were.
std::size_t takeNumbers(std::string_view line, double* out, std::size_t most);

/// What a corner's number says of `total`: from 1, or back from the last one so far; false where it is none of them.
bool takeIndex(std::string_view text, std::size_t sofar, std::size_t total, std::uint32_t& to);

/// Lines that end in a backslash go on in the next: both characters become blanks. Empty where there are none.
std::string joinedLines(std::string_view text);

} // namespace io
