#pragma once

#include "ecs/parameter.h"

namespace rambla::ecs {

/// System parameter: the world's R, for reading. The run throws Misuse if it was never set.
template <class R>
class Res {
public:
    explicit Res(const R& value) : value_{&value} {}
    const R& operator*() const { return *value_; }
    const R* operator->() const { return value_; }

private:
    const R* value_;
};

/// System parameter: the world's R, for writing.
template <class R>
class ResMut {
public:
    explicit ResMut(R& value) : value_{&value} {}
    R& operator*() const { return *value_; }
    R* operator->() const { return value_; }

private:
    R* value_;
};

namespace detail {

template <class R>
struct Parameter<Res<R>> : PlainParameter {
    static void declare(Declaration& declaration) {
        declaration.access.add(access_part<R>(AccessKind::resource, false));
    }
    static Res<R> fetch(SystemContext& context) {
        return Res<R>{static_cast<const World&>(*context.world).resource<R>()};
    }
};

template <class R>
struct Parameter<ResMut<R>> : PlainParameter {
    static void declare(Declaration& declaration) {
        declaration.access.add(access_part<R>(AccessKind::resource, true));
    }
    static ResMut<R> fetch(SystemContext& context) { return ResMut<R>{context.world->resource<R>()}; }
};

}  // namespace detail
}  // namespace rambla::ecs
