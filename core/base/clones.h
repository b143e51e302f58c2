// POINTCLAY_CLONES before a function: it is compiled for several instruction sets, and the loader takes the best that
// the machine has. For loops over lanes that the compiler turns into vector instructions by itself; kernels that need
// more are written with Highway.
//
// Products are never contracted with sums (-ffp-contract=off), so that all versions give the same bits. What such a
// function calls must be inlined into it to gain. Thread sanitizers cannot run code before main: they get one version.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define POINTCLAY_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define POINTCLAY_CLONES
#endif
