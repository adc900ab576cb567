// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/vectorised.h"

// For loops that are also compiled for processors with AVX-512, which have mask registers (that no compiler uses for
// vector comparisons by itself) and registers twice as wide. BURIN_AVX512 is defined if the compiler supports this;
// code between BURIN_AVX512_BEGIN and _END may be called only if `hasAvx512`. Works under sanitizers as well, as the
// program itself makes the choice once everything is initialised.
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
