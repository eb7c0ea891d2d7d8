// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cause/error_place.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/bvh/closest_point.h"

namespace tactooth {
namespace {

/// Which patches a metric measures.
enum class Measures { Over, Under, Both };

struct OfPatches {
    std::string_view metric;
    Measures which;
    int axis = -1;  ///< of the tooth's frame along which it measures a length; -1: none
};
constexpr std::array kOfPatches = {
    OfPatches{"cleared_share", Measures::Under},     OfPatches{"over_volume", Measures::Over},
    OfPatches{"under_volume", Measures::Under},      OfPatches{"dice", Measures::Both},
    OfPatches{"deviation_rms", Measures::Both},      OfPatches{"deviation_mean", Measures::Both},
    OfPatches{"deviation_p50", Measures::Both},      OfPatches{"deviation_p95", Measures::Both},
    OfPatches{"over_volume_beyond", Measures::Over}, OfPatches{"under_enamel", Measures::Under},
    OfPatches{"under_dentin", Measures::Under},      OfPatches{"within_0_1", Measures::Both},
    OfPatches{"within_0_2", Measures::Both},         OfPatches{"within_0_3", Measures::Both},
    OfPatches{"within_0_4", Measures::Both},         OfPatches{"over_enamel", Measures::Over},
    OfPatches{"over_dentin", Measures::Over},        OfPatches{"extent_md", Measures::Both, 0},
    OfPatches{"extent_bl", Measures::Both, 1},       OfPatches{"extent_og", Measures::Both, 2}};

/// Metrics that measure the same as another one that has a place.
struct SameAs {
    std::string_view metric;
    std::array<std::string_view, 2> others;  ///< the place is that of the larger absolute value
};
constexpr std::array kSameAs = {SameAs{"toc_md", {"wall_angle_m", "wall_angle_d"}},
                                SameAs{"toc_bl", {"wall_angle_b", "wall_angle_l"}},
                                SameAs{"toc_sections", {"wall_angle_m", "wall_angle_d"}},
                                SameAs{"toc_cone", {"wall_angle_m", "wall_angle_d"}},
                                SameAs{"occlusal_reduction_median", {"occlusal_reduction_min", {}}},
                                SameAs{"finish_line_width", {"finish_line_roughness", {}}},
                                SameAs{"finish_line_width_sd", {"finish_line_roughness", {}}},
                                SameAs{"finish_line_height", {"finish_line_roughness", {}}},
                                SameAs{"neighbour_scratches", {"neighbour_depth_max", {}}},
                                SameAs{"neighbour_nicks", {"neighbour_depth_max", {}}},
                                SameAs{"removed_pulp", {"pulp_open", {}}}};

const ErrorPatch* largestOf(const OfPatches& row, const ErrorPatches& patches) {
    const ErrorPatch* largest = nullptr;
    double size = 0;
    const auto consider = [&](const std::vector<ErrorPatch>& among) {
        for (const ErrorPatch& patch : among) {
            const double here = patch.volume * (row.axis < 0 ? 1 : std::abs(patch.normal[row.axis]));
            if (here <= size) continue;
            size = here;
            largest = &patch;
        }
    };
    if (row.which != Measures::Under) consider(patches.over);
    if (row.which != Measures::Over) consider(patches.under);
    return largest;
}

const Measured* findIn(const std::vector<MetricResult>& results, std::string_view id) {
    const auto found = std::ranges::find(results, id, [](const MetricResult& each) { return each.metric->id; });
    return found == results.end() ? nullptr : &found->measured;
}

std::optional<Vec3> placeOfSame(const SameAs& row, const std::vector<MetricResult>& results) {
    std::optional<Vec3> place;
    double size = -1;
    for (const std::string_view id : row.others) {
        const Measured* other = findIn(results, id);
        if (other == nullptr || !other->place || std::abs(*other->value) <= size) continue;
        size = std::abs(*other->value);
        place = other->place;
    }
    return place;
}

/// Where decay lies deepest in the prepared tooth.
std::optional<Vec3> placeOfDecay(const Preparation& preparation) {
    if (preparation.tooth == nullptr) return std::nullopt;
    std::optional<Vec3> place;
    double deepest = 0;
    for (const LayeredTooth::Layer& layer : preparation.tooth->layers()) {
        if (!preparation.tooth->materials().hasRole(layer.material, MaterialRole::Decay)) continue;
        for (const Vec3f& vertex : layer.part->mesh().vertices) {
            const double depth = -signedDistance(*preparation.prepared, vertex.cast<double>());
            if (depth <= deepest) continue;
            deepest = depth;
            place = vertex.cast<double>();
        }
    }
    return place;
}

}  // namespace

std::vector<const ErrorPatch*> placeErrors(std::vector<MetricResult>& results, const Preparation& preparation,
                                           const PreparationMeasures& measures, const ErrorPatches& patches) {
    std::vector<const ErrorPatch*> sources(results.size());
    const bool hasDecayLeft = measures.tissues.decayLeft.value.value_or(0) > 0;
    const std::optional<Vec3> decay = hasDecayLeft ? placeOfDecay(preparation) : std::nullopt;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const std::string_view id = results[i].metric->id;
        Measured& measured = results[i].measured;
        if (!measured.value || measured.place) continue;
        if (id == "decay_left" || id == "decay_share") measured.place = decay;
        const auto* const row = std::ranges::find(kOfPatches, id, &OfPatches::metric);
        if (row != kOfPatches.end()) sources[i] = largestOf(*row, patches);
        if (sources[i] != nullptr) measured.place = sources[i]->place;
        const auto* const same = std::ranges::find(kSameAs, id, &SameAs::metric);
        if (same != kSameAs.end()) measured.place = placeOfSame(*same, results);
    }
    return sources;
}

}  // namespace tactooth
