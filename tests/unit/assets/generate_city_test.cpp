#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "assets/generate/building.h"
#include "assets/generate/city.h"
#include "assets/generate/city_plan.h"
#include "unit/assets/generate_support.h"

namespace rambla::assets::test {
namespace {

using generate::CityPlan;

/// Distance from a point to the nearest façade line of blocks or edge, negative inside a house.
float clearance(const CityPlan& plan, glm::vec2 p) {
    const glm::vec2 low = plan.edge_min();
    const glm::vec2 high = plan.edge_max();
    float nearest = std::min(std::min(p.x - low.x, high.x - p.x), std::min(p.y - low.y, high.y - p.y));
    const float half = 0.5f * plan.street.block_m;
    for (int j = 0; j < plan.blocks_z; ++j) {
        for (int i = 0; i < plan.blocks_x; ++i) {
            // A block is the part of the plane inside four sides and four chamfers: the largest signed
            // distance counts, a lower bound of the distance outside.
            const glm::vec2 d = glm::abs(p - plan.block_centre(i, j));
            const float sides = std::max(d.x, d.y) - half;
            const float chamfers = (d.x + d.y - (2.0f * half - generate::k_chamfer_m)) * std::sqrt(0.5f);
            nearest = std::min(nearest, std::max(sides, chamfers));
        }
    }
    return nearest;
}

TEST(City, IsTheSameForTheSameSeedAndAnotherForAnother) {
    CityParameters parameters;
    parameters.blocks_x = parameters.blocks_z = 1;
    const Place a = generate_city(parameters, 7);
    const Place b = generate_city(parameters, 7);
    const Place c = generate_city(parameters, 8);
    EXPECT_EQ(geometry_hash(a.scene), geometry_hash(b.scene));
    EXPECT_EQ(image_hash(a.scene), image_hash(b.scene));
    EXPECT_EQ(node_hash(a.scene), node_hash(b.scene));
    EXPECT_NE(geometry_hash(a.scene), geometry_hash(c.scene));
    EXPECT_NE(image_hash(a.scene), image_hash(c.scene));
    EXPECT_NE(node_hash(a.scene), node_hash(c.scene));
}

TEST(City, HasPanesAsMeshesOfTheirOwnInGlass) {
    const Scene& scene = street().scene;
    std::size_t houses = 0;
    for (const Model& model : scene.models) {
        if (model.name != "house" && model.name != "corner-house") continue;
        ++houses;
        std::size_t panes = 0;
        for (const ModelPart& part : model.parts) {
            const Material& material = scene.materials[part.material];
            if (material.name.rfind("glass", 0) != 0) continue;
            ++panes;
            EXPECT_LE(material.roughness, 0.06f);
            EXPECT_EQ(material.metalness, 0.0f);
            // A mirror needs one direction: all panes of a façade's mesh face the same way.
            const Mesh& mesh = scene.meshes[part.mesh];
            for (const glm::vec3& normal : mesh.normals)
                EXPECT_GT(glm::dot(normal, mesh.normals[0]), 0.999f);
        }
        EXPECT_GE(panes, model.name == "house" ? 1u : 3u);
    }
    EXPECT_GT(houses, 20u);
}

TEST(City, LightsAboutOneWindowInSeven) {
    const Scene& scene = street().scene;
    std::size_t dark = 0;
    std::size_t lit = 0;
    for (const Model& model : scene.models) {
        for (const ModelPart& part : model.parts) {
            const std::string& name = scene.materials[part.material].name;
            if (name == "glass") dark += scene.meshes[part.mesh].indices.size() / 6;
            if (name == "glass-lit") lit += scene.meshes[part.mesh].indices.size() / 6;
        }
    }
    // Thousands of windows, but of three dozen independent houses: a third either way is more than three
    // sigma.
    const double share = static_cast<double>(lit) / static_cast<double>(lit + dark);
    EXPECT_GT(share, 0.67 / 7.0);
    EXPECT_LT(share, 1.33 / 7.0);
}

/// Whether a downward ray at (x, z) of a model's own space meets an upward face above `height`.
bool roofed(const Scene& scene, const Model& model, glm::vec2 at, float height) {
    for (const ModelPart& part : model.parts) {
        const Mesh& mesh = scene.meshes[part.mesh];
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::vec3 a = mesh.positions[mesh.indices[i]];
            const glm::vec3 b = mesh.positions[mesh.indices[i + 1]];
            const glm::vec3 c = mesh.positions[mesh.indices[i + 2]];
            if (std::max({a.y, b.y, c.y}) < height) continue;
            const float area = (b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z);
            if (area > -1e-6f) continue;  // faces down or stands upright
            const float u = ((b.x - at.x) * (c.z - at.y) - (c.x - at.x) * (b.z - at.y)) / area;
            const float v = ((c.x - at.x) * (a.z - at.y) - (a.x - at.x) * (c.z - at.y)) / area;
            if (u >= 0.0f && v >= 0.0f && u + v <= 1.0f) return true;
        }
    }
    return false;
}

TEST(City, CoversItsHousesWithRoofs) {
    const Scene& scene = street().scene;
    for (const Model& model : scene.models) {
        const bool row = model.name == "house";
        if (!row && model.name != "corner-house") continue;
        float half = 0.0f;  // the party walls are the widest plain surfaces
        for (const ModelPart& part : model.parts)
            if (scene.materials[part.material].name == "party-wall")
                half = std::max(half, scene.meshes[part.mesh].bounds.max.x);
        for (int k = 0; k < 40; ++k) {
            const float u = std::fmod(0.5f + 0.618034f * static_cast<float>(k), 1.0f);
            const float v = (static_cast<float>(k) + 0.5f) / 40.0f;
            glm::vec2 at;
            if (row) {
                at = {(2.0f * u - 1.0f) * (half - 0.05f), -0.05f - v * (generate::k_house_depth_m - 0.1f)};
            } else {
                // (u, v) in the block's corner, as building.cpp draws it; points of the cut corner are no
                // house.
                const float size = generate::k_chamfer_m + generate::k_corner_side_m;
                const float bu = u * (size - 0.1f) + 0.05f;
                const float bv = v * (size - 0.1f) + 0.05f;
                if (bu + bv < generate::k_chamfer_m + 0.1f) continue;
                const float r = std::sqrt(0.5f);
                at = {(bu - bv) * r, -(bu + bv - generate::k_chamfer_m) * r};
            }
            ASSERT_TRUE(roofed(scene, model, at, 10.0f)) << model.name << " at " << at.x << ", " << at.y;
        }
    }
}

TEST(City, KeepsWalkersOffFacadesAndOnTheGround) {
    const Place& place = street();
    const CityPlan plan = generate::plan_of({});
    ASSERT_FALSE(place.pavements.links.empty());
    for (const PathNetwork::Link& link : place.pavements.links) {
        const glm::vec3 a = place.pavements.points[link.from];
        const glm::vec3 b = place.pavements.points[link.to];
        ASSERT_GT(glm::length(b - a), 0.1f);
        for (int k = 0; k <= 10; ++k) {
            const glm::vec3 p = glm::mix(a, b, static_cast<float>(k) / 10.0f);
            // Shoulders are a quarter of a metre from the middle.
            EXPECT_GT(clearance(plan, {p.x, p.z}), link.half_width_m + 0.25f);
            EXPECT_GE(p.y, 0.0f);
            EXPECT_LE(p.y, generate::k_kerb_height_m + 1e-6f);  // mixing rounds
        }
    }
}

TEST(City, KeepsFurnitureOutOfTheWalkersWay) {
    const Place& place = street();
    const std::set<std::string> solid{"tree", "lamp-post", "bench", "litter-bin", "bollard"};
    for (const std::uint32_t root : place.scene.roots) {
        const Node& node = place.scene.nodes[root];
        if (solid.count(node.name) == 0) continue;
        const glm::vec2 at{node.local.translation_m.x, node.local.translation_m.z};
        for (const PathNetwork::Link& link : place.pavements.links) {
            const glm::vec3 from = place.pavements.points[link.from];
            const glm::vec3 to = place.pavements.points[link.to];
            const glm::vec2 a{from.x, from.z};
            const glm::vec2 ab = glm::vec2{to.x, to.z} - a;
            const float share = std::clamp(glm::dot(at - a, ab) / glm::dot(ab, ab), 0.0f, 1.0f);
            // Half a thing and half a walker.
            ASSERT_GT(glm::length(at - a - share * ab), link.half_width_m + 0.30f) << node.name;
        }
    }
}

TEST(City, JoinsAllItsWays) {
    const Place& place = street();
    for (const PathNetwork* network : {&place.pavements, &place.lanes}) {
        // From point 0 along the allowed directions; lanes are one-way, so this shows that loops close.
        std::vector<char> seen(network->points.size(), 0);
        std::vector<std::uint32_t> open{0};
        seen[0] = 1;
        while (!open.empty()) {
            const std::uint32_t at = open.back();
            open.pop_back();
            for (const PathNetwork::Link& link : network->links) {
                const bool forwards = link.from == at;
                if (!forwards && !(link.both_ways && link.to == at)) continue;
                const std::uint32_t next = forwards ? link.to : link.from;
                if (!seen[next]) open.push_back(next);
                seen[next] = 1;
            }
        }
        EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
    }
}

TEST(City, LeavesTheStandardWalkFree) {
    const Place& place = street();
    const CityPlan plan = generate::plan_of({});
    ASSERT_GE(place.walk.size(), 4u);
    EXPECT_EQ(place.walk.front().time_s, 0.0f);
    EXPECT_NEAR(place.walk.back().time_s, 16.0f, 1.0f);
    const float kerb = 0.5f * plan.street.carriageway_m();
    const float street_x = plan.street_x(plan.walked_street());
    for (std::size_t k = 0; k < place.walk.size(); ++k) {
        const CameraKey& key = place.walk[k];
        if (k > 0) {
            EXPECT_GT(key.time_s, place.walk[k - 1].time_s);
        }
        EXPECT_GT(glm::length(key.target_m - key.eye_m), 1.0f);
        EXPECT_NEAR(key.eye_m.y, 1.65f, 0.05f);
        EXPECT_LT(std::abs(key.eye_m.x - street_x), kerb - 0.5f);
        EXPECT_GT(clearance(plan, {key.eye_m.x, key.eye_m.z}), 2.0f);
        for (const std::uint32_t root : place.scene.roots) {
            const Node& node = place.scene.nodes[root];
            if (node.name != "parked-car" && node.name != "tree" && node.name != "lamp-post") continue;
            const glm::vec3 way = node.local.translation_m - key.eye_m;
            // Half the longest car.
            EXPECT_GT(std::hypot(way.x, way.z), node.name == "parked-car" ? 3.0f : 0.5f)
                << node.name << " at key " << k;
        }
        for (const PathNetwork::Link& link : place.pavements.links) {
            const glm::vec3 from = place.pavements.points[link.from];
            const glm::vec3 to = place.pavements.points[link.to];
            const glm::vec2 a{from.x, from.z};
            const glm::vec2 ab = glm::vec2{to.x, to.z} - a;
            const glm::vec2 eye{key.eye_m.x, key.eye_m.z};
            const float share = std::clamp(glm::dot(eye - a, ab) / glm::dot(ab, ab), 0.0f, 1.0f);
            EXPECT_GT(glm::length(eye - a - share * ab), link.half_width_m + 0.5f)
                << "walkers cross key " << k;
        }
    }
}

TEST(City, HasPeopleAndCarsThatCanBeAnimated) {
    const Place& place = street();
    const Scene& scene = place.scene;
    const std::set<std::string> wanted{"torso",     "head",  "arm_l", "arm_r",  "forearm_l",
                                       "forearm_r", "leg_l", "leg_r", "shin_l", "shin_r"};
    std::set<std::uint32_t> people;
    for (const ActorStart& actor : place.actors) {
        ASSERT_LT(actor.prototype, scene.nodes.size());
        EXPECT_EQ(std::count(scene.roots.begin(), scene.roots.end(), actor.prototype), 0)
            << "prototypes are not shown";
        const bool walker = actor.kind == ActorKind::walker;
        const PathNetwork& network = walker ? place.pavements : place.lanes;
        ASSERT_LT(actor.link, network.links.size());
        EXPECT_LE(std::abs(actor.aside_m), network.links[actor.link].half_width_m);
        EXPECT_TRUE(actor.along >= 0.0f && actor.along <= 1.0f);
        if (walker) {
            people.insert(actor.prototype);
            EXPECT_TRUE(actor.speed_m_s >= 1.0f && actor.speed_m_s <= 1.6f);
        } else {
            const Node& car = scene.nodes[actor.prototype];
            EXPECT_EQ(
                std::count_if(car.children.begin(), car.children.end(),
                              [&](std::uint32_t c) { return scene.nodes[c].name.rfind("wheel_", 0) == 0; }),
                4);
        }
    }
    EXPECT_GE(people.size(), 8u);
    for (const std::uint32_t person : people) {
        EXPECT_EQ(scene.nodes[person].name, "walker");
        std::set<std::string> names;
        Bounds bounds;
        std::size_t triangles = 0;
        const std::function<void(std::uint32_t, const glm::mat4&)> visit = [&](std::uint32_t index,
                                                                               const glm::mat4& parent) {
            const Node& node = scene.nodes[index];
            const glm::mat4 here = parent * matrix(node.local);
            if (index != person) names.insert(node.name);
            for (const ModelPart& part : scene.models[node.model].parts) {
                bounds.expand(transformed(scene.meshes[part.mesh].bounds, here));
                triangles += scene.meshes[part.mesh].indices.size() / 3;
            }
            for (const std::uint32_t child : node.children)
                visit(child, here);
        };
        visit(person, glm::mat4{1.0f});
        EXPECT_EQ(names, wanted);
        EXPECT_NEAR(bounds.min.y, 0.0f, 0.01f) << "soles stand on the ground";
        EXPECT_GT(bounds.max.y, 1.5f);
        EXPECT_LT(bounds.max.y, 2.0f);
        EXPECT_LT(-bounds.min.z, 0.35f);
        EXPECT_LT(triangles, 1700u);
    }
}

TEST(City, HoldsValidIndicesThroughout) {
    const Scene& scene = street().scene;
    for (const Texture& texture : scene.textures)
        EXPECT_LT(texture.image, scene.images.size());
    for (const Model& model : scene.models)
        for (const ModelPart& part : model.parts) {
            EXPECT_LT(part.mesh, scene.meshes.size());
            EXPECT_LT(part.material, scene.materials.size());
        }
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        EXPECT_TRUE(node.model == k_none || node.model < scene.models.size());
        EXPECT_TRUE(node.light == k_none || node.light < scene.lights.size());
        for (const std::uint32_t child : node.children)
            EXPECT_EQ(scene.nodes[child].parent, i);
    }
}

TEST(City, ScalesFromOneBlockToMany) {
    for (const auto& [x, z] : {std::pair{1, 1}, {2, 1}, {4, 3}}) {
        CityParameters parameters;
        parameters.blocks_x = x;
        parameters.blocks_z = z;
        const Place place = generate_city(parameters, 3);
        EXPECT_EQ(std::count_if(place.scene.roots.begin(), place.scene.roots.end(),
                                [&](std::uint32_t r) { return place.scene.nodes[r].name == "corner-house"; }),
                  4 * x * z);
        EXPECT_EQ(place.lanes.points.size(), static_cast<std::size_t>((x + 1) * (z + 1)));
    }
}

TEST(GeneratePlace, ReadsParameters) {
    const Place place = generate_place("city:blocks=2x1,walkers=5,cars=0", 1);
    EXPECT_EQ(place.actors.size(), 5u);
    EXPECT_EQ(place.lanes.points.size(), 6u);
}

TEST(GeneratePlace, RefusesWhatItDoesNotKnowAndSaysWhatItDoes) {
    const auto message = [](std::string_view spec) -> std::string {
        try {
            (void)generate_place(spec, 1);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(message("village").find("known: city, street, blocks, agents"), std::string::npos);
    EXPECT_NE(message("city:towers=3").find("\"towers=3\""), std::string::npos);
    EXPECT_NE(message("city:towers=3").find("walkers"), std::string::npos);
    EXPECT_NE(message("city:blocks=4").find("blocks=4x2"), std::string::npos);
    for (const std::string_view bad :
         {"", ":", "city:", "city:walkers", "city:walkers=", "city:walkers=x", "city:walkers=-1",
          "city:walkers=1.5", "city:blocks=0x1", "city:blocks=1x101", "city:blocks=2x2x2", "city:street=nan",
          "city:street=1e9", "city:walkers=3,,cars=1"})
        EXPECT_NE(message(bad), "") << bad;
}

}  // namespace
}  // namespace rambla::assets::test
