// A batch as a plan that other programs run: every job a command of its own, with what it reads and writes. Jobs write
// their output whole or not at all, and the same bits each time, so that any of them may be run again.
#pragma once

#include "app/options/batch_options.h"

namespace app {

struct PlannedJob {
    std::string id; ///< "clean_0001"
    std::vector<std::string> command;
    std::vector<std::string> inputs, outputs;
    std::vector<std::string> needs; ///< ids of jobs that have to be done before
};

/// `given`: the options of the batch; those that make it one are left out.
std::vector<PlannedJob> planOf(const std::string& name, const std::vector<std::string>& given,
                               const std::vector<BatchJob>& jobs);

/// As JSON, for Snakemake or for Slurm, by the file's name. Throws UsageError for another one.
void writePlan(const std::string& path, const std::vector<PlannedJob>& plan);

} // namespace app
