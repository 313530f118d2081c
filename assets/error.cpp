#include "assets/error.h"

namespace rambla::assets {

namespace {

std::string message(std::string_view file, std::string_view element, std::string_view found,
                    std::string_view expected) {
    std::string text{file};
    if (!element.empty()) text.append(": ").append(element);
    text.append(": ").append(found);
    if (!expected.empty()) text.append(", expected ").append(expected);
    return text;
}

}  // namespace

Error::Error(std::string_view file, std::string_view element, std::string_view found,
             std::string_view expected)
    : std::runtime_error(message(file, element, found, expected)) {}

}  // namespace rambla::assets
