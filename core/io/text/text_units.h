// Units of length in the head of a text file: below the names of its columns, or in brackets behind them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace io {

/// "meter", "millimeter", "centimeter", "micron", "inch" or "foot", as 3MF calls them, for "m", "[mm]", "(Meter)" or
/// "feet", in any case of letters; empty for everything else.
std::string_view unitOf(std::string_view text);

/// What stands in brackets behind a name: "X [mm]", "x(m)"; empty without.
std::string_view inBrackets(std::string_view name);

/// Whether a line below the names tells units: three of its fields are units of length. No name is one.
bool areUnits(std::span<const std::string_view> fields);

/// The unit of the columns `axes`, by the line below the names where it has one for them, else by brackets in the
/// names. Empty where none is told, nothing where they have not the same.
std::optional<std::string> unitOfAxes(const std::array<std::size_t, 3>& axes, std::span<const std::string> names,
                                      std::span<const std::string> below);

} // namespace io
