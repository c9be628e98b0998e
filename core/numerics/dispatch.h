// One portable program that uses wider vector units where the machine has them.
#pragma once

/// Put before a function whose loop pays for it: the compiler builds it for plain x86-64 and for
/// AVX2, and the loader picks one. The project never allows contraction into fused multiply-adds
/// (-ffp-contract=off), so both give the same bytes. Sanitizers cannot instrument the picking.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ALLTACT_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define ALLTACT_WIDE
#endif
