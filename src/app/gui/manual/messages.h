// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/message.h"

/// The catalogue of the manual.
namespace tactooth::msg {

inline constexpr MessageText kManualOnlyEnglish{"manual_only_english", "This page is in English only.",
                                                "このページはまだ英語だけです。"};
inline constexpr MessageText kManualNoPage{"manual_no_page",
                                           "%1 is not in this manual; it is in the source of Tactooth.",
                                           "%1 はこの説明書にはありません。Tactooth のソースにあります。"};

}  // namespace tactooth::msg
