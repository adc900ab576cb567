// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/vectorised.h"

// For loops that are compiled for processors with AVX-512 as well: those have registers for conditions, which no
// compiler finds from comparisons of vectors, and twice the others. BURIN_AVX512 is there where the compiler can do so;
// what stands between BURIN_AVX512_BEGIN and _END is to be called where `hasAvx512` alone. Under sanitizers as well:
// the choice is the program's own, made when all is up.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__OPTIMIZE__)
#include <immintrin.h>

#define BURIN_AVX512
#define BURIN_AVX512_BEGIN _Pragma("GCC push_options") _Pragma("GCC target(\"avx2,avx512f,avx512vl,avx512dq\")")
#define BURIN_AVX512_END _Pragma("GCC pop_options")

namespace burin {
inline const bool hasAvx512 =
    __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
}
#endif
