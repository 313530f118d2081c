#pragma once

#include <string>

namespace rambla::game {

/// What a measurement was made on, for people; "unknown" where the system does not say.
[[nodiscard]] std::string processor_name();
[[nodiscard]] std::string compiler_name();
[[nodiscard]] std::string c_library_name();

}  // namespace rambla::game
