// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "experiments/experiments.h"

namespace tactooth {

/// Which teeth and which bur were measured, as one sentence.
[[nodiscard]] std::string subjectsText(const TestTeeth& testTeeth);

/// Writes one page (HTML) over all experiments; their pictures and tables lie beside it.
[[nodiscard]] Expected<void> writeReproducePage(std::span<const Experiment> experiments, const std::string& testTeeth,
                                                const std::filesystem::path& path);

}  // namespace tactooth
