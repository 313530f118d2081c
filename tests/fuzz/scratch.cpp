#include "fuzz/scratch.h"

#include <unistd.h>

#include <fstream>

namespace rambla::fuzz {

namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("rambla-fuzz-" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

}  // namespace

const fs::path& scratch_folder() {
    static const Folder k_folder;
    return k_folder.path;
}

fs::path write_scratch(const std::string& name, Bytes bytes) {
    const fs::path file = scratch_folder() / name;
    std::ofstream out{file, std::ios::binary | std::ios::trunc};
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) broken("the fuzzer's own folder can be written: " + file.string());
    return file;
}

std::vector<std::byte> read_scratch(const fs::path& file) {
    std::vector<std::byte> bytes(fs::file_size(file));
    std::ifstream{file, std::ios::binary}.read(reinterpret_cast<char*>(bytes.data()),
                                               static_cast<std::streamsize>(bytes.size()));
    return bytes;
}

}  // namespace rambla::fuzz
