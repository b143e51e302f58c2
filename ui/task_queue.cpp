#include "ui/task_queue.h"

namespace ui {

static std::size_t waitingSamples(const std::deque<Task>& tasks) {
    std::size_t n = 0;
    while (n < tasks.size() && std::holds_alternative<AddSample>(tasks[tasks.size() - 1 - n]))
        ++n;
    return n;
}

/// Keeps the samples 0, 2, 4, ... of the run at the back: the first of a stroke decides its contact.
static void thin(std::deque<Task>& tasks, std::size_t run) {
    const std::size_t start = tasks.size() - run;
    std::size_t kept = start;
    for (std::size_t i = 0; i < run; i += 2, ++kept)
        if (kept != start + i)
            tasks[kept] = std::move(tasks[start + i]);
    tasks.erase(tasks.begin() + static_cast<std::ptrdiff_t>(kept), tasks.end());
}

std::size_t TaskQueue::push(Task task) {
    std::size_t dropped = 0;
    {
        const std::lock_guard lock(m_mutex);
        const std::size_t run = waitingSamples(m_tasks), before = m_tasks.size();
        if (std::holds_alternative<AddSample>(task) && run >= maxWaitingSamples)
            thin(m_tasks, run);
        else if (std::holds_alternative<CancelStroke>(task))
            m_tasks.erase(m_tasks.end() - static_cast<std::ptrdiff_t>(run), m_tasks.end());
        dropped = before - m_tasks.size();
        m_tasks.push_back(std::move(task));
    }
    m_filled.notify_one();
    return dropped;
}

std::optional<Task> TaskQueue::pop() {
    std::unique_lock lock(m_mutex);
    m_filled.wait(lock, [this] { return m_closed || !m_tasks.empty(); });
    if (m_closed)
        return {};
    Task out = std::move(m_tasks.front());
    m_tasks.pop_front();
    return out;
}

void TaskQueue::close() {
    {
        const std::lock_guard lock(m_mutex);
        m_closed = true;
    }
    m_filled.notify_one();
}

} // namespace ui
