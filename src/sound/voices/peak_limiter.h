// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

namespace tactooth {

/// Keeps every sample below a ceiling by reducing the gain shortly *before* a peak. Below the ceiling it only delays,
/// bit for bit: a nonlinear curve (such as tanh) would add overtones with aliasing.
class PeakLimiter {
public:
    static constexpr int kWindow = 64;          ///< samples in which the gain is reduced, 1.3 ms
    static constexpr int kDelay = kWindow - 1;  ///< samples from input to output
    static constexpr float kCeiling = 0.89f;  ///< of the drill, -1 dB of full scale: leaves room for the other sources

    explicit PeakLimiter(float ceiling = kCeiling);
    void process(std::span<float> samples);

private:
    float neededGain() const;

    float ceiling_;
    // Ring buffers of the last kWindow samples, of the gain that each needs, and of the gain that was allowed.
    std::array<float, kWindow> samples_{}, needed_, allowed_;
    int position_ = 0;
    int limitedCount_ = 0;  // entries of needed_ below 1
    float gain_ = 1.0f;
    double allowedSum_ = kWindow;
};

}  // namespace tactooth
