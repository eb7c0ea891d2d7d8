// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include "instruments/mouth_layout.h"

namespace tactooth {

/// Keeps built-in teeth and gums in a folder. The folder may be deleted at any time: missing or damaged files are made
/// anew. Several threads and programs may use it at once.
class ToothCache {
public:
    /// The most bytes in the folder; the files that were unused the longest go first.
    static constexpr std::uintmax_t kDefaultLimit = 256ULL << 20;

    explicit ToothCache(std::filesystem::path folder, std::uintmax_t limit = kDefaultLimit);

    /// makeTooth(request), bit for bit. `progress`: see makeToothReporting.
    [[nodiscard]] BuiltinTooth make(const ToothRequest& request,
                                    const std::function<void(double)>& progress = {}) const;

    /// makeMouth(request), bit for bit. `partDone`: called from several threads, with the share of the work that is
    /// done, 0..1.
    [[nodiscard]] Expected<BuiltinMouth> makeMouth(const MouthRequest& request,
                                                   const std::function<void(double)>& partDone = {}) const;

    /// The file of a tooth.
    [[nodiscard]] std::filesystem::path fileOf(const ToothRequest& request) const;
    /// The file of a mouth without its teeth: their poses and the gums.
    [[nodiscard]] std::filesystem::path fileOf(const MouthRequest& request) const;

private:
    [[nodiscard]] Expected<MouthLayout> makeLayout(const MouthRequest& request) const;
    void store(std::span<const std::byte> bytes, const std::filesystem::path& file) const;
    void removeOldest() const;

    std::filesystem::path folder_;
    std::uintmax_t limit_;
};

/// The user's cache folder: $XDG_CACHE_HOME/tactooth, else ~/.cache/tactooth, else empty.
[[nodiscard]] std::filesystem::path defaultCacheFolder();

}  // namespace tactooth
