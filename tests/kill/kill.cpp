// pointclay_kill PROGRAM [COUNT [SEED]]: ends the program by SIGKILL at random moments of sessions, saves over an
// existing file, conversions and meshes, and looks at what is left: every target is the old or the new file, whole; a
// journal brings back all but the command in progress; what was begun goes with the next run.
#include "core/base/random.h"
#include "support/campaign_arguments.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Seconds = std::chrono::duration<double>;
using Words = std::vector<std::string>;

constexpr int strokes = 6;

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "pointclay_kill: %s\n", what.c_str());
    std::exit(1);
}

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The program at work in the current folder, silent.
pid_t started(const std::string& program, const Words& arguments) {
    const pid_t child = ::fork();
    if (child != 0)
        return child;
    const int none = ::open("/dev/null", O_RDWR);
    for (const int stream : {0, 1, 2})
        ::dup2(none, stream);
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& each : arguments)
        words.push_back(const_cast<char*>(each.c_str()));
    words.push_back(nullptr);
    ::execv(program.c_str(), words.data());
    ::_exit(127);
}

/// To its end; the exit code, -1 for any other end.
int run(const std::string& program, const Words& arguments) {
    int status = 0;
    ::waitpid(started(program, arguments), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Something to be killed at, and what must hold then.
struct Work {
    const char* name;
    Words arguments;
    fs::path target; ///< old or new, whole
    std::string before, after;
    double seconds = 0; ///< that it takes
    int killed = 0, old = 0;
};

class Campaign {
  public:
    Campaign(std::string program, std::uint64_t seed) : m_program(std::move(program)), m_random(seed) {}

    void prepare() {
        succeed({"convert", "sample:knot:60000", "model.ply"});
        succeed({"convert", "sample:sphere:3000", "old.ply"});
        std::ofstream session("session.jsonl");
        session << R"({"op":"new","sample":"sphere","count":20000})"
                << "\n";
        for (int k = 1; k <= strokes; ++k)
            session << R"({"op":"stroke","tool":"draw","radius":0.3,"samples":[[)" << 0.1 * k
                    << R"(,-0.3,3,0,0,-1,1,0],[0,0.3,3,0,0,-1,1,0.2]]})"
                    << "\n"
                    << R"({"op":"save","path":"state)" << k << R"(.ply"})"
                    << "\n";
        session.close();
        std::ofstream("over.jsonl") << R"({"op":"open","path":"over.ply"})"
                                    << "\n"
                                    << R"({"op":"stroke","tool":"clay","radius":0.3,"samples":[[0,0,3,0,0,-1,1,0]]})"
                                    << "\n"
                                    << R"({"op":"save","path":"over.ply"})"
                                    << "\n";
        add("session", {"run", "session.jsonl", "--journal", "journal.jsonl", "--threads", "1"}, "", "");
        for (int k = 1; k <= strokes; ++k)
            m_states.push_back(contentOf(state(k)));
        add("save over", {"run", "over.jsonl", "--journal", "over-journal.jsonl"}, "over.ply", "model.ply");
        add("convert", {"convert", "model.ply", "converted.ply"}, "converted.ply", "old.ply");
        add("mesh", {"mesh", "sample:sphere:8000", "-o", "mesh.ply"}, "mesh.ply", "old.ply");
    }

    void killOnce() {
        Work& work = m_works[m_random.below(m_works.size())];
        restore(work);
        const double wait = m_random.uniform(0, 1.1 * work.seconds);
        const pid_t child = started(m_program, work.arguments);
        std::this_thread::sleep_for(Seconds(wait));
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        ++m_count;
        work.killed += WIFSIGNALED(status) ? 1 : 0;
        if (!work.target.empty())
            checkTarget(work, wait);
        else
            checkJournal(work, wait);
    }

    /// A whole run takes away what killed ones had begun.
    void checkLeftovers() {
        for (Work& work : m_works) {
            restore(work);
            succeed(work.arguments);
        }
        for (const auto& each : fs::directory_iterator("."))
            if (const std::string name = each.path().filename();
                name.starts_with(".") || name.find(".new-") != std::string::npos)
                fail("left behind: " + name);
    }

    void tell() const {
        for (const Work& work : m_works)
            std::printf("%-10s killed %4d, target still old %4d\n", work.name, work.killed, work.old);
        std::printf("%d kills, %d journals recovered, none lost more than the command in progress\n", m_count,
                    m_recovered);
    }

  private:
    static fs::path state(int k) { return "state" + std::to_string(k) + ".ply"; }

    void succeed(const Words& arguments) const {
        if (run(m_program, arguments) != 0)
            fail("fails without any kill: " + arguments.front());
    }

    void add(const char* name, Words arguments, const fs::path& target, const fs::path& old) {
        Work work{name, std::move(arguments), target, {}, {}};
        if (!target.empty())
            work.before = contentOf(old);
        restore(work);
        const auto begin = std::chrono::steady_clock::now();
        succeed(work.arguments);
        work.seconds = Seconds(std::chrono::steady_clock::now() - begin).count();
        if (!target.empty())
            work.after = contentOf(target);
        m_works.push_back(std::move(work));
    }

    void restore(const Work& work) const {
        for (int k = 1; k <= strokes; ++k)
            fs::remove(state(k));
        for (const char* journal : {"journal.jsonl", "over-journal.jsonl"}) // whose sessions did not end
            fs::remove(journal);
        if (!work.target.empty())
            std::ofstream(work.target, std::ios::binary) << work.before;
    }

    void checkTarget(Work& work, double wait) {
        const std::string content = contentOf(work.target);
        work.old += content == work.before ? 1 : 0;
        if (content != work.before && content != work.after)
            fail(std::string(work.name) + ": not whole when killed after " + std::to_string(wait) + " s");
    }

    /// A state that was saved was journalled before; the stroke after it may be, too.
    void checkJournal(Work& work, double wait) {
        int done = 0;
        while (done < strokes && fs::exists(state(done + 1)))
            ++done;
        for (int k = 1; k <= done; ++k)
            if (contentOf(state(k)) != m_states[static_cast<std::size_t>(k - 1)])
                fail("a saved state is not whole");
        work.old += done == 0 ? 1 : 0;
        fs::remove("recovered.ply");
        const int code = run(m_program, {"recover", "journal.jsonl", "-o", "recovered.ply"});
        if (code != 0 && (code != 1 || done > 0))
            fail("a journal that holds " + std::to_string(done) + " strokes cannot be recovered, killed after " +
                 std::to_string(wait) + " s");
        if (code != 0 || done == 0)
            return;
        ++m_recovered;
        const std::string content = contentOf("recovered.ply");
        const auto at = static_cast<std::size_t>(done - 1);
        if (content != m_states[at] && (done == strokes || content != m_states[at + 1]))
            fail("more than the command in progress is lost, killed after " + std::to_string(wait) + " s");
    }

    std::string m_program;
    base::Random m_random;
    std::vector<Work> m_works;
    std::vector<std::string> m_states; ///< as an undisturbed session saves them
    int m_count = 0, m_recovered = 0;
};

} // namespace

int main(int argc, char** argv) {
    const test::CampaignArguments arguments(argc, argv, "pointclay_kill PROGRAM [COUNT [SEED]]", 1);
    const std::string program = fs::canonical(arguments.word(1));
    const int count = arguments.number(2, 1000);
    const std::uint64_t seed = arguments.number<std::uint64_t>(3, 1);
    std::string folder = (fs::temp_directory_path() / "pointclay-kill-XXXXXX").string();
    if (!::mkdtemp(folder.data()))
        fail("no place for files");
    fs::current_path(folder);
    ::setenv("XDG_STATE_HOME", folder.c_str(), 1);
    std::printf("seed %llu, in %s\n", static_cast<unsigned long long>(seed), folder.c_str());
    Campaign campaign(program, seed);
    campaign.prepare();
    for (int k = 0; k < count; ++k)
        campaign.killOnce();
    campaign.checkLeftovers();
    campaign.tell();
    fs::current_path("/");
    fs::remove_all(folder); // kept where something was found
    return 0;
}
