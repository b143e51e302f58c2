// What the interface asks of the model thread, in order. Pointer input that arrives faster than dabs can be done is
// merged here into one piece of path, before it is recorded, so that it never queues up; see also
// sculpt/stroke/stroke_pacer.h.
//
// Threads: `push` and `close` from any, `pop` from the one that works.
#pragma once

#include "core/sculpt/stroke/stroke.h"
#include "core/session/command.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <variant>
#include <vector>

namespace ui {

/// What a command means to a stroke that is still being resampled (model_worker.h).
enum class CommandKind { Other, Undo, Redo };
/// Work on the document through commands; `then` is called on the interface's thread with its success.
struct CommandTask {
    std::function<void(session::Context&)> work;
    std::function<void(bool done)> then;
    CommandKind kind = CommandKind::Other;
};
/// Work on the present version that does not change the model, such as exporting an image.
struct SideTask {
    std::string what;
    std::function<void(const surface::Surface&, const base::Progress&)> work;
    std::function<void(bool done)> then;
};
struct BeginStroke {
    sculpt::StrokeSettings settings;
    /// Set by whoever cancels this stroke, which then ends between two dabs. Not null.
    std::shared_ptr<std::atomic<bool>> cancelled = std::make_shared<std::atomic<bool>>(false);
};
/// A piece of the pointer's way.
struct AddSamples {
    std::vector<sculpt::StrokeSample> samples;
    std::uint64_t input = 0; ///< the pointer event of the last, as the interface counts them
};
struct EndStroke {};
struct CancelStroke {};
using Task = std::variant<CommandTask, SideTask, BeginStroke, AddSamples, EndStroke, CancelStroke>;

class TaskQueue {
  public:
    /// Samples of the piece that waits, at most; beyond it every second one is dropped, its first and the newest never.
    static constexpr std::size_t maxWaitingSamples = 64;

    /// Samples join the piece that waits behind all else; a cancelled stroke's piece goes. Returns by how many fewer
    /// tasks wait than if it had simply been put behind them.
    std::size_t push(Task task);
    /// Waits for the next task; empty once the queue is closed, whatever is still in it.
    std::optional<Task> pop();
    /// Nothing waits, and it is open: time for work that nobody waits for.
    bool idle() const;
    void close();

  private:
    mutable std::mutex m_mutex;
    std::condition_variable m_filled;
    std::deque<Task> m_tasks;
    bool m_closed = false;
};

} // namespace ui
