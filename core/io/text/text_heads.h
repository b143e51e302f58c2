// Names of columns in the head of a text file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace io {

/// Names in a line that has been parted into `fields`. Between commas or semicolons a name may hold blanks ("GPS
/// Time"); quotes are taken off.
std::vector<std::string> namesIn(std::string_view line, const std::vector<std::string_view>& fields);

/// Of a comment at the beginning of the text, x, y and z among them: "//X Y Z R G B". Else empty.
std::vector<std::string> commentNames(std::string_view text);

/// Whether it is a row of a table. Below names it may begin with a word ("id" of a point): three others are numbers.
bool isPoint(const std::vector<std::string_view>& fields, bool named);

} // namespace io
