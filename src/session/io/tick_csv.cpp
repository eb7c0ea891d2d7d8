// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/tick_csv.h"

#include <array>

namespace tactooth {
namespace {

constexpr std::array<std::string_view, 24> kColumns = {
    "t",      "x",       "y",       "z",       "depth",    "nx",       "ny",       "nz",
    "speed",  "fx",      "fy",      "fz",      "tx",       "ty",       "tz",       "contacts",
    "micros", "proxy_x", "proxy_y", "proxy_z", "proxy_qw", "proxy_qx", "proxy_qy", "proxy_qz"};

}  // namespace

Expected<TickCsv> TickCsv::create(const std::filesystem::path& path) {
    Expected<CsvWriter> file = CsvWriter::create(path, kColumns);
    if (!file) return Unexpected{file.error()};
    return TickCsv(std::move(*file));
}

void TickCsv::write(double time, const Tick& tick) {
    const Tick::Contact& contact = tick.contact;
    const Vec3 &hand = tick.input.device.position, &proxy = contact.proxy.position;
    const Quat& turn = contact.proxy.rotation;
    const auto& [force, torque] = tick.force.wrench;
    const double speed = tick.input.speed, micros = tick.diagnostics.micros;
    const std::array<double, kColumns.size()> row = {
        time,          hand.x(),           hand.y(),           hand.z(),
        contact.depth, contact.normal.x(), contact.normal.y(), contact.normal.z(),
        speed,         force.x(),          force.y(),          force.z(),
        torque.x(),    torque.y(),         torque.z(),         double(contact.triangles),
        micros,        proxy.x(),          proxy.y(),          proxy.z(),
        turn.w(),      turn.x(),           turn.y(),           turn.z()};
    file_.row(row);
}

}  // namespace tactooth
