#include "ui/work/task_queue.h"

namespace ui {

/// Keeps the samples 0, 2, 4, ... and the last: the first of a stroke decides its contact.
static void thin(std::vector<sculpt::StrokeSample>& samples) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (i % 2 == 0 || i + 1 == samples.size())
            samples[kept++] = samples[i];
    samples.resize(kept);
}

std::size_t TaskQueue::push(Task task) {
    std::size_t fewer = 0;
    {
        const std::lock_guard lock(m_mutex);
        auto* waiting = m_tasks.empty() ? nullptr : std::get_if<AddSamples>(&m_tasks.back());
        const auto* more = std::get_if<AddSamples>(&task);
        if (waiting && more) {
            waiting->samples.insert(waiting->samples.end(), more->samples.begin(), more->samples.end());
            waiting->input = more->input;
            while (waiting->samples.size() > maxWaitingSamples)
                thin(waiting->samples);
            return 1;
        }
        if (waiting && std::holds_alternative<CancelStroke>(task)) {
            m_tasks.pop_back();
            fewer = 1;
        }
        m_tasks.push_back(std::move(task));
    }
    m_filled.notify_one();
    return fewer;
}

std::optional<Task> TaskQueue::pop() {
    std::unique_lock lock(m_mutex);
    m_filled.wait(lock, [this] { return m_closed || !m_tasks.empty(); });
    if (m_closed)
        return {};
    std::optional<Task> out(std::move(m_tasks.front()));
    m_tasks.pop_front();
    return out;
}

bool TaskQueue::idle() const {
    const std::lock_guard lock(m_mutex);
    return m_tasks.empty() && !m_closed;
}

void TaskQueue::close() {
    {
        const std::lock_guard lock(m_mutex);
        m_closed = true;
    }
    m_filled.notify_one();
}

} // namespace ui
