#pragma once

// The instruction sets that a kernel is compiled for. Every file that Highway compiles once for each includes this
// before any header of Highway.
//
// SSSE3 alone is older than any machine that draws a scan in time, and what AVX3_DL adds no kernel uses. Where
// sanitizers look (POINTCLAY_SETS_BY_WIDTH, from CMake), there is one set of each width: what a vector reads beyond an
// array's end depends on how many lanes it has, not on the instruction; and with their checks a set takes half a minute
// to compile.
#ifdef POINTCLAY_SETS_BY_WIDTH
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SSE4)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif
