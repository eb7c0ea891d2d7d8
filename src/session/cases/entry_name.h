// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "geometry/util/message.h"

namespace tactooth {

/// Faults of the name of a file in a case.
enum class EntryFault { None, NoFile, PathTraversal, ControlCharacter, TooLong };

/// The name of a file in a case, in its canonical form.
struct EntryName {
    std::string name;  ///< parts with '/' between them, composed (NFC); empty with a fault
    EntryFault fault = EntryFault::None;
};

/// Reads a name as archives and people write it: with '/' or the '\' of old Windows tools, perhaps with "./" before it,
/// and composed or not. A name with "..", an absolute name or a drive points out of the case.
[[nodiscard]] EntryName entryName(std::string_view written);

/// Whether `path` stays inside the case and can name a file.
[[nodiscard]] bool isSafeEntry(std::string_view path);

/// Describes the fault of `name`: a sentence without its full stop.
[[nodiscard]] Message inWords(EntryFault fault, const std::string& name);

/// Whether a system has put a file beside the user's: a hidden file ("." first, as "._36.stl" of macOS), "Thumbs.db"
/// and the like. `name` is without folders.
[[nodiscard]] bool isSystemFile(std::string_view name);

/// The same for a path with '/': whether the file or one of its folders is a system's.
[[nodiscard]] bool isSystemEntry(std::string_view path);

}  // namespace tactooth
