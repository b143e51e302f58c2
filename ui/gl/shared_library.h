// A library opened when it is needed. It stays open until the program ends: Mesa's libraries leave thread-local
// destructors behind, and unloading them would crash threads that end later.
#pragma once

namespace render {

class SharedLibrary {
  public:
    /// Its symbols are not shown to other libraries. `isOpen` tells whether it was found.
    explicit SharedLibrary(const char* fileName);

    bool isOpen() const { return m_handle != nullptr; }
    /// Null where the library is not open or has no such symbol.
    void* symbol(const char* name) const;
    template <class Function>
    void find(Function& out, const char* name) const {
        out = reinterpret_cast<Function>(symbol(name));
    }

  private:
    void* m_handle = nullptr;
};

} // namespace render
