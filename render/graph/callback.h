#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

namespace rambla::render::graph {

/// A callable kept in place, so that recording a pass allocates nothing: std::function would, for captures of
/// more than two pointers. Takes trivially copyable callables of up to k_bytes.
template <class... Arguments>
class Callback {
public:
    static constexpr std::size_t k_bytes = 192;  ///< two dozen handles and references

    Callback() = default;
    template <class F>
    requires(!std::is_same_v<std::remove_cvref_t<F>, Callback>) explicit Callback(const F& function)
        : call_{[](const std::byte* storage, Arguments... arguments) {
              (*std::launder(reinterpret_cast<const F*>(storage)))(static_cast<Arguments>(arguments)...);
          }} {
        static_assert(std::is_trivially_copyable_v<F> && std::is_trivially_destructible_v<F>,
                      "capture handles by value and long-lived objects by reference");
        static_assert(sizeof(F) <= k_bytes && alignof(F) <= alignof(std::max_align_t));
        new (storage_) F(function);
    }

    void operator()(Arguments... arguments) const { call_(storage_, static_cast<Arguments>(arguments)...); }
    [[nodiscard]] explicit operator bool() const { return call_ != nullptr; }

private:
    void (*call_)(const std::byte*, Arguments...) = nullptr;
    alignas(std::max_align_t) std::byte storage_[k_bytes]{};
};

}  // namespace rambla::render::graph
