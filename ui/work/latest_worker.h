// A thread that works on the latest request only: a newer one replaces the one that waits, and stops the one that runs
// if its owner says so. An exception ends only the piece of work that threw it.
//
//     LatestWorker<Request> worker([this](const Request& request, const base::Progress& progress) { ... });
//     worker.request(wanted, true);
//
// Any thread may ask; the work is called on the worker's own, and is over when the destructor returns.
#pragma once

#include "core/base/progress.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace ui {

template <class Request>
class LatestWorker {
  public:
    /// `progress` carries the cancel flag; base::Cancelled ends a piece quietly, anything else goes to `failed`.
    using Work = std::function<void(const Request&, const base::Progress& progress)>;
    using Failed = std::function<void(const std::exception&)>;
    using Rested = std::function<void()>; ///< nothing is left to do; another request may be on its way

    LatestWorker(Work work, Failed failed, Rested rested = {})
        : m_work(std::move(work)), m_failed(std::move(failed)), m_rested(std::move(rested)),
          m_thread([this] { loop(); }) {}
    ~LatestWorker() {
        {
            const std::lock_guard lock(m_mutex);
            m_ending = m_cancel = true;
        }
        m_asked.notify_one();
        m_thread.join();
    }
    LatestWorker(const LatestWorker&) = delete;
    LatestWorker& operator=(const LatestWorker&) = delete;

    void request(Request wanted, bool stopRunning) {
        {
            const std::lock_guard lock(m_mutex);
            m_request = std::move(wanted);
            m_cancel = m_cancel || stopRunning;
        }
        m_asked.notify_one();
    }
    /// Nothing is wanted any more.
    void cancel() {
        {
            const std::lock_guard lock(m_mutex);
            m_request.reset();
            m_cancel = m_dropped = true;
        }
        m_asked.notify_one();
    }
    /// Something runs or waits.
    bool busy() const {
        const std::lock_guard lock(m_mutex);
        return m_running || m_request;
    }

  private:
    enum class Next { Work, Rest, End };

    Next next(Request& out) {
        std::unique_lock lock(m_mutex);
        if (std::exchange(m_running, false) && !m_request)
            return Next::Rest;
        m_asked.wait(lock, [this] { return m_ending || m_request || m_dropped; });
        const bool dropped = std::exchange(m_dropped, false);
        if (m_ending)
            return Next::End;
        if (!m_request)
            return dropped ? Next::Rest : Next::End;
        m_running = true;
        m_cancel = false;
        out = *std::exchange(m_request, std::nullopt);
        return Next::Work;
    }
    void loop() {
        base::Progress progress;
        progress.cancel = &m_cancel;
        Request request;
        for (Next what; (what = next(request)) != Next::End;) {
            if (what == Next::Work)
                run(request, progress);
            else if (m_rested)
                m_rested();
        }
    }
    void run(const Request& request, const base::Progress& progress) {
        try {
            m_work(request, progress);
        } catch (const base::Cancelled&) { // something else is wanted, or nothing
        } catch (const std::exception& error) {
            m_failed(error);
        }
    }

    Work m_work;
    Failed m_failed;
    Rested m_rested;
    mutable std::mutex m_mutex;
    std::condition_variable m_asked;
    std::optional<Request> m_request;
    bool m_running = false, m_dropped = false, m_ending = false;
    std::atomic<bool> m_cancel = false;
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace ui
