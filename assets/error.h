#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace rambla::assets {

/// A file that cannot be used. The message names the file, the element, what was found and what was expected.
class Error : public std::runtime_error {
public:
    /// @param file      path as the user gave it
    /// @param element   place inside the file, such as `meshes[3].primitives[0].attributes.POSITION`; may be
    /// empty
    /// @param found     what stands there
    /// @param expected  what should stand there; may be empty
    Error(std::string_view file, std::string_view element, std::string_view found, std::string_view expected);
};

}  // namespace rambla::assets
