// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal/number_range.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <optional>

#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

/// The rejected text for the error message: numbers unchanged, other text in quotes.
std::string found(const std::string& text) {
    constexpr std::size_t kLongest = 24;
    const bool isNumber = toNumber<double>(text).has_value() && text.size() <= kLongest;
    return text.empty() ? "empty" : isNumber ? text : quotedWord(text);
}

/// Writes a limit as a person does: 1000000, not 1e+06.
std::string limitText(double limit) {
    return limit == std::trunc(limit) ? std::to_string(std::llround(limit)) : numberText(limit);
}

CLI::Validator checker(const std::string& kind, const std::string& range,
                       const std::function<std::optional<std::string>(const std::string&)>& taken) {
    const auto check = [kind, range, taken](std::string& text) -> std::string {
        if (const std::optional<std::string> value = taken(text)) {
            text = *value;
            return {};
        }
        return "must be a " + kind + " from " + range + ", but is " + found(text);
    };
    return {check, range};
}

}  // namespace

CLI::Validator numberFrom(double low, double high) {
    const auto taken = [low, high](const std::string& text) -> std::optional<std::string> {
        const std::optional<double> value = toNumber<double>(text);
        if (!value || !(*value >= low && *value <= high)) return std::nullopt;
        return numberText(*value);
    };
    return checker("number", limitText(low) + " to " + limitText(high), taken);
}

CLI::Validator wholeNumberFrom(std::int64_t low, std::int64_t high) {
    const auto taken = [low, high](const std::string& text) -> std::optional<std::string> {
        std::int64_t value = 0;
        const bool hasPlus = text.size() > 1 && text[0] == '+' && text[1] != '-';  // std::from_chars accepts no '+'
        const char* end = text.data() + text.size();
        const auto [stop, failure] = std::from_chars(text.data() + (hasPlus ? 1 : 0), end, value);
        if (stop != end || failure != std::errc() || value < low || value > high) return std::nullopt;
        return std::to_string(value);
    };
    return checker("whole number", std::to_string(low) + " to " + std::to_string(high), taken);
}

}  // namespace tactooth
