// Shared ownership of immutable nodes with the count inside the object: one word per pointer, one allocation per node.
//
// Threads may copy, drop and read shared nodes freely. Only a node that is not yet shared may be written.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace base {

/// Base of shared objects. Starts without owners.
class Shared {
  public:
    Shared() = default;
    Shared(const Shared&) {}
    Shared& operator=(const Shared&) { return *this; }
    void acquire() const { m_owners.fetch_add(1, std::memory_order_relaxed); }
    /// True for the last owner, who must delete the object.
    bool release() const { return m_owners.fetch_sub(1, std::memory_order_acq_rel) == 1; }
    std::uint32_t owners() const { return m_owners.load(std::memory_order_relaxed); }

  private:
    mutable std::atomic<std::uint32_t> m_owners{0};
};

/// Owning pointer; T provides `static void destroy(const T*)`.
template <class T>
class Pointer {
  public:
    Pointer() = default;
    Pointer(std::nullptr_t) {}
    explicit Pointer(T* object) : m_object(object) {
        if (m_object)
            m_object->acquire();
    }
    Pointer(const Pointer& o) : Pointer(o.m_object) {}
    Pointer(Pointer&& o) noexcept : m_object(std::exchange(o.m_object, nullptr)) {}
    /// From a pointer to a derived or less const class.
    template <class U>
    Pointer(const Pointer<U>& o) : Pointer(static_cast<T*>(o.get())) {}
    Pointer& operator=(Pointer o) noexcept {
        std::swap(m_object, o.m_object);
        return *this;
    }
    ~Pointer() {
        if (m_object && m_object->release())
            T::destroy(m_object);
    }

    T* get() const { return m_object; }
    T* operator->() const { return m_object; }
    T& operator*() const { return *m_object; }
    explicit operator bool() const { return m_object != nullptr; }
    bool operator==(const Pointer& o) const { return m_object == o.m_object; }

  private:
    T* m_object = nullptr;
};

} // namespace base
