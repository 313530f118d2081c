#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include "import_support.h"

namespace rambla::assets::test {

/// A glTF document in the making: accessors over one buffer, and the other arrays as text.
class Draft {
public:
    /// @param type  "SCALAR", "VEC3", "MAT4" ...
    /// @param more  further members of the accessor, with a leading comma
    /// @return      the accessor's index
    template <class T>
    int add(const std::vector<T>& values, const std::string& type, const std::string& more = {}) {
        const std::size_t offset = data_.size();
        for (const T value : values)
            data_.append(reinterpret_cast<const char*>(&value), sizeof value);
        const std::size_t length = data_.size() - offset;
        data_.resize((data_.size() + 3) / 4 * 4);
        const std::string view = R"({"buffer":0,"byteOffset":)" + std::to_string(offset) +
                                 R"(,"byteLength":)" + std::to_string(length) + "}";
        const std::size_t count = values.size() / components(type);
        append(views_, view);
        return add_text(R"({"bufferView":)" + std::to_string(views_count_++) + R"(,"componentType":)" +
                        std::to_string(component_type<T>()) + R"(,"count":)" + std::to_string(count) +
                        R"(,"type":")" + type + "\"" + more + "}");
    }

    /// An accessor as it stands in the document.
    int add_text(const std::string& accessor) {
        append(accessors_, accessor);
        return accessors_count_++;
    }

    /// @param rest  further members of the document, with a leading comma
    [[nodiscard]] std::string bytes(const std::string& rest) const { return glb_of(json(rest)); }

    [[nodiscard]] std::string json(const std::string& rest) const {
        std::string json = R"({"asset":{"version":"2.0"})";
        if (!data_.empty())
            json += R"(,"buffers":[{"byteLength":)" + std::to_string(data_.size()) + R"(}],"bufferViews":[)" +
                    views_ + "]";
        if (!accessors_.empty()) json += R"(,"accessors":[)" + accessors_ + "]";
        return json + rest + "}";
    }

    /// The file of a document over the accessors' data.
    [[nodiscard]] std::string glb_of(const std::string& json) const { return glb(json, data_); }

    [[nodiscard]] Scene load(const std::string& rest) const {
        const ScratchFolder folder;
        return import_gltf(folder.write("draft.glb", bytes(rest)));
    }

    /// The message of the error that loading ends in; empty when it loads.
    [[nodiscard]] std::string error(const std::string& rest, const ImportLimits& limits = {}) const {
        const ScratchFolder folder;
        return import_error(folder.write("draft.glb", bytes(rest)), limits);
    }

private:
    template <class T>
    static int component_type() {
        if (std::is_same_v<T, std::int8_t>) return 5120;
        if (std::is_same_v<T, std::uint8_t>) return 5121;
        if (std::is_same_v<T, std::int16_t>) return 5122;
        if (std::is_same_v<T, std::uint16_t>) return 5123;
        if (std::is_same_v<T, std::uint32_t>) return 5125;
        return 5126;
    }
    static std::size_t components(const std::string& type) {
        if (type == "SCALAR") return 1;
        if (type == "MAT4") return 16;
        return static_cast<std::size_t>(type.back() - '0');
    }
    static void append(std::string& list, const std::string& element) {
        list.append(list.empty() ? "" : ",").append(element);
    }

    std::string data_;
    std::string views_;
    std::string accessors_;
    int views_count_ = 0;
    int accessors_count_ = 0;
};

}  // namespace rambla::assets::test
