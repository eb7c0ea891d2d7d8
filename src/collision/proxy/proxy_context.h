// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/proxy/neighbour_horizon.h"
#include "collision/proxy/plane_finder.h"
#include "collision/proxy/proxy_scene.h"
#include "collision/proxy/work_budget.h"

namespace tactooth {

/// The data that the parts of a proxy solver share.
struct ProxyContext {
    ProxyContext(std::shared_ptr<const ToolShape> tool, Freedom freedom)
        : scene{std::move(tool), freedom, nullptr, {}}, horizon(*scene.tool) {}

    ProxyScene scene;
    NeighbourHorizon horizon;
    PlaneFinder planes;
    WorkBudget budget;
    ActiveContacts contacts;

    [[nodiscard]] bool ensurePlane(WatchedPair& watched) { return planes.ensurePlane(scene, watched, budget); }
};

}  // namespace tactooth
