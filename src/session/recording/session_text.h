// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"
#include "journal/codec/signing_key.h"
#include "session/simulation/tooth_file.h"

// What a recording says besides events and settings: the header, the bodies around the tooth, and the end.

namespace tactooth {

/// Name of the attachment with the bytes of the tooth's file.
inline constexpr std::string_view kToothAttachment = "tooth.tactooth";
/// Name of the attachment with the surface of a session that only touches (LayeredTooth::touchOnly).
inline constexpr std::string_view kTouchedAttachment = "touched-surface";
[[nodiscard]] std::vector<std::byte> touchedBytes(const LayeredTooth& tooth);
/// Nothing for bytes of another form. `materials`: what the tags mean.
[[nodiscard]] std::optional<LayeredTooth> touchedOf(std::span<const std::byte> content,
                                                    const MaterialRegistry& materials);

/// Name of the attachment with the description of the work (workText), the first of which is number 0.
[[nodiscard]] std::string workAttachment(std::size_t index);
/// Name of the attachment with a body around the tooth.
[[nodiscard]] std::string surroundingAttachment(std::size_t index);

[[nodiscard]] std::vector<std::byte> surroundingBytes(const SurfacePart& body);
/// Bit for bit the body that it was made of; null for bytes of another form.
[[nodiscard]] std::shared_ptr<const SurfacePart> surroundingOf(std::span<const std::byte> content);

/// Which part of a session a recording holds. A session whose recording stops goes on in another one, the next part.
struct RecordingPart {
    std::string session = {};  ///< the same in all parts, and in no other session; empty: the recording is alone
    std::uint32_t number = 1;  ///< from 1
};
/// The first part of a new session.
[[nodiscard]] RecordingPart firstPart();

/// Facts of the header.
struct RecordingFacts {
    std::string title;  ///< of the tooth
    std::string commit, compiler, machine, date;
    bool touchesOnly = false;                     ///< the surface is attached, and no tooth that can be cut
    std::size_t surroundings = 0;                 ///< number of bodies around the tooth
    const MaterialRegistry* materials = nullptr;  ///< of the tooth
    bool isSealed = false;                        ///< the header says that the recording is signed
    std::optional<PublicKey> sealKey;             ///< by the owner of this key; none if that is damaged
    RecordingPart part;
};
/// The header's JSON text. `seal`: of the key that signs the recording; null: it is not sealed.
[[nodiscard]] std::string recordingHeader(const CutModel& model, const std::string& title,
                                          const PublicKey* seal = nullptr, const RecordingPart& part = {});
/// The header of a changed copy of a sealed recording: nobody has signed that, and it names the key in another place.
/// Nothing if the recording is not sealed.
[[nodiscard]] std::optional<std::string> unsealedHeader(const std::string& json);
/// The part that a header names; of a recording that is alone if it names none, or is damaged.
[[nodiscard]] RecordingPart partOf(const std::string& headerJson);
/// Fails with one sentence; `file` stands for the recording in it.
[[nodiscard]] Expected<RecordingFacts> parseHeader(const std::string& json, const std::string& file);

/// The last note of a recording.
struct RecordedEnd {
    std::optional<std::uint64_t> toothHash = {};  ///< of the cut tooth; nothing if the events do not lead to it
    bool hasGap = false;                          ///< it ends in mid-session: what came later is missing
};
[[nodiscard]] std::string endText(const RecordedEnd& end);
/// Nothing for another text.
[[nodiscard]] std::optional<RecordedEnd> parseEnd(const std::string& json);

}  // namespace tactooth
