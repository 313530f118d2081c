#include "ecs/entity.h"

namespace rambla::ecs {

std::string to_string(Entity entity) {
    if (entity == Entity{}) return "null";
    if (entity.generation == 0) return "placeholder " + std::to_string(entity.index);
    return std::to_string(entity.index) + "v" + std::to_string(entity.generation);
}

}  // namespace rambla::ecs
