#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace rambla::ecs {

/// Bytes that are no usable snapshot or delta. The message says what was found, what was expected, and where.
class SnapshotError : public std::runtime_error {
public:
    SnapshotError(std::uint64_t offset, const std::string& found, const std::string& expected)
        : std::runtime_error{"snapshot, byte " + std::to_string(offset) + ": found " + found + ", expected " +
                             expected},
          offset_{offset},
          found_{found},
          expected_{expected} {}

    /// Where, in bytes from the beginning; 0 for what the stream says as a whole.
    [[nodiscard]] std::uint64_t offset() const { return offset_; }
    /// What stands there.
    [[nodiscard]] const std::string& found() const { return found_; }
    /// What should.
    [[nodiscard]] const std::string& expected() const { return expected_; }

private:
    std::uint64_t offset_;
    std::string found_;
    std::string expected_;
};

}  // namespace rambla::ecs
