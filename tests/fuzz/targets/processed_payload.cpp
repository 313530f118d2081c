#include "assets/cache/processed_payload.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "assets/process/process.h"
#include "fuzz/target.h"
#include "support/sample_scenes.h"

namespace rambla::fuzz {
namespace {

template <class Result>
void check(const std::optional<Result>& result, Bytes bytes) {
    if (!result) return;
    const std::vector<std::byte> again = assets::to_payload(*result);
    if (!std::equal(again.begin(), again.end(), bytes.begin(), bytes.end()))
        broken("what is read from a payload is what stands in it");
}

/// The first byte chooses.
void run(Bytes bytes) {
    if (bytes.empty()) return;
    const Bytes payload = bytes.subspan(1);
    if (std::to_integer<int>(bytes[0]) % 2 == 0) {
        check(assets::mesh_from_payload(payload), payload);
    } else {
        check(assets::texture_from_payload(payload), payload);
    }
}

void seeds(const SeedTaker& take) {
    const auto seed = [&](const std::string& name, std::byte kind, const std::vector<std::byte>& payload) {
        std::vector<std::byte> bytes{kind};
        bytes.insert(bytes.end(), payload.begin(), payload.end());
        take(name, bytes);
    };
    for (const bool moving : {false, true}) {
        const assets::ProcessedScene processed =
            assets::process(moving ? assets::test::moving_scene() : assets::test::standing_scene(), {});
        const std::string end = moving ? "-moving" : "-standing";
        for (std::size_t i = 0; i < processed.meshes.size(); ++i)
            seed("mesh-" + std::to_string(i) + end, std::byte{0}, to_payload(processed.meshes[i]));
        for (std::size_t i = 0; i < processed.images.size(); ++i)
            seed("texture-" + std::to_string(i) + end, std::byte{1}, to_payload(processed.images[i]));
    }
}

const Registration k_processed_payload{{"processed_payload", run, seeds}};

}  // namespace
}  // namespace rambla::fuzz
