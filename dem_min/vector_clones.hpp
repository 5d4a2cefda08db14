// SPDX-License-Identifier: MIT
// g++ makes one copy of a function so marked for each set of vector instructions and chooses when the program starts. clang
// refuses the two attributes together. All copies give the same bits: nothing is contracted or reassociated.
#pragma once

#ifndef __clang__
#define SIMILITUDE_VECTOR_CLONES [[gnu::flatten, gnu::target_clones("avx512f", "avx2", "default")]]
#define SIMILITUDE_NO_DEPENDENCE \
    _Pragma("GCC ivdep")  // `omp simd` keeps g++ 12 from making vectors of long loops
#else
#define SIMILITUDE_VECTOR_CLONES
#define SIMILITUDE_NO_DEPENDENCE
#endif
