#include <spdlog/spdlog.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "assets/export/gltf.h"
#include "assets/import/gltf.h"

/// rambla_reexport FOLDER OUT: writes every glTF file below FOLDER as GLB into OUT, named by its path.
int main(int argc, char** argv) {
    namespace fs = std::filesystem;
    if (argc != 3) {
        std::fputs("usage: rambla_reexport FOLDER OUT\n", stderr);
        return 2;
    }
    spdlog::set_level(spdlog::level::err);
    try {
        const fs::path folder = argv[1];
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder}) {
            const fs::path& file = entry.path();
            if (file.extension() != ".gltf" && file.extension() != ".glb") continue;
            std::string name = fs::relative(file, folder).string();
            for (char& c : name)
                if (c == '/') c = '_';
            rambla::assets::export_gltf(fs::path{argv[2]} / (name + ".glb"),
                                        rambla::assets::import_gltf(file));
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
