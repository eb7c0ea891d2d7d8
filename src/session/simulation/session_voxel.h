// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// Voxel size of a tooth in a session, mm: a twentieth of a small bur's width. Cut faces are finer.
inline constexpr double kSessionVoxel = 0.05;

}  // namespace tactooth
