#pragma once

#include <cstddef>  // declares __GLIBC__

/// Before the definition of a free function: compiles its loops for AVX-512, AVX2 and the baseline,
/// and picks one at load time by what the processor has. For plain loops over arrays; the results
/// are the same bits in all three, as nothing is contracted or reordered.
///
/// Clang up to 14 mistakes "arch=x86-64-v4" for a model of processor, so it is given features.
#if defined(SYMSCENE_SANITIZED) || !defined(__x86_64__) || !defined(__GLIBC__)
#define SYMSCENE_MULTIVERSION
#elif defined(__clang__) && __has_attribute(target_clones)
#define SYMSCENE_MULTIVERSION __attribute__((target_clones("avx512bw", "avx2", "default")))
#elif defined(__GNUC__) && !defined(__clang__)
#define SYMSCENE_MULTIVERSION \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define SYMSCENE_MULTIVERSION
#endif
