#include <cstdio>
#include <exception>
#include <filesystem>

#include "assets/export/image.h"
#include "fuzz/target.h"

/// rambla_fuzz_seeds FOLDER: writes the seeds of each target into a folder of its name.
int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: rambla_fuzz_seeds FOLDER\n", stderr);
        return 2;
    }
    try {
        for (const rambla::fuzz::Target& target : rambla::fuzz::targets())
            target.seeds([&](const std::string& name, rambla::fuzz::Bytes bytes) {
                rambla::assets::write_bytes(std::filesystem::path{argv[1]} / target.name / name, bytes);
            });
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
