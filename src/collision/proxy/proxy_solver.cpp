// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/proxy_solver.h"

#include <bit>
#include <utility>

#include "collision/narrow/gjk.h"
#include "collision/proxy/proxy_move.h"

namespace tactooth {

ProxySolver::ProxySolver(std::shared_ptr<const ToolShape> tool, Freedom freedom) : context_(std::move(tool), freedom) {}

std::shared_ptr<const Surface> ProxySolver::setSurface(std::shared_ptr<const Surface> surface) {
    enter(surface);
    context_.horizon.list().clear();
    return surface;
}

std::shared_ptr<const Surface> ProxySolver::setSurface(std::shared_ptr<const Surface> surface, NeighbourList& near) {
    if (surface != context_.scene.surface) enter(surface);  // else all that is known of it still holds
    context_.horizon.take(near);
    return surface;
}

/// Swaps the surface, and forgets the pairs of the old one.
void ProxySolver::enter(std::shared_ptr<const Surface>& surface) {
    std::swap(context_.scene.surface, surface);
    context_.contacts.count = 0;
    settled_.forgetContacts();
    sweep_.clearRecent();
}

void ProxySolver::placeAt(const Pose& toolInTooth) {
    shiftTo(toolInTooth);
    context_.horizon.list().clear();
}

void ProxySolver::shiftTo(const Pose& toolInTooth) {
    TACTOOTH_ASSERT(toolInTooth.position.allFinite() && toolInTooth.rotation.coeffs().allFinite());
    context_.scene.pose = toolInTooth;
    ++context_.scene.poseStamp;
    context_.contacts.count = 0;
    settled_.placeAt(toolInTooth);
    context_.horizon.wait().endRest();
    context_.budget.endStarvation();
    sweep_.clearRecent();
}

std::optional<bool> ProxySolver::isClearAt(const Pose& toolInTooth) {
    const ProxyScene& scene = context_.scene;
    NeighbourList& list = context_.horizon.list();
    if (!context_.horizon.covers(toolInTooth, scene.margin)) return std::nullopt;
    const ToolMotion still = list.motion(toolInTooth, toolInTooth, 0, {});
    const std::span<const std::uint32_t> packets = list.within(still);
    if (list.isFull()) return std::nullopt;
    for (const std::uint32_t first : packets) {
        for (std::uint32_t near = list.uncertainClusters(first, still); near != 0; near &= near - 1) {
            const std::size_t cluster = first + static_cast<std::size_t>(std::countr_zero(near));
            for (std::uint32_t uncertain = list.uncertainPairs(cluster, still); uncertain != 0;
                 uncertain &= uncertain - 1) {
                const NearPair pair = list[NeighbourList::placeOf(cluster, std::countr_zero(uncertain))];
                const Triangle3 tooth = scene.toothTriangle(pair);
                const Triangle3 tool = scene.tool->cornersAt(toolInTooth, pair.tool);
                if (!distanceBetween(tooth, tool, tool[0] - tooth[0]).separated) return false;
            }
        }
    }
    return true;
}

void ProxySolver::forget() {
    context_.planes.clear();
    sweep_.restartSearch();
    settled_.unsettle();
    context_.horizon.list().forget();
}

MoveResult ProxySolver::moveToward(const Pose& goal) {
    TACTOOTH_ASSERT(goal.position.allFinite() && goal.rotation.coeffs().allFinite());
    if (settled_.answers(goal)) return settled_.result();
    if (!(tool().radius() > 0)) {  // nothing that could touch
        placeAt(goal);
        return {};
    }
    TACTOOTH_ASSERT(surface() != nullptr);
    if (context_.scene.rotates()) return ProxyMove<RotationConstraints>(context_, sweep_, settled_, goal).run();
    return ProxyMove<TranslationConstraints>(context_, sweep_, settled_, goal).run();
}

}  // namespace tactooth
