// Memory that a loop uses over again, on any number of threads: what `thread_local` is for, but for its end. glibc ends
// the program, without a word, where memory for the destructor of a thread's own variable cannot be had; here whoever
// takes it gets std::bad_alloc like anybody else.
//
//     static base::Scratch<std::vector<Neighbour>> scratch;
//     const auto near = scratch.take();
//     tree.nearest(x, 20, *near);
//
// Keeps as many T as were taken at one time, with the memory they have grown to, until the program ends. Any thread may
// take; about 40 ns.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

namespace base {

template <class T>
class Scratch {
  public:
    /// One T for as long as this lives; its content is what the last one has left.
    class Taken {
      public:
        Taken(const Taken&) = delete;
        Taken& operator=(const Taken&) = delete;
        ~Taken() {
            const std::lock_guard lock(m_owner.m_guard);
            m_owner.m_free.push_back(std::move(m_item)); // has room since it was made
        }
        T& operator*() const { return *m_item; }
        T* operator->() const { return m_item.get(); }

      private:
        friend Scratch;
        Taken(Scratch& owner, std::unique_ptr<T> item) : m_owner(owner), m_item(std::move(item)) {}

        Scratch& m_owner;
        std::unique_ptr<T> m_item;
    };

    Taken take() {
        const std::lock_guard lock(m_guard);
        if (m_free.empty()) {
            m_free.reserve(m_made + 1);
            std::unique_ptr<T> made(new T); // large plain memory stays as it is
            ++m_made;
            return {*this, std::move(made)};
        }
        std::unique_ptr<T> item = std::move(m_free.back());
        m_free.pop_back();
        return {*this, std::move(item)};
    }

  private:
    std::mutex m_guard;
    std::vector<std::unique_ptr<T>> m_free;
    std::size_t m_made = 0;
};

} // namespace base
