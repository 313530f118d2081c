#include "game/state_file.h"

#include <spdlog/fmt/fmt.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>
#include <vector>

#include "assets/error.h"
#include "ecs/misuse.h"
#include "ecs/snapshot_error.h"
#include "systems/saved_state.h"

namespace rambla::game {
namespace {

systems::SavedPlace place_of(const Stage& stage, const Options& options) {
    return {options.scene, options.seed, stage.origin, to_text(options.time)};
}

std::vector<std::byte> read(const std::filesystem::path& file) {
    std::error_code missing;
    if (std::filesystem::is_directory(file, missing))
        throw assets::Error{file.string(), "", "a folder", "a saved state"};
    std::ifstream in{file, std::ios::binary};
    const std::vector<char> characters{std::istreambuf_iterator<char>{in}, {}};
    if (!in.is_open() || in.bad())
        throw assets::Error{file.string(), "", "a file that cannot be read", "a saved state"};
    const auto bytes = std::as_bytes(std::span{characters});
    return {bytes.begin(), bytes.end()};
}

}  // namespace

void save_state_file(const std::filesystem::path& file, Stage& stage, const Options& options) {
    const std::vector<std::byte> bytes = systems::save_state(*stage.world, place_of(stage, options));
    std::filesystem::path unfinished = file;
    unfinished += ".part";
    std::ofstream out{unfinished, std::ios::binary};
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    out.close();
    std::error_code failure;
    if (out) std::filesystem::rename(unfinished, file, failure);
    if (out && !failure) return;
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw assets::Error{file.string(), "", "a place that cannot be written to", ""};
}

void load_state_file(const std::filesystem::path& file, Stage& stage, const Options& options) {
    const std::vector<std::byte> bytes = read(file);
    try {
        stage.world = systems::load_state(bytes, *stage.world, place_of(stage, options));
    } catch (const ecs::SnapshotError& error) {
        throw assets::Error{file.string(), fmt::format("byte {}", error.offset()), error.found(),
                            error.expected()};
    } catch (const ecs::CapacityExceeded& error) {
        throw assets::Error{file.string(), "", error.what(), ""};
    }
}

}  // namespace rambla::game
