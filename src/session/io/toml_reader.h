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

/// Takes values out of a TOML file that a person wrote, until something is wrong: the first mistake is kept as one
/// sentence with file and line, and from then on every answer is a default.
class TomlReader {
public:
    /// `name` stands for the file in messages.
    explicit TomlReader(std::string_view name) : name_(name) {}

    /// The text as parseToml takes it; empty after a mistake.
    [[nodiscard]] toml::table parse(std::string_view text);

    /// Refuses every key that is not in the list. `what`: "a tooth".
    void allow(const toml::table& table, std::string_view what, std::initializer_list<std::string_view> keys);

    [[nodiscard]] std::string text(const toml::table& table, std::string_view key, bool isNeeded);
    [[nodiscard]] std::vector<std::string> texts(const toml::table& table, std::string_view key);
    [[nodiscard]] double number(const toml::table& table, std::string_view key, double fallback, double low,
                                double high);
    [[nodiscard]] int integer(const toml::table& table, std::string_view key, int fallback, int low, int high);
    [[nodiscard]] bool flag(const toml::table& table, std::string_view key, bool fallback);
    /// `values` stays as it is if the key is not there.
    void numbers(const toml::table& table, std::string_view key, std::span<double> values);
    /// The tables below [[key]].
    [[nodiscard]] std::vector<const toml::table*> tables(const toml::table& table, std::string_view key);
    /// The table below [key] or in braces; null if there is none.
    [[nodiscard]] const toml::table* table(const toml::table& table, std::string_view key);

    /// What a node says; none, and a mistake, if it is something else. `key` names it in messages.
    [[nodiscard]] std::optional<double> numberOf(const toml::node& node, std::string_view key, double low, double high);
    [[nodiscard]] std::optional<int> integerOf(const toml::node& node, std::string_view key, int low, int high);
    [[nodiscard]] std::optional<std::string> textOf(const toml::node& node, std::string_view key);

    /// Keeps a mistake, if it is the first.
    void fail(const toml::node& where, const std::string& what);
    void fail(const toml::key& where, const std::string& what);

    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

private:
    void failAt(toml::source_index line, const std::string& what);

    std::string name_;
    std::optional<Error> error_;
};

/// What a message says that it found: "-0.5", "a text in quotes", "a list".
[[nodiscard]] std::string describedToml(const toml::node& node);

/// Whether a message or a menu can show a text as it is: one line, not too long, no control characters.
[[nodiscard]] bool isPlainText(const std::string& text);

}  // namespace tactooth
