// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "instruments/bur_shape.h"

namespace tactooth {

/// Either `list`, or `number` with `out`.
struct BurOptions {
    std::string number;
    std::filesystem::path out;
    int triangles = kContactBurTriangles;
    bool list = false;
};

/// Writes a bur of the catalogue as STL, or lists the catalogue.
[[nodiscard]] int runBur(const BurOptions& options);

struct InstrumentOptions {
    std::string name;
    std::filesystem::path out;
    int triangles = 16000;  ///< of the turbine handpiece
};

/// Writes one of the program's other instruments as STL.
[[nodiscard]] int runInstrument(const InstrumentOptions& options);

}  // namespace tactooth
