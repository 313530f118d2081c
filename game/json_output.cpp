#include "game/json_output.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "assets/export/image.h"

namespace rambla::game {

void write_json(const std::string& target, const nlohmann::json& object) {
    if (target.empty()) return;
    const std::string text = object.dump(2) + "\n";
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
