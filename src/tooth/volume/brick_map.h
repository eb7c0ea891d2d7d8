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

/// The bricks that have been made so far. A brick clear of the tooth is remembered as absent.
class BrickMap {
public:
    /// A brick and those around it, as BrickKey::neighbour counts them; null where there is none.
    using Around = std::array<const Brick*, 27>;

    [[nodiscard]] bool knows(const BrickKey& key) const { return bricks_.contains(key); }
    /// What `find` gives, if the map knows of it.
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
    /// Kept with each brick, since its surface is asked for far more often than bricks are made.
    [[nodiscard]] const Around& around(const BrickKey& key) const {
        static constexpr Around kNone{};
        const auto found = bricks_.find(key);
        return found == bricks_.end() ? kNone : found->second.around;
    }
    /// A key that is not known yet.
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
    void clear() { bricks_.clear(); }
    /// Keys of the bricks that exist, in ascending order.
    [[nodiscard]] std::vector<BrickKey> keys() const {
        std::vector<BrickKey> result;
        for (const auto& [key, entry] : bricks_) {
            if (entry.brick) result.push_back(key);
        }
        std::sort(result.begin(), result.end());
        return result;
    }

    /// Asserts the invariants of every brick, and that each one knows its neighbours. Looks at every node.
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
