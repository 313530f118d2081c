#include "assets/trace/embree_scene.h"

#include <embree3/rtcore.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "assets/trace/float_mode.h"

namespace rambla::assets {
namespace {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

/// What Embree says, while a Tracer is built.
struct Diary {
    std::atomic<std::int64_t> bytes{0};
    std::mutex mutex;
    std::string error;
};

}  // namespace

struct EmbreeScene::State {
    explicit State(const PlacedScene& scene) : placed{scene} { build(); }

    const PlacedScene& placed;
    Diary diary;  // outlives the device, which writes to it
    Device device;
    std::vector<Scene> scenes;  ///< of meshes and of copies
    Scene world;
    double reach_m = 0.0;  ///< the largest of the instances'

    void build();

private:
    void open_device();
    /// @throws std::runtime_error  if anything has failed
    void check();
    Scene new_scene();
    /// @param place  of a vertex
    template <class PlaceOf>
    RTCScene add_triangles(const TraceMesh& mesh, PlaceOf&& place_of);
    void add_instance(std::uint32_t instance, std::vector<RTCScene>& scene_of_mesh);
};

void EmbreeScene::State::open_device() {
    device.reset(rtcNewDevice(nullptr));
    if (!device)
        throw std::runtime_error{
            fmt::format("Embree does not start (error {})", static_cast<int>(rtcGetDeviceError(nullptr)))};
    if (rtcGetDeviceProperty(device.get(), RTC_DEVICE_PROPERTY_FILTER_FUNCTION_SUPPORTED) == 0)
        throw std::runtime_error{
            "This build of Embree has no filter functions, which masks and culling need"};
    rtcSetDeviceErrorFunction(
        device.get(),
        [](void* of_state, RTCError code, const char* message) {
            Diary& log = *static_cast<Diary*>(of_state);
            const std::scoped_lock lock{log.mutex};
            if (log.error.empty())
                log.error =
                    fmt::format("{} (error {})", message == nullptr ? "" : message, static_cast<int>(code));
        },
        &diary);
    rtcSetDeviceMemoryMonitorFunction(
        device.get(),
        [](void* of_state, ssize_t bytes, bool) {
            static_cast<Diary*>(of_state)->bytes += bytes;
            return true;
        },
        &diary);
}

void EmbreeScene::State::check() {
    const std::scoped_lock lock{diary.mutex};
    if (!diary.error.empty())
        throw std::runtime_error{fmt::format("Embree cannot trace the scene: {}", diary.error)};
}

Scene EmbreeScene::State::new_scene() {
    Scene scene{rtcNewScene(device.get())};
    check();
    rtcSetSceneFlags(scene.get(), static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                             RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    return scene;
}

template <class PlaceOf>
RTCScene EmbreeScene::State::add_triangles(const TraceMesh& mesh, PlaceOf&& place_of) {
    const Geometry geometry{rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE)};
    auto* const positions = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.positions.size()));
    auto* const indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.indices.size() / 3));
    check();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 place = place_of(mesh.positions[i]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            positions[3 * i + axis] = place[static_cast<glm::length_t>(axis)];
    }
    std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
    rtcCommitGeometry(geometry.get());
    Scene scene = new_scene();
    rtcAttachGeometry(scene.get(), geometry.get());
    rtcCommitScene(scene.get());
    check();
    scenes.push_back(std::move(scene));
    return scenes.back().get();
}

void EmbreeScene::State::add_instance(std::uint32_t instance, std::vector<RTCScene>& scene_of_mesh) {
    const TraceInstance& what = placed.scene().instances[instance];
    const TraceMesh& mesh = placed.scene().meshes[what.mesh];
    if (!placed.exists(instance) || mesh.indices.empty()) return;
    reach_m = std::max(reach_m, placed.reach_m(instance));
    glm::mat4x3 world_from_local = what.world_from_local;
    RTCScene content = nullptr;
    if (placed.condition(instance) < k_largest_condition) {
        if (scene_of_mesh[what.mesh] == nullptr)
            scene_of_mesh[what.mesh] = add_triangles(mesh, [](glm::vec3 local) { return local; });
        content = scene_of_mesh[what.mesh];
    } else {
        world_from_local = glm::mat4x3{1.0f};
        content = add_triangles(
            mesh, [&](glm::vec3 local) { return glm::vec3{placed.placed(instance, glm::dvec3{local})}; });
    }
    const Geometry geometry{rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE)};
    rtcSetGeometryInstancedScene(geometry.get(), content);
    rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &world_from_local[0][0]);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(world.get(), geometry.get(), instance);
}

void EmbreeScene::State::build() {
    open_device();
    world = new_scene();
    std::vector<RTCScene> scene_of_mesh(placed.scene().meshes.size(), nullptr);
    for (std::uint32_t i = 0; i < placed.scene().instances.size(); ++i)
        add_instance(i, scene_of_mesh);
    rtcCommitScene(world.get());
    check();
}

EmbreeScene::EmbreeScene(const PlacedScene& placed) : state_{std::make_unique<State>(placed)} {}
EmbreeScene::~EmbreeScene() {
    const ScopedFloatMode mode;
    state_.reset();
}

RTCSceneTy* EmbreeScene::world() const {
    return state_->world.get();
}

double EmbreeScene::reach_m() const {
    return state_->reach_m;
}

std::size_t EmbreeScene::memory_bytes() const {
    return static_cast<std::size_t>(std::max<std::int64_t>(state_->diary.bytes, 0));
}

}  // namespace rambla::assets
