// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tactooth {

/// The circumstances of a measurement.
struct RunMetadata {
    std::string machine;   ///< processor and number of cores
    std::string compiler;  ///< with its version, the kind of build and the vector instructions
    std::string commit;    ///< of the sources; "unknown" outside a repository
    std::string command;   ///< command line
    std::string date;      ///< UTC, ISO 8601
};

[[nodiscard]] RunMetadata currentRunMetadata();

}  // namespace tactooth
