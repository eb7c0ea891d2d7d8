// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/experiment.h"

#include <charconv>
#include <cmath>

#include "geometry/files/atomic_file.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

std::string textOf(const Cell& cell) {
    if (const auto* number = std::get_if<double>(&cell)) return numberText(*number);
    const auto& text = std::get<std::string>(cell);
    if (text.find_first_of(",\"\n") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted.append(c == '"' ? "\"\"" : std::string(1, c));
    return quoted + '"';
}

}  // namespace

Expected<void> writeExperimentCsv(const Experiment& experiment, const std::filesystem::path& path) {
    auto file = AtomicFile::create(path);
    if (!file) return Unexpected{file.error()};
    std::string line;
    for (const std::string& column : experiment.columns) line.append(line.empty() ? "" : ",").append(column);
    file->write(line + "\n");
    for (const std::vector<Cell>& row : experiment.rows) {
        line.clear();
        for (std::size_t i = 0; i < row.size(); ++i) line.append(i == 0 ? "" : ",").append(textOf(row[i]));
        file->write(line + "\n");
    }
    return file->commit();
}

std::string shortNumber(double value) {
    constexpr int kDigits = 3;
    if (!std::isfinite(value)) return "none";
    const int before = value == 0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    const double unit = std::pow(10.0, before - kDigits);
    const double rounded = value == 0 ? 0 : std::round(value / unit) * unit;
    std::array<char, 400> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), rounded, std::chars_format::fixed,
                                   std::max(0, kDigits - before))
                         .ptr;
    std::string text(digits.data(), end);
    if (text.find('.') != text.npos) text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

}  // namespace tactooth
