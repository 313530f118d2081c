#include <malloc.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>

#include "bench/assets/import_bench.h"
#include "bench/assets/targets.h"
#include "bench/harness/run.h"

namespace {

namespace fs = std::filesystem;

/// A folder for generated files, gone at the end.
struct ScratchFolder {
    fs::path path = fs::temp_directory_path() / ("rambla-assets-bench-" + std::to_string(::getpid()));
    ScratchFolder() { fs::create_directories(path); }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

}  // namespace

int main(int argc, char** argv) {
    spdlog::set_level(spdlog::level::off);  // what files get wrong is not the question here
    // Freed memory stays with the program, as in one that imports file after file: else most of what is
    // measured would be the system's work for fresh pages, on both sides, and more or less of it by chance.
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    const ScratchFolder folder;
    try {
        rambla::bench::register_import_benchmarks(rambla::bench::inputs(folder.path));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 2;
    }
    return rambla::bench::run("Rambla's glTF import and tinygltf alone (bare): medians, nanoseconds per byte",
                              rambla::bench::k_assets_targets, argc, argv);
}
