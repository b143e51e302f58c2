// The models that a command's line reads: what it names, and the copy that a journal keeps of it where the file of that
// name has been written over since. Inside this room only.
//
// A command that reads models has a parameter "source" (one) or "sources" (several, in the order of their names).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace session {

/// By the names that the complete command gives them; none for commands that read no models.
std::vector<std::string> filesNamed(const nlohmann::json& complete);
/// Where each of them is read from. As many.
std::vector<std::string> filesRead(const nlohmann::json& complete);
/// Lets the command read the one of that number from another file.
void readInstead(nlohmann::json& complete, std::size_t number, const std::string& file);

} // namespace session
