#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "assets/cache/content_hash.h"

namespace rambla::assets {

/// What a Cache has done since it was opened.
struct CacheCounts {
    std::uint64_t hits = 0;
    std::uint64_t misses = 0;   ///< entries that were not there, the damaged ones included
    std::uint64_t damaged = 0;  ///< entries that were no more what was stored: removed
    std::uint64_t stored = 0;
    std::uint64_t failed = 0;   ///< entries that could not be written
    std::uint64_t evicted = 0;  ///< entries removed to keep to the limit
};

/// Results of processing in a folder, found again by a hash of all that they were made of, the code's version
/// included. Any number of threads and processes may share a folder. Nothing here is an error: what cannot
/// be read is a miss, what cannot be written is made again next time, with one warning for the folder.
///
/// An entry is a file: a header with key, size and hash of the payload, then the payload. It is written under
/// another name and renamed, so that nobody sees half of one; one that a crash or a disk has damaged does not
/// match its hash, is removed and counts as missing. Files by other names are left alone and not counted.
class Cache {
public:
    /// Entries that were not used for longest go when all together exceed the limit.
    /// @param limit_bytes  0: nothing is kept
    Cache(std::filesystem::path folder, std::uint64_t limit_bytes);

    /// The payload, bit by bit as it was stored; marks the entry as used now.
    [[nodiscard]] std::optional<std::vector<std::byte>> load(const ContentHash& key);
    /// Whether there is an entry, whatever is in it.
    [[nodiscard]] bool contains(const ContentHash& key) const;
    /// Takes the place of an entry of the same key. @return  whether it is kept
    bool store(const ContentHash& key, std::span<const std::byte> payload);

    [[nodiscard]] CacheCounts counts() const;
    /// Bytes of all entries, as far as this process knows.
    [[nodiscard]] std::uint64_t bytes() const;
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] std::filesystem::path file_of(const ContentHash& key) const;

private:
    void warn_once(const std::filesystem::path& file, const char* what);
    void evict(const std::filesystem::path& kept);

    std::filesystem::path folder_;
    std::uint64_t limit_bytes_;
    mutable std::mutex mutex_;  ///< guards bytes_ and the folder's list
    std::uint64_t bytes_ = 0;
    std::atomic<std::uint64_t> hits_ = 0;
    std::atomic<std::uint64_t> misses_ = 0;
    std::atomic<std::uint64_t> damaged_ = 0;
    std::atomic<std::uint64_t> stored_ = 0;
    std::atomic<std::uint64_t> failed_ = 0;
    std::atomic<std::uint64_t> evicted_ = 0;
    std::atomic<bool> warned_ = false;
};

/// Bytes of all entries of a folder; 0 where there is none.
[[nodiscard]] std::uint64_t cache_bytes(const std::filesystem::path& folder);

}  // namespace rambla::assets
