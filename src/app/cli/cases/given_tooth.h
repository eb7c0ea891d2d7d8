// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "assessment/preparation/scan_alignment.h"
#include "geometry/io/import_note.h"
#include "session/track/session_track.h"

namespace tactooth {

/// A tooth that somebody has worked on.
struct GivenTooth {
    std::string name;
    TriangleMesh surface = {};
    std::shared_ptr<const LayeredTooth> uncut = {};  ///< null: a plain surface
    std::shared_ptr<const Surface> cut = {};         ///< with the bodies around it; null: a plain surface
    std::shared_ptr<const SessionTrack> track = {};
    std::string date = {};  ///< empty: not known
};

/// Reads a recording, a saved tooth or a surface. `what`: it, for a message. Fails with one sentence.
[[nodiscard]] Expected<GivenTooth> loadGivenTooth(const std::filesystem::path& file, const MessageText& what,
                                                  std::vector<ImportNote>& notes);

/// Fails with one sentence if a surface is larger than any tooth.
[[nodiscard]] Expected<void> checkSize(const TriangleMesh& mesh, const std::string& name);

/// Lays somebody's work on the uncut tooth (`align`), or checks that it lies there. `pose`: how it was moved.
[[nodiscard]] Expected<ScanFit> place(GivenTooth& work, Pose& pose, const SurfacePart& original, bool align);

}  // namespace tactooth
