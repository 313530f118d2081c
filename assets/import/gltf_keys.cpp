#include "assets/import/gltf_keys.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <numeric>

#include "assets/import/gltf_transform.h"

namespace rambla::assets::gltf {

namespace {

constexpr float k_jump_s = 1e-6f;

/// Normalised bytes round each component to 1/254: four of them move the length by less than this.
constexpr float k_storage_error = 0.01f;

class KeyMending {
public:
    explicit KeyMending(Channel& channel)
        : channel_{channel},
          floats_per_key_{std::size_t{channel.width} *
                          (channel.interpolation == Interpolation::cubic_spline ? 3 : 1)} {}

    KeyFindings run() {
        std::vector<std::size_t> order = usable_keys();
        sort(order);
        count_repetitions(order);
        if (findings_.unusable + findings_.unsorted + findings_.repeated > 0) rebuild(order);
        return findings_;
    }

private:
    float* values(std::size_t key) { return channel_.values.data() + key * floats_per_key_; }
    float time(std::size_t key) const { return channel_.times_s[key]; }

    std::vector<std::size_t> usable_keys() {
        std::vector<std::size_t> keys;
        keys.reserve(channel_.times_s.size());
        for (std::size_t key = 0; key < channel_.times_s.size(); ++key) {
            const bool usable = std::isfinite(time(key)) && time(key) >= 0.0f &&
                                std::all_of(values(key), values(key) + floats_per_key_,
                                            [](float value) { return std::isfinite(value); }) &&
                                (channel_.path != AnimatedPath::rotation || make_unit(key));
            if (usable)
                keys.push_back(key);
            else
                ++findings_.unusable;
        }
        return keys;
    }

    /// @return  false for what is no rotation
    bool make_unit(std::size_t key) {
        float* const value =
            values(key) + (channel_.interpolation == Interpolation::cubic_spline ? channel_.width : 0);
        const glm::vec4 given{value[0], value[1], value[2], value[3]};
        const std::optional<glm::quat> unit = unit_rotation(given);
        if (!unit) return false;
        if (std::abs(glm::length(given) - 1.0f) > k_storage_error) ++findings_.not_unit;
        value[0] = unit->x;
        value[1] = unit->y;
        value[2] = unit->z;
        value[3] = unit->w;
        return true;
    }

    void sort(std::vector<std::size_t>& order) {
        for (std::size_t i = 1; i < order.size(); ++i)
            if (time(order[i]) < time(order[i - 1])) ++findings_.unsorted;
        if (findings_.unsorted > 0)
            std::stable_sort(order.begin(), order.end(),
                             [this](std::size_t a, std::size_t b) { return time(a) < time(b); });
    }

    void count_repetitions(const std::vector<std::size_t>& order) {
        for (std::size_t i = 1; i < order.size(); ++i)
            if (time(order[i]) == time(order[i - 1])) ++findings_.repeated;
    }

    void rebuild(const std::vector<std::size_t>& order) {
        std::vector<float> times_s;
        std::vector<float> numbers;
        times_s.reserve(order.size());
        numbers.reserve(order.size() * floats_per_key_);
        const auto append = [&](std::size_t key, float at_s) {
            times_s.push_back(at_s);
            numbers.insert(numbers.end(), values(key), values(key) + floats_per_key_);
        };
        for (std::size_t first = 0; first < order.size();) {
            const float at_s = time(order[first]);
            std::size_t next = first + 1;
            while (next < order.size() && time(order[next]) == at_s)
                ++next;
            const std::size_t last = next - 1;
            const float later_s = std::max(at_s + k_jump_s, std::nextafter(at_s, k_infinity));
            const bool room = std::isfinite(later_s) && (next == order.size() || later_s < time(order[next]));
            const bool equal =
                std::equal(values(order[first]), values(order[first]) + floats_per_key_, values(order[last]));
            if (equal || !room) {
                append(order[last], at_s);
            } else {
                append(order[first], at_s);
                append(order[last], later_s);
            }
            first = next;
        }
        channel_.times_s = std::move(times_s);
        channel_.values = std::move(numbers);
    }

    static constexpr float k_infinity = std::numeric_limits<float>::infinity();

    Channel& channel_;
    std::size_t floats_per_key_;
    KeyFindings findings_;
};

}  // namespace

KeyFindings& KeyFindings::operator+=(const KeyFindings& other) {
    unusable += other.unusable;
    unsorted += other.unsorted;
    repeated += other.repeated;
    not_unit += other.not_unit;
    return *this;
}

KeyFindings mend_keys(Channel& channel) {
    return KeyMending{channel}.run();
}

}  // namespace rambla::assets::gltf
