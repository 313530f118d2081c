#include "assets/import/gltf_shape.h"

#include <numbers>

namespace rambla::assets::gltf {

namespace {

constexpr double k_largest_index = std::numeric_limits<std::int32_t>::max() - 1.0;
constexpr double k_largest_size = 9007199254740991.0;  // 2⁵³ − 1: doubles tell all of them apart
constexpr double k_largest_float = 3.4028236e38;       // as printed, rounded up

constexpr Shape whole(double least, double most) {
    return {.kind = JsonKind::whole, .least = least, .most = most};
}
constexpr Shape number(double least, double most) {
    return {.kind = JsonKind::number, .least = least, .most = most};
}
constexpr Shape object(std::span<const ShapeMember> members) {
    return {.kind = JsonKind::object, .members = members};
}
constexpr Shape array_of(const Shape& each, std::uint64_t size = 0) {
    return {.kind = JsonKind::array, .each = &each, .size = size};
}
constexpr Shape map_of(const Shape& each) {
    return {.kind = JsonKind::object, .each = &each};
}

constexpr Shape k_index = whole(0.0, k_largest_index);
constexpr Shape k_size = whole(0.0, k_largest_size);
constexpr Shape k_constant = whole(0.0, 65535.0);  // of OpenGL
constexpr Shape k_number{.kind = JsonKind::number};
constexpr Shape k_float = number(-k_largest_float, k_largest_float);
constexpr Shape k_share = number(0.0, 1.0);
constexpr Shape k_amount = number(0.0, k_largest_float);
constexpr Shape k_boolean{.kind = JsonKind::boolean};
constexpr Shape k_text{.kind = JsonKind::text};
constexpr Shape k_object{.kind = JsonKind::object};
constexpr Shape k_indices = array_of(k_index);
constexpr Shape k_numbers = array_of(k_number);
constexpr Shape k_texts = array_of(k_text);
constexpr Shape k_attributes = map_of(k_index);
constexpr Shape k_pair = array_of(k_float, 2);
constexpr Shape k_colour = array_of(k_share, 3);
constexpr Shape k_colour_alpha = array_of(k_share, 4);
constexpr Shape k_amounts = array_of(k_amount, 3);

constexpr ShapeMember k_asset_members[] = {{"version", &k_text}, {"minVersion", &k_text}};
constexpr Shape k_asset = object(k_asset_members);

constexpr ShapeMember k_buffer_members[] = {{"byteLength", &k_size}, {"uri", &k_text}};
constexpr Shape k_buffer = object(k_buffer_members);
constexpr Shape k_buffers = array_of(k_buffer);

constexpr Shape k_stride = whole(0.0, 252.0);
constexpr ShapeMember k_view_members[] = {{"buffer", &k_index},
                                          {"byteOffset", &k_size},
                                          {"byteLength", &k_size},
                                          {"byteStride", &k_stride},
                                          {"target", &k_constant}};
constexpr Shape k_view = object(k_view_members);
constexpr Shape k_views = array_of(k_view);

constexpr ShapeMember k_sparse_part_members[] = {
    {"bufferView", &k_index}, {"byteOffset", &k_index}, {"componentType", &k_constant}};
constexpr Shape k_sparse_part = object(k_sparse_part_members);
constexpr ShapeMember k_sparse_members[] = {
    {"count", &k_index}, {"indices", &k_sparse_part}, {"values", &k_sparse_part}};
constexpr Shape k_sparse = object(k_sparse_members);
constexpr ShapeMember k_accessor_members[] = {
    {"bufferView", &k_index}, {"byteOffset", &k_size}, {"componentType", &k_constant},
    {"count", &k_size},       {"type", &k_text},       {"normalized", &k_boolean},
    {"sparse", &k_sparse},    {"min", &k_numbers},     {"max", &k_numbers}};
constexpr Shape k_accessor = object(k_accessor_members);
constexpr Shape k_accessors = array_of(k_accessor);

constexpr Shape k_mode = whole(0.0, 6.0);
constexpr Shape k_targets = array_of(k_attributes);
constexpr ShapeMember k_primitive_members[] = {{"attributes", &k_attributes},
                                               {"indices", &k_index},
                                               {"material", &k_index},
                                               {"mode", &k_mode},
                                               {"targets", &k_targets}};
constexpr Shape k_primitive = object(k_primitive_members);
constexpr Shape k_primitives = array_of(k_primitive);
constexpr ShapeMember k_mesh_members[] = {{"primitives", &k_primitives}, {"weights", &k_numbers}};
constexpr Shape k_mesh = object(k_mesh_members);
constexpr Shape k_meshes = array_of(k_mesh);

constexpr ShapeMember k_texture_transform_members[] = {
    {"offset", &k_pair}, {"scale", &k_pair}, {"rotation", &k_float}, {"texCoord", &k_index}};
constexpr Shape k_texture_transform = object(k_texture_transform_members);
constexpr ShapeMember k_texture_info_extension_members[] = {{"KHR_texture_transform", &k_texture_transform}};
constexpr Shape k_texture_info_extensions = object(k_texture_info_extension_members);
constexpr ShapeMember k_texture_info_members[] = {{"index", &k_index},
                                                  {"texCoord", &k_index},
                                                  {"scale", &k_float},
                                                  {"strength", &k_share},
                                                  {"extensions", &k_texture_info_extensions}};
constexpr Shape k_texture_info = object(k_texture_info_members);

constexpr ShapeMember k_base_members[] = {{"baseColorFactor", &k_colour_alpha},
                                          {"metallicFactor", &k_share},
                                          {"roughnessFactor", &k_share},
                                          {"baseColorTexture", &k_texture_info},
                                          {"metallicRoughnessTexture", &k_texture_info}};
constexpr Shape k_base = object(k_base_members);
constexpr ShapeMember k_emissive_strength_members[] = {{"emissiveStrength", &k_amount}};
constexpr Shape k_emissive_strength = object(k_emissive_strength_members);
constexpr ShapeMember k_ior_members[] = {{"ior", &k_number}};
constexpr Shape k_ior = object(k_ior_members);
constexpr ShapeMember k_specular_members[] = {{"specularFactor", &k_share},
                                              {"specularColorFactor", &k_amounts},
                                              {"specularTexture", &k_texture_info},
                                              {"specularColorTexture", &k_texture_info}};
constexpr Shape k_specular = object(k_specular_members);
constexpr ShapeMember k_transmission_members[] = {{"transmissionFactor", &k_share},
                                                  {"transmissionTexture", &k_texture_info}};
constexpr Shape k_transmission = object(k_transmission_members);
constexpr ShapeMember k_material_extension_members[] = {
    {"KHR_materials_emissive_strength", &k_emissive_strength},
    {"KHR_materials_ior", &k_ior},
    {"KHR_materials_specular", &k_specular},
    {"KHR_materials_transmission", &k_transmission},
    {"KHR_materials_unlit", &k_object}};
constexpr Shape k_material_extensions = object(k_material_extension_members);
constexpr ShapeMember k_material_members[] = {{"pbrMetallicRoughness", &k_base},
                                              {"normalTexture", &k_texture_info},
                                              {"occlusionTexture", &k_texture_info},
                                              {"emissiveTexture", &k_texture_info},
                                              {"emissiveFactor", &k_colour},
                                              {"alphaMode", &k_text},
                                              {"alphaCutoff", &k_amount},
                                              {"doubleSided", &k_boolean},
                                              {"extensions", &k_material_extensions}};
constexpr Shape k_material = object(k_material_members);
constexpr Shape k_materials = array_of(k_material);

constexpr ShapeMember k_image_members[] = {{"uri", &k_text}, {"bufferView", &k_index}, {"mimeType", &k_text}};
constexpr Shape k_image = object(k_image_members);
constexpr Shape k_images = array_of(k_image);
constexpr ShapeMember k_texture_members[] = {{"source", &k_index}, {"sampler", &k_index}};
constexpr Shape k_texture = object(k_texture_members);
constexpr Shape k_textures = array_of(k_texture);
constexpr ShapeMember k_sampler_members[] = {
    {"magFilter", &k_constant}, {"minFilter", &k_constant}, {"wrapS", &k_constant}, {"wrapT", &k_constant}};
constexpr Shape k_sampler = object(k_sampler_members);
constexpr Shape k_samplers = array_of(k_sampler);

// Some exporters leave the wrapper out.
constexpr ShapeMember k_instancing_members[] = {
    {"attributes", &k_attributes}, {"TRANSLATION", &k_index}, {"ROTATION", &k_index}, {"SCALE", &k_index}};
constexpr Shape k_instancing = object(k_instancing_members);
constexpr ShapeMember k_node_light_members[] = {{"light", &k_index}};
constexpr Shape k_node_light = object(k_node_light_members);
constexpr ShapeMember k_levels_members[] = {{"ids", &k_indices}};
constexpr Shape k_levels = object(k_levels_members);
constexpr ShapeMember k_node_extension_members[] = {{"EXT_mesh_gpu_instancing", &k_instancing},
                                                    {"KHR_lights_punctual", &k_node_light},
                                                    {"MSFT_lod", &k_levels}};
constexpr Shape k_node_extensions = object(k_node_extension_members);
constexpr ShapeMember k_node_members[] = {{"mesh", &k_index},          {"camera", &k_index},
                                          {"skin", &k_index},          {"children", &k_indices},
                                          {"translation", &k_numbers}, {"rotation", &k_numbers},
                                          {"scale", &k_numbers},       {"matrix", &k_numbers},
                                          {"weights", &k_numbers},     {"extensions", &k_node_extensions}};
constexpr Shape k_node = object(k_node_members);
constexpr Shape k_nodes = array_of(k_node);
constexpr ShapeMember k_scene_members[] = {{"nodes", &k_indices}};
constexpr Shape k_scene = object(k_scene_members);
constexpr Shape k_scenes = array_of(k_scene);

constexpr ShapeMember k_skin_members[] = {
    {"inverseBindMatrices", &k_index}, {"skeleton", &k_index}, {"joints", &k_indices}};
constexpr Shape k_skin = object(k_skin_members);
constexpr Shape k_skins = array_of(k_skin);

constexpr ShapeMember k_channel_target_members[] = {{"node", &k_index}, {"path", &k_text}};
constexpr Shape k_channel_target = object(k_channel_target_members);
constexpr ShapeMember k_channel_members[] = {{"sampler", &k_index}, {"target", &k_channel_target}};
constexpr Shape k_channel = object(k_channel_members);
constexpr Shape k_channels = array_of(k_channel);
constexpr ShapeMember k_key_sampler_members[] = {
    {"input", &k_index}, {"output", &k_index}, {"interpolation", &k_text}};
constexpr Shape k_key_sampler = object(k_key_sampler_members);
constexpr Shape k_key_samplers = array_of(k_key_sampler);
constexpr ShapeMember k_animation_members[] = {{"channels", &k_channels}, {"samplers", &k_key_samplers}};
constexpr Shape k_animation = object(k_animation_members);
constexpr Shape k_animations = array_of(k_animation);

constexpr ShapeMember k_perspective_members[] = {
    {"aspectRatio", &k_number}, {"yfov", &k_number}, {"znear", &k_number}, {"zfar", &k_number}};
constexpr Shape k_perspective = object(k_perspective_members);
constexpr ShapeMember k_orthographic_members[] = {
    {"xmag", &k_number}, {"ymag", &k_number}, {"znear", &k_number}, {"zfar", &k_number}};
constexpr Shape k_orthographic = object(k_orthographic_members);
constexpr ShapeMember k_camera_members[] = {
    {"type", &k_text}, {"perspective", &k_perspective}, {"orthographic", &k_orthographic}};
constexpr Shape k_camera = object(k_camera_members);
constexpr Shape k_cameras = array_of(k_camera);

constexpr Shape k_cone = number(0.0, std::numbers::pi / 2.0 + 1e-6);  // floats may be rounded up
constexpr ShapeMember k_spot_members[] = {{"innerConeAngle", &k_cone}, {"outerConeAngle", &k_cone}};
constexpr Shape k_spot = object(k_spot_members);
constexpr ShapeMember k_light_members[] = {{"type", &k_text},
                                           {"color", &k_amounts},
                                           {"intensity", &k_amount},
                                           {"range", &k_amount},
                                           {"spot", &k_spot}};
constexpr Shape k_light = object(k_light_members);
constexpr Shape k_lights = array_of(k_light);
constexpr ShapeMember k_lights_members[] = {{"lights", &k_lights}};
constexpr Shape k_lights_extension = object(k_lights_members);
constexpr ShapeMember k_extension_members[] = {{"KHR_lights_punctual", &k_lights_extension}};
constexpr Shape k_extensions = object(k_extension_members);

constexpr ShapeMember k_document_members[] = {
    {"asset", &k_asset},           {"scene", &k_index},           {"scenes", &k_scenes},
    {"nodes", &k_nodes},           {"meshes", &k_meshes},         {"accessors", &k_accessors},
    {"bufferViews", &k_views},     {"buffers", &k_buffers},       {"materials", &k_materials},
    {"textures", &k_textures},     {"images", &k_images},         {"samplers", &k_samplers},
    {"skins", &k_skins},           {"animations", &k_animations}, {"cameras", &k_cameras},
    {"extensions", &k_extensions}, {"extensionsUsed", &k_texts},  {"extensionsRequired", &k_texts}};
constexpr Shape k_document = object(k_document_members);

}  // namespace

const Shape& document_shape() {
    return k_document;
}

}  // namespace rambla::assets::gltf
