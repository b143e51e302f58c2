// pointclay_fuzz FOLDER [SECONDS [SEED [TARGET [NUMBER]]]]: all targets, or one, on mutations of the seeds in FOLDER
// (tests/fuzz) for so long together. Each runs in a process of its own: one that crashes, leaks or hangs is named with
// the number of its input, and the input lies in ./fuzz-findings. With a NUMBER that input alone is tried, here.
#include "fuzz/fuzzed.h"
#include "fuzz/mutations.h"
#include "fuzz/seeds.h"
#include "support/campaign_arguments.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#define FUZZ_TARGET(name) extern "C" int fuzz_##name(const std::uint8_t* data, std::size_t size);
#include "fuzz_targets.inc"
#undef FUZZ_TARGET
extern "C" int LLVMFuzzerInitialize(int*, char***);

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Target {
    std::string name;
    int (*run)(const std::uint8_t*, std::size_t);
};

constexpr Clock::duration patience = std::chrono::seconds(60); ///< of one execution, on a busy machine

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// As tests/fuzz/run chooses them, too.
std::vector<std::string> seedFolders(const std::string& target) {
    if (target == "open")
        return {"open", "ply", "xyz", "obj", "off", "stl", "pcd", "las", "laz", "e57", "ptx", "gltf", "3mf"};
    return target == "journal" ? std::vector<std::string>{"journal", "session"} : std::vector<std::string>{target};
}

fuzz::Mutations mutationsFor(const std::string& target, const fs::path& folder, const fs::path& made,
                             std::uint64_t seed) {
    std::vector<fs::path> files;
    std::error_code none;
    for (const std::string& each : seedFolders(target))
        for (const fs::path& place : {folder / "seeds" / each, made / each})
            for (const auto& file : fs::directory_iterator(place, none))
                files.push_back(file.path());
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) { // `made` is named by chance
        return std::pair(a.parent_path().filename(), a.filename()) <
               std::pair(b.parent_path().filename(), b.filename());
    });
    std::vector<std::string> seeds;
    for (const fs::path& file : files)
        seeds.push_back(contentOf(file));
    if (seeds.empty())
        seeds.emplace_back();
    const std::string words = target == "journal" ? "session.dict" : target + ".dict";
    return {std::move(seeds), fuzz::dictionaryWords(contentOf(folder / words) + contentOf(made / words)), seed};
}

/// Exactly as many bytes as there are, so that ASan sees who reads more.
void execute(const Target& target, const std::string& input) {
    const auto data = std::make_unique<std::uint8_t[]>(input.size());
    std::memcpy(data.get(), input.data(), input.size());
    target.run(data.get(), input.size());
}

/// What a process at work tells the one that watches it.
struct Board {
    std::atomic<std::uint64_t> number{0}; ///< of the input that is being tried
};

/// `work` in a process of its own, watched by `look`, which ends it by returning false. The status as waitpid's.
template <class Work, class Look>
int inProcess(const Work& work, const Look& look) {
    const pid_t child = ::fork();
    if (child < 0) {
        std::perror("fork");
        std::exit(1);
    }
    if (child == 0) {
        work();
        std::exit(0); // with a look for leaks
    }
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        if (!look())
            ::kill(child, SIGKILL);
    }
    return status;
}

class Runs {
  public:
    Runs(fs::path folder, fs::path made, std::uint64_t seed, Clock::duration each)
        : m_folder(std::move(folder)), m_made(std::move(made)), m_seed(seed), m_each(each) {
        void* const memory = ::mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        m_board = new (memory) Board;
    }

    /// False where something was found.
    bool run(const Target& target) {
        const fuzz::Mutations inputs = mutationsFor(target.name, m_folder, m_made, m_seed);
        m_board->number = 0;
        std::uint64_t last = 0;
        Clock::time_point since = Clock::now();
        bool hangs = false;
        const int status = inProcess(
            [&] {
                LLVMFuzzerInitialize(nullptr, nullptr);
                for (const auto end = Clock::now() + m_each; Clock::now() < end; ++m_board->number)
                    execute(target, inputs.input(m_board->number));
            },
            [&] {
                if (const std::uint64_t now = m_board->number; now != last)
                    last = now, since = Clock::now();
                hangs = Clock::now() - since > patience;
                return !hangs;
            });
        const std::uint64_t number = m_board->number;
        m_executions += number;
        std::printf("%-10s %9llu executions\n", target.name.c_str(), static_cast<unsigned long long>(number));
        std::fflush(stdout);
        if (status == 0)
            return true;
        keep(target, number, inputs.input(number), hangs ? "does not end" : "crashes, leaks or breaks a law");
        return false;
    }
    std::uint64_t executions() const { return m_executions; }

  private:
    void keep(const Target& target, std::uint64_t number, const std::string& input, const char* what) const {
        fs::create_directories("fuzz-findings");
        const fs::path file =
            fs::absolute("fuzz-findings") / (target.name + "-" + std::to_string(m_seed) + "-" + std::to_string(number));
        std::ofstream(file, std::ios::binary) << input;
        std::printf("FOUND: %s %s, input %s; again: pointclay_fuzz %s 0 %llu %s %llu\n", target.name.c_str(), what,
                    file.c_str(), m_folder.c_str(), static_cast<unsigned long long>(m_seed), target.name.c_str(),
                    static_cast<unsigned long long>(number));
    }

    fs::path m_folder, m_made;
    std::uint64_t m_seed;
    Clock::duration m_each;
    Board* m_board;
    std::uint64_t m_executions = 0;
};

} // namespace

int main(int argc, char** argv) {
    std::vector<Target> targets{
#define FUZZ_TARGET(name) {#name, fuzz_##name},
#include "fuzz_targets.inc"
#undef FUZZ_TARGET
    };
    const test::CampaignArguments arguments(argc, argv, "pointclay_fuzz FOLDER [SECONDS [SEED [TARGET [NUMBER]]]]", 1);
    const char* const folder = arguments.word(1);
    const double seconds = arguments.number(2, 60.0);
    const std::uint64_t seed = arguments.number<std::uint64_t>(3, 1);
    if (arguments.has(4))
        std::erase_if(targets, [&](const Target& target) { return target.name != arguments.word(4); });
    if (targets.empty()) {
        std::fprintf(stderr, "pointclay_fuzz: there is no target %s\n", arguments.word(4));
        return 2;
    }
    const fs::path memory = "/dev/shm"; // files of targets are synced, which no disk does often
    const bool quick = ::access(memory.c_str(), W_OK) == 0;
    std::string place = ((quick ? memory : fs::temp_directory_path()) / "pointclay-mutations-XXXXXX").string();
    if (!::mkdtemp(place.data())) {
        std::perror("pointclay_fuzz");
        return 1;
    }
    ::setenv("TMPDIR", place.c_str(), 1); // what killed processes leave goes with it
    const fs::path made = fs::path(place) / "seeds";
    bool good =
        inProcess([&] { fuzz::writeSeeds(made); }, [] { return true; }) == 0; // its threads stay out of the others
    if (arguments.has(5)) {
        LLVMFuzzerInitialize(nullptr, nullptr);
        execute(targets.front(),
                mutationsFor(targets.front().name, folder, made, seed).input(arguments.number<std::uint64_t>(5, 0)));
    } else {
        const std::chrono::duration<double> each(seconds / static_cast<double>(targets.size()));
        Runs runs(folder, made, seed, std::chrono::duration_cast<Clock::duration>(each));
        for (const Target& target : targets)
            good &= runs.run(target);
        std::printf("%llu executions of %zu targets, seed %llu: %s\n",
                    static_cast<unsigned long long>(runs.executions()), targets.size(),
                    static_cast<unsigned long long>(seed), good ? "nothing found" : "FOUND something");
    }
    std::error_code none;
    fs::remove_all(place, none);
    return good ? 0 : 1;
}
