// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "instruments/builtin_tooth.h"
#include "session/simulation/tooth_source.h"

namespace tactooth {

/// How the bur goes through an ideal cavity: strokes of its tip, all with the shaft in one direction.
struct PreparationPlan {
    Vec3 outward;  ///< direction of the shaft, out of the tooth, unit
    double depth;  ///< below the surface, mm
    bool isFlat;   ///< the floor is flat, that deep on the mean of the first stroke; else it follows the surface
    struct Stroke {
        Vec3 from, to;  ///< in the tooth's frame, mm; the height along `outward` is found
    };
    std::vector<Stroke> strokes;
};

/// A task for a student: a cavity in a tooth. Frame: that of the tooth.
struct Exercise {
    std::string name;                                            ///< for people
    std::string task;                                            ///< a sentence
    std::variant<ToothRequest, ToothSource> tooth;               ///< a built-in one, or files
    std::variant<std::string, std::filesystem::path> bur;        ///< number in the catalogue, or a file (readCustomBur)
    std::variant<PreparationPlan, std::filesystem::path> ideal;  ///< or a file (loadIdealShape)
    std::filesystem::path file = {};                             ///< that describes it; empty: it is built in
};

/// Those that are built in (data/exercises/), from easy to hard.
[[nodiscard]] std::span<const std::shared_ptr<const Exercise>> exercises();

/// What the exercise is done on, uncut. Takes a second; fails with one sentence.
[[nodiscard]] Expected<std::shared_ptr<const LayeredTooth>> exerciseTooth(const Exercise& exercise);

/// `tooth`, which is that of the exercise, with the cavity in it, closed. What is cut by a plan has the untouched
/// triangles of the tooth, bit for bit. Fails with one sentence.
[[nodiscard]] Expected<TriangleMesh> idealShape(const Exercise& exercise, std::shared_ptr<const LayeredTooth> tooth);

}  // namespace tactooth
