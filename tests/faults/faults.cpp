// A library to be preloaded that makes one call of one kind fail, once, wherever it comes from: the seam at which tests
// inject faults, so that the program itself has none.
//
//     LD_PRELOAD=libpointclay_faults.so FAULT=write:3 FAULT_LOG=/tmp/struck pointclay ...
//
//     open      open, openat, creat, fopen       EMFILE
//     read      read, pread, readv               EIO
//     write     write, pwrite, writev            ENOSPC
//     sync      fsync, fdatasync                 EIO
//     rename    rename, renameat                 EACCES
//     truncate  ftruncate                        EIO
//     memory    malloc and its kin, so new too   ENOMEM
//
// Calls are counted from 1 between the begin and the end of main(), over all threads. Where the call was reached, the
// file FAULT_LOG is created: a test asks for 1, 2, 3, ... until it is not.
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

enum Kind { Open, Read, Write, Sync, Rename, Truncate, Memory, None };
constexpr const char* names[] = {"open", "read", "write", "sync", "rename", "truncate", "memory"};
constexpr int errors[] = {EMFILE, EIO, ENOSPC, EIO, EACCES, EIO, ENOMEM};

Kind chosen = None;
long wanted = 0;
std::atomic<long> calls{0};
std::atomic<bool> counting{false};

void choose() {
    const char* fault = std::getenv("FAULT");
    const char* colon = fault ? std::strchr(fault, ':') : nullptr;
    for (int k = 0; colon && k < None; ++k)
        if (std::strncmp(fault, names[k], static_cast<std::size_t>(colon - fault)) == 0)
            chosen = static_cast<Kind>(k), wanted = std::atol(colon + 1);
}

/// Whether this call is the one.
bool strikes(Kind kind) {
    if (kind != chosen || !counting.load(std::memory_order_relaxed) || ++calls != wanted)
        return false;
    if (const char* log = std::getenv("FAULT_LOG"))
        ::syscall(SYS_close, ::syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT, 0600));
    errno = errors[kind];
    return true;
}

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

using Main = int(int, char**, char**);
Main* realMain = nullptr;

int countedMain(int argc, char** argv, char** environment) {
    choose();
    counting = true;
    const int out = realMain(argc, argv, environment);
    counting = false;
    return out;
}

} // namespace

/// The call under its own name, unless this one fails.
#define POINTCLAY_FAULT(kind, failed, result, name, parameters, arguments, ...)                                        \
    extern "C" result name parameters __VA_ARGS__ {                                                                    \
        if (strikes(kind))                                                                                             \
            return failed;                                                                                             \
        static auto* const real = next<result parameters>(#name);                                                      \
        return real arguments;                                                                                         \
    }

extern "C" int __libc_start_main(Main* main, int argc, char** argv, void (*init)(), void (*fini)(), void (*loader)(),
                                 void* stack) {
    using Start = int(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*);
    realMain = main;
    return next<Start>("__libc_start_main")(countedMain, argc, argv, init, fini, loader, stack);
}

// The mode is there where a file may be created; reading it where it is not does no harm.
extern "C" int open(const char* path, int flags, ...) {
    va_list list;
    va_start(list, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(list, mode_t) : 0;
    va_end(list);
    return strikes(Open) ? -1 : static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}
extern "C" int open64(const char* path, int flags, ...) {
    va_list list;
    va_start(list, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(list, mode_t) : 0;
    va_end(list);
    return strikes(Open) ? -1 : static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}
extern "C" int openat(int folder, const char* path, int flags, ...) {
    va_list list;
    va_start(list, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(list, mode_t) : 0;
    va_end(list);
    return strikes(Open) ? -1 : static_cast<int>(::syscall(SYS_openat, folder, path, flags, mode));
}
POINTCLAY_FAULT(Open, nullptr, FILE*, fopen, (const char* path, const char* mode), (path, mode))
POINTCLAY_FAULT(Open, nullptr, FILE*, fopen64, (const char* path, const char* mode), (path, mode))
POINTCLAY_FAULT(Read, -1, ssize_t, read, (int file, void* to, size_t size), (file, to, size))
POINTCLAY_FAULT(Read, -1, ssize_t, pread, (int file, void* to, size_t size, off_t at), (file, to, size, at))
POINTCLAY_FAULT(Read, -1, ssize_t, pread64, (int file, void* to, size_t size, off64_t at), (file, to, size, at))
POINTCLAY_FAULT(Read, -1, ssize_t, readv, (int file, const iovec* to, int count), (file, to, count))
POINTCLAY_FAULT(Write, -1, ssize_t, write, (int file, const void* from, size_t size), (file, from, size))
POINTCLAY_FAULT(Write, -1, ssize_t, pwrite, (int file, const void* from, size_t size, off_t at), (file, from, size, at))
POINTCLAY_FAULT(Write, -1, ssize_t, writev, (int file, const iovec* from, int count), (file, from, count))
POINTCLAY_FAULT(Sync, -1, int, fsync, (int file), (file))
POINTCLAY_FAULT(Sync, -1, int, fdatasync, (int file), (file))
POINTCLAY_FAULT(Rename, -1, int, rename, (const char* from, const char* to), (from, to), noexcept)
POINTCLAY_FAULT(Rename, -1, int, renameat, (int a, const char* from, int b, const char* to), (a, from, b, to), noexcept)
POINTCLAY_FAULT(Truncate, -1, int, ftruncate, (int file, off_t size), (file, size), noexcept)
POINTCLAY_FAULT(Truncate, -1, int, ftruncate64, (int file, off64_t size), (file, size), noexcept)

// glibc's own names: dlsym allocates.
extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

void* malloc(size_t size) noexcept {
    return strikes(Memory) ? nullptr : __libc_malloc(size);
}
void* calloc(size_t count, size_t size) noexcept {
    return strikes(Memory) ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) noexcept {
    return strikes(Memory) ? nullptr : __libc_realloc(old, size);
}
void* memalign(size_t alignment, size_t size) noexcept {
    return strikes(Memory) ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) noexcept {
    return strikes(Memory) ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** out, size_t alignment, size_t size) noexcept {
    void* memory = strikes(Memory) ? nullptr : __libc_memalign(alignment, size);
    if (!memory)
        return ENOMEM;
    *out = memory;
    return 0;
}
}
