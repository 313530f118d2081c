#include "render/residency_plan.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "assets/assert.h"
#include "systems/frame.h"

namespace rambla::render {

ResidencyPlan::ResidencyPlan(std::vector<ImageLevels> images) : images_{std::move(images)} {
    for (const ImageLevels& image : images_) {
        RAMBLA_ASSERT(image.chain_bytes.size() == image.floor + 1u,
                      "the levels down to the floor have sizes");
        floor_bytes_ += image.chain_bytes[image.floor];
        reserve_bytes_ = std::max(reserve_bytes_, image.chain_bytes[image.floor]);
        first_stamp_.push_back(static_cast<std::uint32_t>(needed_at_.size()));
        needed_at_.resize(needed_at_.size() + image.chain_bytes.size());
        targets_.push_back(image.floor);
    }
    needed_ = targets_;
    wanted_ = targets_;
}

std::uint64_t ResidencyPlan::limit(std::uint64_t budget_bytes) const {
    return budget_bytes > reserve_bytes_ ? budget_bytes - reserve_bytes_ : 0;
}

void ResidencyPlan::aim(std::span<const std::uint8_t> demand, std::span<const std::uint8_t> resident,
                        std::span<const std::uint8_t> to_be_had, std::uint64_t budget_bytes) {
    RAMBLA_ASSERT(demand.size() == images_.size() && resident.size() == images_.size() &&
                      to_be_had.size() == images_.size(),
                  "there is a number for each image");
    ++now_;
    remember(demand, to_be_had);
    room_bytes_ = limit(budget_bytes);
    target_bytes_ = floor_bytes_;
    replaced_bytes_ = 0;
    for (std::size_t i = 0; i < images_.size(); ++i)
        targets_[i] = images_[i].floor;
    if (target_bytes_ > room_bytes_) return;
    refine(resident);
    keep_unneeded(resident);
}

void ResidencyPlan::remember(std::span<const std::uint8_t> demand, std::span<const std::uint8_t> to_be_had) {
    for (std::uint32_t i = 0; i < images_.size(); ++i) {
        const std::uint8_t floor = images_[i].floor;
        if (demand[i] != systems::k_not_demanded) {
            for (std::uint8_t level = std::min(demand[i], floor); level <= floor; ++level)
                needed_at(i, level) = now_;
        }
        const auto is_needed = [&](std::uint8_t level) {
            const std::uint64_t at = needed_at(i, level);
            return at > 0 && at + k_hold_frames > now_;
        };
        std::uint8_t finest = 0;
        while (finest < floor && !is_needed(finest))
            ++finest;
        const std::uint8_t had = std::min(to_be_had[i], floor);
        wanted_[i] = is_needed(finest) ? std::max(std::min(finest, images_[i].exact), had) : floor;
        needed_[i] = std::max(finest, had);
    }
}

bool ResidencyPlan::is_less_urgent(const Candidate& a, const Candidate& b) {
    // The first of equals comes first.
    return std::tuple{a.missing, a.resident, b.cost, b.image} <
           std::tuple{b.missing, b.resident, a.cost, a.image};
}

ResidencyPlan::Candidate ResidencyPlan::candidate(std::uint32_t image,
                                                  std::span<const std::uint8_t> resident) const {
    const std::uint8_t target = targets_[image];
    const std::vector<std::uint64_t>& chain = images_[image].chain_bytes;
    return {.image = image,
            .missing = static_cast<std::int32_t>(target) - needed_[image],
            .resident = resident[image] < target,
            .cost = chain[target - 1u] - chain[target]};
}

void ResidencyPlan::refine(std::span<const std::uint8_t> resident) {
    queue_.clear();
    for (std::uint32_t i = 0; i < images_.size(); ++i) {
        if (wanted_[i] < targets_[i]) queue_.push_back(candidate(i, resident));
    }
    std::make_heap(queue_.begin(), queue_.end(), is_less_urgent);
    while (!queue_.empty()) {
        std::pop_heap(queue_.begin(), queue_.end(), is_less_urgent);
        const std::uint32_t image = queue_.back().image;
        queue_.pop_back();
        const auto finer = static_cast<std::uint8_t>(targets_[image] - 1);
        if (!take(image, finer, resident) || wanted_[image] == finer) continue;
        queue_.push_back(candidate(image, resident));
        std::push_heap(queue_.begin(), queue_.end(), is_less_urgent);
    }
}

void ResidencyPlan::keep_unneeded(std::span<const std::uint8_t> resident) {
    kept_.clear();
    for (std::uint32_t i = 0; i < images_.size(); ++i) {
        if (resident[i] < targets_[i]) kept_.push_back(i);
    }
    std::sort(kept_.begin(), kept_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair{needed_at(b, resident[b]), a} < std::pair{needed_at(a, resident[a]), b};
    });
    for (const std::uint32_t image : kept_) {
        for (std::uint8_t level = resident[image]; level < targets_[image]; ++level) {
            if (take(image, level, resident)) break;
        }
    }
}

bool ResidencyPlan::take(std::uint32_t image, std::uint8_t target, std::span<const std::uint8_t> resident) {
    const std::vector<std::uint64_t>& chain = images_[image].chain_bytes;
    const std::uint64_t added = chain[target] - chain[targets_[image]];
    const std::uint64_t replaced =
        target < resident[image] ? std::max(replaced_bytes_, chain[resident[image]]) : replaced_bytes_;
    if (target_bytes_ + added + replaced > room_bytes_) return false;
    target_bytes_ += added;
    replaced_bytes_ = replaced;
    targets_[image] = target;
    return true;
}

}  // namespace rambla::render
