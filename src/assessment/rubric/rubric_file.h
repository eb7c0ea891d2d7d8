// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "assessment/rubric/rubric.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Reads a rubric (TOML, docs/assessment.md). `name` stands for the file in messages. Fails with one sentence that
/// names the line.
[[nodiscard]] Expected<Rubric> parseRubric(std::string_view text, const std::string& name);
/// The same from a file.
[[nodiscard]] Expected<Rubric> readRubric(const std::filesystem::path& file);

/// A rubric as TOML that parseRubric reads back as the same, with numbers in their shortest exact form.
[[nodiscard]] std::string rubricText(const Rubric& rubric);

/// One file of data/rubrics/, which is built into the program.
struct BuiltinRubricText {
    const char* name;  ///< without the ending .toml: "class-1"
    const char* text;
};
[[nodiscard]] std::span<const BuiltinRubricText> builtinRubricTexts();
/// Their names, with commas between.
[[nodiscard]] std::string builtinRubricNames();

/// The rubric of an exercise that names none.
inline constexpr std::string_view kUsualRubric = "near-ideal";

/// A built-in rubric by its name, or a file.
[[nodiscard]] Expected<Rubric> findRubric(const std::string& nameOrFile);

}  // namespace tactooth
