#include "game/trace_file.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <utility>

#include "assets/error.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;

std::error_code last_failure() {
    return {errno, std::generic_category()};
}

assets::Error not_written(const fs::path& file, const std::error_code& reason) {
    return assets::Error{file.string(), "", "cannot be written: " + reason.message(), ""};
}

/// A JSON string; what is no UTF-8 is replaced.
std::string quoted(std::string_view text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Microseconds, exact to the nanosecond: rounding would let spans overlap that do not.
std::string microseconds(std::chrono::nanoseconds time) {
    const std::int64_t ns = std::max<std::int64_t>(time.count(), 0);
    return fmt::format("{}.{:03}", ns / 1000, ns % 1000);
}

}  // namespace

TraceFile::TraceFile(fs::path file, std::chrono::steady_clock::time_point zero)
    : path_{std::move(file)}, zero_{zero} {
    std::error_code failed;
    if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), failed);
    file_.reset(std::fopen(path_.c_str(), "w"));
    if (!file_) throw not_written(path_, last_failure());
    std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // it would be emptied in the middle of an event
    unwritten_ = "[\n";
}

TraceFile::~TraceFile() {
    if (!file_) return;
    unwritten_ += "\n]\n";
    flush();
}

void TraceFile::name_track(std::uint32_t track, std::string_view name) {
    write_event(fmt::format(R"({{"name":"thread_name","ph":"M","pid":1,"tid":{},"args":{{"name":{}}}}})",
                            track, quoted(name)));
}

void TraceFile::add(const TraceSpan& span) {
    write_event(
        fmt::format(R"({{"name":{},"cat":{},"ph":"X","ts":{},"dur":{},"pid":1,"tid":{},"args":{{{}:{}}}}})",
                    quoted(span.name), quoted(span.category), microseconds(span.begin - zero_),
                    microseconds(span.duration), span.track, quoted(span.of), span.number));
}

void TraceFile::close() {
    unwritten_ += "\n]\n";
    flush();
    if (std::fclose(file_.release()) != 0 && !failure_) failure_ = last_failure();
    if (failure_) throw not_written(path_, failure_);
}

void TraceFile::write_event(std::string_view text) {
    constexpr std::size_t k_most_unwritten = 65536;
    if (!empty_) unwritten_ += ",\n";
    empty_ = false;
    unwritten_ += text;
    if (unwritten_.size() >= k_most_unwritten) flush();
}

void TraceFile::flush() {
    const std::size_t size = unwritten_.size();
    if (!failure_ && std::fwrite(unwritten_.data(), 1, size, file_.get()) != size) failure_ = last_failure();
    unwritten_.clear();
}

}  // namespace rambla::game
