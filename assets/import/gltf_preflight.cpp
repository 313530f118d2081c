#include "assets/import/gltf_preflight.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "assets/error.h"
#include "assets/import/gltf_files.h"

namespace rambla::assets::gltf {

namespace {

/// Deeper than any real document, shallow enough for recursive readers.
constexpr std::size_t k_deepest = 256;

constexpr std::array<std::string_view, 10> k_supported{"EXT_mesh_gpu_instancing",
                                                       "KHR_lights_punctual",
                                                       "KHR_materials_emissive_strength",
                                                       "KHR_materials_ior",
                                                       "KHR_materials_specular",
                                                       "KHR_materials_transmission",
                                                       "KHR_materials_unlit",
                                                       "KHR_mesh_quantization",
                                                       "KHR_texture_transform",
                                                       "MSFT_lod"};

constexpr double k_exact_integers = 9007199254740992.0;  // 2⁵³

/// The value of "1.0", "1e0" and the like; nothing for other numbers, plain integers, and −0, which must keep
/// its sign.
std::optional<std::int64_t> integral_float(std::string_view number) {
    if (number.find_first_of(".eE") == std::string_view::npos) return std::nullopt;
    double value = 0.0;
    const auto [end, failed] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (failed != std::errc{} || end != number.data() + number.size()) return std::nullopt;
    if (value != std::floor(value) || std::abs(value) >= k_exact_integers) return std::nullopt;
    if (value == 0.0 && std::signbit(value)) return std::nullopt;
    return static_cast<std::int64_t>(value);
}

/// Calls use(begin, size, value) for each number outside strings that is an integer written as a float.
template <class Use>
void for_each_integral_float(std::string_view json, const Use& use) {
    constexpr std::string_view k_number = "+-.0123456789eE";
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (c == '"') {
            for (++i; i < json.size() && json[i] != '"'; ++i)
                if (json[i] == '\\') ++i;
        } else if (c == '-' || (c >= '0' && c <= '9')) {
            std::size_t end = i + 1;
            while (end < json.size() && k_number.find(json[end]) != std::string_view::npos)
                ++end;
            if (const std::optional<std::int64_t> value = integral_float(json.substr(i, end - i)))
                use(i, end - i, *value);
            i = end - 1;
        }
    }
}

/// nlohmann's reader calls this for every token; returning false ends the walk.
class Walk final : public nlohmann::json_sax<nlohmann::json> {
public:
    Walk(const std::string& file, const ImportLimits& limits) : file_{file}, limits_{limits}, shape_{file} {}

    Preflight found;

    /// @throws Error  for values that cannot be meant
    void require_shape() const { shape_.require(); }
    Preflight take() {
        require_shape();
        found.warnings = shape_.take_warnings();
        return std::move(found);
    }

    bool null() override {
        shape_.null();
        return value();
    }
    bool boolean(bool which) override {
        shape_.boolean(which);
        return value();
    }
    bool number_integer(number_integer_t number) override {
        shape_.whole(std::int64_t{number});
        return value();
    }
    bool number_float(number_float_t number, const string_t& text) override {
        const bool is_whole = integral_float(text).has_value();
        shape_.number(number, is_whole, text);
        found.has_integral_floats = found.has_integral_floats || is_whole;
        if (in_buffer() && key_ == "byteLength" && number >= 0.0 && number < k_exact_integers)
            found.buffers.back().byte_length = static_cast<std::uint64_t>(number);
        return value();
    }
    bool binary(binary_t&) override { return value(); }
    bool number_unsigned(number_unsigned_t number) override {
        shape_.whole(std::uint64_t{number});
        if (in_buffer() && key_ == "byteLength") found.buffers.back().byte_length = number;
        return value();
    }
    bool string(string_t& text) override {
        shape_.text(text);
        if (path_.size() == 2 && path_[1] == "asset" && key_ == "version") found.version = text;
        if (path_.size() == 2 && path_[1] == "asset" && key_ == "minVersion") found.min_version = text;
        if (path_.size() == 2 && path_[1] == "extensionsRequired") found.extensions_required.push_back(text);
        if (in_buffer() && key_ == "uri") {
            BufferClaim& claim = found.buffers.back();
            const bool is_data = text.starts_with("data:");
            claim.source = is_data ? BufferClaim::Source::data_uri : BufferClaim::Source::external;
            if (!is_data) claim.uri = text;
        }
        return value();
    }
    bool key(string_t& name) override {
        key_ = name;
        shape_.key(name);
        // Of repeated keys the last one counts, as for tinygltf.
        if (in_buffer() && name == "uri") found.buffers.back().source = BufferClaim::Source::none;
        return true;
    }
    bool start_object(std::size_t) override {
        shape_.open_object();
        if (path_.size() == 2 && path_[1] == "buffers") found.buffers.emplace_back();
        return open();
    }
    bool start_array(std::size_t) override {
        shape_.open_array();
        return open();
    }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
        std::string_view text = error.what();
        if (const std::size_t prefix = text.find("] "); prefix != std::string_view::npos)
            text.remove_prefix(prefix + 2);
        throw Error{file_, "JSON", in_quotes(text), "glTF 2.0"};
    }

private:
    bool in_buffer() const { return path_.size() == 3 && path_[1] == "buffers" && !found.buffers.empty(); }

    bool value() {
        if (path_.size() == 2) ++found.counts[path_[1]];
        if (++values_ > limits_.json_values)
            throw Error{file_, "JSON", "more than " + std::to_string(limits_.json_values) + " values",
                        "fewer"};
        return true;
    }
    bool open() {
        value();
        path_.push_back(path_.size() == 1 ? key_ : std::string{});
        if (path_.size() > k_deepest)
            throw Error{file_, "JSON", "a value nested more than " + std::to_string(k_deepest) + " deep",
                        "less"};
        return true;
    }
    bool close() {
        shape_.close();
        path_.pop_back();
        return true;
    }

    const std::string& file_;
    const ImportLimits& limits_;
    ShapeCheck shape_;
    std::vector<std::string> path_;  ///< path_[1] names the top-level member that is open
    std::string key_;
    std::uint64_t values_ = 0;
};

void check_version(const std::string& file, const Preflight& found) {
    if (found.version.empty()) throw Error{file, "asset.version", "nothing", "\"2.0\""};
    if (!found.version.starts_with("2."))
        throw Error{file, "asset.version", in_quotes(found.version), "\"2.0\""};
    if (!found.min_version.empty() && found.min_version != "2.0")
        throw Error{file, "asset.minVersion", in_quotes(found.min_version), "\"2.0\""};
}

}  // namespace

std::optional<std::string> write_plain_integers(std::span<char> json) {
    std::string longer;  // empty until a number needs more room than it has
    std::size_t copied = 0;
    const std::string_view text{json.data(), json.size()};
    for_each_integral_float(text, [&](std::size_t begin, std::size_t size, std::int64_t integer) {
        std::string plain = std::to_string(integer);
        if (plain.size() <= size) {
            plain.resize(size, ' ');
            std::copy(plain.begin(), plain.end(), json.begin() + static_cast<std::ptrdiff_t>(begin));
            return;
        }
        longer.append(text.substr(copied, begin - copied)).append(plain);
        copied = begin + size;
    });
    if (copied == 0) return std::nullopt;
    return longer.append(text.substr(copied));
}

bool supports_extension(std::string_view name) {
    return std::find(k_supported.begin(), k_supported.end(), name) != k_supported.end();
}

Preflight preflight(const std::string& file, std::string_view json, const ImportLimits& limits) {
    const std::uint64_t longest =
        std::min<std::uint64_t>(limits.json_bytes, 0xffffffffu);  // tinygltf counts in 32 bits
    if (json.size() > longest)
        throw Error{file, "JSON", std::to_string(json.size()) + " bytes",
                    "at most " + std::to_string(longest)};
    Walk walk{file, limits};
    nlohmann::json::sax_parse(json, &walk);
    if (walk.found.version.empty()) walk.require_shape();
    check_version(file, walk.found);
    for (const std::string& name : walk.found.extensions_required)
        if (!supports_extension(name))
            throw Error{file, "extensionsRequired", in_quotes(name), "an extension that is supported"};
    return walk.take();
}

}  // namespace rambla::assets::gltf
