#pragma once

#include "ecs/parent.h"
#include "ecs/reflect.h"

namespace rambla::ecs {

template <>
struct reflection<OnParentEnd> {
    static constexpr auto value =
        enumeration<OnParentEnd>({{"destroyed", OnParentEnd::destroyed}, {"freed", OnParentEnd::freed}});
};
template <>
struct reflection<Parent> {
    static constexpr auto value =
        describe<Parent>("parent").field("entity", &Parent::entity).field("on_end", &Parent::on_end);
};

}  // namespace rambla::ecs
