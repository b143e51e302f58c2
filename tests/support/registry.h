// Test classes of one room in one executable.
//
// A test file defines a QObject with private slots named as laws, and one line at its end:
//     static const test::Registered<BoxTest> registered;
//     #include "box_test.moc"
// The executable's main (registry.cpp) runs every registered class and returns the number of failed functions.
// `room_tests -list` names the classes; `room_tests ClassName [function]...` runs one of them, and
// `room_tests Class.function Class...` what is named.
#pragma once

#include <functional>
#include <QObject>
#include <string>

namespace test {

using Factory = std::function<QObject*()>;
void add(Factory factory);

template <class T>
struct Registered {
    Registered() {
        add([] { return new T; });
    }
};

/// Folder with real scans, from the variable POINTCLAY_DATA; empty when there is none, and tests then skip.
std::string dataFolder();

/// Seed for property tests: POINTCLAY_SEED, else a fixed one. Print it in the failure message.
unsigned long long seed();

/// How often a law is tried with random input: `times`, but a fifth of it, at least once, where a sanitizer makes every
/// instruction ten times as slow. Sanitizers look for other faults than laws do.
constexpr int effort(int times) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return times < 10 ? 1 : times / 5;
#else
    return times;
#endif
}

} // namespace test
