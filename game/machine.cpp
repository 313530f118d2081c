#include "game/machine.h"

#include <fstream>

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

namespace rambla::game {

std::string processor_name() {
    std::ifstream file{"/proc/cpuinfo"};
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    }
    return "unknown";
}

std::string compiler_name() {
#ifdef __clang__
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

std::string c_library_name() {
#ifdef __GLIBC__
    return std::string{"glibc "}.append(gnu_get_libc_version());
#else
    return "unknown";
#endif
}

}  // namespace rambla::game
