// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "geometry/util/expected.h"
#include "journal/codec/signing_key.h"

namespace tactooth {

/// The key pair of this station, a computer of a school: it signs sealed recordings. Its secret half is in a file that
/// only this user can read, and is shown to nobody.
struct StationKey {
    std::shared_ptr<const SigningKey> key;
    std::filesystem::path file;
    bool isNew = false;  ///< it was made just now
};

/// Where the key is kept: $XDG_DATA_HOME/tactooth/station.key, else ~/.local/share/tactooth/station.key. Empty if
/// neither is known.
[[nodiscard]] std::filesystem::path stationKeyFile();

/// Reads the key of the station, or makes it at its first use; several programs that do so at once get the same one.
/// Fails with one sentence if the file is damaged, other users can read it, or it cannot be written; a damaged file is
/// never replaced.
[[nodiscard]] Expected<StationKey> openStationKey(const std::filesystem::path& file = stationKeyFile());

/// The public key of the station, if there is one that can be read. Makes none.
[[nodiscard]] std::optional<PublicKey> knownStationKey(const std::filesystem::path& file = stationKeyFile());

}  // namespace tactooth
