#include "render/passes/bare_mesh.h"

namespace rambla::render {

std::vector<std::pair<std::string, std::string>> bare_mesh_defines(bool skinned, bool morphed) {
    return {{"DETAIL", "0"},
            {"EMISSION", "0"},
            {"SPECULAR", "0"},
            {"TRANSMISSION", "0"},
            {"LIGHT_MAP", "0"},
            {"SKINNED", skinned ? "1" : "0"},
            {"MORPHED", morphed ? "1" : "0"}};
}

}  // namespace rambla::render
