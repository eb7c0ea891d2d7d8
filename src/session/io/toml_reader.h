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
    void allow(const toml::table& table, const MessageText& what, std::initializer_list<std::string_view> keys);

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

    /// Keeps a mistake, if it is the first.
    void fail(const toml::node& where, const Message& what);

    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

private:
    void failAt(toml::source_index line, const Message& what);

    std::string name_;
    std::optional<Error> error_;
};

}  // namespace tactooth
