// A MODEL as people name it on a command line: a file, or a sample made by code.
//
//     bunny.ply               the file
//     sample:torus            the sample with its own count
//     sample:torus:50000      about 50000 surfels
//     sample:scan:50000:7     and the seed 7
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace session {

/// The `open` or `new` command of a MODEL argument. Throws base::Error for a sample that is not written so.
nlohmann::json modelCommand(const std::string& argument);

} // namespace session
