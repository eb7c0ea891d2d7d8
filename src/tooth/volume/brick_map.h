// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/util/assert.h"
#include "tooth/volume/brick.h"
#include "tooth/volume/brick_key.h"
#include "tooth/volume/lattice.h"

namespace tactooth {

/// The bricks that were sampled so far. The map remembers a brick that is clear of the tooth as absent.
class BrickMap {
public:
    /// A brick and its neighbours, in the order of BrickKey::neighbour. Null where no brick exists.
    using Around = std::array<const Brick*, 27>;

    [[nodiscard]] bool knows(const BrickKey& key) const { return bricks_.contains(key); }
    /// The result of `find` if the map knows the key, else nothing.
    [[nodiscard]] std::optional<Brick*> known(const BrickKey& key) {
        const auto found = bricks_.find(key);
        return found == bricks_.end() ? std::nullopt : std::optional(found->second.brick.get());
    }
    [[nodiscard]] const Brick* find(const BrickKey& key) const {
        const auto found = bricks_.find(key);
        return found == bricks_.end() ? nullptr : found->second.brick.get();
    }
    [[nodiscard]] Brick* find(const BrickKey& key) {
        const auto found = bricks_.find(key);
        return found == bricks_.end() ? nullptr : found->second.brick.get();
    }
    /// The neighbours are stored with each brick, since surfaces ask for them far more often than bricks are made.
    [[nodiscard]] const Around& around(const BrickKey& key) const {
        static constexpr Around kNone{};
        const auto found = bricks_.find(key);
        return found == bricks_.end() ? kNone : found->second.around;
    }
    /// Adds a brick, or null for an absent one. The map must not know the key yet.
    void insert(const BrickKey& key, std::unique_ptr<Brick> brick) {
        TACTOOTH_ASSERT(!knows(key));
        TACTOOTH_ASSERT(key.isInRange());
        Entry& entry = bricks_[key];
        entry.brick = std::move(brick);
        for (int i = 0; i < 27; ++i) {
            const auto found = bricks_.find(key.neighbour(i));
            if (found == bricks_.end()) continue;
            entry.around[i] = found->second.brick.get();
            found->second.around[26 - i] = entry.brick.get();
        }
    }
    /// Keys of the existing bricks, in ascending order.
    [[nodiscard]] std::vector<BrickKey> keys() const {
        std::vector<BrickKey> result;
        for (const auto& [key, entry] : bricks_) {
            if (entry.brick) result.push_back(key);
        }
        std::sort(result.begin(), result.end());
        return result;
    }

    /// Asserts the invariants of every brick and of the lists of neighbours. Looks at every node. `spacing` in mm.
    void validate(double spacing) const {
        for (const auto& [key, entry] : bricks_) {
            TACTOOTH_ASSERT(key.isInRange());
            TACTOOTH_ASSERT(entry.around[13] == entry.brick.get());
            for (int i = 0; i < 27; ++i) TACTOOTH_ASSERT(entry.around[i] == find(key.neighbour(i)));
            if (entry.brick) entry.brick->validate(spacing);
        }
    }

private:
    struct Entry {
        std::unique_ptr<Brick> brick;
        Around around{};
    };
    std::unordered_map<BrickKey, Entry, BrickKeyHash> bricks_;
};

}  // namespace tactooth
