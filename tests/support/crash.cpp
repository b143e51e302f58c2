#include "support/crash.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <QTest>
#include <sys/wait.h>
#include <unistd.h>

namespace {

void write(const char* text) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
}

/// In the words with which Qt tells the same. Only for a process that ends: what it calls may hold locks.
void tellFunction() {
    const char* function = QTest::currentTestFunction();
    const char* row = QTest::currentDataTag();
    write("\nQFATAL : ");
    write(QTest::testObject() ? QTest::testObject()->metaObject()->className() : "no class");
    write("::");
    write(function ? function : "no function");
    write("(");
    write(row ? row : "");
    write(") has brought the program down\n");
}

} // namespace

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

#include <sanitizer/common_interface_defs.h>

// A failed assertion is a finding like others: with its stack, and the end at once. What the environment says is added.
#if defined(__SANITIZE_ADDRESS__)
extern "C" const char* __asan_default_options() {
    return "handle_abort=1";
}
#else
extern "C" const char* __tsan_default_options() {
    return "handle_abort=1";
}
#endif

void test::tellCrashes() {
    __sanitizer_set_death_callback(tellFunction);
}

#else

namespace {

/// gdb lets go of whom it looks at when it is killed, so whoever waits for it waits a minute at most.
void printStack() {
    char self[16];
    std::snprintf(self, sizeof self, "%d", static_cast<int>(getpid()));
    const pid_t child = fork();
    if (child == 0) {
        dup2(STDERR_FILENO, STDOUT_FILENO);
        execlp("timeout", "timeout", "-s", "KILL", "60", "gdb", "--nx", "--batch", "-ex", "thread apply all bt",
               "--pid", self, nullptr);
        _exit(1);
    }
    if (child > 0)
        waitpid(child, nullptr, 0);
}

void crashed(int signal) {
    std::signal(signal, SIG_DFL);
    tellFunction();
    printStack();
    raise(signal);
}

} // namespace

void test::tellCrashes() {
    // A stack of its own, for when the other is used up.
    static char space[1 << 16];
    stack_t stack{};
    stack.ss_sp = space;
    stack.ss_size = sizeof space;
    sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = crashed;
    action.sa_flags = SA_ONSTACK;
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL})
        sigaction(signal, &action, nullptr);
}

#endif
