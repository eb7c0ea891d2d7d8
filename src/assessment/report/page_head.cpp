// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/page_head.h"

#include <fmt/core.h>

#include "assessment/report/table_text.h"

namespace tactooth {

std::string pageHead(std::string_view title, std::string_view style, Language language) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\"><title>{}</title>\n"
        "<style>body {{ font-family: {} }}{}</style></head><body>\n",
        language == Language::Japanese ? "ja" : "en", htmlText(title), kPageFonts, style);
}

}  // namespace tactooth
