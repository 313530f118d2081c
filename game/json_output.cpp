#include "game/json_output.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "assets/error.h"
#include "assets/export/image.h"

namespace rambla::game {

namespace fs = std::filesystem;

void prepare_json(const std::string& target) {
    if (target.empty() || target == "-") return;
    const fs::path file{target};
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path{"."};
    std::error_code error;
    fs::create_directories(folder, error);
    // The file is written beside its place and renamed, so the folder's rights are the ones that count.
    if (fs::is_directory(file, error) || !fs::is_directory(folder, error) ||
        access(folder.c_str(), W_OK | X_OK) != 0) {
        throw assets::Error{target, "", "cannot be written", "a file in a folder that can be written to"};
    }
}

void write_json(const std::string& target, const nlohmann::json& object) {
    if (target.empty()) return;
    const std::string text = object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    if (target == "-") {
        std::fputs(text.c_str(), stdout);
        std::fflush(stdout);
    } else {
        assets::write_text(target, text);
    }
}

void print_result(const std::string& json_target, const std::string& text) {
    std::FILE* const stream = json_target == "-" ? stderr : stdout;
    std::fputs(text.c_str(), stream);
    std::fflush(stream);
}

}  // namespace rambla::game
