// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tooth/file/saved_tooth.h"

namespace tactooth {

/// What the file of a tooth holds, at one moment: it stays as it is while the tooth is cut further. It takes the time
/// of a copy, a few milliseconds for a deep cut; the bytes of the file take much longer.
struct ToothSnapshot {
    std::shared_ptr<const LayeredTooth> tooth;
    double voxel = 0;  ///< mm
    MaterialVolumes removed{};
    std::vector<std::pair<BrickKey, CutField>> cuts;  ///< in ascending order of the keys
};

[[nodiscard]] ToothSnapshot snapshotOf(const CutVolume& volume, const MaterialVolumes& removed);

/// The same bytes as those of the volume that the snapshot was made of.
[[nodiscard]] std::vector<std::byte> savedToothBytes(const ToothSnapshot& snapshot, const Provenance& provenance,
                                                     const std::string& work = {});

}  // namespace tactooth
