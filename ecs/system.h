#pragma once

#include <concepts>
#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ecs/job_commands.h"
#include "ecs/parameter.h"

namespace rambla::ecs::detail {

/// What the schedule keeps for a parameter written as P. Says what is wrong with those that it cannot
/// provide.
template <class P>
struct ParameterAs {
    using Type = Parameter<std::remove_cvref_t<P>>;
    static_assert(
        requires { sizeof(Type); },
        "a parameter of a system is a View, Lookup, Res, ResMut or EventReader, or an EventWriter&, "
        "Commands&, JobCommands&, Query& or World&; values of its own belong to the system itself");

    /// Whether the system uses what the schedule keeps, rather than a value made for it.
    static constexpr bool k_lent = [] {
        if constexpr (requires { sizeof(Type); }) {
            return std::is_reference_v<decltype(std::declval<Type&>().fetch(std::declval<SystemContext&>()))>;
        }
        return std::is_reference_v<P>;
    }();
    static constexpr bool k_is_reference_to_change =
        std::is_lvalue_reference_v<P> && !std::is_const_v<std::remove_reference_t<P>>;
    static_assert(!k_lent || std::is_lvalue_reference_v<P>,
                  "a system takes World, Query, Commands, JobCommands and EventWriter by reference: World&");
    static_assert(k_lent || !k_is_reference_to_change,
                  "a system takes View, Lookup, Res, ResMut and EventReader by value, not by reference");
};

template <class F>
concept OneCall = requires {
    &F::operator();
};

/// The parameters of a function, or of what has one operator().
template <class F>
struct Signature {
    static_assert(OneCall<F>,
                  "a system is a function that returns nothing, or an object with one operator() "
                  "that does; no template (auto), no overloads");
};
template <OneCall F>
struct Signature<F> : Signature<decltype(&F::operator())> {};
template <class... Ps>
struct Signature<void (*)(Ps...)> {
    using Parameters = std::tuple<typename ParameterAs<Ps>::Type...>;
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
