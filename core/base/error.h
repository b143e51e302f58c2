// The one exception for bad files, bad arguments and bad data: what is wrong, where, and what to do about it.
//
// Broken promises between our own functions are assertions, degenerate geometry is a status value; only what a person
// can mend is an Error. It is caught at one door per program: the command executor or the command line, which prints
// `message()` and ends with exit code 1.
#pragma once

#include <stdexcept>
#include <string>

namespace base {

class Error : public std::runtime_error {
  public:
    /// `where`: file, line, parameter; may be empty. `todo`: a short clause telling the way out; may be empty.
    Error(const std::string& what, const std::string& where = {}, const std::string& todo = {})
        : std::runtime_error((where.empty() ? "" : where + ": ") + what + (todo.empty() ? "" : "; " + todo)) {}

    std::string message() const { return what(); }
};

/// Thrown by Progress::step when the person asked to stop. Nothing was changed.
class Cancelled : public std::runtime_error {
  public:
    Cancelled() : std::runtime_error("cancelled") {}
};

} // namespace base
