// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "assessment/exercise.h"
#include "instruments/bur_catalogue.h"
#include "session/io/toml_reader.h"

namespace tactooth {

/// The place of a word in the list of those that a key may have.
template <std::size_t N>
std::size_t choice(TomlReader& toml, const toml::table& table, std::string_view key,
                   const std::array<std::string_view, N>& words, const MessageText& mistake, std::size_t fallback) {
    const std::string word = toml.text(table, key, false);
    if (word.empty()) return fallback;
    const auto* const known = std::ranges::find(words, word);
    if (known != words.end()) return static_cast<std::size_t>(known - words.begin());
    toml.fail(*table.get(key), mistake);
    return fallback;
}

/// The key 'side' of a table: out of the tooth, unit.
[[nodiscard]] Vec3 sideIn(TomlReader& toml, const toml::table& table, double mesialX);
/// The place that a key has, near the tooth.
[[nodiscard]] Vec3 placeIn(TomlReader& toml, const toml::table& table, std::string_view key);
/// The list of places that a key has, `least` to `most` of them, near the tooth; `mistake` takes `most`.
[[nodiscard]] std::vector<Vec3> placesIn(TomlReader& toml, const toml::table& table, std::string_view key,
                                         std::size_t least, std::size_t most, const MessageText& mistake);
/// The key 'corners' of a table: a closed outline that does not cross itself, seen along `outward`.
[[nodiscard]] std::vector<Vec3> cornersIn(TomlReader& toml, const toml::table& table, const Vec3& outward);

/// Reads the table [cavity] of an exercise.
class PlanReader {
public:
    /// `bur`: nothing for one from a file. Both others outlive the reader.
    PlanReader(TomlReader& toml, const std::variant<ToothRequest, ToothSource>& tooth, std::optional<BurSpec> bur);

    [[nodiscard]] PreparationPlan read(const toml::table& cavity);

private:
    void readFissure(const toml::table& table, PreparationPlan& plan);
    void readOutline(const toml::table& table, PreparationPlan& plan);
    void readBody(const toml::table& table, PreparationPlan& plan);
    [[nodiscard]] std::optional<Vec3> openSide(const toml::table& table, const PreparationPlan& plan);
    [[nodiscard]] std::optional<CrownOutline> readCrown(const toml::table& table);
    void readBoxes(const std::vector<const toml::table*>& boxes, PreparationPlan& plan);
    [[nodiscard]] ProximalBox box(const toml::table& table);
    [[nodiscard]] PreparationPlan::Stroke stroke(const toml::table& table);

    TomlReader& toml_;
    const std::variant<ToothRequest, ToothSource>& tooth_;
    std::optional<BurSpec> bur_;
    double mesialX_;
};

}  // namespace tactooth
