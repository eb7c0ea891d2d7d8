// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "collision/bvh/surface.h"
#include "instruments/builtin_tooth.h"
#include "session/simulation/tooth_source.h"

namespace tactooth {

/// The path of the bur through an ideal cavity: strokes of its tip, with the shaft in one direction.
struct PreparationPlan {
    Vec3 outward;  ///< direction of the shaft, out of the tooth, unit
    double depth;  ///< below the surface, mm
    /// True: flat floor, `depth` below the mean of the first stroke; false: the floor follows the surface.
    bool isFlat;
    bool stopsDevice = false;  ///< a haptic device stops at the floor, too
    struct Stroke {
        Vec3 from, to;  ///< tooth frame, mm; the height along `outward` is computed
    };
    std::vector<Stroke> strokes;
};

/// A task for a student: a cavity in a tooth. Tooth frame.
struct Exercise {
    std::string name;                                            ///< for people
    std::string task;                                            ///< a sentence
    std::variant<ToothRequest, ToothSource> tooth;               ///< a built-in one, or files
    std::variant<std::string, std::filesystem::path> bur;        ///< number in the catalogue, or a file (readCustomBur)
    std::variant<PreparationPlan, std::filesystem::path> ideal;  ///< or a file (loadIdealShape)
    std::filesystem::path file = {};                             ///< its description; empty: built in
};

/// Those that are built in (data/exercises/), from easy to hard.
[[nodiscard]] std::span<const std::shared_ptr<const Exercise>> exercises();

/// The place from whose height, along PreparationPlan::outward, the depth of a flat floor counts. Nothing where the
/// first stroke misses `outer`, the surface of the uncut tooth.
[[nodiscard]] std::optional<Vec3> floorReference(const PreparationPlan& plan, const SurfacePart& outer);

/// The uncut tooth of the exercise. Takes a second; fails with one sentence.
[[nodiscard]] Expected<std::shared_ptr<const LayeredTooth>> exerciseTooth(const Exercise& exercise);

/// `tooth` (that of the exercise) with the ideal cavity, closed. A cavity from a plan keeps the untouched triangles of
/// the tooth, bit for bit. Fails with one sentence.
[[nodiscard]] Expected<TriangleMesh> idealShape(const Exercise& exercise, std::shared_ptr<const LayeredTooth> tooth);

}  // namespace tactooth
