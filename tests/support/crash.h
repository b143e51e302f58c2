// What is told when a test brings its program down: which function ran, and the stack, on standard error.
//
// Call tellCrashes() before the first test, with Qt's own handler off (`-nocrashhandler`): its gdb has been seen to
// print the stack and then never to let go of the program, and it took the watchdog of Qt, twenty-five minutes later,
// to end both.
#pragma once

namespace test {

/// Under a sanitizer it prints the stack itself (handle_abort in crash.cpp); else gdb does where there is one, and
/// has a minute for it. The program then ends by the signal that it got.
void tellCrashes();

} // namespace test
