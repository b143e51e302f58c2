#include "app/options/output_names.h"

#include "app/usage_error.h"
#include "core/io/before_writing.h"

namespace app {

std::filesystem::path placeOf(const std::string& name) {
    std::error_code failed;
    const std::filesystem::path place = std::filesystem::absolute(name, failed).lexically_normal();
    const std::filesystem::path known = std::filesystem::weakly_canonical(place, failed);
    return failed ? place : known;
}

bool samePlace(const std::string& a, const std::string& b) {
    std::error_code unequal;
    return std::filesystem::equivalent(a, b, unequal) || placeOf(a) == placeOf(b);
}

/// Pipes, terminals, /dev/null.
static bool takesAll(const std::string& name) {
    std::error_code unknown;
    return std::filesystem::is_other(name, unknown);
}

void requireOutputs(std::initializer_list<OutputName> outputs) {
    for (const OutputName& output : outputs)
        if (!output.file.empty()) {
            if (output.file == "-")
                throw UsageError(std::string(output.option) +
                                 " needs the name of a file; what has no format to choose also goes to /dev/stdout");
            io::requireFolder(output.file, output.file);
        }
    for (const OutputName& a : outputs)
        for (const OutputName& b : outputs)
            if (&a < &b && !a.file.empty() && !b.file.empty() && !takesAll(a.file) && samePlace(a.file, b.file))
                throw UsageError(std::string(a.option) + " and " + b.option + " name one file, " + a.file +
                                 "; give each a name of its own");
}

void requireInputsKept(std::initializer_list<OutputName> outputs, std::initializer_list<std::string> inputs) {
    for (const OutputName& output : outputs)
        for (const std::string& input : inputs)
            if (!output.file.empty() && !takesAll(output.file) && samePlace(output.file, input))
                throw UsageError(std::string(output.option) + " names " + input +
                                 ", which is read and would be replaced; choose another name");
}

} // namespace app
