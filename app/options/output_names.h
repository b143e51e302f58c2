// The files that one call of the program writes.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>

namespace app {

struct OutputName {
    const char* option;      ///< "--report", for the message
    const std::string& file; ///< empty: not asked for
};

/// Where a name leads, without links and dots, be there a file or not; the same for all names of one place.
std::filesystem::path placeOf(const std::string& name);

/// Whether both names lead to one place, be there a file or not.
bool samePlace(const std::string& a, const std::string& b);

/// Throws UsageError where one is "-" or two of them are one file, of which the second would replace the first (devices
/// and pipes take both), and base::Error where there is no folder for one. Called before the work.
void requireOutputs(std::initializer_list<OutputName> outputs);

/// Throws UsageError where one of them is what is read: tables take the place of no model, and of no other table.
void requireInputsKept(std::initializer_list<OutputName> outputs, std::initializer_list<std::string> inputs);

} // namespace app
