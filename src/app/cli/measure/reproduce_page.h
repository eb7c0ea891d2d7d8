// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "experiments/experiments.h"

namespace tactooth {

/// One sentence that names the measured teeth and the bur.
[[nodiscard]] std::string testTeethText(const TestTeeth& testTeeth);

/// Writes one page (HTML) on all experiments. Their pictures and tables are next to it.
[[nodiscard]] Expected<void> writeReproducePage(std::span<const Experiment> experiments, const std::string& testTeeth,
                                                const std::filesystem::path& path);

}  // namespace tactooth
