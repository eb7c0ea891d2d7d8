// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Replaces vdb_file.cpp in builds without OpenVDB.
#include "session/io/messages.h"
#include "session/io/vdb_file.h"

namespace tactooth {

Expected<void> checkVdb() { return unexpected(msg::kNoOpenVdb); }

Expected<void> writeVdb(const CutVolume&, const Provenance&, const std::filesystem::path&) { return checkVdb(); }

}  // namespace tactooth
