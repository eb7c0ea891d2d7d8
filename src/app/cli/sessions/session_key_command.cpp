// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/session_key_command.h"

#include <nlohmann/json.hpp>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/file_bytes.h"
#include "session/recording/station_key.h"

namespace tactooth {

int runSessionKey(const SessionKeyOptions& options) {
    const Expected<StationKey> station = openStationKey();
    if (!station) return reportError(station.error());
    const std::string key = keyText(station->key->publicKey());
    if (options.json) {
        const nlohmann::ordered_json json = {
            {"public_key", key}, {"file", displayName(station->file)}, {"new", station->isNew}};
        print("{}\n", json.dump(2));
        return kExitOk;
    }
    print("public key: {}\n", key);
    print("kept in:    {}{}\n", displayName(station->file), station->isNew ? " (made just now)" : "");
    return kExitOk;
}

}  // namespace tactooth
