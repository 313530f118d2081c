#include "ecs/type_registry.h"

#include <algorithm>

#include "ecs/misuse.h"

namespace rambla::ecs {

const ComponentType* TypeRegistry::component(std::string_view name) const {
    const auto found = std::find_if(components_.begin(), components_.end(),
                                    [&](const ComponentType& type) { return type.name == name; });
    return found == components_.end() ? nullptr : &*found;
}

const ComponentType* TypeRegistry::component(const ComponentInfo& info) const {
    const auto found = std::find_if(components_.begin(), components_.end(), [&](const ComponentType& type) {
        return type.info->type_index == info.type_index;
    });
    return found == components_.end() ? nullptr : &*found;
}

const ResourceType* TypeRegistry::resource(std::string_view name) const {
    const auto found = std::find_if(resources_.begin(), resources_.end(),
                                    [&](const ResourceType& type) { return type.description->name == name; });
    return found == resources_.end() ? nullptr : &*found;
}

const TypeRegistry::Migration* TypeRegistry::migration(std::string_view name, std::uint32_t from) const {
    const auto found = migrations_.find(key(name, from));
    return found == migrations_.end() ? nullptr : &found->second;
}

void TypeRegistry::insert(const ComponentType& type) {
    if (component(type.name) != nullptr || component(*type.info) != nullptr) {
        throw Misuse{"ecs: TypeRegistry: component " + std::string{type.name} + " is registered twice"};
    }
    components_.push_back(type);
}

void TypeRegistry::insert(const ResourceType& type) {
    if (resource(type.description->name) != nullptr) {
        throw Misuse{"ecs: TypeRegistry: resource " + std::string{type.description->name} +
                     " is registered twice"};
    }
    resources_.push_back(type);
}

}  // namespace rambla::ecs
