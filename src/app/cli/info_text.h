// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh_report.h"
#include "geometry/remark.h"

namespace tactooth {

/// What `report` says about the file `name`, and the remarks on reading it, as a table for people, several lines.
[[nodiscard]] std::string infoTable(std::string_view name, const MeshReport& report,
                                    const std::vector<Remark>& remarks);

/// The same, and all other numbers of the report, as one line of JSON; lengths in mm.
[[nodiscard]] std::string infoJson(std::string_view name, const MeshReport& report, const std::vector<Remark>& remarks);

}  // namespace tactooth
