// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/given_tooth.h"

#include <fmt/core.h>

#include <cmath>

#include "app/cli/cases/messages.h"
#include "app/cli/terminal/messages.h"
#include "assessment/ideal_shape.h"
#include "collision/solid/solid_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/number_text.h"
#include "session/cases/loaded_tooth.h"
#include "session/recording/session_recording.h"
#include "session/track/make_track.h"

namespace tactooth {
namespace {

constexpr double kLargestTooth = 100;  // mm: with much of a jaw
constexpr double kSameTooth = 0.75;    // share of an uncut tooth that lies on itself; a fifth never counts
constexpr double kInPlace = 1e-3;      // mm: a surface that lies so well need not be moved

Expected<GivenTooth> finished(GivenTooth work, const CutModel& piece) {
    work.cut = piece.surface();
    work.surface = asReadFromFile(*work.cut);
    work.uncut = piece.volume().tooth();
    if (auto fits = checkSize(work.surface, work.name); !fits) return Unexpected{fits.error()};
    return work;
}

Expected<GivenTooth> loadRecording(const std::filesystem::path& file) {
    const Expected<SessionRecording> recording = SessionRecording::open(file);
    if (!recording) return Unexpected{recording.error()};
    auto model = recording->makeModel();
    if (!model) return Unexpected{model.error()};
    auto track = emptyTrack(*recording, **model);
    if (!track) return Unexpected{track.error()};
    makeTrack(*recording, *model, **track);
    if (const auto fault = (*track)->fault()) return Unexpected{Error(*fault)};
    if (const auto at = (*track)->differsAt()) {
        return unexpected(msg::kReplayIsNotTheWork, displayName(file), fmt::format("{:.0f}", std::floor(*at)));
    }
    return finished({.name = displayFileName(file), .track = *track, .date = recording->facts().date}, **model);
}

}  // namespace

Expected<GivenTooth> loadGivenTooth(const std::filesystem::path& file, const MessageText& what,
                                    std::vector<ImportNote>& notes) {
    if (file.extension() == ".ttsession") return loadRecording(file);
    if (isToothFile(file)) {
        Expected<OpenedTooth> opened = openTooth(file);
        if (!opened) return Unexpected{opened.error()};
        notes.insert(notes.end(), opened->importNotes.begin(), opened->importNotes.end());
        return finished({.name = displayFileName(file)}, *opened->piece);
    }
    Expected<TriangleMesh> surface = loadSolid(file, what, {}, &notes);
    if (!surface) return Unexpected{surface.error()};
    if (auto fits = checkSize(*surface, displayName(file)); !fits) return Unexpected{fits.error()};
    return GivenTooth{.name = displayFileName(file), .surface = std::move(*surface)};
}

Expected<void> checkSize(const TriangleMesh& mesh, const std::string& name) {
    const double size = boundingBox(mesh).sizes().maxCoeff();
    if (size <= kLargestTooth) return {};
    return unexpected(msg::kLargerThanATooth, name, numberText(std::round(size)));
}

Expected<ScanFit> place(GivenTooth& work, Pose& pose, const SurfacePart& original, bool align) {
    const auto own = work.uncut != nullptr ? work.uncut->ownOuter() : nullptr;
    const TriangleMesh& reference = own != nullptr ? own->mesh() : work.surface;
    ScanFit fit = fitOf(reference, original);
    if (align && fit.residual > kInPlace) {
        const ScanAlignment alignment = alignScan(reference, original);
        pose = alignment.scanInTooth;
        fit = alignment.fit;
        work.surface = transformed(work.surface, pose);
    }
    const bool isSame = fit.isGood() && (own == nullptr || fit.usedShare >= kSameTooth);
    if (isSame) return fit;
    return unexpected(align ? msg::kNotAligned : msg::kNotInPlace, work.name, fmt::format("{:.3f}", fit.residual),
                      numberText(kMostResidual), fmt::format("{:.0f}", 100 * fit.usedShare));
}

}  // namespace tactooth
