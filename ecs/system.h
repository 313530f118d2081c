#pragma once

#include <concepts>
#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ecs/job_commands.h"
#include "ecs/parameter.h"

namespace rambla::ecs::detail {

/// The parameters of a function, or of what has one operator().
template <class F>
struct Signature : Signature<decltype(&F::operator())> {};
template <class... Ps>
struct Signature<void (*)(Ps...)> {
    using Parameters = std::tuple<Parameter<std::remove_cvref_t<Ps>>...>;
};
template <class... Ps>
struct Signature<void (*)(Ps...) noexcept> : Signature<void (*)(Ps...)> {};
template <class C, class... Ps>
struct Signature<void (C::*)(Ps...)> : Signature<void (*)(Ps...)> {};
template <class C, class... Ps>
struct Signature<void (C::*)(Ps...) const> : Signature<void (*)(Ps...)> {};
template <class C, class... Ps>
struct Signature<void (C::*)(Ps...) noexcept> : Signature<void (*)(Ps...)> {};
template <class C, class... Ps>
struct Signature<void (C::*)(Ps...) const noexcept> : Signature<void (*)(Ps...)> {};

template <class P, class Parameters>
inline constexpr bool k_at_most_once = false;
template <class P, class... Ps>
inline constexpr bool k_at_most_once<P, std::tuple<Ps...>> = k_times_in<Parameter<P>, Ps...> <= 1;

/// A system with what it keeps from run to run, its type forgotten.
class SystemBody {
public:
    virtual ~SystemBody() = default;
    virtual void prepare(World& world) = 0;
    virtual void run(SystemContext& context) = 0;
    /// Hands over what was written for later systems.
    virtual void finish(SystemContext& context) = 0;
    /// Drops it instead.
    virtual void forget() noexcept = 0;
};

template <class F>
class TypedSystem final : public SystemBody {
public:
    static_assert(k_at_most_once<Commands, typename Signature<F>::Parameters>, "a system has one Commands&");

    TypedSystem(F function, Declaration& declaration) : function_{std::move(function)} {
        each([&](auto& parameter) { parameter.declare(declaration); });
    }

    void prepare(World& world) override {
        each([&](auto& parameter) { parameter.prepare(world); });
    }
    void run(SystemContext& context) override {
        std::apply([&](auto&... parameter) { std::invoke(function_, parameter.fetch(context)...); },
                   parameters_);
    }
    void finish(SystemContext& context) override {
        each([&](auto& parameter) { parameter.finish(context); });
    }
    void forget() noexcept override {
        each([](auto& parameter) { parameter.forget(); });
    }

private:
    template <class Do>
    void each(const Do& what) {
        std::apply([&](auto&... parameter) { (what(parameter), ...); }, parameters_);
    }

    F function_;
    typename Signature<F>::Parameters parameters_;
};

}  // namespace rambla::ecs::detail
