// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"

namespace tactooth {

/// Reads values of a TOML file. It keeps the first mistake as one sentence with file and line. After a mistake it still
/// returns values or defaults, so that callers check once, at the end.
class TomlReader {
public:
    /// `name` stands for the file in messages.
    explicit TomlReader(std::string_view name) : name_(name) {}

    /// Parses a text by parseToml; returns an empty table after a mistake.
    [[nodiscard]] toml::table parse(std::string_view text);

    /// Reports a mistake for each key that is not in the list. `what` names the table in the message: "a tooth".
    void allow(const toml::table& table, const MessageText& what, std::initializer_list<std::string_view> keys);

    [[nodiscard]] std::string text(const toml::table& table, std::string_view key, bool isNeeded);
    [[nodiscard]] std::vector<std::string> texts(const toml::table& table, std::string_view key);
    [[nodiscard]] double number(const toml::table& table, std::string_view key, double fallback, double low,
                                double high);
    [[nodiscard]] int integer(const toml::table& table, std::string_view key, int fallback, int low, int high);
    [[nodiscard]] bool flag(const toml::table& table, std::string_view key, bool fallback);
    /// Leaves `values` unchanged if the key is missing.
    void numbers(const toml::table& table, std::string_view key, std::span<double> values);
    /// The tables of [[key]].
    [[nodiscard]] std::vector<const toml::table*> tables(const toml::table& table, std::string_view key);
    /// The table of [key] or in braces; null if the key is missing.
    [[nodiscard]] const toml::table* table(const toml::table& table, std::string_view key);

    /// The value of a node; nothing, and a mistake, if it has another type or range. `key` names it in messages.
    [[nodiscard]] std::optional<double> numberOf(const toml::node& node, std::string_view key, double low, double high);
    [[nodiscard]] std::optional<int> integerOf(const toml::node& node, std::string_view key, int low, int high);
    [[nodiscard]] std::optional<std::string> textOf(const toml::node& node, std::string_view key);

    /// Reports a mistake; only the first one is kept.
    void fail(const toml::node& where, const Message& what);
    void fail(const toml::key& where, const Message& what);

    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

private:
    void failAt(toml::source_index line, const Message& what);

    std::string name_;
    std::optional<Error> error_;
};

/// Describes a node for a message: "-0.5", "a text in quotes", "a list".
[[nodiscard]] Message describedToml(const toml::node& node);

/// Whether a text can be shown as it is: one line of at most 2000 bytes without control characters.
[[nodiscard]] bool isPlainText(const std::string& text);

}  // namespace tactooth
