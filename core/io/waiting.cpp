#include "core/io/waiting.h"

#include "core/base/cancel_scope.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace io {

int openToRead(const std::filesystem::path& path) {
    int descriptor = -1;
    do
        base::CancelScope::check();
    while ((descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) < 0 && errno == EINTR);
    return descriptor;
}

ssize_t readSome(int descriptor, char* out, std::size_t size) {
    ssize_t got = -1;
    do
        base::CancelScope::check();
    while ((got = ::read(descriptor, out, size)) < 0 && errno == EINTR);
    return got;
}

} // namespace io
