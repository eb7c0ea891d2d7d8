// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the service of a haptic device sends: it is refused with a sentence, or the hand is at a place.
#include "devices/haply/haply_message.h"
#include "fuzz/fuzz_target.h"

namespace tactooth::test {
namespace {

void requireWords(const Error& error) {
    const std::string sentence = error.message();
    require(sentence.size() > 20 && sentence.ends_with('.') && sentence.size() < 1000, "a refusal is a sentence");
}

bool accepts(std::span<const std::byte> bytes) {
    const std::string_view text = asText(bytes);
    const auto devices = haplyDevices(text);
    if (!devices) requireWords(devices.error());
    if (devices) require(!devices->empty(), "a list of devices has one");
    const auto reading = readHaply(text, {"049D", "61576"});
    if (!reading) return requireWords(reading.error()), devices.has_value();
    require(reading->hand.position.allFinite() || !reading->usable, "a usable hand is at a place");
    require(reading->hand.rotation.coeffs().allFinite() || !reading->usable, "a usable hand has a rotation");
    return true;
}

const AddFuzzTarget added({"message", accepts, 0.02});  // JSON forgives nothing

}  // namespace
}  // namespace tactooth::test
