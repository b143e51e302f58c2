// What the interface asks of the model thread, in order. Pointer input that arrives faster than dabs can be done is
// merged here, before it is recorded, so that it never queues up for seconds.
//
// Threads: `push` and `close` from any, `pop` from the one that works.
#pragma once

#include "core/sculpt/stroke.h"
#include "core/session/command.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <variant>

namespace ui {

/// Work on the document through commands; `then` is called on the interface's thread with its success.
struct CommandTask {
    std::function<void(session::Context&)> work;
    std::function<void(bool done)> then;
};
/// Work on the present version that does not change the model, such as exporting an image.
struct SideTask {
    std::string what;
    std::function<void(const surface::Surface&, const base::Progress&)> work;
    std::function<void(bool done)> then;
};
struct BeginStroke {
    sculpt::StrokeSettings settings;
};
struct AddSample {
    sculpt::StrokeSample sample;
};
struct EndStroke {};
struct CancelStroke {};
using Task = std::variant<CommandTask, SideTask, BeginStroke, AddSample, EndStroke, CancelStroke>;

class TaskQueue {
  public:
    /// Samples that wait at most; beyond it every second one is dropped, the first and the newest of a stroke never.
    static constexpr std::size_t maxWaitingSamples = 6;

    /// Returns how many waiting tasks were dropped for it.
    std::size_t push(Task task);
    /// Waits for the next task; empty once the queue is closed, whatever is still in it.
    std::optional<Task> pop();
    void close();

  private:
    std::mutex m_mutex;
    std::condition_variable m_filled;
    std::deque<Task> m_tasks;
    bool m_closed = false;
};

} // namespace ui
