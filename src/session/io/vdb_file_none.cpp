// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Stands in for vdb_file.cpp where there is no OpenVDB to build with.
#include "session/io/messages.h"
#include "session/io/vdb_file.h"

namespace tactooth {

Expected<void> checkVdb() { return unexpected(msg::kNoOpenVdb); }

Expected<void> writeVdb(const CutVolume&, const Provenance&, const std::filesystem::path&) { return checkVdb(); }

}  // namespace tactooth
