#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rambla::game {

/// Makes the folder of the file that --json names, so that a place that cannot be written to is known before
/// the work. Does nothing for `-` and for nowhere. @throws assets::Error
void prepare_json(const std::string& target);

/// Writes one JSON object where --json says: `-` is standard output, empty is nowhere, else a file.
/// Numbers that JSON cannot hold (infinite, not a number) become null, text that is no UTF-8 loses what is
/// not.
/// @throws assets::Error  if the file cannot be written
void write_json(const std::string& target, const nlohmann::json& object);

/// Standard output belongs to JSON alone: prints text for people there, or to standard error if JSON goes
/// there.
void print_result(const std::string& json_target, const std::string& text);

}  // namespace rambla::game
