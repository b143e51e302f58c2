// How much memory a subcommand may take: "4G", "512M", "64K" or a number of bytes.
#pragma once

#include <cstdint>
#include <string>

namespace app {

/// 0 for what is no amount.
std::uint64_t bytesOf(std::string text);
/// For Option::check.
std::string memoryFault(const std::string& text);

} // namespace app
