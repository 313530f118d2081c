#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

namespace rambla::game {

/// Something that began and ended on one track of a trace.
struct TraceSpan {
    std::string_view name;
    std::string_view category;  ///< several: separated by commas
    std::uint32_t track = 0;
    std::chrono::steady_clock::time_point begin{};
    std::chrono::nanoseconds duration{};
    std::string_view of;       ///< what `number` counts, such as "frame"
    std::uint64_t number = 0;  ///< shown with the span
};

/// A file in the Trace Event Format (Google, 2016) as Perfetto and chrome://tracing read it: one array of
/// events. Written as it grows, in its place: it takes no memory that depends on its length, and a run that
/// is killed leaves whole events, which both open without the array's end.
class TraceFile {
public:
    /// Makes the file, and its folder. @param zero  the moment that is time 0
    /// @throws assets::Error  if it cannot be
    TraceFile(std::filesystem::path file, std::chrono::steady_clock::time_point zero);
    ~TraceFile();  ///< closes without a word about what failed
    TraceFile(const TraceFile&) = delete;
    TraceFile& operator=(const TraceFile&) = delete;

    void name_track(std::uint32_t track, std::string_view name);
    /// Of spans on one track, either one lies within the other or they do not overlap.
    void add(const TraceSpan& span);
    /// Ends the array. @throws assets::Error  if anything since the beginning could not be written
    void close();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    void write_event(std::string_view text);
    void flush();

    std::filesystem::path path_;
    std::chrono::steady_clock::time_point zero_;
    std::unique_ptr<std::FILE, CloseFile> file_;
    std::error_code failure_;  ///< the first
    std::string unwritten_;    ///< whole events
    bool empty_ = true;
};

}  // namespace rambla::game
