// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/toml_reader.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/display_text.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"
#include "session/io/limited_toml.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

constexpr std::size_t kLongestText = 2000;  // bytes

std::string quoted(std::string_view key) { return quotedWord(key); }

}  // namespace

bool isPlainText(const std::string& text) { return text.size() <= kLongestText && isShownAsItIs(text); }

Message describedToml(const toml::node& node) {
    if (const auto* integer = node.as_integer()) return Message::verbatim(std::to_string(integer->get()));
    if (const auto* number = node.as_floating_point()) {
        if (!std::isfinite(number->get())) return msg::kNotFiniteNumber;
        return Message::verbatim(numberText(number->get()));
    }
    if (node.is_string()) return msg::kTextInQuotes;
    if (node.is_boolean()) return msg::kTrueOrFalse;
    if (node.is_array()) return msg::kAList;
    if (node.is_table()) return msg::kATable;
    return msg::kDateOrTime;
}

toml::table TomlReader::parse(std::string_view text) {
    Expected<toml::table> table = parseToml(text, name_);
    if (table) return std::move(*table);
    if (!error_) error_ = table.error();
    return {};
}

void TomlReader::failAt(toml::source_index line, const Message& what) {
    if (!error_) error_ = Error{msg::kAtLine, name_, line, what};
}

void TomlReader::fail(const toml::node& where, const Message& what) { failAt(where.source().begin.line, what); }

void TomlReader::fail(const toml::key& where, const Message& what) { failAt(where.source().begin.line, what); }

std::optional<double> TomlReader::numberOf(const toml::node& node, std::string_view key, double low, double high) {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (value && *value >= low && *value <= high) return value;
    fail(node, {msg::kKeyTakesNumber, quoted(key), numberText(low), numberText(high), describedToml(node)});
    return std::nullopt;
}

std::optional<int> TomlReader::integerOf(const toml::node& node, std::string_view key, int low, int high) {
    const auto value = node.value_exact<std::int64_t>();
    if (value && *value >= low && *value <= high) return static_cast<int>(*value);
    fail(node, {msg::kKeyTakesWholeNumber, quoted(key), low, high, describedToml(node)});
    return std::nullopt;
}

std::optional<std::string> TomlReader::textOf(const toml::node& node, std::string_view key) {
    auto value = node.value_exact<std::string>();
    if (value && isPlainText(*value)) return value;
    fail(node, {msg::kKeyTakesText, quoted(key)});
    return std::nullopt;
}

void TomlReader::allow(const toml::table& table, const MessageText& what,
                       std::initializer_list<std::string_view> keys) {
    for (auto&& [key, node] : table) {
        if (std::ranges::find(keys, key.str()) != keys.end()) continue;
        std::string list;
        for (const std::string_view known : keys) list.append(list.empty() ? "" : ", ").append(known);
        failAt(key.source().begin.line, {msg::kUnknownKey, what, quoted(key.str()), list});
    }
}

std::string TomlReader::text(const toml::table& table, std::string_view key, bool isNeeded) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        if (isNeeded) fail(table, {msg::kKeyMissing, key});
        return {};
    }
    const auto value = textOf(*node, key);
    if (!value) return {};
    if (isNeeded && value->empty()) fail(*node, {msg::kKeyEmpty, key});
    return *value;
}

std::vector<std::string> TomlReader::texts(const toml::table& table, std::string_view key) {
    std::vector<std::string> result;
    const toml::node* node = table.get(key);
    if (node == nullptr) return result;
    const toml::array* list = node->as_array();
    if (list == nullptr) {
        fail(*node, {msg::kKeyTakesTexts, quoted(key)});
        return result;
    }
    for (const toml::node& each : *list) {
        const auto value = each.value_exact<std::string>();
        if (!value || !isPlainText(*value)) {
            fail(each, {msg::kKeyTakesLines, quoted(key)});
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
    fail(*node, {msg::kKeyTakesFlag, quoted(key)});
    return fallback;
}

void TomlReader::numbers(const toml::table& table, std::string_view key, std::span<double> values) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    const Message wanted(msg::kKeyTakesNumbers, quoted(key), values.size());
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
        fail(*node, {msg::kKeyTakesTables, key, key});
        return {};
    }
    return result;
}

const toml::table* TomlReader::table(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return nullptr;
    if (node->as_table() == nullptr) fail(*node, {msg::kKeyTakesTable, quoted(key)});
    return node->as_table();
}

}  // namespace tactooth
