// Function multiversioning: wider vector units where the machine has them.
#pragma once

/// Put before a free function with a hot loop: the compiler builds it for plain x86-64, AVX2 and
/// AVX-512, and the loader selects the widest that the processor has. The results are bitwise
/// equal: no target may contract a multiplication and an addition (-ffp-contract=off), and no sum
/// is reordered. Disabled under sanitizers, whose run-time is not yet up when the choice is made.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__clang__)
#define ALLTACT_WIDE __attribute__((target_clones("default", "avx2", "arch=x86-64-v4")))
#else
#define ALLTACT_WIDE
#endif
