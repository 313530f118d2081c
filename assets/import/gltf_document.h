#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "assets/import/gltf.h"

namespace rambla::assets::gltf {

/// A parsed document, its name for messages, and what it may still cost.
struct Document {
    std::filesystem::path path;
    ImportLimits limits;
    tinygltf::Model model;            ///< images hold the encoded bytes of data URIs, nothing else
    std::uint64_t elements = 0;       ///< vertices, indices ... that the file may yield in all
    std::uint64_t elements_left = 0;  ///< and those that it may still yield

    [[noreturn]] void fail(std::string_view element, std::string_view found, std::string_view expected) const;
    void warn(std::string_view element, std::string_view text) const;

    /// Takes elements off the budget; from several threads at once, too. @throws Error  when it is used up
    void spend(std::string_view element, std::uint64_t wanted);

    /// `index` when it is inside an array of `size`, else Error: for references between elements.
    [[nodiscard]] std::uint32_t checked(int index, std::size_t size, std::string_view element,
                                        std::string_view what) const;
};

/// Keeps the warnings of this thread, instead of logging them, while it lives: for work on several threads
/// that reports in the order of the document.
class WarningHold {
public:
    explicit WarningHold(std::vector<std::string>& lines);
    ~WarningHold();
    WarningHold(const WarningHold&) = delete;
    WarningHold& operator=(const WarningHold&) = delete;
};

/// `array[index]suffix`
[[nodiscard]] std::string element_name(std::string_view array, std::size_t index,
                                       std::string_view suffix = {});

/// Reads and parses a file with its buffers; images stay unread. @throws Error
[[nodiscard]] Document load_document(const std::filesystem::path& file, const ImportLimits& limits);

}  // namespace rambla::assets::gltf
