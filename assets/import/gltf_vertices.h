#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "assets/import/gltf_accessor.h"
#include "assets/import/gltf_document.h"

namespace rambla::assets::gltf {

using Attributes = std::map<std::string, int>;

/// The accessor of an attribute, −1 where there is none.
[[nodiscard]] int attribute(const Attributes& attributes, const std::string& name);

/// How an attribute is stored and read.
struct AttributeForm {
    int least_components = 3;
    int most_components = 3;
    float missing = 0.0f;  ///< for components that the accessor lacks
    bool always_normalise = false;
};

/// What the vectors of a column must be beyond finite, for pieces of the column.
template <int N>
struct Rule {
    /// Whether all are so, and finite: one look instead of two for what most files hold.
    std::function<bool(std::span<const glm::vec<N, float>>)> holds;
    /// Makes finite vectors so.
    Finish<N> enforce;
};

/// Reads the columns of one primitive's vertices, all of one length, numbers that are not finite as 0 with a
/// warning.
class VertexReader {
public:
    /// @param element   the primitive, for messages
    /// @param vertices  elements that each accessor must have
    VertexReader(Document& document, std::string element, std::uint64_t vertices)
        : document_{document}, element_{std::move(element)}, vertices_{vertices} {}

    /// Reads only these vertices from now on: ascending, each once.
    void keep(std::vector<std::uint32_t> kept) { kept_ = std::move(kept); }

    /// Entries of a column.
    [[nodiscard]] std::uint64_t size() const { return kept_.empty() ? vertices_ : kept_.size(); }
    [[nodiscard]] const std::string& element() const { return element_; }
    [[nodiscard]] Document& document() { return document_; }

    /// @param name  of the attribute inside the primitive, such as "attributes.NORMAL"
    /// @throws Error
    template <int N>
    [[nodiscard]] std::vector<glm::vec<N, float>> read(int accessor, const std::string& name,
                                                       const AttributeForm& form = {},
                                                       const Rule<N>& rule = {});

private:
    Document& document_;
    std::string element_;
    std::uint64_t vertices_ = 0;
    std::vector<std::uint32_t> kept_;  ///< empty: all
};

}  // namespace rambla::assets::gltf
