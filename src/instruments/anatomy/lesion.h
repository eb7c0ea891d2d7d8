// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/anatomy/tooth_shape.h"
#include "instruments/builtin_tooth.h"

namespace tactooth {

/// Decay as a body: narrow through the enamel, then spreading along the dentin's border and toward the pulp, as
/// fissure and contact lesions do. It stands out of the tooth; cut it with the tooth's own surface.
[[nodiscard]] ScalarField lesionBody(const ToothShape& shape, const Lesion& lesion);

}  // namespace tactooth
