#pragma once

#include <cstdint>
#include <string_view>

namespace rambla::bench {

/// What a target limits.
enum class Measure {
    ratio,        ///< time of the subject / time of the baseline, at most
    nanoseconds,  ///< time of the subject per item, at most
    counter,      ///< a counter that the subject reports, at most
    speed_up,     ///< time of the baseline / time of the subject, at least
    share,        ///< the same where the subject contains the baseline's work, at least
};

/// One line of the table of targets.
struct Target {
    std::string_view operation;
    std::uint64_t size = 0;  ///< the only size that it speaks about; 0: every size that is measured
    Measure measure = Measure::ratio;
    double solid = 0.0;  ///< the floor of acceptance
    double goal = 0.0;   ///< what we want
    std::string_view reason;
    std::string_view subject = "rambla";  ///< variant that is judged
    std::string_view baseline = "bare";   ///< variant that it is compared with, for ratio, speed_up and share
    std::string_view counter = {};        ///< its name, for counter
};

enum class Verdict { no_target, not_measured, missed, solid, goal };

/// Whether more is better.
[[nodiscard]] constexpr bool wants_at_least(Measure measure) {
    return measure == Measure::speed_up || measure == Measure::share;
}

/// @param value  in the target's measure
[[nodiscard]] constexpr Verdict judge(const Target& target, double value) {
    const auto reaches = [&](double limit) {
        return wants_at_least(target.measure) ? value >= limit : value <= limit;
    };
    if (reaches(target.goal)) return Verdict::goal;
    return reaches(target.solid) ? Verdict::solid : Verdict::missed;
}

}  // namespace rambla::bench
