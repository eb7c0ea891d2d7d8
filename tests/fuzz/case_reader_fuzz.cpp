// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of cases refuses them with a sentence, or gives a tooth whose surfaces are valid. The
// bytes are tried as an archive, and as the description in an archive that is sound.
#include "fuzz/fuzz_target.h"
#include "fuzz/small_surface.h"
#include "session/cases/open_case.h"

namespace tactooth::test {
namespace {

bool isOpened(std::span<const std::byte> bytes) {
    const auto store = CaseStore::openArchive(bytes, "fuzz");
    const auto opened = store ? openCase(*store) : Expected<OpenedCase>(Unexpected{store.error()});
    if (!opened) return requireSentence(opened.error(), 1000), false;
    requireValid(opened->teeth->outer()->mesh());
    require(parseCase(caseText(opened->description), "fuzz").has_value(),
            "what was read can be written and read again");
    return true;
}

bool accepts(std::span<const std::byte> bytes) {
    const bool isArchive = isOpened(bytes);
    const auto packed = packCase({{"case.toml", {bytes.begin(), bytes.end()}}, {"a.stl", smallSurface()}});
    require(packed.has_value(), "any text can be packed");
    const bool isDescription = isOpened(*packed);
    return isArchive || isDescription;
}

const AddFuzzTarget added({"case", accepts});

}  // namespace
}  // namespace tactooth::test
