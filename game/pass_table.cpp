#include "game/pass_table.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "game/statistics.h"

namespace rambla::game {
namespace {

/// One value per frame of everything that a row states.
struct Samples {
    std::vector<double> gpu_ms, cpu_ms, bytes;
    double memory_bytes = 0.0;
    std::uint32_t frames = 0;
    std::optional<std::size_t> last_frame{};  ///< passes of one name may run several times in a frame

    explicit Samples(std::size_t count) : gpu_ms(count), cpu_ms(count), bytes(count) {}
};

PassRow to_row(std::string name, const Samples& samples, double frame_ms) {
    const double gpu_ms = median(samples.gpu_ms);
    return {.name = std::move(name),
            .gpu_ms_median = gpu_ms,
            .gpu_ms_p99 = percentile(samples.gpu_ms, 0.99),
            .share = frame_ms > 0.0 ? gpu_ms / frame_ms : 0.0,
            .cpu_ms_median = median(samples.cpu_ms),
            .bytes_written = median(samples.bytes),
            .memory_bytes = samples.memory_bytes,
            .frames = samples.frames};
}

std::string row_text(const PassRow& row) {
    return fmt::format("{:<24} {:>10.3f} {:>10.3f} {:>7.1f} % {:>10.3f} {:>12} {:>12} {:>7}\n", row.name,
                       row.gpu_ms_median, row.gpu_ms_p99, 100.0 * row.share, row.cpu_ms_median,
                       bytes_text(row.bytes_written), bytes_text(row.memory_bytes), row.frames);
}

nlohmann::json row_json(const PassRow& row) {
    return {{"name", row.name},
            {"gpu_ms_median", row.gpu_ms_median},
            {"gpu_ms_p99", row.gpu_ms_p99},
            {"share", row.share},
            {"cpu_ms_median", row.cpu_ms_median},
            {"bytes_written", row.bytes_written},
            {"memory_bytes", row.memory_bytes},
            {"frames", row.frames}};
}

}  // namespace

PassTable make_pass_table(const std::vector<systems::Feedback>& frames) {
    const std::size_t count = frames.size();
    std::vector<std::pair<std::string, Samples>> passes;
    Samples envelope{count};
    Samples missing{count};
    std::vector<double> draws(count);
    std::vector<double> triangles(count);
    PassTable table;
    for (std::size_t f = 0; f < count; ++f) {
        const systems::Feedback& feedback = frames[f];
        missing.gpu_ms[f] = feedback.gpu_frame_ms;
        missing.cpu_ms[f] = feedback.cpu_frame_ms;
        envelope.gpu_ms[f] = feedback.gpu_frame_ms;
        envelope.cpu_ms[f] = feedback.cpu_frame_ms;
        for (const systems::PassTiming& timing : feedback.passes) {
            auto found = std::find_if(passes.begin(), passes.end(),
                                      [&](const auto& pass) { return pass.first == timing.name; });
            if (found == passes.end()) found = passes.insert(passes.end(), {timing.name, Samples{count}});
            Samples& samples = found->second;
            samples.gpu_ms[f] += timing.gpu_ms;
            samples.cpu_ms[f] += timing.cpu_ms;
            samples.bytes[f] += static_cast<double>(timing.bytes_written);
            samples.memory_bytes = std::max(samples.memory_bytes, static_cast<double>(timing.memory_bytes));
            envelope.memory_bytes = std::max(envelope.memory_bytes, samples.memory_bytes);
            samples.frames += samples.last_frame == f ? 0 : 1;
            samples.last_frame = f;
            missing.gpu_ms[f] -= timing.gpu_ms;
            missing.cpu_ms[f] -= timing.cpu_ms;
            envelope.bytes[f] += static_cast<double>(timing.bytes_written);
        }
        draws[f] = feedback.draws;
        triangles[f] = static_cast<double>(feedback.triangles);
        table.gpu_memory_bytes = std::max(table.gpu_memory_bytes, feedback.gpu_memory_bytes);
    }
    missing.frames = envelope.frames = static_cast<std::uint32_t>(count);
    const double frame_ms = median(envelope.gpu_ms);
    for (auto& [name, samples] : passes)
        table.passes.push_back(to_row(std::move(name), samples, frame_ms));
    table.missing = to_row("(missing)", missing, frame_ms);
    table.frame = to_row("frame", envelope, frame_ms);
    table.draws = static_cast<std::uint32_t>(std::lround(median(draws)));
    table.triangles = static_cast<std::uint64_t>(std::llround(median(triangles)));
    return table;
}

std::string to_text(const PassTable& table) {
    std::string text = fmt::format("{:<24} {:>10} {:>10} {:>9} {:>10} {:>12} {:>12} {:>7}\n", "pass",
                                   "ms median", "ms p99", "share", "CPU ms", "written", "memory", "frames");
    for (const PassRow& row : table.passes)
        text += row_text(row);
    text += row_text(table.missing);
    text += row_text(table.frame);
    text +=
        fmt::format("GPU memory {}, {} draws and {} triangles per frame\n",
                    bytes_text(static_cast<double>(table.gpu_memory_bytes)), table.draws, table.triangles);
    return text;
}

nlohmann::json to_json(const PassTable& table) {
    nlohmann::json passes = nlohmann::json::array();
    for (const PassRow& row : table.passes)
        passes.push_back(row_json(row));
    return {{"passes", passes},
            {"missing", row_json(table.missing)},
            {"frame", row_json(table.frame)},
            {"gpu_memory_bytes", table.gpu_memory_bytes},
            {"draws", table.draws},
            {"triangles", table.triangles}};
}

std::string bytes_text(double bytes) {
    constexpr std::array<const char*, 4> k_units{"B", "KiB", "MiB", "GiB"};
    std::size_t unit = 0;
    while (bytes >= 1024.0 && unit + 1 < k_units.size()) {
        bytes /= 1024.0;
        ++unit;
    }
    return fmt::format("{:.{}f} {}", bytes, unit == 0 || bytes >= 100.0 ? 0 : 1, k_units[unit]);
}

}  // namespace rambla::game
