#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace rambla::assets {

/// The same PNG without the chunks that do not change its pixels (profiles, text, times), its chunks checked
/// for length and sum. libpng would print its opinion of all of these on standard error.
/// @param name  stands for the file in errors
/// @throws Error
[[nodiscard]] std::vector<std::byte> essential_png(std::span<const std::byte> bytes, const std::string& name);

}  // namespace rambla::assets
