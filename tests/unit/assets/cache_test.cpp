#include "assets/cache/cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "import_support.h"

namespace rambla::assets::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

using Bytes = std::vector<std::byte>;
constexpr std::uint64_t k_plenty = 1 << 20;
constexpr std::uint64_t k_header_bytes = 56;

ContentHash key_of(std::uint32_t number) {
    ContentHasher hasher;
    hasher.add(number);
    return hasher.hash();
}

Bytes payload_of(std::uint32_t number, std::size_t size) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i)
        bytes[i] = static_cast<std::byte>((number + i * 7) & 0xff);
    return bytes;
}

std::string content(const fs::path& file) {
    std::ifstream in{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
}

void overwrite(const fs::path& file, const std::string& text) {
    std::ofstream{file, std::ios::binary | std::ios::trunc} << text;
}

void set_used(const Cache& cache, std::uint32_t number, std::chrono::minutes ago) {
    fs::last_write_time(cache.file_of(key_of(number)), fs::file_time_type::clock::now() - ago);
}

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator{folder}, fs::directory_iterator{}));
}

TEST(Cache, GivesBackWhatItTook) {
    const ScratchFolder scratch;
    const fs::path folder = scratch.path() / "made" / "on demand";
    Cache cache{folder, k_plenty};
    EXPECT_FALSE(cache.load(key_of(1)));
    cache.store(key_of(1), payload_of(1, 1000));
    cache.store(key_of(2), {});
    EXPECT_EQ(cache.load(key_of(1)), payload_of(1, 1000));
    EXPECT_EQ(cache.load(key_of(2)), Bytes{});
    Cache later{folder, k_plenty};
    EXPECT_EQ(later.load(key_of(1)), payload_of(1, 1000));
    EXPECT_EQ(later.bytes(), 2 * k_header_bytes + 1000);
    EXPECT_EQ(cache_bytes(folder), 2 * k_header_bytes + 1000);
    EXPECT_EQ(cache_bytes(scratch.path() / "nowhere"), 0u);
    EXPECT_EQ(cache.counts().hits, 2u);
    EXPECT_EQ(cache.counts().misses, 1u);
    EXPECT_EQ(cache.counts().stored, 2u);
    EXPECT_EQ(cache.counts().damaged, 0u);
    cache.store(key_of(1), payload_of(9, 10));
    EXPECT_EQ(cache.load(key_of(1)), payload_of(9, 10)) << "the later one takes the place";
}

TEST(Cache, EveryFlippedBitAndEveryTruncationIsAMissThatHeals) {
    const ScratchFolder scratch;
    Cache cache{scratch.path(), k_plenty};
    const Bytes payload = payload_of(3, 40);
    cache.store(key_of(3), payload);
    const fs::path file = cache.file_of(key_of(3));
    const std::string whole = content(file);
    ASSERT_EQ(whole.size(), k_header_bytes + payload.size());
    std::uint64_t damages = 0;
    const auto expect_healed = [&](const std::string& damaged, const std::string& how) {
        overwrite(file, damaged);
        ++damages;
        EXPECT_FALSE(cache.load(key_of(3))) << how;
        EXPECT_FALSE(fs::exists(file)) << how;
        EXPECT_EQ(cache.counts().damaged, damages) << how;
    };
    for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
        std::string damaged = whole;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
        expect_healed(damaged, "bit " + std::to_string(bit));
    }
    for (std::size_t size = 0; size < whole.size(); ++size)
        expect_healed(whole.substr(0, size), "cut at " + std::to_string(size));
    expect_healed(whole + "x", "a byte more");
    cache.store(key_of(3), payload);
    EXPECT_EQ(cache.load(key_of(3)), payload);
}

TEST(Cache, AnEntryOfAnotherKeyIsNotTaken) {
    const ScratchFolder scratch;
    Cache cache{scratch.path(), k_plenty};
    cache.store(key_of(1), payload_of(1, 10));
    fs::copy_file(cache.file_of(key_of(1)), cache.file_of(key_of(2)));
    EXPECT_FALSE(cache.load(key_of(2)));
    EXPECT_TRUE(cache.load(key_of(1)));
}

TEST(Cache, WhatWasNotUsedForLongestGoesFirst) {
    const ScratchFolder scratch;
    constexpr std::uint64_t k_entry = k_header_bytes + 100;
    Cache cache{scratch.path(), 4 * k_entry};
    for (std::uint32_t i = 0; i < 4; ++i)
        cache.store(key_of(i), payload_of(i, 100));
    for (std::uint32_t i = 0; i < 4; ++i)
        set_used(cache, i, std::chrono::minutes{40 - 10 * i});
    EXPECT_TRUE(cache.load(key_of(0))) << "used now, so the next to go is 1";
    cache.store(key_of(4), payload_of(4, 100));
    EXPECT_TRUE(cache.load(key_of(0)));
    EXPECT_FALSE(cache.load(key_of(1)));
    EXPECT_TRUE(cache.load(key_of(4)));
    EXPECT_LE(cache.bytes(), 4 * k_entry);
    EXPECT_GE(cache.counts().evicted, 1u);
}

TEST(Cache, KeepsToItsLimitWhateverComes) {
    const ScratchFolder scratch;
    constexpr std::uint64_t k_limit = 10'000;
    Cache cache{scratch.path(), k_limit};
    for (std::uint32_t i = 0; i < 200; ++i)
        cache.store(key_of(i), payload_of(i, (i * 37) % 3000));
    std::uint64_t on_disk = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator{scratch.path()})
        on_disk += entry.file_size();
    EXPECT_LE(on_disk, k_limit);
    EXPECT_EQ(on_disk, cache.bytes());
    cache.store(key_of(999), payload_of(0, k_limit));
    EXPECT_FALSE(cache.load(key_of(999))) << "larger than all that may be kept";
    EXPECT_GT(files_in(scratch.path()), 0u) << "and nothing went for it";

    Cache smaller{scratch.path(), k_limit / 2};
    EXPECT_LE(smaller.bytes(), k_limit / 2) << "a lower limit counts from the start";
    Cache none{scratch.path(), 0};
    none.store(key_of(1), payload_of(1, 0));
    EXPECT_EQ(files_in(scratch.path()), 0u);
}

TEST(Cache, LeavesOtherFilesAloneAndClearsWhatWasAbandoned) {
    const ScratchFolder scratch;
    const fs::path mine = scratch.path() / "notes.txt";
    const fs::path old = scratch.path() / "0123.77-1.rambla.unfinished";
    const fs::path fresh = scratch.path() / "0123.77-2.rambla.unfinished";
    for (const fs::path& file : {mine, old, fresh})
        overwrite(file, std::string(500, 'x'));
    fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours{2});
    fs::last_write_time(mine, fs::file_time_type::clock::now() - std::chrono::hours{2000});
    Cache cache{scratch.path(), 200};
    EXPECT_EQ(cache.bytes(), 0u);
    EXPECT_TRUE(fs::exists(mine));
    EXPECT_FALSE(fs::exists(old));
    EXPECT_TRUE(fs::exists(fresh)) << "somebody may be writing it";
}

TEST(Cache, AFolderThatCannotBeWrittenCostsOneWarning) {
    const ScratchFolder scratch;
    const fs::path not_a_folder = scratch.path() / "file";
    overwrite(not_a_folder, "x");
    const LogCapture log;
    Cache cache{not_a_folder, k_plenty};
    for (std::uint32_t i = 0; i < 3; ++i) {
        cache.store(key_of(i), payload_of(i, 10));
        EXPECT_FALSE(cache.load(key_of(i)));
    }
    EXPECT_EQ(cache.counts().failed, 3u);
    EXPECT_THAT(log.text(), HasSubstr(not_a_folder.string()));
    EXPECT_EQ(log.lines(), 1);
}

// A payload tells its key, so that a mix-up between threads would be seen.
TEST(Cache, ThreadsAndProcessesShareAFolder) {
    const ScratchFolder scratch;
    Cache one{scratch.path(), 40'000};
    Cache other{scratch.path(), 40'000};
    std::atomic<int> wrong = 0;
    std::vector<std::thread> threads;
    for (std::uint32_t t = 0; t < 8; ++t)
        threads.emplace_back([&, t] {
            Cache& cache = t % 2 == 0 ? one : other;
            for (std::uint32_t i = 0; i < 200; ++i) {
                const std::uint32_t number = (i * 13 + t) % 50;
                if (const auto found = cache.load(key_of(number))) {
                    if (*found != payload_of(number, 700 + number)) ++wrong;
                } else {
                    cache.store(key_of(number), payload_of(number, 700 + number));
                }
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(one.counts().damaged + other.counts().damaged, 0u) << "nobody ever sees half an entry";
    EXPECT_GT(one.counts().hits + other.counts().hits, 100u);
    EXPECT_EQ(one.counts().failed + other.counts().failed, 0u);
}

}  // namespace
}  // namespace rambla::assets::test
