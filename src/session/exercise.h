// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "instruments/builtin_tooth.h"
#include "session/work_piece.h"

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

/// A task for a student: a cavity in a built-in tooth that has no decay.
struct Exercise {
    const char* name;  ///< for people
    const char* task;  ///< a sentence
    BuiltinToothKind tooth;
    const char* bur;  ///< number in the catalogue, as one would take it
    PreparationPlan plan;
};

/// From easy to hard.
[[nodiscard]] std::span<const Exercise> exercises();

[[nodiscard]] ToothRequest toothRequest(const Exercise& exercise);

/// `tooth` with the cavity of the exercise in it, closed; its untouched triangles are those of the tooth, bit for bit.
[[nodiscard]] Expected<TriangleMesh> idealShape(const Exercise& exercise, std::shared_ptr<const LayeredTooth> tooth);

}  // namespace tactooth
