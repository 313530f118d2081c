#pragma once

#include <string>

namespace rambla::game::study {

/// The style sheet of the page, without that of its figures; for light and dark surroundings, broad and
/// narrow windows, and paper.
[[nodiscard]] const std::string& page_style();

}  // namespace rambla::game::study
