// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "assessment/preparation/measured.h"
#include "session/track/session_track.h"

namespace tactooth {

/// A small cube of decay.
struct DecayPiece {
    Vec3 place;            ///< its middle, tooth frame, mm
    double toPulp;         ///< mm
    double belowJunction;  ///< below the outside of the dentin, mm; negative in the enamel
};

/// The decay of a tooth in equal pieces, on a grid of 0.1 mm, or wider for very much decay. Empty without decay, dentin
/// or pulp.
[[nodiscard]] std::vector<DecayPiece> decayPieces(const LayeredTooth& tooth);

/// In which order decay was removed. The *deep* decay is the third of all pieces that lies nearest to the pulp; the
/// *periphery* is of the others what lies in the enamel or within 0.5 mm below it, where decay spreads unseen.
/// Teachers ask for the periphery first and for the deep decay last, so that nobody works over the pulp in an unclean
/// cavity.
struct DecayOrder {
    Measured peripheryFirst;  ///< share of the pairs, one of each, in which the periphery went first; ties count half
    Measured deepEarly;       ///< share of the deep decay that went before 90 % of the periphery had gone
};
/// `times`: when each piece was removed, s; nothing for one that was not removed in the session.
[[nodiscard]] DecayOrder decayOrder(std::span<const DecayPiece> pieces, std::span<const std::optional<double>> times);

/// In which order a session has removed the tissues of a tooth.
struct TissueOrder {
    Measured dentinTime;  ///< when the bur first cut dentin, s since the session began
    DecayOrder decay;
};
/// `tooth`: in the frame of the session; null: not known.
[[nodiscard]] TissueOrder tissueOrder(const LayeredTooth* tooth, const std::shared_ptr<const SessionTrack>& track);

}  // namespace tactooth
