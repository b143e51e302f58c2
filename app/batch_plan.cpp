#include "app/batch_plan.h"

#include "app/usage_error.h"
#include "core/base/error.h"
#include "core/io/safe_file.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace app {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::vector<PlannedJob> planOf(const std::string& name, const std::vector<std::string>& given,
                               const std::vector<BatchJob>& jobs) {
    std::vector<std::string> options;
    for (const std::string& each : given)
        if (!each.starts_with("--into=") && !each.starts_with("--as=") && !each.starts_with("--plan=") &&
            each != "--json")
            options.push_back(each);
    const bool positional = name == "clean" || name == "convert"; // IN OUT; else MODEL -o OUT
    std::vector<PlannedJob> out;
    for (const BatchJob& job : jobs) {
        std::string number = std::to_string(out.size() + 1);
        number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
        PlannedJob planned{name + "_" + number, {"pointclay", name, job.in}, {job.in}, {job.out}, {}};
        if (!positional)
            planned.command.push_back("-o");
        planned.command.push_back(job.out);
        planned.command.insert(planned.command.end(), options.begin(), options.end());
        if (job.in.starts_with("sample:"))
            planned.inputs.clear(); // no file
        out.push_back(std::move(planned));
    }
    return out;
}

/// As a shell reads it back.
static std::string quoted(const std::string& word) {
    std::string out = "'";
    for (const char c : word)
        out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}

/// The output's folder has to be there first.
static std::string shellOf(const PlannedJob& job) {
    std::string out = "mkdir -p " + quoted(fs::path(job.outputs[0]).parent_path().string()) + " &&";
    for (const std::string& word : job.command)
        out += " " + (word == "pointclay" ? word : quoted(word));
    return out;
}

/// Throws base::Error for names of files that JSON cannot tell.
static std::string textOf(const ordered_json& value, int indent = -1) {
    try {
        return value.dump(indent);
    } catch (const ordered_json::type_error&) {
        throw base::Error("a file's name is not UTF-8, in which plans are written", "--plan",
                          "name the file otherwise");
    }
}

static std::string jsonText(const std::vector<PlannedJob>& plan) {
    ordered_json jobs = ordered_json::array();
    for (const PlannedJob& job : plan)
        jobs.push_back({{"id", job.id},
                        {"command", job.command},
                        {"inputs", job.inputs},
                        {"outputs", job.outputs},
                        {"needs", job.needs}});
    return textOf(ordered_json{{"jobs", jobs}}, 2) + "\n";
}

/// Strings of JSON are such of Python; braces stand for Snakemake's own words unless they are doubled.
static std::string snakeText(const std::vector<PlannedJob>& plan) {
    const auto list = [](const std::vector<std::string>& names) {
        std::string out;
        for (const std::string& name : names) {
            if (name.find_first_of("{}") != std::string::npos) // they would be wildcards
                throw UsageError("--plan: Snakemake takes no file names with braces, as " + name +
                                 "; name it otherwise");
            out += (out.empty() ? "" : ", ") + textOf(ordered_json(name));
        }
        return out;
    };
    const auto doubled = [](const std::string& text) {
        std::string out;
        for (const char c : text)
            out += c == '{' || c == '}' ? std::string(2, c) : std::string(1, c);
        return out;
    };
    std::vector<std::string> all;
    for (const PlannedJob& job : plan)
        all.insert(all.end(), job.outputs.begin(), job.outputs.end());
    std::string out = "rule all:\n    input: " + list(all) + "\n";
    for (const PlannedJob& job : plan) {
        out += "\nrule " + job.id + ":\n";
        if (!job.inputs.empty())
            out += "    input: " + list(job.inputs) + "\n";
        out +=
            "    output: " + list(job.outputs) + "\n    shell: " + textOf(ordered_json(doubled(shellOf(job)))) + "\n";
    }
    return out;
}

/// An array job: each task is one of them. Without Slurm the number is the script's argument.
static std::string slurmText(const std::vector<PlannedJob>& plan) {
    std::string out = "#!/bin/sh\n#SBATCH --array=0-" + std::to_string(plan.size() - 1) +
                      "\nset -eu\ncase \"${SLURM_ARRAY_TASK_ID:-${1:?number of a job}}\" in\n";
    for (std::size_t k = 0; k < plan.size(); ++k)
        out += std::to_string(k) + ") " + shellOf(plan[k]) + " ;;\n";
    return out + "*) echo 'there is no job of that number' >&2; exit 2 ;;\nesac\n";
}

void writePlan(const std::string& path, const std::vector<PlannedJob>& plan) {
    const fs::path name = fs::path(path).filename();
    if (name.extension() == ".json")
        io::writeFile(path, jsonText(plan));
    else if (name == "Snakefile" || name.extension() == ".smk")
        io::writeFile(path, snakeText(plan));
    else if (name.extension() == ".sh")
        io::writeFile(path, slurmText(plan));
    else
        throw UsageError("--plan: the file's name must end in .json, .smk or .sh, or be Snakefile");
}

} // namespace app
