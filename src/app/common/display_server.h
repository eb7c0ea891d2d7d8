// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tactooth {

/// Whether the X server of DISPLAY answers: not only lets one connect, but replies to a request. May wait for ever, for
/// a server that never does or for a computer that is not there: to be called in a child process. True also where it
/// refuses: that is an answer.
[[nodiscard]] bool xServerAnswers();

/// The same for the Wayland compositor of WAYLAND_DISPLAY.
[[nodiscard]] bool waylandServerAnswers();

}  // namespace tactooth
