// Skinned and morphed meshes: where their vertices land, how they are lit, and what shadow they throw.
#include <gtest/gtest.h>

#include <cmath>

#include "render/scene_meshes.h"
#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::only_sun;
using tests::Picture;
using tests::Stage;

constexpr float k_pi = 3.14159265f;

glm::mat4 turned(float angle_rad, glm::vec3 axis) {
    return glm::rotate(glm::mat4{1.0f}, angle_rad, axis);
}
glm::mat4 moved(glm::vec3 by) {
    return glm::translate(glm::mat4{1.0f}, by);
}

/// The square of the stage with every vertex on joint 0 (weight a) and joint 1 (the rest).
std::uint32_t skinned_square(Stage& stage, float a) {
    assets::Mesh m = stage.scene.meshes[stage.square()];
    m.joints.assign(4, {0, 1, 0, 0});
    m.weights.assign(4, {a, 1.0f - a, 0, 0});
    return stage.mesh(std::move(m));
}

std::uint32_t unlit_white(Stage& stage) {
    assets::Material m = matte();
    m.unlit = true;
    return stage.material(m);
}

/// Share of the pixels in which the pictures differ by more than a fifth of white. Two drawings of the same
/// triangles may round an edge's pixels to either side.
double differing(const Picture& a, const Picture& b) {
    int count = 0;
    for (std::uint32_t y = 0; y < a.size.y; ++y) {
        for (std::uint32_t x = 0; x < a.size.x; ++x)
            count += glm::distance(a.radiance(x, y), b.radiance(x, y)) > 0.2f ? 1 : 0;
    }
    return static_cast<double>(count) / (a.size.x * a.size.y);
}

/// How much of the picture is white, in pixels.
double area(const Picture& picture) {
    double sum = 0.0;
    for (std::uint32_t y = 0; y < picture.size.y; ++y) {
        for (std::uint32_t x = 0; x < picture.size.x; ++x)
            sum += picture.radiance(x, y).x > 0.5f ? 1.0 : 0.0;
    }
    return sum;
}

TEST(Skinning, PlacesASquareWhereItsJointsSay) {
    Stage stage;
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    const std::uint32_t white = unlit_white(stage);
    const std::uint32_t mesh = skinned_square(stage, 1.0f);
    const glm::mat4 place =
        moved({0.6f, -0.3f, -1}) * turned(0.5f, {0, 0, 1}) * glm::scale(glm::mat4{1.0f}, {0.5f, 1.2f, 1});
    // Its own place is nowhere near, and does not count.
    stage.place(mesh, white, moved({50, 0, 0}));
    stage.things[0].world_from_mesh = {place, moved({-40, 0, 0})};
    const Picture skinned = stage.draw();
    stage.things.clear();
    stage.place(stage.square(), white, place);
    const Picture rigid = stage.draw();
    EXPECT_GT(area(rigid), 500.0);
    EXPECT_EQ(differing(skinned, rigid), 0.0);
}

TEST(Skinning, MixesJointsByWeight) {
    Stage stage;
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    const std::uint32_t white = unlit_white(stage);
    // Three eighths of one place and five of the other.
    const std::uint32_t mesh = skinned_square(stage, 0.375f);
    stage.place(mesh, white);
    stage.things[0].world_from_mesh = {moved({1.6f, 0, 0}), moved({-0.8f, 0.8f, 0})};
    const Picture skinned = stage.draw();
    stage.things.clear();
    stage.place(stage.square(), white, moved({0.375f * 1.6f - 0.625f * 0.8f, 0.625f * 0.8f, 0}));
    // Weights are sixteenths of a thousandth apart, far less than a pixel; an edge may yet round otherwise.
    EXPECT_LT(differing(skinned, stage.draw()), 130.0 / (128 * 128));
}

/// A cylinder of radius 1 and height 2 about the y axis, whose upper ring follows joint 1, the lower joint 0;
/// normals point outwards.
assets::Mesh cylinder() {
    constexpr int k_sides = 64;
    assets::Mesh m;
    for (int i = 0; i <= k_sides; ++i) {
        const float angle = 2.0f * k_pi * static_cast<float>(i) / k_sides;
        for (const float y : {-1.0f, 1.0f}) {
            m.positions.push_back({std::sin(angle), y, std::cos(angle)});
            m.normals.push_back({std::sin(angle), 0, std::cos(angle)});
            m.tangents.push_back({std::cos(angle), 0, -std::sin(angle), 1});
            m.joints.push_back({0, 1, 0, 0});
            m.weights.push_back(y < 0.0f ? glm::vec4{1, 0, 0, 0} : glm::vec4{0, 1, 0, 0});
        }
    }
    for (std::uint32_t i = 0; i < 2 * k_sides; i += 2) {
        for (const std::uint32_t corner : {i, i + 2, i + 1, i + 1, i + 2, i + 3})
            m.indices.push_back(corner);
    }
    return m;
}

TEST(Skinning, LightsAnEllipticCylinderByItsTrueNormals) {
    // Both joints squeeze x to a half and stretch z to two: the cylinder becomes elliptic. At the front,
    // where x = sin φ / 2 and z = 2 cos φ, the true normal is along (sin φ / ½, cos φ / 2): the inverse
    // transpose.
    Stage stage;
    const std::uint32_t mesh = stage.mesh(cylinder());
    stage.place(mesh, stage.material(matte()));
    const glm::mat4 squeezed = glm::scale(glm::mat4{1.0f}, {0.5f, 1, 2});
    stage.things[0].world_from_mesh = {squeezed, squeezed};
    stage.things[0].casts = false;
    stage.frame.environment = only_sun({1, 0, 1});
    stage.look_flat({0, 0, 10}, {0, 0, 0}, 1.0f);
    const Picture picture = stage.draw();
    const glm::vec3 to_sun = glm::normalize(glm::vec3{1, 0, 1});
    int lit = 0;
    for (std::uint32_t x = 38; x < 90; x += 3) {
        const double right = (static_cast<double>(x) + 0.5) / 64.0 - 1.0;  // ±0.5 is the silhouette
        const double sine = 2.0 * right;
        if (std::fabs(sine) > 0.9) continue;
        const double cosine = std::sqrt(1.0 - sine * sine);
        const glm::dvec3 normal = glm::normalize(glm::dvec3{sine / 0.5, 0, cosine / 2.0});
        // Lambert under a sun of illuminance π: albedo · cos θ; the rest is the dielectric's thin highlight.
        const double expected = std::max(0.0, glm::dot(normal, glm::dvec3{to_sun}));
        const double found = picture.radiance(x, 64).x;
        EXPECT_NEAR(found, expected, 0.06) << x;
        lit += expected > 0.3 ? 1 : 0;
    }
    EXPECT_GT(lit, 5);
}

TEST(Skinning, TurnsNormalMapsWithTheirTangents) {
    // A normal map that leans by 45° along the tangent. The joint turns the square by 90° about z, so that it
    // leans upwards.
    Stage stage;
    assets::Material m = matte();
    m.normal_texture = stage.texture(1, 1, {{218, 128, 218, 255}});
    const std::uint32_t material = stage.material(m);
    const std::uint32_t mesh = skinned_square(stage, 1.0f);
    stage.place(mesh, material);
    stage.things[0].casts = false;
    for (const float angle : {0.0f, 0.5f * k_pi, k_pi}) {
        stage.things[0].world_from_mesh = {turned(angle, {0, 0, 1}), glm::mat4{1.0f}};
        stage.frame.environment = only_sun({0, 1, 1});
        const double towards =
            std::cos(0.25 * k_pi) * (1.0 + std::sin(static_cast<double>(angle))) / std::sqrt(2.0);
        EXPECT_NEAR(stage.draw().radiance(64, 64).x, towards, 0.06) << angle;
    }
}

TEST(Skinning, ThrowsTheShadowOfWhereItIs) {
    Stage stage;
    const std::uint32_t ground = stage.material(matte());
    stage.place(stage.square(), ground,
                turned(-0.5f * k_pi, {1, 0, 0}) * glm::scale(glm::mat4{1.0f}, glm::vec3{8.0f}));
    const std::uint32_t mesh = skinned_square(stage, 1.0f);
    stage.place(mesh, ground, moved({90, 0, 0}));
    // Lying 2 m above the ground, at x = 2, half a metre to each side.
    const glm::mat4 lying =
        moved({2, 2, 0}) * turned(-0.5f * k_pi, {1, 0, 0}) * glm::scale(glm::mat4{1.0f}, glm::vec3{0.5f});
    stage.things[1].world_from_mesh = {lying, lying};
    stage.frame.environment = only_sun({0, 1, 0});
    stage.look({0, 1, 6}, {0, 0, 0});
    const Picture picture = stage.draw();
    const auto lit = [&](glm::vec3 at) {
        const glm::vec2 pixel = stage.pixel_of(at);
        return picture.radiance(static_cast<std::uint32_t>(pixel.x), static_cast<std::uint32_t>(pixel.y)).x;
    };
    EXPECT_LT(lit({2, 0, 0}), 0.1f);
    EXPECT_GT(lit({0, 0, 0}), 0.8f);
    EXPECT_GT(lit({3, 0, 0}), 0.8f);
    EXPECT_GT(lit({2, 0, 1}), 0.8f);
}

TEST(Morphing, AddsTargetsByWeight) {
    Stage stage;
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    const std::uint32_t white = unlit_white(stage);
    // Another morphed mesh comes first: targets are counted over all of them.
    assets::Mesh other = stage.scene.meshes[stage.square()];
    other.morphs.resize(3);
    for (assets::MorphTarget& target : other.morphs)
        target.positions.assign(4, {7, 7, 7});
    stage.mesh(std::move(other));
    assets::Mesh m = stage.scene.meshes[0];
    m.morphs.resize(2);
    m.morphs[0].positions = {{-1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};  // wider
    m.morphs[1].positions = {{0, 1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}};    // the lower edge goes up
    const std::uint32_t mesh = stage.mesh(std::move(m));
    stage.place(mesh, white, glm::scale(glm::mat4{1.0f}, glm::vec3{0.7f}));
    stage.things[0].morphs = {{0, 0.4f}, {1, 1.0f}};
    const Picture morphed = stage.draw();
    // x from −1.4 to 1.4, y from 0 to 1, times 0.7.
    stage.things.clear();
    stage.place(0, white, moved({0, 0.35f, 0}) * glm::scale(glm::mat4{1.0f}, {0.98f, 0.35f, 1}));
    const Picture expected = stage.draw();
    EXPECT_GT(area(expected), 500.0);
    EXPECT_LT(differing(morphed, expected), 60.0 / (128 * 128)) << "an edge's pixels at most";
    stage.things.clear();
    stage.place(mesh, white, glm::scale(glm::mat4{1.0f}, glm::vec3{0.7f}));
    stage.things[0].morphs = {{0, -1.0f}};  // narrower until nothing is left
    EXPECT_EQ(area(stage.draw()), 0.0);
}

TEST(Morphing, TurnsNormalsAndComesBeforeSkinning) {
    // The target lays the normals over from +Z to +X; the joint turns that to +Y.
    Stage stage;
    assets::Mesh m = stage.scene.meshes[stage.square()];
    m.morphs.resize(1);
    m.morphs[0].normals.assign(4, {1, 0, -1});
    m.joints.assign(4, {0, 0, 0, 0});
    m.weights.assign(4, {1, 0, 0, 0});
    const std::uint32_t mesh = stage.mesh(std::move(m));
    stage.place(mesh, stage.material(matte()));
    stage.things[0].casts = false;
    stage.things[0].world_from_mesh = {turned(0.5f * k_pi, {0, 0, 1})};
    stage.things[0].morphs = {{0, 1.0f}};
    stage.frame.environment = only_sun({0, 1, 0});
    EXPECT_NEAR(stage.draw().radiance(64, 64).x, 1.0f, 0.05f);
    stage.frame.environment = only_sun({1, 0, 0});
    EXPECT_NEAR(stage.draw().radiance(64, 64).x, 0.0f, 0.02f);
    stage.things[0].morphs = {{0, 0.5f}};  // half way: 45° between
    stage.frame.environment = only_sun({0, 1, 1});
    EXPECT_NEAR(stage.draw().radiance(64, 64).x, 1.0f, 0.05f);
}

TEST(Deformation, BlendedThingsDeformToo) {
    Stage stage;
    assets::Material glass = matte();
    glass.unlit = true;
    glass.alpha_mode = assets::AlphaMode::blend;
    glass.base_colour.w = 0.5f;
    const std::uint32_t material = stage.material(glass);
    const std::uint32_t mesh = skinned_square(stage, 1.0f);
    stage.place(mesh, material, moved({40, 0, 0}));
    stage.things[0].world_from_mesh = {moved({1.5f, 0, 0}), glm::mat4{1.0f}};
    stage.frame.environment.sky_zenith_radiance = stage.frame.environment.sky_horizon_radiance =
        glm::vec3{0.0f};
    const Picture picture = stage.draw();
    const glm::vec2 inside = stage.pixel_of({1.5f, 0.5f, 0});
    EXPECT_NEAR(
        picture.radiance(static_cast<std::uint32_t>(inside.x), static_cast<std::uint32_t>(inside.y)).x, 0.5f,
        0.02f);
    EXPECT_LT(picture.radiance(40, 40).x, 0.02f);
}

TEST(Deformation, PackedWeightsSumToOneExactly) {
    assets::Mesh m;
    m.joints = {{1, 2, 3, 65535}, {0, 0, 0, 0}, {4, 5, 6, 7}, {8, 9, 10, 11}};
    m.weights = {{0.333333f, 0.333333f, 0.333333f, 1e-6f}, {0, 0, 0, 0}, {0.1f, 0.7f, 0.2f, 0}, {3, 1, 0, 0}};
    for (std::size_t v = 0; v < 4; ++v) {
        const render::PackedSkin packed = render::pack_skin(m, v);
        std::uint32_t sum = 0;
        for (unsigned i = 0; i < 4; ++i) {
            const auto share = static_cast<std::uint32_t>((packed.weights >> (16 * i)) & 0xffffu);
            sum += share;
            EXPECT_EQ((packed.joints >> (16 * i)) & 0xffffu, m.joints[v][static_cast<int>(i)]);
            const float total = glm::dot(m.weights[v], glm::vec4{1.0f});
            if (total > 0.0f) {
                EXPECT_NEAR(share, 65535.0f * m.weights[v][static_cast<int>(i)] / total, 3.0f);
            }
        }
        EXPECT_EQ(sum, 65535u);
    }
}

}  // namespace
