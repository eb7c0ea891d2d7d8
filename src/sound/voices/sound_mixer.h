// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// Volumes of the listener, 0 (silent) .. 1 (unchanged); they multiply the amplitude.
struct SoundMixer {
    double motor = 1.0;    ///< spindle tones and drive air
    double cutting = 1.0;  ///< grinding noise and taps
    double master = 1.0;
    bool muted = false;
    double environment = 1.0;  ///< spray and suction
};

}  // namespace tactooth
