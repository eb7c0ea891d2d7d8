// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "instruments/mouth_layout.h"

namespace tactooth {

/// Built-in teeth and gums that were made before, in a folder that may be deleted at any time: then, or where a file is
/// damaged, they are made anew. May be used by several threads and programs at once.
class ToothCache {
public:
    /// Most bytes that the folder keeps; what was not asked for the longest goes first.
    static constexpr std::uintmax_t kDefaultLimit = 256ULL << 20;

    explicit ToothCache(std::filesystem::path folder, std::uintmax_t limit = kDefaultLimit);

    /// makeTooth(request), bit for bit.
    [[nodiscard]] BuiltinTooth make(const ToothRequest& request) const;

    /// makeMouth(request), bit for bit.
    [[nodiscard]] Expected<BuiltinMouth> makeMouth(const MouthRequest& request) const;

    /// The file that keeps a tooth.
    [[nodiscard]] std::filesystem::path fileOf(const ToothRequest& request) const;
    /// The file that keeps what a mouth has beside its teeth: their places and the gums.
    [[nodiscard]] std::filesystem::path fileOf(const MouthRequest& request) const;

private:
    [[nodiscard]] Expected<MouthLayout> makeLayout(const MouthRequest& request) const;
    void store(std::span<const std::byte> bytes, const std::filesystem::path& file) const;
    void removeOldest() const;

    std::filesystem::path folder_;
    std::uintmax_t limit_;
};

/// The user's folder for this: $XDG_CACHE_HOME/tactooth, ~/.cache/tactooth without it; empty if there is neither.
[[nodiscard]] std::filesystem::path defaultCacheFolder();

}  // namespace tactooth
