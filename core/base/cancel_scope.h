// Cancellation that reaches every parallel loop below without being handed down: while a scope lives, loops that its
// thread starts look at the flag between chunks, on whatever thread these run, and throw base::Cancelled.
//
//     base::CancelScope scope(progress.cancel);   // at the door: a command, a stroke, a subcommand
//     ...                                         // tools, estimation, resampling, trees know nothing of it
//
// For work that is dropped as a whole when it is cancelled. Work that keeps what it has done so far looks at
// Progress::cancel itself. Scopes nest; a null flag is no scope at all, so that the one around it stays.
#pragma once

#include <atomic>

namespace base {

class CancelScope {
  public:
    /// The flag outlives the scope; may be null.
    explicit CancelScope(const std::atomic<bool>* cancel);
    ~CancelScope();
    CancelScope(const CancelScope&) = delete;
    CancelScope& operator=(const CancelScope&) = delete;

    /// Of the calling thread's innermost scope; null outside of all.
    static const std::atomic<bool>* flag();
    /// For long loops of one thread: throws base::Cancelled where the calling thread's scope is asked to stop.
    static void check();

  private:
    const std::atomic<bool>* m_outer;
};

} // namespace base
