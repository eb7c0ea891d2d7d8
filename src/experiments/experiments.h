// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/experiment.h"
#include "experiments/test_teeth.h"

namespace tactooth {

/// Time from an STL file to a surface that can be touched, by number of triangles. The files are made in the folder
/// `scratch` and removed again.
[[nodiscard]] Expected<Experiment> measureLoading(TestTeeth& testTeeth, const std::filesystem::path& scratch);

/// The smallest movement of the hand that changes the depth, and the time that a force takes, at every resolution.
[[nodiscard]] Expected<Experiment> measureMovement(TestTeeth& testTeeth);

/// Depth on the ten-patch object at A, B and C against the exact answer, at hand speeds up to 1 m/s.
[[nodiscard]] Experiment measureTenPatches(const TestTeeth& testTeeth);

/// The bur comes sideways, along y, onto a molar.
[[nodiscard]] Expected<Experiment> measureSideways(TestTeeth& testTeeth);

/// Depth, velocity and force on a tooth at low and at high speed. `kind` is not Large.
[[nodiscard]] Expected<Experiment> measureTouch(TestTeeth& testTeeth, StandardToothKind kind);

}  // namespace tactooth
