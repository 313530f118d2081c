#include "assets/cache/cache.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

namespace rambla::assets {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view k_extension = ".rambla";
constexpr std::string_view k_unfinished = ".unfinished";
// What another process left unfinished this long ago, it will not finish.
constexpr std::chrono::hours k_abandoned_after{1};
constexpr std::uint32_t k_format = 1;

struct Header {
    std::array<char, 8> magic{'R', 'a', 'm', 'b', 'l', 'a', 'C', '\n'};
    std::uint32_t format = k_format;
    std::uint32_t byte_order = 0x01020304;
    ContentHash key;
    std::uint64_t payload_bytes = 0;
    ContentHash payload_hash;

    bool operator==(const Header&) const = default;
};
static_assert(sizeof(Header) == 56 && std::is_trivially_copyable_v<Header>);

Header header_of(const ContentHash& key, std::span<const std::byte> payload) {
    Header header;
    header.key = key;
    header.payload_bytes = payload.size();
    header.payload_hash = content_hash(payload);
    return header;
}

/// The payload of a file that is what it says, else nothing.
std::optional<std::vector<std::byte>> read_entry(const fs::path& file, const ContentHash& key) {
    std::error_code failure;
    const std::uint64_t size = fs::file_size(file, failure);
    if (failure || size < sizeof(Header)) return std::nullopt;
    std::ifstream in{file, std::ios::binary};
    Header header;
    in.read(reinterpret_cast<char*>(&header), sizeof header);
    if (!in || header.payload_bytes != size - sizeof header) return std::nullopt;
    std::vector<std::byte> payload(header.payload_bytes);
    in.read(reinterpret_cast<char*>(payload.data()), static_cast<std::streamsize>(payload.size()));
    if (!in || header != header_of(key, payload)) return std::nullopt;
    return payload;
}

bool write_entry(const fs::path& file, const Header& header, std::span<const std::byte> payload) {
    std::ofstream out{file, std::ios::binary | std::ios::trunc};
    out.write(reinterpret_cast<const char*>(&header), sizeof header);
    out.write(reinterpret_cast<const char*>(payload.data()), static_cast<std::streamsize>(payload.size()));
    out.close();
    return static_cast<bool>(out);
}

/// A name that no other thread or process uses, whatever it writes.
fs::path unfinished_name(const fs::path& file) {
    static std::atomic<std::uint64_t> next{0};
    return fs::path{file}.replace_extension(
        fmt::format(".{}-{}{}{}", ::getpid(), next++, k_extension, k_unfinished));
}

struct Entry {
    fs::path file;
    fs::file_time_type used;
    std::uint64_t bytes;
};

/// Other processes come and go in the folder: whatever cannot be asked any more is left out.
std::vector<Entry> entries_of(const fs::path& folder) {
    std::vector<Entry> entries;
    std::error_code failure;
    for (fs::directory_iterator at{folder, failure}, end; !failure && at != end; at.increment(failure)) {
        std::error_code gone;
        if (!at->is_regular_file(gone) || gone) continue;
        const fs::file_time_type used = at->last_write_time(gone);
        if (gone) continue;
        const fs::path& file = at->path();
        if (file.extension() == k_unfinished && file.stem().extension() == k_extension) {
            if (fs::file_time_type::clock::now() - used > k_abandoned_after) fs::remove(file, gone);
            continue;
        }
        if (file.extension() != k_extension) continue;
        const std::uint64_t bytes = at->file_size(gone);
        if (!gone) entries.push_back({file, used, bytes});
    }
    return entries;
}

std::uint64_t bytes_of(std::span<const Entry> entries) {
    std::uint64_t bytes = 0;
    for (const Entry& entry : entries)
        bytes += entry.bytes;
    return bytes;
}

}  // namespace

std::uint64_t cache_bytes(const fs::path& folder) {
    return bytes_of(entries_of(folder));
}

Cache::Cache(fs::path folder, std::uint64_t limit_bytes)
    : folder_{std::move(folder)}, limit_bytes_{limit_bytes} {
    std::error_code failure;
    fs::create_directories(folder_, failure);
    if (failure) warn_once(folder_, "a folder that cannot be made");
    const std::lock_guard lock{mutex_};
    evict({});
}

fs::path Cache::file_of(const ContentHash& key) const {
    return folder_ / (to_string(key) + std::string{k_extension});
}

std::optional<std::vector<std::byte>> Cache::load(const ContentHash& key) {
    const fs::path file = file_of(key);
    std::error_code failure;
    if (fs::is_regular_file(file, failure)) {
        if (std::optional<std::vector<std::byte>> payload = read_entry(file, key)) {
            fs::last_write_time(file, fs::file_time_type::clock::now(), failure);
            ++hits_;
            return payload;
        }
        fs::remove(file, failure);
        ++damaged_;
    }
    ++misses_;
    return std::nullopt;
}

bool Cache::contains(const ContentHash& key) const {
    std::error_code failure;
    return fs::is_regular_file(file_of(key), failure);
}

bool Cache::store(const ContentHash& key, std::span<const std::byte> payload) {
    if (sizeof(Header) + payload.size() > limit_bytes_) return false;
    const fs::path file = file_of(key);
    const fs::path unfinished = unfinished_name(file);
    std::error_code failure;
    // No fsync: after a crash the hash tells what did not reach the disk.
    const bool written = write_entry(unfinished, header_of(key, payload), payload);
    if (written) fs::rename(unfinished, file, failure);
    if (!written || failure) {
        fs::remove(unfinished, failure);
        ++failed_;
        warn_once(file, "a place that cannot be written to");
        return false;
    }
    ++stored_;
    const std::lock_guard lock{mutex_};
    bytes_ += sizeof(Header) + payload.size();
    if (bytes_ > limit_bytes_) evict(file);
    return true;
}

void Cache::evict(const fs::path& kept) {
    std::vector<Entry> entries = entries_of(folder_);
    bytes_ = bytes_of(entries);
    if (bytes_ <= limit_bytes_) return;
    // A tenth below the limit, so that the folder is not listed again for the next entry.
    const std::uint64_t enough = limit_bytes_ - limit_bytes_ / 10;
    std::ranges::sort(entries, {}, [](const Entry& entry) { return std::pair{entry.used, entry.file}; });
    for (const Entry& entry : entries) {
        if (bytes_ <= enough) return;
        if (entry.file == kept) continue;
        std::error_code failure;
        if (fs::remove(entry.file, failure)) ++evicted_;
        bytes_ -= entry.bytes;
    }
}

CacheCounts Cache::counts() const {
    return {.hits = hits_,
            .misses = misses_,
            .damaged = damaged_,
            .stored = stored_,
            .failed = failed_,
            .evicted = evicted_};
}

std::uint64_t Cache::bytes() const {
    const std::lock_guard lock{mutex_};
    return bytes_;
}

void Cache::warn_once(const fs::path& file, const char* what) {
    if (!warned_.exchange(true))
        spdlog::warn("{}: {}; what is processed is not kept for the next start", file.string(), what);
}

}  // namespace rambla::assets
