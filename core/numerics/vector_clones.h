// Loops built once for each width of the processor's vectors.
#pragma once

/// Before a free function: it is compiled for plain x86-64, AVX2 and AVX-512, and the program takes
/// the widest that the processor has. The results are the same bytes: none of the three targets
/// may contract a multiplication and an addition (-ffp-contract=off), and no sum is reordered.
/// Left out under sanitizers, whose run-time is not yet up when the choice is made.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__clang__)
#define ALLTACT_VECTOR_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define ALLTACT_VECTOR_CLONES
#endif
