#pragma once

#include <cstdint>
#include <string>

namespace rambla::game {

/// Progress bar on standard error, drawn only where that is a terminal, and wiped when it ends.
class Progress {
public:
    /// @param shown  false keeps it silent whatever standard error is
    Progress(std::string what, std::uint32_t total, bool shown);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(std::uint32_t done);

private:
    std::string what_;
    std::uint32_t total_;
    bool shown_;
    std::uint32_t drawn_percent_;
};

}  // namespace rambla::game
