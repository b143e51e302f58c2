// What a person says of a file that it does not tell itself, as parameters of `open` and of every subcommand that reads
// a model: what the columns of a text are, in which unit it is, which way is up, and how many of its points are wanted.
// Inside this room and the command line.
#pragma once

#include "core/base/progress.h"
#include "core/io/file_model.h"
#include "core/session/command.h"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace session {

/// `columns`, `unit_scale`, `up_axis` and `thin_to`; all may be left out.
std::span<const CommandParameter> readParameters();

/// Reads a file by them. Pictures that it names are those of `folder`, its own where that is empty. What was done is
/// among the model's messages. Throws base::Error where they do not fit the file; base::Cancelled.
io::FileModel readFile(const std::filesystem::path& path, const std::filesystem::path& folder,
                       const nlohmann::json& parameters, const base::Progress& progress);

bool hasReadParameters(const nlohmann::json& parameters);

/// Throws base::Error, in the name of `where`, where any of them is given: of a sample, or of a file that only names
/// others.
void refuseReadParameters(const nlohmann::json& parameters, const std::string& where);

/// Thins points to those no closer than `spacing`, in stored units, and tells how many were left.
void thinPoints(io::FileModel& model, double spacing, const base::Progress& progress);

} // namespace session
