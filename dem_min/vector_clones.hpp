// SPDX-License-Identifier: MIT
// g++ makes one copy of a function so marked for each set of vector instructions and chooses when the program starts;
// SIMILITUDE_VECTORS (see CMakeLists.txt) leaves one of them, so that each can be tested. clang refuses the two attributes
// together. All copies give the same bits: nothing is contracted or reassociated.
#pragma once

#ifdef __clang__
#define SIMILITUDE_VECTOR_CLONES
#define SIMILITUDE_NO_DEPENDENCE
#else
#ifdef SIMILITUDE_VECTORS
#define SIMILITUDE_VECTOR_CLONES [[gnu::flatten, gnu::target(SIMILITUDE_VECTORS)]]
#else
#define SIMILITUDE_VECTOR_CLONES [[gnu::flatten, gnu::target_clones("avx512f", "avx2", "default")]]
#endif
#define SIMILITUDE_NO_DEPENDENCE \
    _Pragma("GCC ivdep")  // `omp simd` keeps g++ 12 from making vectors of long loops
#endif
