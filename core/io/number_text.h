// Numbers as text, without the locale: parsing that never overruns, printing that reads back to the same bits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace io {

/// Parses the number at `begin` and returns the first byte after it, or null where there is none. Understands a leading
/// '+', nan and inf in any case, and old Windows spellings such as 1.#QNAN. What is too large for a double becomes
/// infinite, what is too small becomes zero; any number of digits is correctly rounded.
const char* parseNumber(const char* begin, const char* end, double& out);

/// The whole text as a number.
std::optional<double> numberOf(std::string_view text);
/// The whole text as a count: decimal digits only.
std::optional<std::uint64_t> countOf(std::string_view text);

/// Appends the shortest text that reads back to the same value. Non-finite values are nan, inf and -inf.
void appendNumber(std::string& out, float value);
void appendNumber(std::string& out, double value);
void appendNumber(std::string& out, std::int64_t value);

} // namespace io
