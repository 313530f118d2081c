#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rambla::game {

/// Writes one JSON object where --json says: `-` is standard output, empty is nowhere, else a file.
/// Numbers that JSON cannot hold (infinite, not a number) become null.
/// @throws assets::Error  if the file cannot be written
void write_json(const std::string& target, const nlohmann::json& object);

/// Standard output belongs to JSON alone: prints text for people there, or to standard error if JSON goes
/// there.
void print_result(const std::string& json_target, const std::string& text);

}  // namespace rambla::game
