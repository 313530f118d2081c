#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <span>

#include "assets/import/gltf_unit.h"
#include "draft.h"

namespace rambla::assets::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr float k_infinity = std::numeric_limits<float>::infinity();
constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_not_finite[]{k_infinity, -k_infinity, k_nan, -k_nan};

/// Columns are read in pieces of 512 vectors, which are checked some at a time.
std::vector<std::size_t> sizes() {
    std::vector<std::size_t> all(21);
    std::iota(all.begin(), all.end(), std::size_t{0});
    all.insert(all.end(), {63, 64, 65, 511, 512, 513, 1023, 1024, 1025, 1300});
    return all;
}

/// Finite, of both signs, denormal, and zeros of both signs.
float finite(std::size_t i) {
    constexpr float k_tiny = std::numeric_limits<float>::denorm_min();
    constexpr float k_large = std::numeric_limits<float>::max();
    constexpr float k_some[]{1.5f, -0.0f, 0.0f, -k_tiny, k_tiny, -k_large, k_large, -7.25f, 1e-39f};
    return k_some[i % std::size(k_some)];
}

std::vector<float> finite_numbers(std::size_t count) {
    std::vector<float> numbers(count);
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = finite(i);
    return numbers;
}

/// Directions of unit length, with `width` components, of which a fourth is a sign.
std::vector<float> directions(std::size_t count, std::size_t width) {
    std::vector<float> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        const auto turn = static_cast<float>(i);
        const float direction[]{std::cos(turn), 0.6f * std::sin(turn), 0.8f * std::sin(turn),
                                i % 3 == 0 ? -1.0f : 1.0f};
        numbers.insert(numbers.end(), direction, direction + width);
    }
    return numbers;
}

template <class Vector>
std::vector<std::uint32_t> bits_of(const std::vector<Vector>& vectors) {
    std::vector<std::uint32_t> bits(vectors.size() * sizeof(Vector) / sizeof(std::uint32_t));
    if (!bits.empty()) std::memcpy(bits.data(), vectors.data(), vectors.size() * sizeof(Vector));
    return bits;
}

/// A mesh of columns, and what was said of it.
struct Read {
    Mesh mesh;
    std::string warnings;
};

Read read(const Draft& draft, const std::string& attributes, const std::string& more = {}) {
    const LogCapture log;
    Scene scene =
        draft.load(R"(,"meshes":[{"primitives":[{"attributes":{)" + attributes + "}" + more + "}]}]");
    return {std::move(scene.meshes.at(0)), log.text()};
}

Read read_positions(const std::vector<float>& numbers) {
    Draft draft;
    draft.add(numbers, "VEC3");
    return read(draft, R"("POSITION":0)", R"(,"mode":0)");
}

Read read_normals(const std::vector<float>& normals) {
    Draft draft;
    draft.add(finite_numbers(normals.size()), "VEC3");
    draft.add(normals, "VEC3");
    return read(draft, R"("POSITION":0,"NORMAL":1)");
}

Read read_tangents(const std::vector<float>& tangents) {
    Draft draft;
    const std::size_t count = tangents.size() / 4;
    draft.add(finite_numbers(3 * count), "VEC3");
    draft.add(directions(count, 3), "VEC3");
    draft.add(tangents, "VEC4");
    return read(draft, R"("POSITION":0,"NORMAL":1,"TANGENT":2)");
}

TEST(GltfColumns, FiniteNumbersKeepTheirBits) {
    for (const std::size_t size : sizes()) {
        if (size == 0) continue;
        const std::vector<float> numbers = finite_numbers(3 * size);
        const Read found = read_positions(numbers);
        EXPECT_EQ(bits_of(found.mesh.positions), bits_of(numbers)) << size;
        EXPECT_EQ(found.warnings, "") << size;
    }
}

TEST(GltfColumns, NumbersThatAreNotFiniteBecomeZeroWhereverTheyAre) {
    for (const std::size_t size : sizes())
        for (const float bad : k_not_finite)
            for (const std::size_t at : {std::size_t{0}, 3 * size / 2, 3 * size - 1}) {
                if (size == 0) continue;
                std::vector<float> numbers = finite_numbers(3 * size);
                numbers[at] = bad;
                const Read found = read_positions(numbers);
                numbers[at] = 0.0f;
                EXPECT_EQ(bits_of(found.mesh.positions), bits_of(numbers)) << at << " of " << size;
                EXPECT_THAT(found.warnings, HasSubstr("POSITION: 1 values were not finite and became 0"));
            }
}

TEST(GltfColumns, NumbersThatAreNotFiniteAreCountedInAllPieces) {
    std::vector<float> numbers = finite_numbers(3 * 1300);
    for (const std::size_t at : {0u, 1535u, 1536u, 3000u, 3899u})
        numbers[at] = k_nan;
    EXPECT_THAT(read_positions(numbers).warnings, HasSubstr("POSITION: 5 values were not finite"));
}

TEST(GltfColumns, DirectionsOfUnitLengthKeepTheirBits) {
    for (const std::size_t size : sizes()) {
        if (size == 0) continue;
        const std::vector<float> normals = directions(size, 3);
        const std::vector<float> tangents = directions(size, 4);
        EXPECT_EQ(bits_of(read_normals(normals).mesh.normals), bits_of(normals)) << size;
        const Read found = read_tangents(tangents);
        EXPECT_EQ(bits_of(found.mesh.tangents), bits_of(tangents)) << size;
        EXPECT_THAT(found.warnings, Not(HasSubstr("finite")));
    }
}

TEST(GltfColumns, WrongNormalsAreMendedWhereverTheyAre) {
    for (const std::size_t size : sizes())
        for (const std::size_t at : {std::size_t{0}, size / 2, size - 1}) {
            if (size == 0) continue;
            const auto with = [&](float x, float y, float z) {
                std::vector<float> numbers = directions(size, 3);
                numbers[3 * at] = x, numbers[3 * at + 1] = y, numbers[3 * at + 2] = z;
                return numbers;
            };
            const auto expect = [&](const Read& found, const std::vector<float>& wanted) {
                EXPECT_EQ(bits_of(found.mesh.normals), bits_of(wanted)) << at << " of " << size;
            };
            expect(read_normals(with(0, 0, 2)), with(0, 0, 1));
            expect(read_normals(with(0, 0, 0)), with(0, 1, 0));
            expect(read_normals(with(3e38f, 3e38f, 0)), with(0, 1, 0));
            for (const float bad : k_not_finite) {
                const Read found = read_normals(with(0, -4, bad));
                expect(found, with(0, -1, 0));
                EXPECT_THAT(found.warnings, HasSubstr("NORMAL: 1 values were not finite and became 0"));
            }
        }
}

TEST(GltfColumns, WrongTangentsAreMendedWhereverTheyAre) {
    for (const std::size_t size : sizes())
        for (const std::size_t at : {std::size_t{0}, size / 2, size - 1}) {
            if (size == 0) continue;
            const auto with = [&](float x, float w) {
                std::vector<float> numbers = directions(size, 4);
                numbers[4 * at] = x, numbers[4 * at + 1] = 0, numbers[4 * at + 2] = 0;
                numbers[4 * at + 3] = w;
                return numbers;
            };
            const auto expect = [&](const Read& found, const std::vector<float>& wanted) {
                EXPECT_EQ(bits_of(found.mesh.tangents), bits_of(wanted)) << at << " of " << size;
            };
            expect(read_tangents(with(2, -1)), with(1, -1));
            expect(read_tangents(with(1, -0.5f)), with(1, -1));
            expect(read_tangents(with(1, 1.0000001f)), with(1, 1));
            expect(read_tangents(with(1, -0.0f)), with(1, 1));
            for (const float bad : k_not_finite) {
                const Read found = read_tangents(with(1, bad));
                expect(found, with(1, 1));
                EXPECT_THAT(found.warnings, HasSubstr("TANGENT: 1 values were not finite and became 0"));
            }
        }
}

/// The normal that a tangent without a direction is made for is that of its vertex, in every piece.
TEST(GltfColumns, TangentsWithoutADirectionAreMadePerpendicularToTheirNormals) {
    constexpr std::size_t k_count = 1300;
    std::vector<float> tangents = directions(k_count, 4);
    const std::vector<float> normals = directions(k_count, 3);
    for (const std::size_t at : {0u, 511u, 512u, 1024u, 1299u}) {
        std::vector<float> some = tangents;
        some[4 * at] = some[4 * at + 1] = some[4 * at + 2] = 0.0f;
        const glm::vec3 made{read_tangents(some).mesh.tangents.at(at)};
        const glm::vec3 normal{normals[3 * at], normals[3 * at + 1], normals[3 * at + 2]};
        EXPECT_NEAR(glm::dot(made, normal), 0.0f, 1e-6f) << at;  // one rounding
        EXPECT_NEAR(glm::length(made), 1.0f, 1e-6f) << at;
    }
}

TEST(GltfColumns, BuffersNeedNotBeAligned) {
    constexpr std::size_t k_count = 600;
    std::vector<float> numbers = finite_numbers(3 * k_count);
    numbers.back() = k_nan;
    std::vector<std::uint8_t> bytes(1 + numbers.size() * sizeof(float));
    std::memcpy(&bytes[1], numbers.data(), numbers.size() * sizeof(float));
    Draft draft;
    draft.add(bytes, "SCALAR");
    draft.add_text(R"({"bufferView":0,"byteOffset":1,"componentType":5126,"count":600,"type":"VEC3"})");
    const Read found = read(draft, R"("POSITION":1)", R"(,"mode":0)");
    numbers.back() = 0.0f;
    EXPECT_EQ(bits_of(found.mesh.positions), bits_of(numbers));
    EXPECT_THAT(found.warnings, HasSubstr("POSITION: 1 values were not finite"));
}

TEST(GltfColumns, SparseValuesAreCheckedAndTheReplacedAreNot) {
    constexpr std::size_t k_count = 600;
    std::vector<float> numbers = finite_numbers(3 * k_count);
    numbers[0] = k_infinity;
    Draft draft;
    draft.add(numbers, "VEC3");
    draft.add<std::uint16_t>({0, 599}, "SCALAR");
    draft.add<float>({1, 2, 3, 4, k_nan, 6}, "VEC3");
    const std::string sparse = R"("sparse":{"count":2,"indices":{"bufferView":1,"componentType":5123},)"
                               R"("values":{"bufferView":2}}})";
    draft.add_text(R"({"bufferView":0,"componentType":5126,"count":600,"type":"VEC3",)" + sparse);
    const int zeros = draft.add_text(R"({"componentType":5126,"count":600,"type":"VEC3",)" + sparse);
    EXPECT_EQ(zeros, 4);
    for (const char* const accessor : {"3", "4"}) {
        const Read found = read(draft, std::string{R"("POSITION":)"}.append(accessor), R"(,"mode":0)");
        EXPECT_EQ(found.mesh.positions.front(), glm::vec3(1, 2, 3));
        EXPECT_EQ(found.mesh.positions.back(), glm::vec3(4, 0, 6));
        EXPECT_THAT(found.warnings, HasSubstr("POSITION: 1 values were not finite"));
    }
}

TEST(GltfColumns, OnlyVerticesThatAreKeptAreCheckedAndAllOfThem) {
    constexpr std::size_t k_count = 3000;
    std::vector<float> numbers = finite_numbers(3 * k_count);
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < k_count; i += 3)
        indices.push_back(i);
    numbers[3] = k_nan;
    numbers[3 * 2997] = k_nan;
    Draft draft;
    draft.add(numbers, "VEC3");
    draft.add(indices, "SCALAR");
    const Read found = read(draft, R"("POSITION":0)", R"(,"mode":0,"indices":1)");
    ASSERT_EQ(found.mesh.positions.size(), 1000u);
    EXPECT_EQ(found.mesh.positions.back(), glm::vec3(0, numbers[3 * 2997 + 1], numbers[3 * 2997 + 2]));
    EXPECT_THAT(found.warnings, HasSubstr("POSITION: 1 values were not finite"));
}

template <class T>
std::string index_error(const std::vector<T>& indices, const std::string& sparse = {}) {
    Draft draft;
    draft.add(finite_numbers(3 * 200), "VEC3");
    draft.add<std::uint16_t>({0, 1}, "SCALAR");
    draft.add<T>({static_cast<T>(3), static_cast<T>(200)}, "SCALAR");
    draft.add(indices, "SCALAR", sparse);
    return draft.error(R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":3,"mode":0}]}])");
}

template <class T>
void expect_that_indices_are_checked() {
    for (const std::size_t size : sizes())
        for (const std::size_t at : {std::size_t{0}, size / 2, size - 1}) {
            if (size == 0) continue;
            std::vector<T> indices(size, 199);
            EXPECT_EQ(index_error(indices), "");
            indices[at] = 200;
            EXPECT_THAT(index_error(indices), HasSubstr("index 200 at " + std::to_string(at)));
        }
}

TEST(GltfColumns, IndicesAreCheckedWhereverTheyAre) {
    expect_that_indices_are_checked<std::uint8_t>();
    expect_that_indices_are_checked<std::uint16_t>();
    expect_that_indices_are_checked<std::uint32_t>();
}

TEST(GltfColumns, SparseIndicesAreCheckedAndTheReplacedAreNot) {
    const auto sparse = [](int count) {
        return R"(,"sparse":{"count":)" + std::to_string(count) +
               R"(,"indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":2}})";
    };
    EXPECT_EQ(index_error<std::uint16_t>({250, 1, 2}, sparse(1)), "");
    EXPECT_THAT(index_error<std::uint16_t>({0, 1, 2}, sparse(2)), HasSubstr("index 200 at 1"));
}

TEST(GltfColumns, WhatIsOfUnitLengthIsToldAtEverySize) {
    for (std::size_t size = 0; size <= 20; ++size) {
        std::vector<glm::vec3> vectors(size, glm::vec3{0.6f, 0.0f, 0.80001f});
        EXPECT_TRUE(gltf::are_unit(std::span<const glm::vec3>{vectors}));
        for (std::size_t at = 0; at < size; ++at)
            for (const glm::vec3 wrong :
                 {glm::vec3{0.6f, 0.0f, 0.801f}, glm::vec3{0.6f, 0.0f, 0.799f}, glm::vec3{0.0f},
                  glm::vec3{k_nan, 0.6f, 0.8f}, glm::vec3{0.0f, -k_infinity, 0.0f}, glm::vec3{-k_nan}}) {
                std::vector<glm::vec3> some = vectors;
                some[at] = wrong;
                EXPECT_FALSE(gltf::are_unit(std::span<const glm::vec3>{some})) << at << " of " << size;
            }
    }
}

TEST(GltfColumns, WhatIsASignIsToldAtEverySize) {
    for (std::size_t size = 0; size <= 20; ++size) {
        std::vector<glm::vec4> vectors(size, glm::vec4{5.0f, k_nan, 0.0f, 1.0f});
        for (std::size_t i = 0; i < size; i += 2)
            vectors[i].w = -1.0f;
        EXPECT_TRUE(gltf::are_signs(vectors));
        for (std::size_t at = 0; at < size; ++at)
            for (const float wrong : {0.0f, -0.0f, std::nextafter(1.0f, 2.0f), -0.5f, k_nan, -k_infinity}) {
                std::vector<glm::vec4> some = vectors;
                some[at].w = wrong;
                EXPECT_FALSE(gltf::are_signs(some)) << at << " of " << size;
            }
    }
}

}  // namespace
}  // namespace rambla::assets::test
