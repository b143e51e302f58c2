// The program as somebody who asks for a picture sees it: from the start of its process to a frame in a file.
#include "app/bench/start_workload.h"

#include "app/bench/workload.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/process/samples/samples.h"

#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ; // NOLINT: POSIX has it so

namespace bench {

namespace {

/// A picture that goes away with its last user.
struct FrameFile {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("pointclay-bench-" + std::to_string(::getpid()) + "-start.png");
    ~FrameFile() {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
};

} // namespace

void startAndDraw(const std::filesystem::path& program, const std::filesystem::path& picture) {
    const std::string sample = std::string("sample:") + process::sampleTable().front().id;
    std::vector<std::string> words{program.string(), "render",  sample,      "-o",
                                   picture.string(), "--quiet", "--threads", std::to_string(base::threadCount())};
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    int status = 0;
    if (::posix_spawn(&child, words[0].c_str(), nullptr, nullptr, arguments.data(), environ) != 0 ||
        ::waitpid(child, &status, 0) != child || status != 0)
        throw base::Error("did not draw a frame", program.string(), "try the same by hand: render " + sample);
}

std::vector<Workload> startWorkloads() {
    const auto starting = [](Scene&) -> Run {
        const char* named = std::getenv("POINTCLAY_PROGRAM");
        const std::filesystem::path program = named ? named : std::filesystem::read_symlink("/proc/self/exe");
        return [program, frame = std::make_shared<FrameFile>()] {
            startAndDraw(program, frame->path);
            return std::size_t(1);
        };
    };
    return {{"start", "start", "from the start of the process to the first frame of the first sample, in a file", "",
             starting, nullptr, true}};
}

} // namespace bench
