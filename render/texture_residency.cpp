#include "render/texture_residency.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "assets/assert.h"
#include "render/level_upload.h"
#include "systems/frame.h"

namespace rambla::render {

namespace {

/// Loads under way at once: enough that the disk and the upload both have work.
constexpr std::size_t k_most_loads = 4;
/// Levels waiting in memory to be uploaded take no more than this, or else are one image's alone.
constexpr std::uint64_t k_most_staged_bytes = std::uint64_t{64} << 20;

constexpr double k_mib = 1048576.0;

std::uint64_t bytes_from_mib(float mib) {
    return static_cast<std::uint64_t>(static_cast<double>(mib) * k_mib);
}

/// The coarsest level that is the finest one over an exact power of two.
std::uint8_t last_exact_level(const assets::TextureData& image) {
    const assets::TextureLevel& finest = image.levels[0];
    std::uint8_t level = 0;
    while (level + 1u < image.levels.size() &&
           image.levels[level + 1u].width << (level + 1u) == finest.width &&
           image.levels[level + 1u].height << (level + 1u) == finest.height) {
        ++level;
    }
    return level;
}

ImageLevels levels_of(const assets::TextureData& image) {
    ImageLevels levels{.floor = static_cast<std::uint8_t>(image.first_stored),
                       .exact = last_exact_level(image),
                       .chain_bytes = {}};
    for (std::uint32_t first = 0; first <= image.first_stored; ++first)
        levels.chain_bytes.push_back(gl::storage_bytes(describe_levels(image, first)));
    return levels;
}

std::uint64_t bytes_of(const assets::TextureData& image, const assets::LevelRange& range) {
    std::uint64_t bytes = 0;
    for (std::uint32_t level = range.first; level < range.end; ++level)
        bytes += image.levels[level].size;
    return bytes;
}

}  // namespace

TextureResidency::TextureResidency(std::span<const assets::TextureData> images,
                                   std::shared_ptr<assets::LevelSource> source)
    : source_{std::move(source)} {
    std::vector<ImageLevels> levels;
    for (const assets::TextureData& image : images) {
        const std::uint32_t first = image.first_stored;
        levels.push_back(levels_of(image));
        resident_.push_back(static_cast<std::uint8_t>(first));
        const gl::Texture& texture = textures_.emplace_back(make_level_texture(image, first));
        held_bytes_ += texture.bytes();
        for (std::uint32_t level = first; level < image.levels.size(); ++level) {
            upload_rows(texture, first, image, level, assets::bytes_of(image, level, level + 1), 0,
                        image.levels[level].height);
        }
        assets::TextureData& kept = images_.emplace_back();
        kept.name = image.name;
        kept.format = image.format;
        kept.colour_space = image.colour_space;
        kept.swizzle = image.swizzle;
        kept.levels = image.levels;
    }
    plan_ = ResidencyPlan{std::move(levels)};
    peak_bytes_ = held_bytes_;
    finest_to_be_had_.assign(images_.size(), 0);
    demand_.assign(images_.size(), systems::k_not_demanded);
    // A frame in a steady state needs no more memory.
    asked_.reserve(k_most_loads);
    ready_.reserve(k_most_loads);
}

TextureResidency::~TextureResidency() = default;

void TextureResidency::update(std::span<const std::uint8_t> demand, const TextureParameters& parameters) {
    changed_.clear();
    if (source_ == nullptr) return;
    aim(demand, parameters);
    advance(bytes_from_mib(parameters.upload_mib));
}

void TextureResidency::complete(std::span<const std::uint8_t> demand, const TextureParameters& parameters,
                                const std::function<void()>& finish) {
    changed_.clear();
    if (source_ == nullptr) return;
    aim(demand, parameters);
    for (;;) {
        if (std::exchange(lost_, false)) aim(demand, parameters);
        if (advance(std::numeric_limits<std::uint64_t>::max())) continue;
        if (!retired_.empty()) {
            finish();
        } else if (asked_.empty() || !source_->wait()) {
            return;
        }
    }
}

void TextureResidency::aim(std::span<const std::uint8_t> demand, const TextureParameters& parameters) {
    RAMBLA_ASSERT(demand.empty() || demand.size() == images_.size(),
                  "Frames use the uploaded scene's indices");
    budget_bytes_ = bytes_from_mib(parameters.budget_mib);
    if (!demand.empty()) std::copy(demand.begin(), demand.end(), demand_.begin());
    plan_.aim(demand_, resident_, finest_to_be_had_, budget_bytes_);
    if (plan_.floor_bytes() > budget_bytes_ && !std::exchange(warned_, true)) {
        spdlog::warn(
            "textures: found a budget of {:.2f} MiB, expected {:.2f} MiB for the smallest levels of "
            "{} images, which stay",
            parameters.budget_mib, static_cast<double>(plan_.floor_bytes()) / k_mib, images_.size());
    }
}

bool TextureResidency::advance(std::uint64_t upload_bytes) {
    bool moved = take_answers();
    moved |= coarsen();
    moved |= build(upload_bytes);
    moved |= request();
    return moved;
}

bool TextureResidency::take_answers() {
    bool any = false;
    while (std::optional<assets::LoadedLevels> levels = source_->take()) {
        any = true;
        std::erase(asked_, levels->range);
        const std::uint32_t image = levels->range.image;
        if (levels->bytes.empty()) {
            finest_to_be_had_[image] = static_cast<std::uint8_t>(levels->range.end);
            lost_ = true;
            staged_bytes_ -= bytes_of(images_[image], levels->range);
        } else {
            ready_.push_back(std::move(*levels));
            ++loads_;
        }
    }
    return any;
}

bool TextureResidency::coarsen() {
    // Beyond the limit there is something only after a smaller budget was set: then any way down is right.
    std::uint64_t resident_bytes = 0;
    for (std::uint32_t image = 0; image < images_.size(); ++image)
        resident_bytes += chain_bytes(image, resident_[image]);
    const bool too_much = resident_bytes > plan_.limit(budget_bytes_);
    bool any = false;
    std::optional<std::uint32_t> stuck;  // the least needed of those that do not fit beside what they replace
    for (std::uint32_t image = 0; image < images_.size(); ++image) {
        const std::uint8_t target = plan_.targets()[image];
        if (target <= resident_[image] || (building_ && building_->levels.range.image == image)) continue;
        if (fits(image, target)) {
            make_coarser(image, target);
            any = true;
        } else if (!stuck || needed_levels(image) < needed_levels(*stuck)) {
            stuck = image;
        }
    }
    // What is being replaced leaves room soon. Else one becomes coarser than it is to be, and comes back.
    if (any || !stuck || !retired_.empty() || (building_ && !too_much)) return any;
    std::uint8_t first = plan_.targets()[*stuck];
    while (first < plan_.images()[*stuck].floor && !fits(*stuck, first))
        ++first;
    if (!fits(*stuck, first) && !too_much) return false;
    make_coarser(*stuck, first);
    return true;
}

bool TextureResidency::fits(std::uint32_t image, std::uint32_t first) const {
    return held_bytes_ + chain_bytes(image, first) <= budget_bytes_;
}

int TextureResidency::needed_levels(std::uint32_t image) const {
    return int{plan_.images()[image].floor} - int{plan_.needed()[image]};
}

void TextureResidency::make_coarser(std::uint32_t image, std::uint32_t first) {
    gl::Texture texture = make_texture(image, first);
    copy_levels(textures_[image], resident_[image], texture, first, images_[image], first);
    replace(image, first, std::move(texture));
}

bool TextureResidency::build(std::uint64_t upload_bytes) {
    bool any = false;
    while (upload_bytes > 0 && (building_ || start_building())) {
        any = true;
        upload_bytes -= upload(*building_, upload_bytes);
        if (building_->level < building_->levels.range.end) break;
        const std::uint32_t image = building_->levels.range.image;
        copy_levels(textures_[image], resident_[image], building_->texture, building_->first, images_[image],
                    building_->levels.range.end);
        staged_bytes_ -= bytes_of(images_[image], building_->levels.range);
        replace(image, building_->first, std::move(building_->texture));
        building_.reset();
    }
    return any;
}

bool TextureResidency::start_building() {
    while (!ready_.empty()) {
        assets::LoadedLevels& levels = ready_.front();
        const auto [image, finest, end] = levels.range;
        // What was asked for may be too fine by now, or no more wanted at all.
        const std::uint32_t first = std::max<std::uint32_t>(finest, plan_.targets()[image]);
        const bool wanted = first < resident_[image] && resident_[image] <= end;
        if (wanted && held_bytes_ + chain_bytes(image, first) > plan_.limit(budget_bytes_)) return false;
        if (wanted) {
            std::size_t offset = 0;
            for (std::uint32_t level = finest; level < first; ++level)
                offset += images_[image].levels[level].size;
            building_ = Building{.texture = make_texture(image, first),
                                 .levels = std::move(levels),
                                 .first = first,
                                 .level = first,
                                 .row = 0,
                                 .offset = offset};
        } else {
            staged_bytes_ -= bytes_of(images_[image], levels.range);
        }
        ready_.erase(ready_.begin());
        if (wanted) return true;
    }
    return false;
}

std::uint64_t TextureResidency::upload(Building& building, std::uint64_t bytes) const {
    const assets::TextureData& image = images_[building.levels.range.image];
    const std::uint32_t step = row_step(image);
    std::uint64_t uploaded = 0;
    while (building.level < building.levels.range.end && uploaded < bytes) {
        const assets::TextureLevel& level = image.levels[building.level];
        const std::size_t step_bytes = row_step_bytes(image, building.level);
        // A row at least: the limit may be less than that.
        const std::uint64_t steps = std::max<std::uint64_t>((bytes - uploaded) / step_bytes, 1);
        const auto rows =
            static_cast<std::uint32_t>(std::min<std::uint64_t>(level.height - building.row, steps * step));
        upload_rows(building.texture, building.first, image, building.level,
                    std::span{building.levels.bytes}.subspan(building.offset, level.size), building.row,
                    rows);
        uploaded += std::uint64_t{(rows + step - 1) / step} * step_bytes;
        building.row += rows;
        if (building.row < level.height) break;
        building.row = 0;
        building.offset += level.size;
        ++building.level;
    }
    return std::min(uploaded, bytes);
}

bool TextureResidency::request() {
    bool any = false;
    while (asked_.size() + ready_.size() < k_most_loads) {
        const std::optional<std::uint32_t> image = most_missing();
        if (!image) break;
        const assets::LevelRange range{*image, plan_.targets()[*image], resident_[*image]};
        const std::uint64_t bytes = bytes_of(images_[*image], range);
        if (staged_bytes_ > 0 && staged_bytes_ + bytes > k_most_staged_bytes) break;
        staged_bytes_ += bytes;
        asked_.push_back(range);
        source_->request(range);
        any = true;
    }
    return any;
}

std::optional<std::uint32_t> TextureResidency::most_missing() const {
    std::optional<std::uint32_t> most;
    int most_levels = 0;
    for (std::uint32_t image = 0; image < images_.size(); ++image) {
        const std::uint8_t target = plan_.targets()[image];
        const int levels = int{resident_[image]} - int{target};
        if (levels <= most_levels || finest_to_be_had_[image] > target || is_coming(image)) continue;
        most = image;
        most_levels = levels;
    }
    return most;
}

bool TextureResidency::is_coming(std::uint32_t image) const {
    const auto is_of_image = [image](const assets::LevelRange& range) {
        return range.image == image;
    };
    return (building_ && building_->levels.range.image == image) ||
           std::any_of(asked_.begin(), asked_.end(), is_of_image) ||
           std::any_of(ready_.begin(), ready_.end(),
                       [&](const assets::LoadedLevels& levels) { return is_of_image(levels.range); });
}

gl::Texture TextureResidency::make_texture(std::uint32_t image, std::uint32_t first) {
    held_bytes_ += chain_bytes(image, first);
    peak_bytes_ = std::max(peak_bytes_, held_bytes_);
    return make_level_texture(images_[image], first);
}

void TextureResidency::replace(std::uint32_t image, std::uint32_t first, gl::Texture texture) {
    retired_.push_back({std::exchange(textures_[image], std::move(texture)), frame_});
    resident_[image] = static_cast<std::uint8_t>(first);
    changed_.push_back(image);
}

void TextureResidency::release(std::uint64_t finished) {
    std::erase_if(retired_, [&](const Retired& retired) {
        if (retired.frame >= finished) return false;
        held_bytes_ -= retired.texture.bytes();
        return true;
    });
}

systems::TextureFeedback TextureResidency::feedback() const {
    systems::TextureFeedback result{.resident_bytes = held_bytes_,
                                    .peak_bytes = peak_bytes_,
                                    .budget_bytes = budget_bytes_,
                                    .loads = loads_,
                                    .pending_loads = 0,
                                    .below_demand = 0};
    result.pending_loads = static_cast<std::uint32_t>(asked_.size() + ready_.size()) + (building_ ? 1u : 0u);
    for (std::size_t image = 0; image < images_.size(); ++image)
        result.below_demand += resident_[image] > demand_[image] ? 1u : 0u;
    return result;
}

}  // namespace rambla::render
