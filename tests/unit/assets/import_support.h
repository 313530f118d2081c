#pragma once

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "assets/error.h"
#include "assets/import/gltf.h"

namespace rambla::assets::test {

/// A folder of its own for one test, gone afterwards.
class ScratchFolder {
public:
    ScratchFolder() {
        static int counter = 0;
        path_ = std::filesystem::temp_directory_path() /
                ("rambla-assets-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
        std::filesystem::create_directories(path_);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream{file, std::ios::binary}.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return file;
    }

private:
    std::filesystem::path path_;
};

/// Collects what is logged while it lives.
class LogCapture {
public:
    LogCapture() : previous_{spdlog::default_logger()} {
        auto sink = std::make_shared<spdlog::sinks::ostream_sink_mt>(text_);
        spdlog::set_default_logger(std::make_shared<spdlog::logger>("test", sink));
    }
    ~LogCapture() { spdlog::set_default_logger(previous_); }
    LogCapture(const LogCapture&) = delete;
    LogCapture& operator=(const LogCapture&) = delete;

    [[nodiscard]] std::string text() const { return text_.str(); }
    [[nodiscard]] std::ptrdiff_t lines() const {
        const std::string all = text();
        return std::count(all.begin(), all.end(), '\n');
    }

private:
    std::ostringstream text_;
    std::shared_ptr<spdlog::logger> previous_;
};

template <class T>
std::string bytes_of(std::initializer_list<T> values) {
    std::string out;
    for (const T value : values)
        out.append(reinterpret_cast<const char*>(&value), sizeof value);
    return out;
}

inline std::string glb(const std::string& json, const std::string& binary = {}) {
    const auto word = [](std::size_t value) {
        return bytes_of({static_cast<std::uint32_t>(value)});
    };
    const std::string text = json + std::string((4 - json.size() % 4) % 4, ' ');
    const std::string data = binary + std::string((4 - binary.size() % 4) % 4, '\0');
    std::string body = word(text.size()) + "JSON" + text;
    if (!data.empty()) body += word(data.size()) + std::string("BIN\0", 4) + data;
    return "glTF" + word(2) + word(12 + body.size()) + body;
}

/// The message of the assets::Error that importing the file ends in; empty when it loads.
inline std::string import_error(const std::filesystem::path& file, const ImportLimits& limits = {}) {
    try {
        static_cast<void>(import_gltf(file, limits));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

/// The corpus of sample files, or empty, after one loud line, when this machine has none.
inline std::filesystem::path corpus(const char* tests_not_run) {
    const std::filesystem::path folder = RAMBLA_GLTF_DIR;
    if (!folder.empty() && std::filesystem::exists(folder)) return folder;
    std::fprintf(stderr, "NOT RUN: %s (RAMBLA_GLTF_DIR names no folder of glTF sample files)\n",
                 tests_not_run);
    return {};
}

}  // namespace rambla::assets::test
