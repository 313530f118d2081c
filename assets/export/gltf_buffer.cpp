#include "assets/export/gltf_buffer.h"

namespace rambla::assets {

std::size_t GltfBuffer::add_bytes(std::span<const std::byte> bytes, Target target) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4, 0);
    nlohmann::json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
    if (target != Target::none) view["target"] = static_cast<int>(target);
    views_.push_back(std::move(view));
    const auto* const first = reinterpret_cast<const unsigned char*>(bytes.data());
    bytes_.insert(bytes_.end(), first, first + bytes.size());
    return views_.size() - 1;
}

std::size_t GltfBuffer::add(std::span<const std::byte> bytes, std::size_t count, const Form& form) {
    accessors_.push_back({{"bufferView", add_bytes(bytes, form.target)},
                          {"componentType", static_cast<int>(form.component)},
                          {"count", count},
                          {"type", form.type}});
    return accessors_.size() - 1;
}

std::size_t GltfBuffer::add_zeros(std::size_t count, const std::string& type) {
    accessors_.push_back(
        {{"componentType", static_cast<int>(Component::f32)}, {"count", count}, {"type", type}});
    return accessors_.size() - 1;
}

void GltfBuffer::set_range(std::size_t accessor, nlohmann::json least, nlohmann::json largest) {
    accessors_[accessor]["min"] = std::move(least);
    accessors_[accessor]["max"] = std::move(largest);
}

void GltfBuffer::finish(nlohmann::json& document) const {
    if (!accessors_.empty()) document["accessors"] = accessors_;
    if (!views_.empty()) document["bufferViews"] = views_;
    if (!bytes_.empty()) document["buffers"] = nlohmann::json::array({{{"byteLength", bytes_.size()}}});
}

}  // namespace rambla::assets
