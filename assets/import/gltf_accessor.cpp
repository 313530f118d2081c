#include "assets/import/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace rambla::assets::gltf {

namespace {

template <class T>
T load(const unsigned char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// Size of one component, 0 for types that glTF does not have (tinygltf lets double and int through).
std::uint64_t component_size(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

std::uint32_t load_index(const unsigned char* bytes, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return *bytes;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return load<std::uint16_t>(bytes);
        default:
            return load<std::uint32_t>(bytes);
    }
}

/// glTF 2.0, section 3.11: signed types map to max(c / c_max, −1), unsigned ones to c / c_max.
template <class T>
float to_float(T value, bool normalised) {
    if (!normalised) return static_cast<float>(value);
    constexpr auto k_max = static_cast<float>(std::numeric_limits<T>::max());
    return std::max(static_cast<float>(value) / k_max, -1.0f);
}

bool is_index_type(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

constexpr std::string_view k_index_types = "5121, 5123 or 5125 (unsigned integers)";

}  // namespace

AccessorReader::AccessorReader(const Document& document, int accessor, std::string element)
    : document_{document}, element_{std::move(element)} {
    const tinygltf::Model& model = document.model;
    const std::uint32_t index = document.checked(accessor, model.accessors.size(), element_, "accessor");
    const tinygltf::Accessor& source = model.accessors[index];
    const std::string where = element_name("accessors", index);

    count_ = source.count;
    component_type_ = source.componentType;
    component_bytes_ = component_size(component_type_);
    normalised_ = source.normalized;
    if (component_bytes_ == 0)
        document.fail(where + ".componentType", std::to_string(component_type_),
                      "5120, 5121, 5122, 5123, 5125 or 5126");
    components_ = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(source.type));
    if (source.type < TINYGLTF_TYPE_VEC2 || source.type > TINYGLTF_TYPE_VEC4)
        if (source.type != TINYGLTF_TYPE_SCALAR)
            document.fail(element_, "accessor " + std::to_string(index) + " of matrices",
                          "scalars or vectors");
    if (count_ > document.limits.vertices)
        document.fail(where + ".count", std::to_string(count_),
                      "at most " + std::to_string(document.limits.vertices));

    const std::uint64_t element_bytes = component_bytes_ * static_cast<std::uint64_t>(components_);
    if (source.bufferView >= 0) {
        if (source.byteOffset > static_cast<std::size_t>(std::numeric_limits<std::int64_t>::max()))
            document.fail(where + ".byteOffset", std::to_string(source.byteOffset),
                          "an offset inside the buffer view");
        base_ = bytes_of_view(source.bufferView, static_cast<std::int64_t>(source.byteOffset), count_,
                              element_bytes, true, where);
    } else if (count_ > document.elements_left) {
        document.fail(where + ".count", std::to_string(count_) + " elements without a buffer view",
                      "at most " + std::to_string(document.elements_left) + " for a file of this size");
    }
    if (!source.sparse.isSparse) return;

    const std::string sparse = where + ".sparse";
    if (source.sparse.count < 0 || static_cast<std::uint64_t>(source.sparse.count) > count_)
        document.fail(sparse + ".count", std::to_string(source.sparse.count),
                      "0 to " + std::to_string(count_));
    sparse_count_ = static_cast<std::uint64_t>(source.sparse.count);
    sparse_index_type_ = source.sparse.indices.componentType;
    if (!is_index_type(sparse_index_type_))
        document.fail(sparse + ".indices.componentType", std::to_string(sparse_index_type_), k_index_types);
    sparse_index_bytes_ =
        bytes_of_view(source.sparse.indices.bufferView, source.sparse.indices.byteOffset, sparse_count_,
                      component_size(sparse_index_type_), false, sparse + ".indices");
    sparse_values_ = bytes_of_view(source.sparse.values.bufferView, source.sparse.values.byteOffset,
                                   sparse_count_, element_bytes, false, sparse + ".values");
}

bool AccessorReader::is_integer() const {
    return component_type_ != TINYGLTF_COMPONENT_TYPE_FLOAT;
}

AccessorReader::Bytes AccessorReader::bytes_of_view(int view_index, std::int64_t offset, std::uint64_t count,
                                                    std::uint64_t element_bytes, bool may_interleave,
                                                    const std::string& where) const {
    const tinygltf::Model& model = document_.model;
    const std::uint32_t checked_view =
        document_.checked(view_index, model.bufferViews.size(), where + ".bufferView", "buffer view");
    const tinygltf::BufferView& view = model.bufferViews[checked_view];
    const std::string view_name = element_name("bufferViews", checked_view);
    const std::vector<unsigned char>& data =
        model.buffers[document_.checked(view.buffer, model.buffers.size(), view_name + ".buffer", "buffer")]
            .data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        document_.fail(view_name,
                       "bytes " + std::to_string(view.byteOffset) + " + " + std::to_string(view.byteLength),
                       "to end in buffer " + std::to_string(view.buffer) + " of " +
                           std::to_string(data.size()) + " bytes");
    const std::uint64_t stride = may_interleave && view.byteStride > 0 ? view.byteStride : element_bytes;
    if (stride < element_bytes)
        document_.fail(view_name + ".byteStride", std::to_string(stride),
                       "at least " + std::to_string(element_bytes) + ", the size of an element of " + where);
    const std::uint64_t length = view.byteLength;
    // Rearranged so that nothing can overflow: offset + stride · (count − 1) + element_bytes ≤ length.
    const bool fits =
        offset >= 0 && static_cast<std::uint64_t>(offset) <= length &&
        (count == 0 || (element_bytes <= length - static_cast<std::uint64_t>(offset) &&
                        count - 1 <= (length - static_cast<std::uint64_t>(offset) - element_bytes) / stride));
    if (!fits)
        document_.fail(where, std::to_string(count) + " elements from byte " + std::to_string(offset),
                       "to end in buffer view " + std::to_string(checked_view) + " of " +
                           std::to_string(length) + " bytes");
    return {data.data() + view.byteOffset + offset, stride};
}

std::vector<std::uint32_t> AccessorReader::sparse_indices() const {
    std::vector<std::uint32_t> indices(sparse_count_);
    for (std::uint64_t i = 0; i < sparse_count_; ++i) {
        indices[i] =
            load_index(sparse_index_bytes_.first + i * sparse_index_bytes_.stride, sparse_index_type_);
        if (indices[i] >= count_)
            document_.fail(element_, "sparse index " + std::to_string(indices[i]),
                           "below " + std::to_string(count_));
    }
    return indices;
}

float AccessorReader::component(const unsigned char* bytes, bool normalised) const {
    switch (component_type_) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return to_float(load<std::int8_t>(bytes), normalised);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return to_float(load<std::uint8_t>(bytes), normalised);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return to_float(load<std::int16_t>(bytes), normalised);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return to_float(load<std::uint16_t>(bytes), normalised);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return to_float(load<std::uint32_t>(bytes), normalised);
        default:
            return load<float>(bytes);
    }
}

template <int N>
glm::vec<N, float> AccessorReader::element(const unsigned char* bytes, float missing, bool normalised) const {
    glm::vec<N, float> value{missing};
    const int present = std::min(N, components_);
    if (component_type_ == TINYGLTF_COMPONENT_TYPE_FLOAT)
        std::memcpy(&value[0], bytes, sizeof(float) * static_cast<std::size_t>(present));
    else
        for (int c = 0; c < present; ++c)
            value[c] = component(bytes + component_bytes_ * static_cast<std::uint64_t>(c), normalised);
    return value;
}

template <int N>
std::vector<glm::vec<N, float>> AccessorReader::read(std::span<const std::uint32_t> gather, float missing,
                                                     bool always_normalise) const {
    const bool normalised = normalised_ || always_normalise;
    const std::uint64_t size = gather.empty() ? count_ : gather.size();
    std::vector<glm::vec<N, float>> values(size, glm::vec<N, float>{0.0f});
    if (base_.first != nullptr)
        for (std::uint64_t i = 0; i < size; ++i) {
            const std::uint64_t at = gather.empty() ? i : gather[i];
            values[i] = element<N>(base_.first + at * base_.stride, missing, normalised);
        }
    if (sparse_count_ == 0) return values;

    const std::vector<std::uint32_t> replaced = sparse_indices();
    for (std::uint64_t i = 0; i < sparse_count_; ++i) {
        const auto value = element<N>(sparse_values_.first + i * sparse_values_.stride, missing, normalised);
        if (gather.empty()) {
            values[replaced[i]] = value;
        } else {
            // A gather is sorted and holds each element once.
            const auto found = std::lower_bound(gather.begin(), gather.end(), replaced[i]);
            if (found != gather.end() && *found == replaced[i])
                values[static_cast<std::size_t>(found - gather.begin())] = value;
        }
    }
    return values;
}

template std::vector<glm::vec2> AccessorReader::read<2>(std::span<const std::uint32_t>, float, bool) const;
template std::vector<glm::vec3> AccessorReader::read<3>(std::span<const std::uint32_t>, float, bool) const;
template std::vector<glm::vec4> AccessorReader::read<4>(std::span<const std::uint32_t>, float, bool) const;

std::vector<std::uint32_t> AccessorReader::read_indices() const {
    if (components_ != 1 || !is_index_type(component_type_))
        document_.fail(element_,
                       std::to_string(components_) + " components of type " + std::to_string(component_type_),
                       std::string{"scalars of type "}.append(k_index_types));
    std::vector<std::uint32_t> indices(count_, 0);
    if (base_.first != nullptr)
        for (std::uint64_t i = 0; i < count_; ++i)
            indices[i] = load_index(base_.first + i * base_.stride, component_type_);
    const std::vector<std::uint32_t> replaced = sparse_indices();
    for (std::uint64_t i = 0; i < sparse_count_; ++i)
        indices[replaced[i]] = load_index(sparse_values_.first + i * sparse_values_.stride, component_type_);
    return indices;
}

}  // namespace rambla::assets::gltf
