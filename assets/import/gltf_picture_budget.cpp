#include "assets/import/gltf_picture_budget.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "assets/error.h"
#include "assets/import/gltf_files.h"
#include "assets/import/picture_limits.h"

namespace rambla::assets::gltf {

namespace {

namespace fs = std::filesystem;

/// What images refer to, and what is really there.
class Stock {
public:
    explicit Stock(const Document& document) : document_{document} {
        for (const tinygltf::Buffer& buffer : document.model.buffers)
            held_ += buffer.data.size();
    }

    /// @return  bytes that the image refers to; 0 where there are none, which its decoding will tell
    std::uint64_t add(std::uint32_t image) {
        const tinygltf::Image& source = document_.model.images[image];
        const std::uint64_t bytes = source.bufferView >= 0  ? view_bytes(source.bufferView)
                                    : !source.image.empty() ? data_bytes(source)
                                                            : file_bytes(source.uri);
        referred_ += bytes;
        return bytes;
    }

    [[nodiscard]] std::uint64_t held() const { return held_; }
    [[nodiscard]] std::uint64_t referred() const { return referred_; }

private:
    std::uint64_t view_bytes(int view) const {
        const auto& views = document_.model.bufferViews;
        const auto index = static_cast<std::size_t>(view);
        return index < views.size() ? std::min<std::uint64_t>(views[index].byteLength, held_) : 0;
    }

    std::uint64_t data_bytes(const tinygltf::Image& image) {
        held_ += image.image.size();
        return image.image.size();
    }

    std::uint64_t file_bytes(const std::string& uri) {
        try {
            const fs::path file = resolve_uri(document_.path, "", uri);
            const std::uint64_t bytes = fs::file_size(file);
            if (files_.insert(file).second) held_ += bytes;
            return bytes;
        } catch (const std::exception&) {
            return 0;
        }
    }

    const Document& document_;
    std::set<fs::path> files_;
    std::uint64_t held_ = 0;
    std::uint64_t referred_ = 0;
};

}  // namespace

std::vector<std::uint64_t> texel_budgets(const Document& document, std::span<const std::uint32_t> images) {
    Stock stock{document};
    std::vector<std::uint64_t> budgets;
    for (const std::uint32_t image : images)
        budgets.push_back(stock.add(image));
    const auto all = static_cast<double>(most_texel_bytes(stock.held()));
    const double for_each = static_cast<double>(most_texel_bytes(0)) /
                            static_cast<double>(std::max<std::size_t>(1, images.size()));
    for (std::uint64_t& budget : budgets) {
        const double share =
            static_cast<double>(budget) / static_cast<double>(std::max<std::uint64_t>(1, stock.referred()));
        budget = static_cast<std::uint64_t>(std::max(all * share, for_each));
    }
    return budgets;
}

}  // namespace rambla::assets::gltf
