// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Replaces vdb_file.cpp in builds without OpenVDB.
#include "session/io/vdb_file.h"

namespace tactooth {

Expected<void> checkVdb() {
    return unexpected(
        "this program was built without OpenVDB and cannot write .vdb files: install OpenVDB (Debian: libopenvdb-dev) "
        "and build it again.");
}

Expected<void> writeVdb(const CutVolume&, const Provenance&, const std::filesystem::path&) { return checkVdb(); }

}  // namespace tactooth
