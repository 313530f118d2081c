#include "assets/cache/content_hash.h"

#include <spdlog/fmt/fmt.h>
#include <xxhash.h>

#include <new>

namespace rambla::assets {

namespace {

ContentHash from_xxh(XXH128_hash_t hash) {
    return {.high = hash.high64, .low = hash.low64};
}

}  // namespace

struct ContentHasher::State {
    XXH3_state_t* xxh = XXH3_createState();
    ~State() { XXH3_freeState(xxh); }
};

ContentHasher::ContentHasher() : state_{std::make_unique<State>()} {
    if (state_->xxh == nullptr) throw std::bad_alloc{};
    XXH3_128bits_reset(state_->xxh);
}

ContentHasher::~ContentHasher() = default;

void ContentHasher::add(std::span<const std::byte> bytes) {
    const std::uint64_t size = bytes.size();
    XXH3_128bits_update(state_->xxh, &size, sizeof size);
    XXH3_128bits_update(state_->xxh, bytes.data(), bytes.size());
}

void ContentHasher::add(const ContentHash& hash) {
    add(hash.high);
    add(hash.low);
}

ContentHash ContentHasher::hash() const {
    return from_xxh(XXH3_128bits_digest(state_->xxh));
}

ContentHash content_hash(std::span<const std::byte> bytes) {
    return from_xxh(XXH3_128bits(bytes.data(), bytes.size()));
}

std::string to_string(const ContentHash& hash) {
    return fmt::format("{:016x}{:016x}", hash.high, hash.low);
}

}  // namespace rambla::assets
