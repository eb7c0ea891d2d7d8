// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tactooth {

/// Whether the X server of DISPLAY answers: it must reply to a request, not only accept a connection. May block for
/// ever on a server that never answers or on a computer that is not there: call it in a child process. Also true if the
/// server refuses, because that is an answer.
[[nodiscard]] bool xServerAnswers();

/// The same for the Wayland compositor of WAYLAND_DISPLAY.
[[nodiscard]] bool waylandServerAnswers();

}  // namespace tactooth
