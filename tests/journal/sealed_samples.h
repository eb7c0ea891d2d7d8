// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "journal/codec/signing_key.h"
#include "journal/format/journal_block.h"

namespace tactooth::test {

/// The same key pair for each number.
[[nodiscard]] std::shared_ptr<const SigningKey> sampleKey(unsigned number);

/// A header that names the key, as the session writes it.
[[nodiscard]] std::string sealedHeader(const SigningKey& key);

/// The bytes of a sealed recording of these blocks, with its end or without it. There is a sync, and so a signature,
/// after each third block.
[[nodiscard]] std::vector<std::byte> sealedBytes(std::span<const JournalBlock> blocks, bool hasEnd,
                                                 const std::shared_ptr<const SigningKey>& key);

}  // namespace tactooth::test
