// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace tactooth {

/// How the glass of a mouth mirror dims by itself: breath condenses on it where no spray runs, and what the bur throws
/// stays on it. Equal calls give equal bits.
class MirrorGlass {
public:
    struct Input {
        bool isInMouth = false;
        bool sprayRuns = false;  ///< it rinses the breath off
        double ground = 0;       ///< off the tooth so far, mm^3
    };
    /// Advances by `dt` seconds.
    void advance(const Input& now, double dt);
    /// The glass is clear again.
    void wipe() { breathed_ = dirt_ = 0; }

    /// Breath on the glass, 0..1.
    [[nodiscard]] double fog() const;
    /// Dried slurry and dust on the glass, 0..1.
    [[nodiscard]] double dirt() const { return dirt_; }

    static constexpr double kBegins = 10;  ///< s in the mouth until breath is seen
    static constexpr double kFull = 60;    ///< s until it is full
    static constexpr double kRinses = 2;   ///< s of spray that take a full breath away
    static constexpr double kSoils = 40;   ///< mm^3 ground off that soil the glass to 1 - 1/e

private:
    double breathed_ = 0;  // s, up to kFull
    double dirt_ = 0;
    std::optional<double> ground_;  // at the last call
};

}  // namespace tactooth
