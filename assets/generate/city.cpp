#include "assets/generate/city.h"

#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

#include "assets/generate/city_paths.h"
#include "assets/generate/city_walk.h"
#include "assets/generate/ground_light.h"
#include "assets/generate/houses.h"
#include "assets/generate/node.h"
#include "assets/generate/people.h"
#include "assets/generate/street_furniture.h"
#include "assets/generate/vehicles.h"

namespace rambla::assets {

namespace {

using namespace generate;

constexpr float k_quarter_rad = 1.57079633f;
constexpr std::uint32_t k_people = 12;

/// The middle of a street 9 m wide between houses of 18 m sees cos(atan(18/4.5)) = 0.24 of the sky's
/// cosine-weighted light, a crossing about 0.5, the upper storeys nearly all of their half: between them.
constexpr float k_sky_between_houses = 0.4f;

/// What lamps send up from pavements and walls, as ground_radiance: on average a lamp lights the ground
/// around it with an illuminance of 0.08, of which asphalt, paving and plaster return a third.
constexpr glm::vec3 k_lamps_off_ground = (0.08f / 3.0f / 3.14159265f) * k_light_2700k;

/// Widths of the houses between two corner houses; each row fills block − 2 · (chamfer + corner side) = 36 m.
constexpr std::array<std::array<float, 4>, 9> k_rows_m{{{12.0f, 12.0f, 12.0f, 0.0f},
                                                        {10.0f, 14.0f, 12.0f, 0.0f},
                                                        {8.0f, 10.0f, 8.0f, 10.0f},
                                                        {14.0f, 8.0f, 14.0f, 0.0f},
                                                        {9.0f, 9.0f, 9.0f, 9.0f},
                                                        {10.0f, 8.0f, 10.0f, 8.0f},
                                                        {12.0f, 10.0f, 14.0f, 0.0f},
                                                        {8.0f, 14.0f, 14.0f, 0.0f},
                                                        {9.0f, 8.0f, 9.0f, 10.0f}}};

/// Parts of the seed, one for each thing that draws from it.
enum Part : std::uint64_t {
    k_palette,
    k_houses,
    k_blocks,
    k_edges,
    k_things,
    k_people_looks,
    k_cars,
    k_parked,
    k_actors
};

class CityBuilder {
public:
    CityBuilder(const CityParameters& parameters, std::uint64_t seed, TimeOfDay time)
        : parameters_{parameters},
          seed_{seed},
          time_{time},
          evening_{evening_at(time)},
          plan_{plan_of(parameters)},
          palette_{add_palette(place_.scene, evening_, key_of(seed, k_palette))},
          houses_{place_.scene, palette_, evening_, key_of(seed, k_houses)},
          things_{place_.scene, palette_, plan_.street, evening_, key_of(seed, k_things)} {}

    Place build() {
        place_.scene.name = "city";
        add_blocks();
        add_edges();
        for (const Crossing& crossing : plan_crossings(plan_))
            things_.add(StreetThings::Thing::crossing,
                        turned({crossing.middle.x, 0.0f, crossing.middle.y},
                               crossing.street_along_z ? 0.0f : k_quarter_rad));
        add_cars();
        add_actors();
        place_.environment = light();
        place_.scene.time = time_;
        place_.exposure_ev = daylight_exposure_ev(time_);
        place_.walk = plan_walk(plan_);
        place_.walk_fov_rad = 0.96f;
        return std::move(place_);
    }

private:
    [[nodiscard]] Environment light() const {
        Environment light = daylight(time_);
        light.sky_visibility = k_sky_between_houses;
        light.ground_radiance += evening_.lamps * k_lamps_off_ground;
        // High enough that the street's east side leaves some sun on the pavement across, low enough that
        // cornices and balconies draw slanted shadows on the west side's façades.
        if (!time_.solar_minutes) light.direction_to_sun = glm::normalize(glm::vec3{0.39f, 0.86f, 0.33f});
        return light;
    }

    std::uint32_t add_root(const std::string& name, std::uint32_t model, const Frame& at) {
        const std::uint32_t node = add_node(place_.scene, name, k_none, transform_of(at));
        place_.scene.nodes[node].model = model;
        place_.scene.roots.push_back(node);
        return node;
    }

    void add_blocks() {
        Builder builder;
        build_block_ground(builder, plan_.street);
        const std::uint32_t ground =
            add_model(place_.scene, "block-ground", store(place_.scene, builder.take("block-ground")),
                      palette_.standard);
        const GroundCharts charts = block_ground_charts(plan_.street, light_texel_m());
        prepare_for_light(ground, charts);
        for (int j = 0; j < plan_.blocks_z; ++j) {
            for (int i = 0; i < plan_.blocks_x; ++i) {
                const glm::vec2 centre = plan_.block_centre(i, j);
                const Frame at = turned({centre.x, 0.0f, centre.y}, 0.0f);
                const std::uint32_t node = add_root("block-ground", ground, at);
                add_block(i, j);
                const std::vector<ShopWindow> shops = houses_.take_lit_shops();
                place_.scene.nodes[node].model = lit_ground(ground, charts, at, shops);
            }
        }
    }

    /// The length of a light map's texel: small against the height of shop windows, unless the city is so
    /// large that the light maps of its blocks would take more than 64 MiB. Those of the edges, which grow
    /// with its circumference only, come on top.
    [[nodiscard]] float light_texel_m() const {
        constexpr float k_fine_m = 0.25f;
        constexpr double k_most_texels = 16 << 20;
        const glm::uvec2 size = block_ground_charts(plan_.street, k_fine_m).size;
        const double texels = static_cast<double>(size.x) * size.y * plan_.blocks_x * plan_.blocks_z;
        return k_fine_m * static_cast<float>(std::sqrt(std::max(1.0, texels / k_most_texels)));
    }

    /// Whether light falls on a part of a ground's model.
    [[nodiscard]] bool is_lit(const ModelPart& part) const {
        return part.material != palette_.standard[static_cast<std::size_t>(Surface::roof)];
    }

    /// Gives the meshes of a ground coordinates in its light maps, which those of all places where it lies
    /// share.
    void prepare_for_light(std::uint32_t ground, const GroundCharts& charts) {
        if (evening_.lamps == 0.0f) return;
        for (const ModelPart& part : place_.scene.models[ground].parts)
            if (is_lit(part)) add_light_coordinates(place_.scene.meshes[part.mesh], charts);
    }

    /// The model of a prepared ground as shops light it, with materials of its own where light falls.
    std::uint32_t lit_ground(std::uint32_t ground, const GroundCharts& charts, const Frame& at,
                             std::span<const ShopWindow> shops) {
        GroundLight light = bake_ground(charts, plan_.street, at, shops);
        if (light.strength == 0.0f) return ground;
        Scene& scene = place_.scene;
        const std::uint32_t texture = add_light_map(scene, std::move(light.image));
        Model model = scene.models[ground];
        for (ModelPart& part : model.parts) {
            if (!is_lit(part)) continue;
            Material material = scene.materials[part.material];
            material.light_map_texture = {.texture = texture, .uv_set = 1};
            material.light_map_strength = light.strength;
            scene.materials.push_back(std::move(material));
            part.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
        }
        scene.models.push_back(std::move(model));
        return static_cast<std::uint32_t>(scene.models.size() - 1);
    }

    void add_block(int i, int j) {
        const glm::vec2 centre = plan_.block_centre(i, j);
        Draws draws{key_of(seed_, k_blocks),
                    static_cast<std::uint64_t>(j) * 1000u + static_cast<std::uint64_t>(i)};
        const float half = 0.5f * plan_.street.block_m;
        for (int side = 0; side < 4; ++side) {
            // Sides face +z, +x, −z, −x in turn.
            const float angle = k_quarter_rad * static_cast<float>(side);
            const Frame middle =
                turned({centre.x, k_kerb_height_m, centre.y}, angle) * turned({0.0f, 0.0f, half}, 0.0f);
            // East of the walked street houses stay low, so that the sun reaches the pavement across.
            const bool shades_walk = side == 3 && i == plan_.walked_street();
            add_row(middle, !shades_walk ? 6 : (j == plan_.walked_row() ? 3 : 4), draws);
            const bool trees = side == 1 || side == 0;
            things_.furnish_side(middle, plan_.street.block_m - 2.0f * k_chamfer_m, trees, draws);

            const float corner = half - 0.5f * k_chamfer_m;
            const Frame chamfer = turned({centre.x, k_kerb_height_m, centre.y}, angle) *
                                  turned({corner, 0.0f, corner}, 0.5f * k_quarter_rad);
            // The chamfers at both ends of side 3.
            const bool corner_shades = i == plan_.walked_street() && side >= 2;
            houses_.add_corner_house(chamfer, corner_shades ? 4 : 6, draws);
            things_.furnish_corner(chamfer);
        }
    }

    /// Houses between the corner houses of one side.
    void add_row(const Frame& middle, int most_storeys, Draws& draws) {
        const auto& widths = k_rows_m[draws.below(static_cast<std::uint32_t>(k_rows_m.size()))];
        float x = -0.5f * plan_.street.block_m + k_chamfer_m + k_corner_side_m;
        for (const float width : widths) {
            if (width == 0.0f) break;
            houses_.add_row_house(width, middle * turned({x + 0.5f * width, 0.0f, 0.0f}, 0.0f), most_storeys,
                                  draws);
            if (draws.chance(0.5f))
                things_.add(StreetThings::Thing::wall_lantern, middle * turned({x, 3.45f, 0.0f}, 0.0f));
            x += width;
        }
    }

    /// Rows of houses around the city, so that every street ends before a façade.
    void add_edges() {
        const glm::vec2 low = plan_.edge_min();
        const glm::vec2 high = plan_.edge_max();
        const std::array<Frame, 4> frames{turned({low.x, 0.0f, low.y}, 0.0f),
                                          turned({high.x, 0.0f, low.y}, -k_quarter_rad),
                                          turned({high.x, 0.0f, high.y}, 2.0f * k_quarter_rad),
                                          turned({low.x, 0.0f, high.y}, k_quarter_rad)};
        std::array<std::uint32_t, 4> grounds{};
        std::vector<ShopWindow> shops;
        const auto length_of = [&](std::size_t side) {
            return (side & 1u) ? high.y - low.y : high.x - low.x;
        };
        for (std::size_t side = 0; side < 4; ++side) {
            Draws draws{key_of(seed_, k_edges), side};
            const float length = length_of(side);
            Builder builder;
            build_edge_ground(builder, plan_.street, length);
            grounds[side] =
                add_root("edge-ground",
                         add_model(place_.scene, "edge-ground",
                                   store(place_.scene, builder.take("edge-ground")), palette_.standard),
                         frames[side]);
            const Frame pavement = frames[side] * turned({0.0f, k_kerb_height_m, 0.0f}, 0.0f);
            // The last house overruns its corner, where the next side's row begins behind it.
            for (float x = 0.0f; x < length;) {
                const float width = Houses::k_widths_m[draws.below(Houses::k_widths_m.size())];
                houses_.add_row_house(width, pavement * turned({x + 0.5f * width, 0.0f, 0.0f}, 0.0f), 6,
                                      draws);
                x += width;
            }
            const int blocks = (side & 1u) ? plan_.blocks_z : plan_.blocks_x;
            for (int k = 0; k < blocks; ++k) {
                const float middle = plan_.street.street_width_m + 0.5f * plan_.street.block_m +
                                     static_cast<float>(k) * plan_.street.pitch_m();
                things_.furnish_side(pavement * turned({middle, 0.0f, 0.0f}, 0.0f), 50.0f, false, draws);
            }
            for (ShopWindow& shop : houses_.take_lit_shops()) {
                const glm::vec3 end = shop.wall.point({shop.opening.max.x, 0.0f, 0.0f});
                if (frames[side].local(end).x < length) shops.push_back(std::move(shop));
            }
        }
        // Once all stand: about corners, shops of two sides light the same ground.
        for (std::size_t side = 0; side < 4; ++side) {
            std::uint32_t& model = place_.scene.nodes[grounds[side]].model;
            const GroundCharts charts = edge_ground_charts(plan_.street, length_of(side), light_texel_m());
            prepare_for_light(model, charts);
            model = lit_ground(model, charts, frames[side], shops);
        }
    }

    void add_cars() {
        std::array<CarMeshes, k_car_kinds> meshes;
        for (std::uint32_t kind = 0; kind < k_car_kinds; ++kind) {
            const auto car = static_cast<CarKind>(kind);
            Builder builder;
            build_car_body(builder, car);
            meshes[kind].body = store(place_.scene, builder.take("car-body"));
            build_wheel(builder, car_size(car), -1.0f);
            meshes[kind].left_wheel = store(place_.scene, builder.take("wheel"));
            build_wheel(builder, car_size(car), 1.0f);
            meshes[kind].right_wheel = store(place_.scene, builder.take("wheel"));
        }
        Draws draws{seed_, k_cars};
        constexpr std::uint32_t k_cars_made = 9;
        for (std::uint32_t n = 0; n < k_cars_made; ++n) {
            const std::uint32_t kind = n % k_car_kinds;
            Scheme scheme = palette_.standard;
            scheme[static_cast<std::size_t>(Surface::body)] =
                palette_.bodies[(n + draws.below(2)) % palette_.bodies.size()];
            cars_.push_back(add_car(place_.scene, meshes[kind], static_cast<CarKind>(kind), scheme));
        }
        park_cars();
    }

    /// Copies a prototype's subtree as a root.
    void add_copy(std::uint32_t prototype, const Frame& at) {
        const std::uint32_t root = add_node(place_.scene, "parked-car", k_none, transform_of(at));
        place_.scene.nodes[root].model = place_.scene.nodes[prototype].model;
        place_.scene.roots.push_back(root);
        const std::vector<std::uint32_t> children = place_.scene.nodes[prototype].children;
        for (const std::uint32_t child : children) {
            const Node source = place_.scene.nodes[child];
            const std::uint32_t node = add_node(place_.scene, source.name, root, source.local);
            place_.scene.nodes[node].model = source.model;
        }
    }

    void park_cars() {
        constexpr float k_slot_m = 5.4f;
        constexpr float k_parked_share = 0.45f;
        constexpr float k_widest_m = 1.82f;
        if (plan_.street.carriageway_m() < 4.2f) return;  // a parked car would block the lane
        const float aside = 0.5f * plan_.street.carriageway_m() - 0.18f - 0.5f * k_widest_m;
        Draws draws{seed_, k_parked};
        const auto park = [&](glm::vec3 at, float angle) {
            add_copy(cars_[draws.below(static_cast<std::uint32_t>(cars_.size()))], turned(at, angle));
        };
        const float reach = 0.5f * plan_.street.block_m - k_chamfer_m - 4.5f;
        for (int i = 0; i <= plan_.blocks_x; ++i) {
            const bool forwards = runs_positive(i, plan_.blocks_x, false);
            for (int j = 0; j < plan_.blocks_z; ++j) {
                for (float t = -reach; t <= reach; t += k_slot_m) {
                    if (!draws.chance(k_parked_share)) continue;
                    // The walk keeps to this side of its street: from a car's length before it to its end.
                    const bool walk =
                        i == plan_.walked_street() && j == plan_.walked_row() && -t > k_walk_from_m - 6.0f;
                    if (!walk)
                        park({plan_.street_x(i) + aside, 0.0f, plan_.block_centre(0, j).y + t},
                             forwards ? 2.0f * k_quarter_rad : 0.0f);
                }
            }
        }
        for (int j = 0; j <= plan_.blocks_z; ++j) {
            const bool forwards = runs_positive(j, plan_.blocks_z, true);
            for (int i = 0; i < plan_.blocks_x; ++i)
                for (float t = -reach; t <= reach; t += k_slot_m)
                    if (draws.chance(k_parked_share))
                        park({plan_.block_centre(i, 0).x + t, 0.0f, plan_.street_z(j) + aside},
                             forwards ? -k_quarter_rad : k_quarter_rad);
        }
    }

    void add_actors() {
        std::vector<std::uint32_t> people;
        Draws draws{seed_, k_people_looks};
        for (std::uint32_t n = 0; n < k_people; ++n)
            people.push_back(add_person(place_.scene, draw_looks(n, draws), palette_.standard));
        PavementPlan pavements = plan_pavements(plan_);
        place_.lanes = plan_lanes(plan_);
        place_.actors =
            plan_actors(parameters_, pavements, place_.lanes, people, cars_, key_of(seed_, k_actors));
        place_.pavements = std::move(pavements.network);
    }

    CityParameters parameters_;
    std::uint64_t seed_;
    TimeOfDay time_;
    Evening evening_;
    CityPlan plan_;
    Place place_;
    Palette palette_;
    Houses houses_;
    StreetThings things_;
    std::vector<std::uint32_t> cars_;
};

}  // namespace

Place generate_city(const CityParameters& parameters, std::uint64_t seed, TimeOfDay time) {
    for (const Parameter<CityParameters>& parameter : k_city_parameters) {
        const double value = parameter.get(parameters);
        if (!(value >= parameter.minimum && value <= parameter.maximum))
            throw std::invalid_argument("city: " + std::string{parameter.name} + " is out of range");
    }
    return CityBuilder{parameters, seed, time}.build();
}

}  // namespace rambla::assets
