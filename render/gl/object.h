#pragma once

#include <epoxy/gl.h>

#include <atomic>
#include <cstdint>
#include <string_view>
#include <utility>

namespace rambla::render::gl {

/// GL objects alive in this process, and the bytes of their storage: both return to zero when all owners are
/// gone.
struct LiveCounts {
    std::uint32_t objects = 0;
    std::uint64_t bytes = 0;
};
[[nodiscard]] LiveCounts live_counts();

namespace detail {
inline std::atomic<std::uint32_t> live_objects{0};
inline std::atomic<std::uint64_t> live_bytes{0};
}  // namespace detail

/// Owner of one GL name and of the account of its storage: move-only, deletes with Deleter::destroy(name).
/// A context must be current in the thread that destroys a non-empty one.
template <class Deleter>
class Object {
public:
    Object() = default;
    explicit Object(GLuint name, std::uint64_t bytes = 0) : name_{name}, bytes_{bytes} {
        detail::live_objects.fetch_add(1, std::memory_order_relaxed);
        detail::live_bytes.fetch_add(bytes_, std::memory_order_relaxed);
    }
    Object(Object&& other) noexcept
        : name_{std::exchange(other.name_, 0)}, bytes_{std::exchange(other.bytes_, 0)} {}
    Object& operator=(Object&& other) noexcept {
        std::swap(name_, other.name_);
        std::swap(bytes_, other.bytes_);
        return *this;
    }
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;
    ~Object() {
        if (name_ == 0) return;
        Deleter::destroy(name_);
        detail::live_objects.fetch_sub(1, std::memory_order_relaxed);
        detail::live_bytes.fetch_sub(bytes_, std::memory_order_relaxed);
    }

    [[nodiscard]] GLuint name() const { return name_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    [[nodiscard]] explicit operator bool() const { return name_ != 0; }

private:
    GLuint name_ = 0;
    std::uint64_t bytes_ = 0;
};

/// Names an object for debug output and GPU debuggers. @param kind  GL_BUFFER, GL_TEXTURE, …
void label(GLenum kind, GLuint name, std::string_view text);

}  // namespace rambla::render::gl
