// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>

#include "session/cavity_ghost.h"
#include "view/distance_grid.h"

namespace tactooth {

/// The ideal shape that a tooth is compared with.
struct Target {
    QString name;
    std::shared_ptr<const DistanceGrid> distances;
    std::shared_ptr<CavityGhost> ghost;
};

}  // namespace tactooth
