#pragma once

#include <chrono>
#include <filesystem>

#include "render/shader_source.h"

namespace rambla::game {

/// The folder of shader sources that this program was built from: looked at while a window is open, so that a
/// saved change shows at once. Elsewhere, and where the folder is gone, the texts embedded at build serve.
class ShaderFolder {
public:
    explicit ShaderFolder(std::filesystem::path folder);

    /// The build's own source folder.
    [[nodiscard]] static std::filesystem::path of_build();

    [[nodiscard]] bool exists() const;
    /// Reads from the folder; empty (the embedded texts) where there is none.
    [[nodiscard]] render::ShaderSource source() const;

    /// Whether a file was changed, added or removed since the last call that looked. Looks once a second at
    /// most.
    [[nodiscard]] bool changed(std::chrono::steady_clock::time_point now);

private:
    /// The newest change and the number of files: removing a file changes the second.
    struct Stamp {
        std::filesystem::file_time_type newest = std::filesystem::file_time_type::min();
        std::size_t files = 0;
        bool operator==(const Stamp&) const = default;
    };
    [[nodiscard]] Stamp stamp() const;

    std::filesystem::path folder_;
    Stamp seen_;
    std::chrono::steady_clock::time_point looked_{};
};

}  // namespace rambla::game
