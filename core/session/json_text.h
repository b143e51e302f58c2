// JSON that comes from outside: files, pipes, settings. Whatever the bytes are, they become a value or one sentence.
//
// Values are nested at most `deepestJson` levels, so that nobody who walks or copies one runs out of stack, and their
// numbers are finite.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace session {

/// Commands need four.
constexpr int deepestJson = 64;

/// Throws base::Error for text that is no JSON, that breaks off, is nested deeper or holds a number that no double
/// can. Its message names no place beyond the character: whoever knows the file and line adds them.
nlohmann::json jsonOf(std::string_view text);

/// A value as it can stand in a message: at most `most` characters.
std::string shortly(const nlohmann::json& value, std::size_t most = 60);

} // namespace session
