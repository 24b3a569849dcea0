// Bandwidth of memory: copy and triad of large arrays. One line of JSON, bytes a second.
//   bench_copy <backend> <threads> <MiB an array> <repeats>

#include "bench/copy.h"

#include "base/Error.h"
#include "parallel/CpuExecutor.h"

#include <cstdio>
#include <thread>

using namespace fpm;

int main(int argc, char** argv)
{
    if (argc != 5) {
        std::fprintf(stderr, "usage: bench_copy <backend> <threads> <MiB an array> <repeats>\n");
        return 2;
    }
    const std::string backend = argv[1];
    const int asked = std::atoi(argv[2]), repeats = std::atoi(argv[4]);
    const Index count = Index(std::atoi(argv[3])) * (1 << 20) / Index(sizeof(double));
    const int cores = int(std::thread::hardware_concurrency()), threads = backend == "serial" ? 1
                                                                          : asked > 0
                                                                              ? asked
                                                                              : std::max(1, cores);
    try {
        const bench::Bandwidth found =
            backend == "cuda" ? bench::bandwidthOfGpu(count, repeats)
                              : bench::bandwidth(CpuExecutor<64>(threads, 0), count, repeats);
        std::printf("{\"backend\": \"%s\", \"threads\": %d, \"copy\": %.6g, \"triad\": %.6g}\n",
                    backend.c_str(), backend == "cuda" ? 0 : threads, found.copy, found.triad);
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return int(error.code());
    }
    return 0;
}
