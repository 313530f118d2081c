#include "game/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace rambla::game {
namespace {

constexpr std::uint32_t k_bar_width = 40;
constexpr std::uint32_t k_not_drawn = 101;

}  // namespace

Progress::Progress(std::string what, std::uint32_t total, bool shown)
    : what_{std::move(what)},
      total_{total},
      shown_{shown && isatty(STDERR_FILENO) == 1},
      drawn_percent_{k_not_drawn} {}

Progress::~Progress() {
    if (shown_ && drawn_percent_ != k_not_drawn) std::fputs("\r\033[K", stderr);
}

void Progress::update(std::uint32_t done) {
    const std::uint32_t percent = total_ > 0 ? static_cast<std::uint32_t>(100ull * done / total_) : 100;
    if (!shown_ || percent == drawn_percent_) return;
    drawn_percent_ = percent;
    const std::uint32_t filled = k_bar_width * percent / 100;
    const std::string bar = std::string(filled, '=') + std::string(k_bar_width - filled, ' ');
    std::fprintf(stderr, "\r%s [%s] %3u %% (%u of %u)", what_.c_str(), bar.c_str(), percent, done, total_);
    std::fflush(stderr);
}

}  // namespace rambla::game
