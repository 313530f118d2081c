#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>

namespace rambla::test {

/// Random inputs for property tests, the same in every run.
class Random {
public:
    explicit Random(std::uint32_t seed) : engine_{seed} {}

    float uniform(float low, float high) { return std::uniform_real_distribution<float>{low, high}(engine_); }
    std::uint32_t below(std::uint32_t count) {
        return std::uniform_int_distribution<std::uint32_t>{0, count - 1}(engine_);
    }
    std::uint64_t bits() { return std::uniform_int_distribution<std::uint64_t>{}(engine_); }
    /// Any float at all: every exponent is equally likely, with NaN, infinities, denormals and both zeros
    /// among them.
    float any_float() { return std::bit_cast<float>(static_cast<std::uint32_t>(bits())); }
    /// Any positive float, from denormals to the largest, all magnitudes equally likely.
    float positive() { return std::bit_cast<float>(below(0x7f800000u)); }
    glm::vec3 point(float reach) {
        return {uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)};
    }
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 p = point(1.0f);
            const float size = glm::length(p);
            if (size > 0.1f && size <= 1.0f) return p / size;
        }
    }
    glm::quat rotation() { return glm::angleAxis(uniform(-3.14159f, 3.14159f), direction()); }

private:
    std::mt19937 engine_;
};

}  // namespace rambla::test
