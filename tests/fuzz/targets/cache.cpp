#include <cstring>
#include <string>

#include "assets/cache/cache.h"
#include "fuzz/scratch.h"
#include "fuzz/target.h"

namespace rambla::fuzz {
namespace {

constexpr std::uint64_t k_plenty = 1 << 24;
constexpr std::size_t k_header_bytes = 56;

assets::Cache& cache() {
    static assets::Cache k_cache{scratch_folder() / "cache", k_plenty};
    return k_cache;
}

/// The bytes as an entry: nothing comes back but what a header with the right hash vouches for.
void load_foreign(const assets::ContentHash& key, Bytes bytes) {
    write_scratch("cache/" + cache().file_of(key).filename().string(), bytes);
    const auto payload = cache().load(key);
    if (payload && payload->size() + k_header_bytes != bytes.size())
        broken("a payload is as long as its entry says");
}

/// A whole entry, then changed: 4 bytes of place and value for each change, the rest is the payload.
void load_damaged(const assets::ContentHash& key, Bytes bytes) {
    const std::size_t changes =
        std::min<std::size_t>(bytes.size() / 4, std::to_integer<std::size_t>(bytes[0]) % 4);
    const Bytes places = bytes.first(4 * changes);
    const Bytes payload = bytes.subspan(4 * changes);
    cache().store(key, payload);
    std::vector<std::byte> entry = read_scratch(cache().file_of(key));
    for (std::size_t i = 0; i < changes; ++i) {
        std::uint16_t place = 0;
        std::memcpy(&place, &places[4 * i + 1], sizeof place);
        entry[place % entry.size()] ^= places[4 * i + 3];
    }
    load_foreign(key, entry);
    const auto back = cache().load(key);
    if (back && !std::equal(back->begin(), back->end(), payload.begin(), payload.end()))
        broken("a payload comes back as it was stored, or not at all");
}

/// The first byte chooses.
void run(Bytes bytes) {
    if (bytes.empty()) return;
    assets::ContentHasher hasher;
    hasher.add(std::string_view{"fuzz"});
    const assets::ContentHash key = hasher.hash();
    if (std::to_integer<int>(bytes[0]) == 0)
        load_foreign(key, bytes.subspan(1));
    else if (bytes.size() > 1)
        load_damaged(key, bytes.subspan(1));
}

void seeds(const SeedTaker& take) {
    const auto text = [&](const std::string& name, const std::string& content) {
        take(name, std::as_bytes(std::span{content}));
    };
    text("intact", std::string{"\1\0payload", 9});
    text("changed", std::string{"\1\2\1\0\7\2\60\0\1payload", 16});
    text("foreign", std::string{"\0RamblaC\n", 9} + std::string(60, 'x'));
}

const Registration k_cache{{"cache", run, seeds}};

}  // namespace
}  // namespace rambla::fuzz
