// One key of an INI file as QSettings writes it, read without Qt.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

/// The values of `key` in `[section]`: one, or a list where commas stand outside quotes. Escapes are resolved; UTF-8
/// stays. Nothing where the key is missing. Never fails: what is malformed is read as far as it goes.
std::optional<std::vector<std::string>> iniValues(std::string_view file, std::string_view section,
                                                  std::string_view key);

} // namespace io
