#include "assets/process/simplify.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "assets/process/columns.h"
#include "assets/process/deviation.h"

namespace rambla::assets {

namespace {

/// Width of the measured error's bounds, as a share of the mesh's extent: far below a pixel of any level that
/// is not much larger than the picture.
constexpr double k_error_resolution = 1e-5;

/// The collapses estimate their error too low where surfaces curve; asked for less, they often stay within
/// it.
constexpr std::array k_asked_shares{1.0f, 0.5f, 0.25f};

struct Level {
    std::vector<std::uint32_t> indices;
    double error_m = 0.0;
    bool sloppy = false;
};

class Chain {
public:
    Chain(const Mesh& mesh, const LodParameters& parameters, Borders borders)
        : mesh_{mesh},
          parameters_{parameters},
          places_{without_negative_zero(mesh.positions)},
          surface_{places_, mesh.indices},
          extent_m_{meshopt_simplifyScale(&places_[0].x, places_.size(), sizeof(glm::vec3))},
          options_{borders == Borders::locked ? unsigned{meshopt_SimplifyLockBorder} : 0u},
          may_be_sloppy_{borders == Borders::free && mesh.joints.empty() && mesh.morphs.empty() &&
                         extent_m_ <= parameters.sloppy_below_m} {}

    LodChain run() {
        if (!(extent_m_ > 0.0f) || !std::isfinite(extent_m_)) return {};
        std::size_t triangles = mesh_.indices.size() / 3;
        double error_m = 0.0;
        for (int i = 0; i < parameters_.levels; ++i) {
            const auto wanted = static_cast<std::size_t>(static_cast<double>(triangles) * parameters_.ratio);
            const auto worth = static_cast<std::size_t>(static_cast<double>(triangles) * parameters_.pays);
            std::optional<Level> level = next_level(3 * wanted, 3 * worth);
            if (!level) break;
            triangles = level->indices.size() / 3;
            error_m = std::max(error_m, level->error_m);
            append(*level, error_m);
        }
        return std::move(chain_);
    }

private:
    std::optional<Level> next_level(std::size_t wanted_indices, std::size_t worth_indices) const {
        if (wanted_indices == 0) return {};
        for (const float share : k_asked_shares) {
            Level level{.indices = collapsed(wanted_indices, share * parameters_.max_error)};
            if (serves(level, worth_indices)) return level;
        }
        if (!may_be_sloppy_) return {};
        for (const float share : k_asked_shares) {
            Level level{.indices = merged(wanted_indices, share * parameters_.max_error), .sloppy = true};
            if (serves(level, worth_indices)) return level;
        }
        return {};
    }

    /// Measures the level's error and says whether it is worth having.
    bool serves(Level& level, std::size_t worth_indices) const {
        if (level.indices.empty() || level.indices.size() > worth_indices) return false;
        const double resolution_m = k_error_resolution * extent_m_;
        level.error_m = deviation(surface_, Surface{places_, level.indices}, resolution_m).at_most_m;
        return level.error_m <= double{parameters_.max_error} * extent_m_;
    }

    std::vector<std::uint32_t> collapsed(std::size_t wanted_indices, float error) const {
        std::vector<std::uint32_t> indices(mesh_.indices.size());
        indices.resize(meshopt_simplify(indices.data(), mesh_.indices.data(), mesh_.indices.size(),
                                        &places_[0].x, places_.size(), sizeof(glm::vec3), wanted_indices,
                                        error, options_, nullptr));
        return indices;
    }

    std::vector<std::uint32_t> merged(std::size_t wanted_indices, float error) const {
        std::vector<std::uint32_t> indices(mesh_.indices.size());
        indices.resize(meshopt_simplifySloppy(indices.data(), mesh_.indices.data(), mesh_.indices.size(),
                                              &places_[0].x, places_.size(), sizeof(glm::vec3),
                                              wanted_indices, error, nullptr));
        return indices;
    }

    void append(const Level& level, double error_m) {
        const AttributeDeviation attributes = attribute_deviation(mesh_, Surface{places_, level.indices});
        const float rounded_up =
            std::nextafter(static_cast<float>(error_m), std::numeric_limits<float>::infinity());
        chain_.levels.push_back({.range = {static_cast<std::uint32_t>(chain_.indices.size()),
                                           static_cast<std::uint32_t>(level.indices.size())},
                                 .error_m = rounded_up,
                                 .normal_error_deg = static_cast<float>(attributes.normal_deg),
                                 .uv_error = static_cast<float>(attributes.uv),
                                 .sloppy = level.sloppy});
        chain_.indices.insert(chain_.indices.end(), level.indices.begin(), level.indices.end());
    }

    const Mesh& mesh_;
    const LodParameters& parameters_;
    std::vector<glm::vec3> places_;
    Surface surface_;
    float extent_m_;
    unsigned options_;
    bool may_be_sloppy_;
    LodChain chain_;
};

}  // namespace

LodChain lod_chain(const Mesh& mesh, const LodParameters& parameters, Borders borders) {
    const bool usable = mesh.topology == Topology::triangles && mesh.indices.size() >= 3;
    if (!usable || !all_finite(mesh.positions)) return {};
    return Chain{mesh, parameters, borders}.run();
}

}  // namespace rambla::assets
