// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/toml_reader.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/display_text.h"
#include "geometry/util/number_text.h"
#include "session/io/limited_toml.h"

namespace tactooth {
namespace {

constexpr std::size_t kLongestText = 2000;  // bytes

std::string quoted(std::string_view key) { return quotedWord(key); }

}  // namespace

bool isPlainText(const std::string& text) { return text.size() <= kLongestText && isShownAsItIs(text); }

std::string describedToml(const toml::node& node) {
    if (const auto* integer = node.as_integer()) return std::to_string(integer->get());
    if (const auto* number = node.as_floating_point()) {
        if (!std::isfinite(number->get())) return "not a finite number";
        return numberText(number->get());
    }
    if (node.is_string()) return "a text in quotes";
    if (node.is_boolean()) return "true or false";
    if (node.is_array()) return "a list";
    if (node.is_table()) return "a table";
    return "a date or a time";
}

toml::table TomlReader::parse(std::string_view text) {
    Expected<toml::table> table = parseToml(text, name_);
    if (table) return std::move(*table);
    if (!error_) error_ = table.error();
    return {};
}

void TomlReader::failAt(toml::source_index line, const std::string& what) {
    if (!error_) error_ = Error{name_ + ", line " + std::to_string(line) + ": " + what + "."};
}

void TomlReader::fail(const toml::node& where, const std::string& what) { failAt(where.source().begin.line, what); }

void TomlReader::fail(const toml::key& where, const std::string& what) { failAt(where.source().begin.line, what); }

std::optional<double> TomlReader::numberOf(const toml::node& node, std::string_view key, double low, double high) {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (value && *value >= low && *value <= high) return value;
    fail(node, quoted(key) + " must be a number from " + numberText(low) + " to " + numberText(high) + ", but is " +
                   describedToml(node));
    return std::nullopt;
}

std::optional<int> TomlReader::integerOf(const toml::node& node, std::string_view key, int low, int high) {
    const auto value = node.value_exact<std::int64_t>();
    if (value && *value >= low && *value <= high) return static_cast<int>(*value);
    fail(node, quoted(key) + " must be a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
                   ", but is " + describedToml(node));
    return std::nullopt;
}

std::optional<std::string> TomlReader::textOf(const toml::node& node, std::string_view key) {
    auto value = node.value_exact<std::string>();
    if (value && isPlainText(*value)) return value;
    fail(node, quoted(key) + " must be a text of one line in quotes");
    return std::nullopt;
}

void TomlReader::allow(const toml::table& table, std::string_view what, std::initializer_list<std::string_view> keys) {
    for (auto&& [key, node] : table) {
        if (std::ranges::find(keys, key.str()) != keys.end()) continue;
        std::string list;
        for (const std::string_view known : keys) list.append(list.empty() ? "" : ", ").append(known);
        failAt(key.source().begin.line,
               std::string(what) + " has no key " + quoted(key.str()) + "; the keys are " + list);
    }
}

std::string TomlReader::text(const toml::table& table, std::string_view key, bool isNeeded) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        if (isNeeded) fail(table, "the key '" + std::string(key) + "' is missing");
        return {};
    }
    const auto value = textOf(*node, key);
    if (!value) return {};
    if (isNeeded && value->empty()) fail(*node, "the key '" + std::string(key) + "' is empty");
    return *value;
}

std::vector<std::string> TomlReader::texts(const toml::table& table, std::string_view key) {
    std::vector<std::string> result;
    const toml::node* node = table.get(key);
    if (node == nullptr) return result;
    const toml::array* list = node->as_array();
    if (list == nullptr) {
        fail(*node, quoted(key) + " must be a list of texts");
        return result;
    }
    for (const toml::node& each : *list) {
        const auto value = each.value_exact<std::string>();
        if (!value || !isPlainText(*value)) {
            fail(each, quoted(key) + " must be a list of texts of one line in quotes");
            return {};
        }
        result.push_back(*value);
    }
    return result;
}

double TomlReader::number(const toml::table& table, std::string_view key, double fallback, double low, double high) {
    const toml::node* node = table.get(key);
    return node != nullptr ? numberOf(*node, key, low, high).value_or(fallback) : fallback;
}

int TomlReader::integer(const toml::table& table, std::string_view key, int fallback, int low, int high) {
    const toml::node* node = table.get(key);
    return node != nullptr ? integerOf(*node, key, low, high).value_or(fallback) : fallback;
}

bool TomlReader::flag(const toml::table& table, std::string_view key, bool fallback) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return fallback;
    if (const auto value = node->value_exact<bool>()) return *value;
    fail(*node, quoted(key) + " must be true or false");
    return fallback;
}

void TomlReader::numbers(const toml::table& table, std::string_view key, std::span<double> values) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    const std::string wanted = quoted(key) + " must be a list of " + std::to_string(values.size()) + " numbers";
    if (list == nullptr || list->size() != values.size()) return fail(*node, wanted);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const toml::node& each = *list->get(i);
        const std::optional<double> value = each.is_number() ? each.value<double>() : std::nullopt;
        if (!value || !std::isfinite(*value)) return fail(each, wanted);
        values[i] = *value;
    }
}

std::vector<const toml::table*> TomlReader::tables(const toml::table& table, std::string_view key) {
    std::vector<const toml::table*> result;
    const toml::node* node = table.get(key);
    if (node == nullptr) return result;
    const toml::array* list = node->as_array();
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) result.push_back(list->get(i)->as_table());
    if (list == nullptr || std::find(result.begin(), result.end(), nullptr) != result.end()) {
        fail(*node, "begin each " + std::string(key) + " with a line [[" + std::string(key) + "]]");
        return {};
    }
    return result;
}

const toml::table* TomlReader::table(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return nullptr;
    if (node->as_table() == nullptr) fail(*node, quoted(key) + " must be a list of names and values in braces");
    return node->as_table();
}

}  // namespace tactooth
