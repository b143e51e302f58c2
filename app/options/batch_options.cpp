#include "app/options/batch_options.h"

#include "app/batch_plan.h"
#include "app/options/output_names.h"
#include "app/usage_error.h"
#include "core/base/error.h"
#include "core/io/file_name.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace app {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

void addBatchOptions(OptionSet command, BatchOptions& options) {
    command.add("MORE", options.more, "with --into: further inputs, each done by itself").group("Many files");
    command
        .add("--into", options.into,
             "do this for every file that is named, all of which are then inputs, and write each under its own name "
             "into this folder; one that fails does not end the rest")
        .typeName("FOLDER")
        .group("Many files");
    command.add("--as", options.as, "format of what is written, as its extension [the input's where it can be written]")
        .typeName("EXT")
        .group("Many files");
    command
        .add("--plan", options.plan,
             "write what would be done instead of doing it: commands, inputs and outputs as JSON; Snakefile or "
             "*.smk: for Snakemake; *.sh: an array job for Slurm")
        .typeName("PLAN.json|Snakefile|JOB.sh")
        .group("Many files");
    command.addFlag("--json", options.json, "print the table of what was done as JSON").group("Many files");
}

void requireNoBatch(const BatchOptions& options) {
    if (!options.more.empty())
        throw UsageError("more files than one input and one output; name a folder with --into to do all of them");
    if (!options.as.empty() || !options.plan.empty() || options.json)
        throw UsageError("--as, --plan and --json go with --into");
}

void requireOneOutput(const BatchOptions& options, const std::string& out) {
    if (options.wanted())
        throw UsageError("-o writes one file, --into many; give one of them");
    if (out.empty())
        throw UsageError("-o,--output is required: the file to write");
    requireNoBatch(options);
}

/// "a" of "b/a.ply.gz" and "sample-a" of "sample:a:500".
static std::string stemOf(const std::string& in) {
    fs::path name = fs::path(in).filename();
    if (name.extension() == ".gz")
        name = name.stem();
    std::string out = name.stem().string();
    std::replace(out.begin(), out.end(), ':', '-');
    return out;
}

static std::string outputOf(const std::string& in, const BatchOptions& options, const BatchOutputs& outputs) {
    std::string extension = options.as;
    if (extension.starts_with('.'))
        extension.erase(0, 1);
    if (extension.empty() && outputs.keepsFormat && outputs.writes(in))
        extension = io::extensionOf(in);
    if (extension.empty())
        extension = outputs.fallback;
    return (fs::path(options.into) / (stemOf(in) + "." + extension)).string();
}

static std::vector<BatchJob> jobsOf(const std::vector<std::string>& inputs, const BatchOptions& options,
                                    const BatchOutputs& outputs) {
    std::vector<BatchJob> jobs;
    std::set<std::string> names;
    for (const std::string& in : inputs) {
        const BatchJob job{in, outputOf(in, options, outputs)};
        if (!outputs.writes(job.out))
            throw UsageError("--as: '" + options.as + "' is no format that can be written");
        if (!names.insert(job.out).second)
            throw UsageError("--into: two inputs would become " + job.out + "; put them into folders of their own");
        jobs.push_back(job);
    }
    std::map<fs::path, std::string> read;
    for (const std::string& in : inputs)
        read.emplace(placeOf(in), in);
    for (const BatchJob& job : jobs)
        if (const auto at = read.find(placeOf(job.out)); at != read.end())
            throw UsageError("--into: " + at->second + " would be written over; name another folder");
    return jobs;
}

/// Its row of the table: whether and how long, and why not.
static ordered_json done(const BatchJob& job, const std::function<ordered_json(const BatchJob&)>& work) {
    const auto begun = std::chrono::steady_clock::now();
    ordered_json row{{"input", job.in}, {"output", job.out}, {"ok", true}};
    try {
        const ordered_json report = work(job);
        if (!report.empty())
            row["report"] = report;
    } catch (const base::Cancelled&) {
        throw;
    } catch (const std::bad_alloc&) {
        row["ok"] = false;
        row["error"] = "there is not enough memory for it";
    } catch (const std::exception& error) {
        row["ok"] = false;
        row["error"] = error.what();
    }
    row["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return row;
}

static std::string textOf(const ordered_json& rows) {
    std::ostringstream out;
    out.precision(3);
    for (const ordered_json& row : rows)
        if (row.at("ok").get<bool>())
            out << "done    " << row.at("input").get<std::string>() << " -> " << row.at("output").get<std::string>()
                << ", " << row.at("seconds").get<double>() << " s\n";
        else
            out << "failed  " << row.at("input").get<std::string>() << ": " << row.at("error").get<std::string>()
                << '\n';
    return out.str();
}

void runBatch(const char* name, OptionSet command, const BatchOptions& options, std::vector<std::string> inputs,
              const BatchOutputs& outputs, Console& console, const std::function<ordered_json(const BatchJob&)>& work) {
    inputs.insert(inputs.end(), options.more.begin(), options.more.end());
    std::erase(inputs, "");
    if (inputs.empty())
        throw UsageError("--into: no file is named");
    const std::vector<BatchJob> jobs = jobsOf(inputs, options, outputs);
    if (!options.plan.empty())
        return writePlan(options.plan, planOf(name, command.given(), jobs));
    std::error_code refused;
    fs::create_directories(options.into, refused);
    if (refused)
        throw base::Error("cannot be made: " + refused.message(), options.into, "name a folder that can be written");
    ordered_json rows = ordered_json::array();
    std::size_t failed = 0;
    for (const BatchJob& job : jobs) {
        console.tell(std::to_string(rows.size() + 1) + " of " + std::to_string(jobs.size()) + ": " + job.in);
        rows.push_back(done(job, work));
        failed += !rows.back().at("ok").get<bool>();
    }
    console.clear();
    if (options.json)
        std::cout << ordered_json{{"jobs", rows}, {"done", jobs.size() - failed}, {"failed", failed}}.dump(
                         2, ' ', false, ordered_json::error_handler_t::replace)
                  << "\n";
    else
        std::cout << textOf(rows);
    if (failed > 0)
        throw base::Error(std::to_string(failed) + " of " + std::to_string(jobs.size()) + " files failed", options.into,
                          "the table tells why; the others are done");
}

} // namespace app
