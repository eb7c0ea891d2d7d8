// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tactooth {

/// Which button does what; kNone: no button.
struct ButtonMap {
    static constexpr int kNone = -1;
    int swap = 0;        ///< turbine or mirror: the white one of a pen
    int cut = 1;         ///< touch or cut: the blue one
    int clutch = kNone;  ///< held: the tool stays while the hand moves on
};

/// Turns buttons that are down into what they do. A button counts when it goes down; one that is down at the first
/// reading does nothing before it was up.
class ButtonActions {
public:
    /// Bit i of `buttons`: button i is down.
    void press(std::uint32_t buttons, const ButtonMap& map) {
        const std::uint32_t fresh = started_ ? buttons & ~last_ : 0;
        started_ = true;
        last_ = buttons;
        swapToggled_ ^= isDown(fresh, map.swap);
        cutToggled_ ^= isDown(fresh, map.cut);
        clutchHeld_ = isDown(buttons, map.clutch);
    }

    [[nodiscard]] bool swapToggled() const { return swapToggled_; }
    [[nodiscard]] bool cutToggled() const { return cutToggled_; }
    [[nodiscard]] bool clutchHeld() const { return clutchHeld_; }

private:
    [[nodiscard]] static bool isDown(std::uint32_t buttons, int button) {
        return button >= 0 && button < 32 && ((buttons >> button) & 1U) != 0;
    }

    bool started_ = false;
    std::uint32_t last_ = 0;
    bool swapToggled_ = false;
    bool cutToggled_ = false;
    bool clutchHeld_ = false;
};

}  // namespace tactooth
