#include "ui/gl/shared_library.h"

#include <dlfcn.h>

namespace render {

SharedLibrary::SharedLibrary(const char* fileName) : m_handle(dlopen(fileName, RTLD_NOW | RTLD_LOCAL)) {}

void* SharedLibrary::symbol(const char* name) const {
    return m_handle ? dlsym(m_handle, name) : nullptr;
}

} // namespace render
