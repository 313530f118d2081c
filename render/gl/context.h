#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/window_context.h"

namespace rambla::render {

/// The machine's GL lacks something that the renderer cannot do without; the message names it in one line.
class MissingFeature : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// One thing that a device can or cannot do.
struct DeviceFeature {
    std::string name;
    bool present = false;
    bool required = false;
};

struct DeviceLimit {
    std::string name;
    std::int64_t value = 0;
    std::int64_t required = 0;  ///< 0: any value will do
};

/// What `rambla doctor` prints about the graphics device.
struct DeviceInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    std::string shading_language;
    bool software = false;                 ///< a rasteriser on the CPU
    bool block_compression = false;        ///< textures had better be block-compressed
    std::string block_compression_reason;  ///< why, or why not
    std::vector<DeviceFeature> features;
    std::vector<DeviceLimit> limits;
};

/// Opens a context, asks, and closes it again. @throws MissingFeature  only when no context can be made at
/// all
[[nodiscard]] DeviceInfo query_device(const WindowContext& window);

}  // namespace rambla::render

namespace rambla::render::gl {

/// The renderer's GL context, current in the thread that constructs it until it is destroyed there.
class Context {
public:
    /// @param window  functions of a context made elsewhere, or empty for an EGL surfaceless one
    /// @throws MissingFeature
    Context(const WindowContext& window, bool errors_throw);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    [[nodiscard]] bool headless() const;
    /// Shows the default framebuffer; nothing when headless.
    void swap();
    /// Throws std::runtime_error with the GL debug messages since the last call, if errors are to throw.
    void check_errors();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// What the current context offers.
[[nodiscard]] DeviceInfo describe_device();
/// @throws MissingFeature  naming the first required feature or limit that is absent
void require_features(const DeviceInfo& device);

}  // namespace rambla::render::gl
