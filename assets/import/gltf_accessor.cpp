#include "assets/import/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <type_traits>

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

/// Calls `use` with a function that reads component c of an element: one loop for each type, instead of one
/// question for each number.
template <class Use>
void with_component(int type, bool normalised, const Use& use) {
    const auto of = [&]<class T>(T) {
        const auto read_as = [&](auto is_normalised) {
            use([is_normalised](const unsigned char* element, int c) {
                return to_float(load<T>(element + sizeof(T) * static_cast<std::size_t>(c)), is_normalised());
            });
        };
        if (normalised)
            read_as(std::true_type{});
        else
            read_as(std::false_type{});
    };
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return of(std::int8_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return of(std::uint8_t{});
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return of(std::int16_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return of(std::uint16_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return of(std::uint32_t{});
        default:
            return use([](const unsigned char* element, int c) {
                return load<float>(element + sizeof(float) * static_cast<std::size_t>(c));
            });
    }
}

/// An iterator over values that are computed from their index, so that a vector is filled in one pass,
/// without writing zeros first.
template <class Compute>
class ComputedIterator {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = std::remove_cvref_t<std::invoke_result_t<const Compute&, std::uint64_t>>;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = value_type;

    ComputedIterator(const Compute& compute, std::uint64_t index) : compute_{compute}, index_{index} {}
    value_type operator*() const { return compute_(index_); }
    ComputedIterator& operator++() {
        ++index_;
        return *this;
    }
    bool operator==(const ComputedIterator& other) const { return index_ == other.index_; }

private:
    Compute compute_;
    std::uint64_t index_;
};

/// Appends compute(begin), compute(begin + 1) ... compute(end − 1).
template <class T, class Compute>
void append_computed(std::vector<T>& values, std::uint64_t begin, std::uint64_t end, const Compute& compute) {
    using Iterator = ComputedIterator<Compute>;
    values.insert(values.end(), Iterator{compute, begin}, Iterator{compute, end});
}

/// compute(0), compute(1) ... compute(size − 1)
template <class Compute>
auto computed(std::uint64_t size, const Compute& compute) {
    using Iterator = ComputedIterator<Compute>;
    return std::vector<typename Iterator::value_type>(Iterator{compute, 0}, Iterator{compute, size});
}

/// Values that lie one after the other in a buffer, of a copy of which the compiler makes a block move or a
/// loop over vectors, as it does not of a load for each. Null where the buffer is not aligned for them.
template <class T>
const T* in_a_row(const unsigned char* bytes) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (reinterpret_cast<std::uintptr_t>(bytes) % alignof(T) != 0) return nullptr;
    return reinterpret_cast<const T*>(bytes);
}

/// Values of a piece: at most 8 KiB, so that it and what it is copied from fit the nearest cache together.
constexpr std::uint64_t k_piece = 512;

/// Calls append(begin, end), which makes `values` longer, for piece after piece of [0, size), each followed
/// by finish(piece, begin).
template <class T, class Append, class Finished>
void append_pieces(std::vector<T>& values, std::uint64_t size, const Append& append, const Finished& finish) {
    values.reserve(size);
    for (std::uint64_t begin = 0; begin < size; begin += k_piece) {
        append(begin, std::min(begin + k_piece, size));
        finish(std::span{values}.subspan(begin), begin);
    }
}

template <class T>
T largest_of(std::span<const T> indices) {
    T largest = 0;
    for (const T index : indices)
        largest = std::max(largest, index);
    return largest;
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
    // Their columns are padded in ways of their own, and nothing uses them.
    if (source.type == TINYGLTF_TYPE_MAT2 || source.type == TINYGLTF_TYPE_MAT3)
        document.fail(element_, "accessor " + std::to_string(index) + " of small matrices",
                      "scalars, vectors or matrices of 4 x 4");
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
    } else if (count_ > document.elements) {
        document.fail(where + ".count", std::to_string(count_) + " elements without a buffer view",
                      "at most " + std::to_string(document.elements) + " for a file of this size");
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

bool AccessorReader::is_float() const {
    return component_type_ == TINYGLTF_COMPONENT_TYPE_FLOAT;
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

template <int N>
std::vector<glm::vec<N, float>> AccessorReader::read(std::span<const std::uint32_t> gather, float missing,
                                                     bool always_normalise, const Finish<N>& finish) const {
    using Vector = glm::vec<N, float>;
    const std::uint64_t size = gather.empty() ? count_ : gather.size();
    const std::vector<std::uint32_t> replaced = sparse_indices();
    std::vector<Vector> values;
    const auto append_all = [&](const auto& append) {
        append_pieces(values, size, append, [&](std::span<Vector> piece, std::uint64_t begin) {
            if (sparse_count_ == 0) finish(piece, begin);
        });
    };
    const auto fill = [&](const auto& element) {
        const Bytes base = base_;
        if (base.first == nullptr)
            values.assign(size, Vector{0.0f});
        else
            append_all([&](std::uint64_t begin, std::uint64_t end) {
                if (gather.empty())
                    append_computed(values, begin, end,
                                    [&](std::uint64_t i) { return element(base.first + i * base.stride); });
                else
                    append_computed(values, begin, end, [&](std::uint64_t i) {
                        return element(base.first + gather[i] * base.stride);
                    });
            });
        for (std::uint64_t i = 0; i < sparse_count_; ++i) {
            // A gather is sorted and holds each element once.
            const auto found = std::lower_bound(gather.begin(), gather.end(), replaced[i]);
            const bool kept = gather.empty() || (found != gather.end() && *found == replaced[i]);
            const auto at = gather.empty() ? replaced[i] : static_cast<std::uint64_t>(found - gather.begin());
            if (kept) values[at] = element(sparse_values_.first + i * sparse_values_.stride);
        }
        if (base.first == nullptr || sparse_count_ > 0) finish(values, 0);
    };
    if (is_float() && components_ >= N) {
        const auto element = [](const unsigned char* bytes) {
            Vector value;
            std::memcpy(&value[0], bytes, sizeof value);
            return value;
        };
        const bool packed = base_.first != nullptr && base_.stride == sizeof(Vector);
        const bool as_it_is = packed && gather.empty() && sparse_count_ == 0;
        if (const Vector* const row = as_it_is ? in_a_row<Vector>(base_.first) : nullptr)
            append_all([&](std::uint64_t begin, std::uint64_t end) {
                values.insert(values.end(), row + begin, row + end);
            });
        else
            fill(element);
        return values;
    }
    with_component(component_type_, normalised_ || always_normalise, [&](auto read_component) {
        if (components_ >= N)
            return fill([&](const unsigned char* bytes) {
                Vector value;
                for (int c = 0; c < N; ++c)
                    value[c] = read_component(bytes, c);
                return value;
            });
        fill([&](const unsigned char* bytes) {
            Vector value{missing};
            for (int c = 0; c < components_; ++c)
                value[c] = read_component(bytes, c);
            return value;
        });
    });
    return values;
}

template std::vector<glm::vec2> AccessorReader::read<2>(std::span<const std::uint32_t>, float, bool,
                                                        const Finish<2>&) const;
template std::vector<glm::vec3> AccessorReader::read<3>(std::span<const std::uint32_t>, float, bool,
                                                        const Finish<3>&) const;
template std::vector<glm::vec4> AccessorReader::read<4>(std::span<const std::uint32_t>, float, bool,
                                                        const Finish<4>&) const;

std::vector<float> AccessorReader::read_floats(std::uint64_t elements, bool always_normalise) const {
    const std::uint64_t size = std::min(elements, count_);
    const std::vector<std::uint32_t> replaced = sparse_indices();
    const auto width = static_cast<std::uint64_t>(components_);
    std::vector<float> values;
    with_component(component_type_, normalised_ || always_normalise, [&](auto read_component) {
        const auto store = [&](std::uint64_t at, const unsigned char* bytes) {
            for (int c = 0; c < components_; ++c)
                values[at * width + static_cast<std::uint64_t>(c)] = read_component(bytes, c);
        };
        const bool packed = base_.stride == component_bytes_ * width;
        if (base_.first != nullptr && packed)
            values = computed(size * width, [&, first = base_.first](std::uint64_t i) {
                return read_component(first + i * component_bytes_, 0);
            });
        else
            values.assign(size * width, 0.0f);
        if (base_.first != nullptr && !packed)
            for (std::uint64_t i = 0; i < size; ++i)
                store(i, base_.first + i * base_.stride);
        for (std::uint64_t i = 0; i < sparse_count_; ++i)
            if (replaced[i] < size) store(replaced[i], sparse_values_.first + i * sparse_values_.stride);
    });
    return values;
}

IndexColumn AccessorReader::read_indices() const {
    if (components_ != 1 || !is_index_type(component_type_))
        document_.fail(element_,
                       std::to_string(components_) + " components of type " + std::to_string(component_type_),
                       std::string{"scalars of type "}.append(k_index_types));
    IndexColumn column;
    std::vector<std::uint32_t>& indices = column.indices;
    const auto fill = [&]<class T>(T) {
        const Bytes base = base_;
        const T* const row = base.stride == sizeof(T) ? in_a_row<T>(base.first) : nullptr;
        const auto append = [&](std::uint64_t begin, std::uint64_t end) {
            if (row != nullptr)
                indices.insert(indices.end(), row + begin, row + end);
            else
                append_computed(indices, begin, end, [&](std::uint64_t i) {
                    return static_cast<std::uint32_t>(load<T>(base.first + i * base.stride));
                });
        };
        append_pieces(
            indices, count_, append, [&](std::span<const std::uint32_t> piece, std::uint64_t begin) {
                // Of small types, more go into a register.
                const std::uint32_t largest =
                    row != nullptr ? largest_of(std::span{row + begin, piece.size()}) : largest_of(piece);
                column.largest = std::max(column.largest, largest);
            });
    };
    if (base_.first == nullptr)
        indices.assign(count_, 0);
    else if (component_type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE)
        fill(std::uint8_t{});
    else if (component_type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
        fill(std::uint16_t{});
    else
        fill(std::uint32_t{});
    if (sparse_count_ == 0) return column;
    const std::vector<std::uint32_t> replaced = sparse_indices();
    for (std::uint64_t i = 0; i < sparse_count_; ++i)
        indices[replaced[i]] = load_index(sparse_values_.first + i * sparse_values_.stride, component_type_);
    column.largest = largest_of(std::span<const std::uint32_t>{indices});
    return column;
}

}  // namespace rambla::assets::gltf
