// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "instruments/bur_head.h"
#include "session/cases/custom_bur.h"
#include "session/live/live_runner.h"
#include "session/simulation/session_work.h"

namespace tactooth {

/// A bur that is ready to cut, or another instrument in the hand, with its meshes for the picture.
struct SessionBur {
    std::string name;  ///< for people
    Instrument instrument;
    std::shared_ptr<const TriangleMesh> shown;
    std::shared_ptr<const TriangleMesh> blurred;  ///< spinEnvelopeMesh: the bur as the eye sees it turning fast
    BurMaterial material = BurMaterial::Carbide;
    std::filesystem::path file;  ///< that describes it; empty for a bur of the catalogue or of a case
    BurHead head = {};           ///< of `shown`
    std::shared_ptr<const TriangleMesh> headCap = {};  ///< closes it where the neck begins; null: unknown

    /// Whether it is held without a handpiece.
    [[nodiscard]] bool isHandInstrument() const { return instrument.hand.has_value(); }
};

/// The bur with its head measured.
[[nodiscard]] SessionBur withHead(SessionBur bur);

// These take up to a second: run them in a Task. They fail with one sentence for the user.
[[nodiscard]] Expected<SessionBur> makeSessionBur(const BurSpec& spec);
/// `file`: that described `bur`; empty if a case brought it.
[[nodiscard]] Expected<SessionBur> makeSessionBur(CustomBur bur, const std::filesystem::path& file);
[[nodiscard]] SessionBur makeHandInstrument(HandInstrument kind);
[[nodiscard]] Expected<SessionBur> loadSessionBur(const std::filesystem::path& path);
/// As findOrReadBur finds it.
[[nodiscard]] Expected<SessionBur> findOrLoadSessionBur(const std::filesystem::path& numberOrFile);
/// The bur or hand instrument that somebody worked with: of the catalogue, or of its file, which may also lie in
/// `folder`. Nothing if it is not there any more, or belongs to a case.
[[nodiscard]] std::optional<SessionBur> burOf(const SessionWork& work, const std::filesystem::path& folder);

}  // namespace tactooth
