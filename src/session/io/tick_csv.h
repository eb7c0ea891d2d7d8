// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "haptics/haptic_simulation.h"
#include "session/io/csv_table.h"

namespace tactooth {

/// Writes ticks as rows of t,x,y,z,depth,nx,ny,nz,speed,fx,fy,fz,tx,ty,tz,contacts,micros,proxy_x,proxy_y,proxy_z,
/// proxy_qw,proxy_qx,proxy_qy,proxy_qz (s, mm, mm/s, N, N*mm, us). The file appears when `commit` succeeds.
class TickCsv {
public:
    [[nodiscard]] static Expected<TickCsv> create(const std::filesystem::path& path);

    void write(double time, const Tick& tick);
    [[nodiscard]] Expected<void> commit() { return file_.commit(); }

private:
    explicit TickCsv(CsvWriter file) : file_(std::move(file)) {}
    CsvWriter file_;
};

}  // namespace tactooth
