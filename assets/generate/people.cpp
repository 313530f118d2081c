#include "assets/generate/people.h"

#include <array>
#include <cmath>
#include <span>

#include "assets/generate/node.h"

namespace rambla::assets::generate {

namespace {

constexpr int k_arm_sides = 6;
constexpr int k_leg_sides = 8;
constexpr int k_trunk_sides = 10;
constexpr int k_head_sides = 10;

/// Joint heights as shares of a person's height, after common tables of body proportions (Drillis and Contini
/// 1966).
constexpr float k_hip = 0.525f;
constexpr float k_knee = 0.285f;
constexpr float k_ankle = 0.045f;
constexpr float k_waist = 0.60f;
constexpr float k_shoulder = 0.815f;
constexpr float k_neck = 0.845f;
constexpr float k_upper_arm = 0.175f;
constexpr float k_forearm = 0.150f;

/// A level elliptical ring: half width x, half depth z.
Ring ring(float y, float half_x, float half_z, float x = 0.0f, float z = 0.0f) {
    return {{x, y, z}, {half_x, 0.0f, 0.0f}, {0.0f, 0.0f, half_z}};
}

/// The ring at a height between those of a tube that rises.
Ring ring_at(std::span<const Ring> rings, float y) {
    std::size_t i = 1;
    while (i + 1 < rings.size() && rings[i].centre_m.y < y)
        ++i;
    const Ring& low = rings[i - 1];
    const Ring& high = rings[i];
    const float t = (y - low.centre_m.y) / (high.centre_m.y - low.centre_m.y);
    return ring(y, glm::mix(low.axis_a.x, high.axis_a.x, t), glm::mix(low.axis_b.z, high.axis_b.z, t));
}

/// Builds the parts of one person about their joints.
class Tailor {
public:
    Tailor(Scene& scene, const Looks& looks, const Scheme& scheme)
        : scene_{scene},
          looks_{looks},
          scheme_{scheme},
          h_{looks.height_m},
          g_{looks.height_m * looks.girth} {}

    std::uint32_t sew() {
        const std::uint32_t walker = add("walker", k_none, glm::vec3{0.0f});
        show(walker, [&] { pelvis(); });
        const std::uint32_t torso = add("torso", walker, {0.0f, k_waist * h_, 0.0f});
        show(torso, [&] { trunk(); });
        const std::uint32_t head_node = add("head", torso, {0.0f, (k_neck - k_waist) * h_, 0.0f});
        show(head_node, [&] { head(); });
        const float shoulder = (looks_.shoulders ? 0.113f : 0.100f) * g_;
        const float hip = 0.052f * g_;
        for (const bool left : {true, false}) {
            const float side = left ? -1.0f : 1.0f;
            const std::uint32_t arm = add(left ? "arm_l" : "arm_r", torso,
                                          {side * shoulder, (k_shoulder - k_waist) * h_ - 0.018f * h_, 0.0f});
            show(arm, [&] { upper_arm(); });
            const std::uint32_t forearm_node =
                add(left ? "forearm_l" : "forearm_r", arm, {side * 0.006f * h_, -k_upper_arm * h_, 0.0f});
            show(forearm_node, [&] { forearm(); });
        }
        for (const bool left : {true, false}) {
            const float side = left ? -1.0f : 1.0f;
            const std::uint32_t leg = add(left ? "leg_l" : "leg_r", walker, {side * hip, k_hip * h_, 0.0f});
            show(leg, [&] { thigh(); });
            const std::uint32_t shin_node =
                add(left ? "shin_l" : "shin_r", leg, {0.0f, -(k_hip - k_knee) * h_, 0.0f});
            show(shin_node, [&] { shin(); });
        }
        return walker;
    }

private:
    std::uint32_t add(const char* name, std::uint32_t parent, glm::vec3 at) {
        Transform local;
        local.translation_m = at;
        return add_node(scene_, name, parent, local);
    }
    template <class Shape>
    void show(std::uint32_t node, const Shape& shape) {
        shape();
        const std::string name = scene_.nodes[node].name;
        scene_.nodes[node].model = add_model(scene_, name, store(scene_, builder_.take(name)), scheme_);
    }
    /// Ends that lie inside other parts stay open.
    enum class Ends : std::uint8_t { open, first, last, both };
    void tube(Surface surface, glm::vec3 colour, std::span<const Ring> rings, int sides, Ends closed) {
        builder_.colour = {colour, 1.0f};
        builder_.tube(surface, rings, sides, closed == Ends::first || closed == Ends::both,
                      closed == Ends::last || closed == Ends::both);
    }

    float hip() const { return (looks_.shoulders ? 0.094f : 0.101f) * g_; }
    float hip_depth() const { return 0.066f * g_; }

    std::array<Ring, 5> hip_rings() const {
        // Under a skirt's waistband the hips give way.
        const float wide = (looks_.skirt ? 0.92f : 1.0f) * hip();
        const float deep = (looks_.skirt ? 0.92f : 1.0f) * hip_depth();
        return {ring(0.470f * h_, 0.55f * wide, 0.6f * deep), ring(0.495f * h_, 0.92f * wide, 0.98f * deep),
                ring(0.530f * h_, wide, 1.04f * deep), ring(0.570f * h_, 0.94f * wide, 0.96f * deep),
                ring(0.615f * h_, 0.70f * wide, 0.72f * deep)};
    }

    /// Half depth of a skirt that holds a thigh, `thigh` deep to either side, at its widest swing.
    float skirt_depth(float share, float thigh) const {
        // At 1.6 m/s the gait's reach is (0.8 + 0.6 · 1.6) / 4 = 0.44, and its swing goes 1.089 times as far:
        // sine 0.479, tangent 0.546, cosine 0.878.
        constexpr float k_tangent = 0.546f;
        constexpr float k_cosine = 0.878f;
        // Legs are off the middle, where an ellipse of flat sides is shallower.
        constexpr float k_flank = 1.12f;
        return k_flank * (k_tangent * (k_hip - share) * h_ + thigh / k_cosine);
    }

    std::array<Ring, 4> skirt_rings() const {
        return {ring(0.300f * h_, 1.76f * hip(), skirt_depth(0.300f, 0.034f * g_)),
                ring(0.42f * h_, 1.45f * hip(), skirt_depth(0.42f, 0.050f * g_)),
                ring(0.53f * h_, 1.06f * hip(), 1.14f * hip_depth()),
                ring(0.605f * h_, 0.80f * hip(), 0.84f * hip_depth())};
    }

    void pelvis() {
        tube(Surface::cloth, looks_.bottom, hip_rings(), k_trunk_sides, Ends::first);
        if (looks_.skirt) tube(Surface::cloth, looks_.bottom, skirt_rings(), 14, Ends::first);
    }

    /// The ring of a shirt that hangs over trousers or skirt at this height. It is wider than the 1.07 that
    /// two ten-sided rings need when the torso turns by 0.12 rad, or the 1.09 over a skirt's fourteen sides.
    Ring over_hips(float share) const {
        constexpr float k_over_trousers = 1.10f;
        constexpr float k_over_skirt = 1.12f;
        const Ring under =
            looks_.skirt ? ring_at(skirt_rings(), share * h_) : ring_at(hip_rings(), share * h_);
        const float loose = looks_.skirt ? k_over_skirt : k_over_trousers;
        return ring((share - k_waist) * h_, loose * under.axis_a.x, loose * under.axis_b.z);
    }

    void trunk() {
        const float broad = looks_.shoulders ? 1.0f : 0.90f;
        const auto at = [&](float share) {
            return (share - k_waist) * h_;
        };
        const float hem = looks_.skirt ? 0.585f : 0.555f;
        const std::array<Ring, 9> rings{
            over_hips(hem),
            over_hips(0.592f),
            ring(at(0.640f), 0.086f * broad * g_, 0.062f * g_),
            ring(at(0.700f), 0.098f * broad * g_, 0.070f * g_, 0.0f, -0.004f * h_),
            ring(at(0.755f), 0.107f * broad * g_, 0.071f * g_, 0.0f, -0.004f * h_),
            ring(at(0.795f), 0.112f * broad * g_, 0.062f * g_),
            ring(at(0.822f), 0.094f * broad * g_, 0.048f * g_),
            ring(at(0.838f), 0.060f * g_, 0.038f * g_),
            ring(at(0.848f), 0.036f * g_, 0.034f * g_)};
        tube(Surface::cloth, looks_.top, rings, k_trunk_sides, Ends::first);
        if (!looks_.bag) return;
        builder_.colour = {looks_.extra, 1.0f};
        const std::array<Ring, 5> bag{ring(at(0.625f), 0.055f * h_, 0.025f * h_, 0.0f, 0.095f * g_),
                                      ring(at(0.640f), 0.075f * h_, 0.042f * h_, 0.0f, 0.100f * g_),
                                      ring(at(0.740f), 0.080f * h_, 0.045f * h_, 0.0f, 0.100f * g_),
                                      ring(at(0.800f), 0.066f * h_, 0.032f * h_, 0.0f, 0.092f * g_),
                                      ring(at(0.812f), 0.030f * h_, 0.015f * h_, 0.0f, 0.090f * g_)};
        builder_.tube(Surface::cloth, bag, 10, true, true);
    }

    void head() {
        // Neck, jaw, face and skull; y counts from the base of the neck.
        const std::array<Ring, 9> rings{ring(-0.012f * h_, 0.034f * h_, 0.034f * h_, 0.0f, 0.004f * h_),
                                        ring(0.020f * h_, 0.029f * h_, 0.031f * h_, 0.0f, 0.002f * h_),
                                        ring(0.030f * h_, 0.031f * h_, 0.038f * h_, 0.0f, -0.006f * h_),
                                        ring(0.042f * h_, 0.037f * h_, 0.047f * h_, 0.0f, -0.009f * h_),
                                        ring(0.070f * h_, 0.043f * h_, 0.053f * h_, 0.0f, -0.006f * h_),
                                        ring(0.100f * h_, 0.045f * h_, 0.056f * h_, 0.0f, -0.002f * h_),
                                        ring(0.128f * h_, 0.040f * h_, 0.050f * h_),
                                        ring(0.148f * h_, 0.024f * h_, 0.031f * h_),
                                        ring(0.155f * h_, 0.004f * h_, 0.005f * h_)};
        tube(Surface::skin, looks_.skin, rings, k_head_sides, Ends::last);
        const float front = -0.0575f * h_;
        const std::array<Ring, 3> nose{
            ring(0.066f * h_, 0.0085f * h_, 0.013f * h_, 0.0f, front),
            ring(0.072f * h_, 0.0075f * h_, 0.012f * h_, 0.0f, front),
            ring(0.094f * h_, 0.004f * h_, 0.004f * h_, 0.0f, front + 0.003f * h_)};
        tube(Surface::skin, looks_.skin, nose, 5, Ends::first);
        const glm::vec3 dark = 0.25f * looks_.hair + glm::vec3{0.012f};
        for (const float side : {-1.0f, 1.0f}) {
            const std::array<Ring, 2> eye{
                ring(0.088f * h_, 0.0075f * h_, 0.006f * h_, side * 0.018f * h_, front + 0.006f * h_),
                ring(0.094f * h_, 0.0075f * h_, 0.006f * h_, side * 0.018f * h_, front + 0.006f * h_)};
            tube(Surface::skin, dark, eye, 5, Ends::both);
            const std::array<Ring, 2> ear{
                ring(0.068f * h_, 0.004f * h_, 0.009f * h_, side * 0.045f * h_, 0.004f * h_),
                ring(0.096f * h_, 0.006f * h_, 0.012f * h_, side * 0.046f * h_, 0.006f * h_)};
            tube(Surface::skin, looks_.skin, ear, 5, Ends::both);
        }
        hair();
        if (looks_.hat) {
            const std::array<Ring, 6> hat{
                ring(0.122f * h_, 0.085f * h_, 0.095f * h_), ring(0.126f * h_, 0.086f * h_, 0.096f * h_),
                ring(0.128f * h_, 0.050f * h_, 0.061f * h_), ring(0.165f * h_, 0.046f * h_, 0.056f * h_),
                ring(0.176f * h_, 0.034f * h_, 0.042f * h_), ring(0.178f * h_, 0.004f * h_, 0.005f * h_)};
            tube(Surface::cloth, looks_.extra, hat, 12, Ends::both);
        }
    }

    void hair() {
        // A cap that sits back on the skull, so that the face stays free; long hair falls to the shoulders.
        const std::array<Ring, 5> cap{ring(0.075f * h_, 0.041f * h_, 0.032f * h_, 0.0f, 0.026f * h_),
                                      ring(0.100f * h_, 0.0475f * h_, 0.048f * h_, 0.0f, 0.012f * h_),
                                      ring(0.126f * h_, 0.0455f * h_, 0.056f * h_, 0.0f, 0.001f * h_),
                                      ring(0.152f * h_, 0.031f * h_, 0.039f * h_, 0.0f, 0.001f * h_),
                                      ring(0.163f * h_, 0.005f * h_, 0.006f * h_)};
        tube(Surface::cloth, looks_.hair, cap, k_head_sides, Ends::last);
        if (!looks_.long_hair) {
            const std::array<Ring, 2> nape{ring(0.045f * h_, 0.030f * h_, 0.018f * h_, 0.0f, 0.028f * h_),
                                           ring(0.080f * h_, 0.041f * h_, 0.030f * h_, 0.0f, 0.026f * h_)};
            tube(Surface::cloth, looks_.hair, nape, 8, Ends::first);
            return;
        }
        const std::array<Ring, 4> fall{ring(-0.060f * h_, 0.030f * h_, 0.014f * h_, 0.0f, 0.050f * h_),
                                       ring(0.000f, 0.046f * h_, 0.022f * h_, 0.0f, 0.044f * h_),
                                       ring(0.060f * h_, 0.048f * h_, 0.034f * h_, 0.0f, 0.028f * h_),
                                       ring(0.110f * h_, 0.046f * h_, 0.040f * h_, 0.0f, 0.016f * h_)};
        tube(Surface::cloth, looks_.hair, fall, k_head_sides, Ends::first);
    }

    void upper_arm() {
        const float l = k_upper_arm * h_;
        const std::array<Ring, 5> sleeve{
            ring(-0.62f * l, 0.030f * g_, 0.031f * g_), ring(-0.30f * l, 0.032f * g_, 0.034f * g_),
            ring(0.0f, 0.028f * g_, 0.033f * g_), ring(0.09f * l, 0.019f * g_, 0.025f * g_),
            ring(0.13f * l, 0.006f * g_, 0.008f * g_)};
        tube(Surface::cloth, looks_.top, sleeve, k_arm_sides, Ends::both);
        const std::array<Ring, 4> arm{
            ring(-1.06f * l, 0.020f * g_, 0.021f * g_), ring(-0.98f * l, 0.0225f * g_, 0.024f * g_),
            ring(-0.62f * l, 0.025f * g_, 0.027f * g_), ring(-0.40f * l, 0.025f * g_, 0.027f * g_)};
        limb(looks_.bare_arms, looks_.top, arm, k_arm_sides, Ends::open);
    }

    void forearm() {
        const float l = k_forearm * h_;
        const std::array<Ring, 4> arm{
            ring(-1.0f * l, 0.0145f * g_, 0.016f * g_), ring(-0.35f * l, 0.023f * g_, 0.024f * g_),
            ring(0.0f, 0.0225f * g_, 0.0235f * g_), ring(0.07f * l, 0.018f * g_, 0.019f * g_)};
        limb(looks_.bare_arms, looks_.top, arm, k_arm_sides, Ends::first);
        const std::array<Ring, 4> hand{
            ring(-1.0f * l - 0.098f * h_, 0.006f * h_, 0.010f * h_, 0.0f, -0.004f * h_),
            ring(-1.0f * l - 0.070f * h_, 0.011f * h_, 0.022f * h_, 0.0f, -0.004f * h_),
            ring(-1.0f * l - 0.030f * h_, 0.013f * h_, 0.023f * h_, 0.0f, -0.003f * h_),
            ring(-1.0f * l + 0.010f * h_, 0.013f * h_, 0.015f * h_)};
        tube(Surface::skin, looks_.skin, hand, k_arm_sides, Ends::first);
    }

    void thigh() {
        const float l = (k_hip - k_knee) * h_;
        const std::array<Ring, 5> rings{
            ring(-1.05f * l, 0.031f * g_, 0.034f * g_), ring(-0.95f * l, 0.034f * g_, 0.037f * g_),
            ring(-0.45f * l, 0.044f * g_, 0.050f * g_), ring(-0.05f * l, 0.050f * g_, 0.060f * g_),
            ring(0.10f * l, 0.040f * g_, 0.050f * g_)};
        limb(looks_.bare_legs && looks_.skirt, looks_.bottom, rings, k_leg_sides, Ends::first);
    }

    void shin() {
        const float l = (k_knee - k_ankle) * h_;
        const float loose = looks_.bare_legs ? 1.0f : 1.18f;
        const std::array<Ring, 6> rings{ring(-1.02f * l, 0.021f * loose * g_, 0.025f * loose * g_),
                                        ring(-0.80f * l, 0.021f * loose * g_, 0.026f * loose * g_),
                                        ring(-0.45f * l, 0.029f * g_, 0.035f * g_, 0.0f, 0.006f * h_),
                                        ring(-0.20f * l, 0.032f * g_, 0.037f * g_, 0.0f, 0.005f * h_),
                                        ring(0.0f, 0.033f * g_, 0.035f * g_),
                                        ring(0.06f * l, 0.027f * g_, 0.029f * g_)};
        limb(looks_.bare_legs, looks_.bottom, rings, k_leg_sides, Ends::first);
        // The shoe runs forwards (−z) from the heel; its rings stand upright.
        const float sole = -(k_knee * h_);
        const auto slice = [&](float z, float half, float top) {
            const float middle = 0.5f * top;
            return Ring{{0.0f, sole + middle, z}, {half, 0.0f, 0.0f}, {0.0f, middle, 0.0f}};
        };
        const std::array<Ring, 6> shoe{
            slice(-0.108f * h_, 0.012f * h_, 0.018f * h_), slice(-0.092f * h_, 0.026f * h_, 0.026f * h_),
            slice(-0.050f * h_, 0.030f * h_, 0.036f * h_), slice(-0.010f * h_, 0.026f * h_, 0.058f * h_),
            slice(0.026f * h_, 0.024f * h_, 0.062f * h_),  slice(0.044f * h_, 0.014f * h_, 0.045f * h_)};
        tube(Surface::cloth, looks_.shoes, shoe, 7, Ends::both);
    }

    /// A limb of bare skin or in cloth.
    void limb(bool bare, glm::vec3 cloth, std::span<const Ring> rings, int sides, Ends closed) {
        tube(bare ? Surface::skin : Surface::cloth, bare ? looks_.skin : cloth, rings, sides, closed);
    }

    Scene& scene_;
    const Looks& looks_;
    const Scheme& scheme_;
    float h_;
    float g_;
    Builder builder_;
};

constexpr std::array<glm::vec3, 5> k_skins{{{0.66f, 0.44f, 0.33f},
                                            {0.58f, 0.38f, 0.27f},
                                            {0.44f, 0.27f, 0.18f},
                                            {0.24f, 0.14f, 0.09f},
                                            {0.70f, 0.49f, 0.38f}}};
constexpr std::array<glm::vec3, 6> k_hairs{{{0.020f, 0.014f, 0.010f},
                                            {0.070f, 0.040f, 0.022f},
                                            {0.16f, 0.095f, 0.045f},
                                            {0.36f, 0.26f, 0.13f},
                                            {0.34f, 0.33f, 0.32f},
                                            {0.11f, 0.035f, 0.015f}}};
constexpr std::array<glm::vec3, 12> k_tops{{{0.70f, 0.68f, 0.63f},
                                            {0.46f, 0.07f, 0.06f},
                                            {0.09f, 0.17f, 0.33f},
                                            {0.58f, 0.42f, 0.12f},
                                            {0.10f, 0.22f, 0.13f},
                                            {0.30f, 0.40f, 0.52f},
                                            {0.55f, 0.26f, 0.22f},
                                            {0.06f, 0.06f, 0.07f},
                                            {0.62f, 0.56f, 0.42f},
                                            {0.30f, 0.12f, 0.22f},
                                            {0.07f, 0.30f, 0.31f},
                                            {0.62f, 0.34f, 0.36f}}};
constexpr std::array<glm::vec3, 7> k_bottoms{{{0.045f, 0.065f, 0.12f},
                                              {0.05f, 0.05f, 0.055f},
                                              {0.33f, 0.26f, 0.17f},
                                              {0.12f, 0.16f, 0.24f},
                                              {0.20f, 0.19f, 0.17f},
                                              {0.42f, 0.40f, 0.35f},
                                              {0.14f, 0.09f, 0.06f}}};
constexpr std::array<glm::vec3, 4> k_shoes{
    {{0.03f, 0.03f, 0.03f}, {0.14f, 0.075f, 0.04f}, {0.60f, 0.59f, 0.56f}, {0.20f, 0.19f, 0.19f}}};

}  // namespace

Looks draw_looks(std::uint32_t number, Draws& draws) {
    const auto one_of = [&](const auto& choices) {
        return choices[draws.below(static_cast<std::uint32_t>(choices.size()))];
    };
    Looks looks;
    const bool woman = (number & 1u) != 0;
    looks.shoulders = !woman;
    looks.height_m = woman ? draws.between(1.58f, 1.74f) : draws.between(1.68f, 1.86f);
    looks.girth = draws.between(0.92f, 1.16f);
    looks.skirt = woman && (number % 4 == 1);
    looks.long_hair = woman && (number % 3 != 0);
    looks.hat = number % 7 == 4;
    looks.bag = number % 5 == 2;
    looks.bare_arms = number % 3 != 2;
    looks.bare_legs = looks.skirt || number % 6 == 0;
    looks.skin = one_of(k_skins);
    // By number, so that among twelve people no two tops and among six women no two heads of hair are alike:
    // strides without a common divisor with the table. The draws vary their brightness.
    looks.hair = k_hairs[(number / 2 + (woman ? 0u : 3u)) % k_hairs.size()];
    looks.top = k_tops[number * 7 % k_tops.size()] * draws.between(0.85f, 1.1f);
    const glm::vec3 bottom = looks.skirt ? k_tops[(number * 7 + 5) % k_tops.size()]
                                         : k_bottoms[(number * 3 + 2) % k_bottoms.size()];
    looks.bottom = bottom * draws.between(0.85f, 1.1f);
    looks.shoes = one_of(k_shoes);
    looks.extra = one_of(k_tops) * 0.7f;
    return looks;
}

std::uint32_t add_person(Scene& scene, const Looks& looks, const Scheme& scheme) {
    return Tailor{scene, looks, scheme}.sew();
}

}  // namespace rambla::assets::generate
