#include "ui/work/command_preview.h"

#include "core/base/cancel_scope.h"
#include "core/reduce/watch.h"
#include "ui/words/words.h"
#include "ui/work/floaters.h"
#include "ui/work/post.h"

#include <bit>
#include <chrono>
#include <optional>
#include <QPointer>
#include <thread>
#include <unordered_set>

namespace ui {

namespace {

using Clock = std::chrono::steady_clock;
/// So many rounds of floaters are waited for, or a search for an error would take minutes.
constexpr int unhurried = 30;

struct PlaceHash {
    std::size_t operator()(const base::Vec3f& p) const {
        std::uint64_t h = 0;
        for (const float each : {p.x, p.y, p.z})
            h = (h ^ std::bit_cast<std::uint32_t>(each)) * 0x9E3779B97F4A7C15u;
        return static_cast<std::size_t>(h ^ (h >> 29));
    }
};

template <class Fn>
void forEachPlace(const tree::SurfelTree& tree, const Fn& fn) {
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            fn(block.position(slot));
    });
}

} // namespace

std::vector<base::Vec3d> goneFrom(const tree::SurfelTree& before, const tree::SurfelTree& after, std::size_t most) {
    if (after.size() >= before.size())
        return {};
    std::unordered_set<base::Vec3f, PlaceHash> stays;
    stays.reserve(after.size());
    forEachPlace(after, [&](const base::Vec3f& p) { stays.insert(p); });
    std::vector<base::Vec3d> out;
    forEachPlace(before, [&](const base::Vec3f& p) {
        if (!stays.contains(p))
            out.push_back(base::cast<double>(p));
    });
    if (out.size() + after.size() > before.size()) // some have moved
        return {};
    const std::size_t step = out.size() / most + 1;
    for (std::size_t i = 0; i * step < out.size(); ++i)
        out[i] = out[i * step];
    out.resize((out.size() + step - 1) / step);
    return out;
}

CommandPreview::CommandPreview(Editor& editor, QObject* parent) : QObject(parent), m_editor(editor) {
    m_worker = std::make_unique<LatestWorker<Wanted>>(
        [this](const Wanted& wanted, const base::Progress& progress) { make(wanted, progress); },
        [](const std::exception&) {}); // told by make
}

CommandPreview::~CommandPreview() {
    m_worker.reset();
}

void CommandPreview::want(const nlohmann::json& command) {
    cancel();
    const auto copy = std::make_shared<session::Document>(); // set by the model thread before it is told to be done
    m_editor.copyDocument(copy, [this, alive = QPointer<CommandPreview>(this), copy, command, wish = m_wish](bool) {
        if (alive && wish == m_wish)
            m_worker->request({*copy, command, wish, m_roundMs}, true);
    });
}

void CommandPreview::cancel() {
    ++m_wish;
    m_worker->cancel();
}

template <class Call>
void CommandPreview::answer(std::uint64_t wish, Call call) {
    post(this, [this, wish, call = std::move(call)] {
        if (wish == m_wish)
            call();
    });
}

/// On the worker's thread.
void CommandPreview::make(const Wanted& wanted, const base::Progress& progress) {
    const base::CancelScope scope(progress.cancel);
    const auto told = [this, wish = wanted.wish](double share, std::string_view doing) {
        answer(wish, [this, share, what = spoken(doing, "progress")] { Q_EMIT progressed(share, what); });
    };
    session::Document document = wanted.document;
    session::Context context{document, {}, {told, progress.cancel}, {}, 0, {}};
    session::ShownScene beside;
    std::optional<Snapshot> before; // few commands ask
    const reduce::WatchScope watched(
        [&, next = Clock::time_point(), rounds = 0](const reduce::Sites& floaters) mutable {
            if (rounds >= unhurried && Clock::now() < next)
                return;
            next = Clock::now() + std::chrono::milliseconds(wanted.roundMs);
            if (!before)
                before = snapshotOf(wanted.document, beside);
            answer(wanted.wish, [this, shown = withFloaters(*before, floaters)] { Q_EMIT spread(shown); });
            if (++rounds <= unhurried)
                std::this_thread::sleep_until(next);
        });
    try {
        session::run(context, wanted.command);
        Previewed found{snapshotOf(document, beside), {}, {}};
        found.gone = goneFrom(wanted.document.surface().tree(), document.surface().tree(), mostShown);
        QStringList said;
        for (const std::string& each : context.messages)
            said << spokenMessage(each);
        found.said = said.join('\n');
        answer(wanted.wish, [this, found] { Q_EMIT shown(found); });
    } catch (const base::Cancelled&) {
        throw;
    } catch (const std::exception& error) {
        answer(wanted.wish, [this, why = spokenMessage(textOf(error).toStdString())] { Q_EMIT failed(why); });
    }
}

} // namespace ui
