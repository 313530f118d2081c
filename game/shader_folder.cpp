#include "game/shader_folder.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace rambla::game {
namespace fs = std::filesystem;

ShaderFolder::ShaderFolder(fs::path folder) : folder_{std::move(folder)}, seen_{stamp()} {}

fs::path ShaderFolder::of_build() {
    return RAMBLA_SHADER_DIR;
}

bool ShaderFolder::exists() const {
    std::error_code ignored;
    return fs::is_directory(folder_, ignored);
}

render::ShaderSource ShaderFolder::source() const {
    if (!exists()) return {};
    return [folder = folder_](const std::string& path) {
        std::ifstream file{folder / path};
        std::ostringstream text;
        text << file.rdbuf();
        if (!file) throw std::out_of_range{"shader file " + (folder / path).string() + " cannot be read"};
        return text.str();
    };
}

bool ShaderFolder::changed(std::chrono::steady_clock::time_point now) {
    if (now - looked_ < std::chrono::seconds{1}) return false;
    looked_ = now;
    const Stamp found = stamp();
    return found != std::exchange(seen_, found);
}

ShaderFolder::Stamp ShaderFolder::stamp() const {
    // Editors replace files while we look: whatever vanishes in between is simply not counted this time.
    Stamp result;
    std::error_code gone;
    for (fs::recursive_directory_iterator file{folder_, gone}, end; !gone && file != end;
         file.increment(gone)) {
        std::error_code ignored;
        const fs::file_time_type changed = file->last_write_time(ignored);
        if (ignored) continue;
        result.newest = std::max(result.newest, changed);
        ++result.files;
    }
    return result;
}

}  // namespace rambla::game
