#pragma once

#include <cstddef>  // declares __GLIBC__

/// Put before the definition of a free function: compiles it for AVX-512, AVX2 and the x86-64
/// baseline, and selects a version at load time by the processor. For plain loops over arrays. All
/// three give the same bits, because floating-point operations are neither contracted nor
/// reordered.
///
/// Clang up to 14 takes "arch=x86-64-v4" for a processor model, so features are named instead.
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
