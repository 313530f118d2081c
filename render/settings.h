#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "assets/parameter.h"
#include "render/settings/anti_aliasing.h"
#include "render/settings/bloom.h"
#include "render/settings/exposure.h"
#include "render/settings/tone.h"

namespace rambla::render {

enum class ShadowMethod : std::uint8_t { off, focused };

enum class ShadowTaps : std::uint8_t { four, sixteen };

/// Shadow of the sun: one map fitted to what the camera sees (Brabec et al. 2002), filtered by PCF.
struct ShadowParameters {
    ShadowMethod method = ShadowMethod::focused;
    int size_texels = 4096;
    ShadowTaps taps = ShadowTaps::sixteen;
    float distance_m = 160.0f;
    float bias_texels = 1.5f;
};
inline constexpr std::array<std::string_view, 2> k_shadow_methods{"off", "focused"};
inline constexpr std::array<std::string_view, 2> k_shadow_taps{"4", "16"};
inline constexpr std::array k_shadow_parameters{
    parameter<&ShadowParameters::method>("method", k_shadow_methods, "How the sun's shadow is found."),
    parameter<&ShadowParameters::size_texels>("size", "texels", 256, 8192,
                                              "Width and height of the shadow map."),
    parameter<&ShadowParameters::taps>("taps", k_shadow_taps,
                                       "Depth comparisons per pixel: one gather of 4, or four of them."),
    parameter<&ShadowParameters::distance_m>("distance", "m", 10, 2000,
                                             "How far from the eye shadows are looked for."),
    parameter<&ShadowParameters::bias_texels>("bias", "texels", 0, 8,
                                              "Offset along the normal, in shadow texels."),
};

enum class LightingPath : std::uint8_t { fullscreen, volumes, clustered, tiled, forward };

enum class LightVolume : std::uint8_t { quad, solid };

/// How surfaces are lit. All paths give the same picture; they differ in what they cost.
struct LightingParameters {
    LightingPath path = LightingPath::tiled;
    int tile_px = 64;
    int slices = 16;
    LightVolume volume = LightVolume::quad;
    bool queries = false;
    bool prepass = false;
};
inline constexpr std::array<std::string_view, 5> k_lighting_paths{"fullscreen", "volumes", "clustered",
                                                                  "tiled", "forward"};
inline constexpr std::array<std::string_view, 2> k_light_volumes{"quad", "solid"};
inline constexpr std::array k_lighting_parameters{
    parameter<&LightingParameters::path>("lighting", k_lighting_paths,
                                         "How lights find the pixels that they reach."),
    parameter<&LightingParameters::tile_px>("tile", "px", 16, 256,
                                            "Width and height of the screen's tiles, of which each has a "
                                            "list of lights."),
    parameter<&LightingParameters::slices>("slices", "", 1, 64,
                                           "clustered, forward and blending: depths that a tile's list of "
                                           "lights is divided into."),
    parameter<&LightingParameters::volume>("volume", k_light_volumes,
                                           "volumes: what is drawn for a light, a rectangle of the screen "
                                           "or a sphere or cone."),
    parameter<&LightingParameters::queries>("queries", "", 0, 1,
                                            "volumes: lights that reach nothing seen, by an occlusion query "
                                            "each, are not drawn."),
    parameter<&LightingParameters::prepass>("prepass", "", 0, 1,
                                            "Depth is drawn alone first, so that hidden surfaces are not "
                                            "shaded."),
};

enum class GBufferLayout : std::uint8_t { compact, wide };

/// How the deferred paths keep what they light.
struct GBufferParameters {
    GBufferLayout layout = GBufferLayout::compact;
};
inline constexpr std::array<std::string_view, 2> k_gbuffer_layouts{"compact", "wide"};
inline constexpr std::array k_gbuffer_parameters{
    parameter<&GBufferParameters::layout>("gbuffer", k_gbuffer_layouts,
                                          "Bytes with positions from depth, or positions, normals, tangents "
                                          "and colours as half floats."),
};

enum class DetailGrade : std::uint8_t { flat, normal, parallax, occlusion };

/// How much of what lies in a surface's textures is more than colour. Each grade adds to the one before.
struct DetailParameters {
    DetailGrade grade = DetailGrade::normal;
    int steps = 16;
};
inline constexpr std::array<std::string_view, 4> k_detail_grades{"flat", "normal", "parallax", "occlusion"};
inline constexpr std::array k_detail_parameters{
    parameter<&DetailParameters::grade>("detail", k_detail_grades,
                                        "Unevenness of surfaces: none, normal maps, or also shifts by their "
                                        "heights, with what hides behind them or without."),
    parameter<&DetailParameters::steps>("steps", "", 4, 128,
                                        "occlusion: places at which a look meets the heights, at most."),
};

enum class Brdf : std::uint8_t { ggx, blinn, lambert };

/// How surfaces reflect the sun and local lights.
struct BrdfParameters {
    Brdf model = Brdf::ggx;
};
inline constexpr std::array<std::string_view, 3> k_brdf_models{"ggx", "blinn", "lambert"};
inline constexpr std::array k_brdf_parameters{
    parameter<&BrdfParameters::model>("brdf", k_brdf_models,
                                      "Reflection of sun and lamps: GGX as glTF has it, Blinn-Phong, or "
                                      "Lambert without highlights."),
};

enum class DebugView : std::uint8_t {
    off,
    albedo,
    normal,
    roughness,
    metalness,
    occlusion,
    emission,
    depth,
    shadow,
    lights,
    tiles,
    overdraw,
    luminance,
    nonfinite,
    objects
};

/// What is shown instead of the picture.
struct DebugParameters {
    DebugView view = DebugView::off;
};
inline constexpr std::array<std::string_view, 15> k_debug_views{
    "off",    "albedo", "normal", "roughness", "metalness", "occlusion", "emission", "depth",
    "shadow", "lights", "tiles",  "overdraw",  "luminance", "nonfinite", "objects"};
inline constexpr std::array k_debug_parameters{
    parameter<&DebugParameters::view>("debug-view", k_debug_views,
                                      "Shows what a picture is made from instead of the picture."),
};

/// How much of a scene's textures is on the graphics card. Pictures need no more than what they show: the
/// default is what a card of 4 GiB can spare.
struct TextureParameters {
    float budget_mib = 1024.0f;
    float upload_mib = 16.0f;  ///< a few milliseconds of a PCIe bus, or of llvmpipe
};
inline constexpr std::array k_texture_budget_parameters{
    parameter<&TextureParameters::budget_mib>(
        "budget", "MiB", 0.125, 65536, "What textures may take; levels of 64 texels and less stay even so."),
    parameter<&TextureParameters::upload_mib>("upload", "MiB", 0.0625, 4096,
                                              "What may be uploaded of them for a frame."),
};

/// All that a user may choose about drawing, read anew for each Frame.
struct Settings {
    LightingParameters lighting;
    GBufferParameters gbuffer;
    DetailParameters detail;
    BrdfParameters brdf;
    ShadowParameters shadows;
    ExposureParameters exposure;
    ToneParameters tone;
    BloomParameters bloom;
    AntiAliasingParameters anti_aliasing;
    TextureParameters textures;
    DebugParameters debug;
};

}  // namespace rambla::render
