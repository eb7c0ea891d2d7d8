// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tactooth {

/// Assignment of buttons to actions; kNone: no button.
struct ButtonMap {
    static constexpr int kNone = -1;
    int swap = 0;        ///< exchanges turbine and mirror: the white button of a pen
    int cut = 1;         ///< switches between touch and cut: the blue button
    int clutch = kNone;  ///< while held, the tool stays and the device moves freely
};

/// Converts button states into actions. An action starts when its button goes down; a button that is down at the first
/// reading has no effect until it was released.
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
