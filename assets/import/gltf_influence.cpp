#include "assets/import/gltf_influence.h"

#include <cmath>
#include <limits>
#include <utility>

namespace rambla::assets::gltf {

namespace {

constexpr AttributeForm k_joints{.least_components = 4, .most_components = 4};
constexpr AttributeForm k_weights{.least_components = 4, .most_components = 4, .always_normalise = true};

/// What must be said of a primitive's influences once all of its vertices are read.
struct Findings {
    std::size_t left_out = 0;  ///< vertices with more than four joints
    std::size_t negative = 0;  ///< weights below 0
    std::size_t weightless = 0;
};

class InfluenceImport {
public:
    InfluenceImport(VertexReader& reader, const Attributes& attributes, Mesh& mesh)
        : reader_{reader}, attributes_{attributes}, mesh_{mesh} {}

    void run() {
        mesh_.joints.assign(reader_.size(), glm::u16vec4{0});
        mesh_.weights.assign(reader_.size(), glm::vec4{0.0f});
        for (int set = 0; attribute(attributes_, "JOINTS_" + std::to_string(set)) >= 0; ++set)
            read_set(set);
        normalise();
        warn();
    }

private:
    void read_set(int set) {
        const std::string number = std::to_string(set);
        const int weights_accessor = attribute(attributes_, "WEIGHTS_" + number);
        const std::string name = "attributes.JOINTS_" + number;
        Document& document = reader_.document();
        if (weights_accessor < 0)
            document.fail(reader_.element() + "." + name, "no WEIGHTS_" + number + " beside it", "weights");
        // The first set is part of what a vertex may cost.
        if (set > 0) document.spend(reader_.element() + "." + name, reader_.size());
        const auto joints = reader_.read<4>(attribute(attributes_, "JOINTS_" + number), name, k_joints);
        const auto weights = reader_.read<4>(weights_accessor, "attributes.WEIGHTS_" + number, k_weights);
        for (std::size_t v = 0; v < joints.size(); ++v) {
            if (set == 0) mesh_.joints[v].x = joint(name, v, joints[v].x);
            for (int i = 0; i < 4; ++i) {
                if (weights[v][i] < 0.0f) ++findings_.negative;
                if (weights[v][i] > 0.0f) add(v, joint(name, v, joints[v][i]), weights[v][i]);
            }
        }
    }

    std::uint16_t joint(const std::string& name, std::size_t vertex, float value) {
        constexpr float k_largest = std::numeric_limits<std::uint16_t>::max();
        if (!(value >= 0.0f && value <= k_largest && value == std::floor(value)))
            reader_.document().fail(reader_.element() + "." + name,
                                    "joint " + std::to_string(value) + " of vertex " + std::to_string(vertex),
                                    "a whole number up to 65535");
        return static_cast<std::uint16_t>(value);
    }

    /// Sorts one influence in among the strongest four, which stand in falling order.
    void add(std::size_t vertex, std::uint16_t joint, float weight) {
        glm::u16vec4& joints = mesh_.joints[vertex];
        glm::vec4& weights = mesh_.weights[vertex];
        for (int i = 0; i < 4; ++i) {
            if (weight <= weights[i]) continue;
            std::swap(joints[i], joint);
            std::swap(weights[i], weight);
        }
        if (weight > 0.0f) ++findings_.left_out;
    }

    void normalise() {
        for (std::size_t v = 0; v < mesh_.weights.size(); ++v) {
            glm::vec4& weights = mesh_.weights[v];
            const float sum = weights.x + weights.y + weights.z + weights.w;
            if (sum == 1.0f) continue;
            const bool usable = sum > std::numeric_limits<float>::min() && std::isfinite(sum);
            if (!usable) ++findings_.weightless;
            weights = usable ? weights / sum : glm::vec4{1.0f, 0.0f, 0.0f, 0.0f};
        }
    }

    void warn() const {
        const auto say = [&](std::size_t count, const char* what) {
            if (count > 0)
                reader_.document().warn(reader_.element() + ".attributes.WEIGHTS_0",
                                        std::to_string(count) + " " + what);
        };
        say(findings_.left_out, "influences beyond the strongest four of their vertices are left out");
        say(findings_.negative, "weights were negative and became 0");
        say(findings_.weightless, "vertices have no weights and follow one joint");
    }

    VertexReader& reader_;
    const Attributes& attributes_;
    Mesh& mesh_;
    Findings findings_;
};

}  // namespace

bool is_skinned(const Attributes& attributes) {
    return attribute(attributes, "JOINTS_0") >= 0;
}

void read_influences(VertexReader& reader, const Attributes& attributes, Mesh& mesh) {
    InfluenceImport{reader, attributes, mesh}.run();
}

}  // namespace rambla::assets::gltf
