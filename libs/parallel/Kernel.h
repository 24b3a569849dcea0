#pragma once

// Marks a function that runs on every backend: on the GPU and, inlined into loops, on the CPU.
// The only macro of the libraries.
#ifdef __CUDACC__
#define FPM_KERNEL __host__ __device__ __forceinline__
#else
#define FPM_KERNEL inline __attribute__((always_inline))
#endif
