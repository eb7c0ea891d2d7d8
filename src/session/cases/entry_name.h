// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "geometry/util/message.h"

namespace tactooth {

/// What may be wrong with the name of a file in a case.
enum class EntryFault { None, NoFile, PathTraversal, ControlCharacter, TooLong };

/// The name of a file in a case, as it was written and as it is looked for.
struct EntryName {
    std::string name;  ///< parts with '/' between them, composed (NFC); empty with a fault
    EntryFault fault = EntryFault::None;
};

/// Reads a name as archives and people write it: with '/' or the '\' of old Windows tools, perhaps with "./" before it,
/// its letters composed or not. Only what leads out of the case points out of it: "..", absolute names, names of
/// drives.
[[nodiscard]] EntryName entryName(std::string_view written);

/// Whether `path` (in a case) stays inside it and can be the name of a file.
[[nodiscard]] bool isSafeEntry(std::string_view path);

/// What is wrong with `name`, as a sentence without its full stop.
[[nodiscard]] Message inWords(EntryFault fault, const std::string& name);

/// Whether a file is none of its owner's but put beside others by a system: hidden (a name that begins with '.', as the
/// Mac's "._36.stl"), or "Thumbs.db" and the like. `name` is that of the file alone.
[[nodiscard]] bool isSystemFile(std::string_view name);

/// The same for a path with '/': whether it or a folder of it is foreign.
[[nodiscard]] bool isSystemEntry(std::string_view path);

}  // namespace tactooth
