#include "assets/cache/content_hash.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <vector>

namespace rambla::assets::test {
namespace {

TEST(ContentHash, StandsForTheBytes) {
    const std::array<std::byte, 3> abc{std::byte{'a'}, std::byte{'b'}, std::byte{'c'}};
    // XXH3, 128 bits, seed 0, of "abc": the published value (xxhsum -H2).
    EXPECT_EQ(to_string(content_hash(abc)), "06b05ab6733a618578af5f94892f3950");
}

TEST(ContentHash, EveryBitCounts) {
    std::vector<std::byte> bytes(300, std::byte{0});
    std::set<std::string> hashes{to_string(content_hash(bytes))};
    for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
        bytes[bit / 8] ^= std::byte{1} << bit % 8;
        hashes.insert(to_string(content_hash(bytes)));
        bytes[bit / 8] ^= std::byte{1} << bit % 8;
    }
    EXPECT_EQ(hashes.size(), bytes.size() * 8 + 1);
}

ContentHash of_texts(std::initializer_list<std::string_view> texts) {
    ContentHasher hasher;
    for (const std::string_view text : texts)
        hasher.add(text);
    return hasher.hash();
}

TEST(ContentHash, ValuesAreToldApartWhereTheirBytesAreNot) {
    EXPECT_EQ(of_texts({"ab", "c"}), of_texts({"ab", "c"}));
    EXPECT_NE(of_texts({"ab", "c"}), of_texts({"a", "bc"}));
    EXPECT_NE(of_texts({"abc"}), of_texts({"abc", ""}));
    EXPECT_NE(of_texts({}), of_texts({""}));
    ContentHasher narrow;
    narrow.add(std::uint8_t{1});
    ContentHasher wide;
    wide.add(std::uint32_t{1});
    EXPECT_NE(narrow.hash(), wide.hash());
}

}  // namespace
}  // namespace rambla::assets::test
