// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the bytes: the window's settings are refused with a sentence, or can be written and read again.
#include "app/gui/settings/window_settings.h"
#include "fuzz/fuzz_target.h"

namespace tactooth::test {
namespace {

bool accepts(std::span<const std::byte> bytes) {
    const auto settings = parseWindowSettings(asText(bytes), "fuzz");
    if (!settings) return requireSentence(settings.error(), 1000), false;
    for (const Error& refused : settings->refused) requireSentence(refused, 1000);
    const std::string text = windowSettingsText(*settings);
    const auto again = parseWindowSettings(text, "again");
    require(again && windowSettingsText(*again) == text, "what was read can be written and read again");
    return true;
}

const AddFuzzTarget added({"settings", accepts});

}  // namespace
}  // namespace tactooth::test
