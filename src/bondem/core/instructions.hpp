// Level of the instruction set of a CPU: a microarchitecture level of x86-64 (psABI), or 0 for other CPUs.
#pragma once
#include "scalars.hpp"

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace bondem {

#if !defined(__x86_64__)
constexpr Index compiled_level = 0;
inline Index instruction_level() { return 0; }
#else

#if defined(__AVX512F__)
constexpr Index compiled_level = 4;
#elif defined(__AVX2__)
constexpr Index compiled_level = 3;
#else
constexpr Index compiled_level = 2;
#endif

// Register sets that the operating system saves when it switches programs.
inline uint64_t saved_state() {
    uint32_t low, high;
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    return uint64_t(high) << 32 | low;
}

inline Index instruction_level() {
    uint32_t a, b, c, d;
    const auto all = [](uint32_t found, uint32_t wanted) { return (found & wanted) == wanted; };
    if (!__get_cpuid(1, &a, &b, &c, &d)) return 2;
    const uint32_t fma = 1u << 12, movbe = 1u << 22, osxsave = 1u << 27, avx = 1u << 28, f16c = 1u << 29;
    if (!all(c, fma | movbe | osxsave | avx | f16c) || !all(uint32_t(saved_state()), 0x6)) return 2;
    if (!__get_cpuid_count(7, 0, &a, &b, &c, &d)) return 2;
    const uint32_t bmi1 = 1u << 3, avx2 = 1u << 5, bmi2 = 1u << 8;
    const uint32_t avx512 = 1u << 16 | 1u << 17 | 1u << 28 | 1u << 30 | 1u << 31;  // F, DQ, CD, BW, VL
    const uint32_t ebx7 = b;
    if (!all(ebx7, bmi1 | avx2 | bmi2) || !__get_cpuid(0x80000001, &a, &b, &c, &d) || !all(c, 1u << 5)) return 2;
    return all(ebx7, avx512) && all(uint32_t(saved_state()), 0xe6) ? 4 : 3;
}

#endif

}  // namespace bondem
