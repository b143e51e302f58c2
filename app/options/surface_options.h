// The option group "Surface", the same for every subcommand: a loop over the parameters of the `surface` command.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace app {

struct SurfaceOptions {
    std::vector<std::pair<std::string, std::string>> given; ///< name and value
    std::string precision = "float";

    /// As parameters of `open` and `new`.
    nlohmann::json parameters() const;
    bool inDouble() const { return precision == "double"; }
};

/// `withPrecision`: where the subcommand can answer in float64, too.
std::shared_ptr<SurfaceOptions> addSurfaceOptions(CLI::App& command, bool withPrecision);

} // namespace app
