// pointclay_soak [MINUTES [SEED]]: sculpts for as long as it is told, by random strokes of all tools with undo, redo,
// saving, opening and recovery, one model after the other, and looks at what stays behind: memory at rest, between two
// models, must be flat after a warm-up, every redo and recovery must bring back the same bits, and every tree be whole.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/session/command.h"
#include "core/session/journal.h"
#include "core/session/recover.h"
#include "session/random_strokes.h"
#include "support/campaign_arguments.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <malloc.h>
#include <numeric>

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Seconds = std::chrono::duration<double>;

/// In turn.
constexpr struct {
    const char* sample;
    int count;
} models[] = {{"sphere", 20000}, {"knot", 15000},  {"clay", 20000},
              {"scan", 15000},   {"torus", 20000}, {"moebius", 8000}};
constexpr int actionsPerModel = 120;
/// Memory at rest is flat where its mean over the last third of the time is at most this much above that over the
/// middle third; the first third warms up.
constexpr double slack = 1.05, slackMiB = 8;

[[noreturn]] void fail(const std::string& what) {
    std::printf("pointclay_soak: %s\n", what.c_str());
    std::exit(1);
}

/// Of this process, in MiB, what nobody holds having been given back.
double memory() {
    ::malloc_trim(0);
    std::ifstream in("/proc/self/status");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("VmRSS:"))
            return std::strtod(line.c_str() + 6, nullptr) / 1024;
    fail("the system does not tell how much memory is held");
}

struct Counts {
    int strokes = 0, refused = 0, undos = 0, redos = 0, saves = 0, opened = 0, recoveries = 0, models = 0;
};

/// One model from its making to its discarding.
class Round {
  public:
    Round(base::Random& random, Counts& counts) : m_random(random), m_counts(counts) {}

    void run() {
        const auto& model = models[static_cast<std::size_t>(m_counts.models++) % std::size(models)];
        session::run(m_context, {{"op", "new"},
                                 {"sample", model.sample},
                                 {"count", model.count},
                                 {"seed", static_cast<int>(m_random.below(1000))}});
        test::RandomStrokes strokes(m_document, m_random);
        for (int k = 0; k < actionsPerModel; ++k) {
            const std::size_t what = m_random.below(20);
            if (what < 13)
                stroke(strokes.next());
            else if (what < 17)
                undoAndRedo();
            else if (what < 18)
                save();
            else if (what < 19)
                open();
            else
                recover();
        }
        recover();
        m_journal.discard();
    }

  private:
    void stroke(const json& line) {
        ++m_counts.strokes;
        const base::Hash128 before = m_document.hash();
        try {
            session::run(m_context, line);
        } catch (const base::Error&) {
            ++m_counts.refused;
            if (!(m_document.hash() == before))
                fail("a refused stroke changed the model: " + line.dump());
        }
        m_document.surface().tree().validate();
    }
    /// Some steps back, and all or some of them forward again.
    void undoAndRedo() {
        const base::Hash128 before = m_document.hash();
        std::size_t back = 0;
        for (const std::size_t most = 1 + m_random.below(8); back < most && m_document.canUndo(); ++back)
            session::run(m_context, {{"op", "undo"}});
        const std::size_t forward = m_random.below(3) == 0 ? m_random.below(back + 1) : back;
        for (std::size_t k = 0; k < forward; ++k)
            session::run(m_context, {{"op", "redo"}});
        m_counts.undos += static_cast<int>(back), m_counts.redos += static_cast<int>(forward);
        if (forward == back && !(m_document.hash() == before))
            fail("redo leads elsewhere");
    }
    void save() {
        static constexpr const char* names[] = {"a.ply", "a.ply", "b.ply", "c.xyz", "d.obj"};
        session::run(m_context,
                     {{"op", "save"}, {"path", fs::absolute(names[m_random.below(std::size(names))]).string()}});
        ++m_counts.saves;
    }
    /// What is saved now and opened goes on as this does.
    void open() {
        const std::string file = fs::absolute("own.ply").string();
        const base::Hash128 before = m_document.hash();
        session::run(m_context, {{"op", "save"}, {"path", file}});
        session::run(m_context, {{"op", "open"}, {"path", file}});
        if (!(m_document.hash() == before))
            fail("what was opened is not what was saved");
        ++m_counts.opened;
    }
    void recover() {
        session::Document again;
        session::Context context{again, {}, {}, {}, 0, {}, nullptr};
        session::recover(m_journal.path(), context);
        if (!(again.hash() == m_document.hash()))
            fail("the journal leads elsewhere");
        ++m_counts.recoveries;
    }

    base::Random& m_random;
    Counts& m_counts;
    session::Document m_document;
    session::Journal m_journal;
    session::Context m_context{m_document, {}, {}, {}, 0, {}, &m_journal};
};

struct Rest {
    double at, memory; ///< a share of the whole time, MiB
};

double meanBetween(const std::vector<Rest>& rests, double from, double to) {
    double sum = 0;
    int count = 0;
    for (const Rest& rest : rests)
        if (rest.at >= from && rest.at <= to)
            sum += rest.memory, ++count;
    return count > 0 ? sum / count : 0;
}

bool tell(const Counts& n, const std::vector<Rest>& rests, double minutes) {
    double least = 1e9, most = 0;
    for (const Rest& rest : rests)
        if (rest.at >= 1.0 / 3)
            least = std::min(least, rest.memory), most = std::max(most, rest.memory);
    const double middle = meanBetween(rests, 1.0 / 3, 2.0 / 3), last = meanBetween(rests, 2.0 / 3, 1);
    const bool judged = rests.size() >= 2 * std::size(models) && middle > 0 && last > 0,
               flat = last <= slack * middle + slackMiB;
    std::printf(
        "%.1f minutes, %d models, %d strokes (%d refused), %d undos, %d redos, %d saves, %d opened again, %d "
        "recovered; memory at rest after the warm-up %.0f to %.0f MiB, %.1f in the middle third and %.1f in the "
        "last: %s\n",
        minutes, n.models, n.strokes, n.refused, n.undos, n.redos, n.saves, n.opened, n.recoveries, least, most, middle,
        last,
        !judged ? "too few models to judge"
        : flat  ? "flat"
                : "IT GROWS");
    return !judged || flat;
}

} // namespace

int main(int argc, char** argv) {
    const test::CampaignArguments arguments(argc, argv, "pointclay_soak [MINUTES [SEED]]", 0);
    const double minutes = arguments.number(1, 60.0);
    const std::uint64_t seed = arguments.number<std::uint64_t>(2, 1);
    std::string folder = (fs::temp_directory_path() / "pointclay-soak-XXXXXX").string();
    if (!::mkdtemp(folder.data()))
        fail("no place for files");
    fs::current_path(folder);
    ::setenv("XDG_STATE_HOME", folder.c_str(), 1);
    std::printf("seed %llu, in %s\n", static_cast<unsigned long long>(seed), folder.c_str());
    std::fflush(stdout);

    base::Random random(seed);
    Counts counts;
    std::vector<Rest> rests;
    const auto begin = std::chrono::steady_clock::now();
    const auto share = [&] { return Seconds(std::chrono::steady_clock::now() - begin).count() / (60 * minutes); };
    while (share() < 1) {
        try {
            Round(random, counts).run();
        } catch (const std::exception& error) {
            fail(std::string(error.what()) + ", model " + std::to_string(counts.models) + " of seed " +
                 std::to_string(seed));
        }
        rests.push_back({std::min(share(), 1.0), memory()});
    }
    const bool good = tell(counts, rests, minutes);
    fs::current_path("/");
    fs::remove_all(folder); // kept where something was found
    return good ? 0 : 1;
}
