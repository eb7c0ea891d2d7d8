// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/settings/window_settings.h"

#include <toml++/toml.h>

#include <QStandardPaths>
#include <optional>
#include <sstream>
#include <utility>

#include "app/gui/text/messages.h"
#include "devices/open_device.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/system_reason.h"
#include "session/io/limited_toml.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

/// Reads values from a file; skips and reports an invalid one.
class SettingsReader {
public:
    SettingsReader(const toml::table& root, std::string_view name) : root_(root), name_(name) {}

    void text(const WindowOption& option, std::string& value) {
        const toml::node* found = node(option.table, option.key);
        if (found == nullptr) return;
        const auto* held = found->as_string();
        if (held == nullptr) {
            refuse(*found, option.key, msg::kTextInQuotes);
        } else if (!takesText(option, held->get())) {
            refuse(*found, option.key, {msg::kOneOfWords, option.words});
        } else {
            value = held->get();
        }
    }
    void yesOrNo(std::string_view table, std::string_view key, bool& value) {
        const toml::node* found = node(table, key);
        if (found == nullptr) return;
        if (const auto* held = found->as_boolean()) {
            value = held->get();
        } else {
            refuse(*found, key, msg::kTrueOrFalse);
        }
    }
    void number(const WindowOption& option, double& value) {
        const toml::node* found = node(option.table, option.key);
        if (found == nullptr) return;
        if (option.zero != nullptr && found->value<std::string_view>() == option.zero) {
            value = 0;
            return;
        }
        const std::optional<double> held = found->is_number() ? found->value<double>() : std::nullopt;
        if (held && *held >= option.lowest && *held <= option.highest) {
            value = *held;
            return;
        }
        const std::string lowest = shown(option.lowest), highest = shown(option.highest);
        refuse(*found, option.key,
               option.zero == nullptr ? Message(msg::kNumberFromTo, lowest, highest)
                                      : Message(msg::kNumberFromToOr, lowest, highest, option.zero));
    }
    [[nodiscard]] const std::vector<Error>& refused() const { return refused_; }

private:
    const toml::node* node(std::string_view table, std::string_view key) {
        const toml::node* section = root_.get(table);
        if (section == nullptr) return nullptr;
        if (!section->is_table()) {
            refuse(*section, table, msg::kATable);
            return nullptr;
        }
        return section->as_table()->get(key);
    }
    static std::string shown(double number) {
        std::ostringstream text;
        text << number;
        return text.str();
    }
    void refuse(const toml::node& node, std::string_view key, const Message& wanted) {
        // A value in place of a table is reported for each key of the table.
        const auto place = std::pair(node.source().begin.line, std::string(key));
        if (std::exchange(lastRefused_, place) == place) return;
        refused_.push_back({msg::kSettingRefused, name_, place.first, key, wanted});
    }

    const toml::table& root_;
    std::string_view name_;
    std::vector<Error> refused_;
    std::pair<toml::source_index, std::string> lastRefused_;  ///< line and key
};

ParsedSettings settingsFrom(const toml::table& root, std::string_view name) {
    SettingsReader reader(root, name);
    ParsedSettings settings;
    for (const WindowOption& option : windowOptions()) {
        if (const auto* text = std::get_if<WindowOption::Text>(&option.value)) {
            reader.text(option, (*text)(settings));
        } else if (const auto* on = std::get_if<WindowOption::Switch>(&option.value)) {
            reader.yesOrNo(option.table, option.key, (*on)(settings));
        } else {
            reader.number(option, std::get<WindowOption::Number>(option.value)(settings));
        }
    }
    settings.refused = reader.refused();
    return settings;
}

}  // namespace

std::filesystem::path windowSettingsFile() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation);
    return std::filesystem::path(folder.toStdString()) / "tactooth" / "window.toml";
}

Expected<ParsedSettings> parseWindowSettings(std::string_view text, std::string_view name) {
    const Expected<toml::table> root = parseToml(text, name);
    if (!root) return Unexpected{root.error()};
    return settingsFrom(*root, name);
}

std::string windowSettingsText(const WindowSettings& settings) {
    WindowSettings values = settings;
    toml::table root;
    for (const WindowOption& option : windowOptions()) {
        toml::table& table = *root.insert(option.table, toml::table{}).first->second.as_table();
        const auto* number = std::get_if<WindowOption::Number>(&option.value);
        if (option.zero != nullptr && number != nullptr && (*number)(values) == 0) {
            table.insert(option.key, option.zero);
        } else {
            std::visit([&](auto value) { table.insert(option.key, value(values)); }, option.value);
        }
    }
    std::ostringstream text;
    text << "# What the window of Tactooth remembers. Without this file it starts with its defaults.\n" << root << "\n";
    return text.str();
}

Expected<ParsedSettings> readWindowSettings(const std::filesystem::path& file) {
    std::error_code none;
    if (!std::filesystem::exists(file, none)) return ParsedSettings();
    const Expected<FileBytes> content = readFile(file, kTomlLimits.bytes);
    if (!content) return Unexpected{content.error()};
    return parseWindowSettings(content->text(), displayName(file));
}

Expected<std::filesystem::path> backUpInvalidSettings(const std::filesystem::path& file) {
    std::filesystem::path aside = file;
    aside += ".bad";
    std::error_code failure;
    std::filesystem::rename(file, aside, failure);
    if (failure) return unexpected(systemReason(failure));
    return aside;
}

std::optional<Error> resetUnknownDevices(DeviceSettings& hand, const std::filesystem::path& file) {
    const DeviceSettings usual;
    Message forgotten;
    const auto keepValid = [&](std::string& device, const std::string& otherwise, const char* key, bool isSecond) {
        if (checkDeviceName(device, key, isSecond)) return;
        const Message its(msg::kDeviceInSetting, device, key);
        forgotten = forgotten.empty() ? its : Message(msg::kTwoDevicesForgotten, forgotten, its);
        device = otherwise;
    };
    keepValid(hand.device, usual.device, "device", false);
    keepValid(hand.secondDevice, usual.secondDevice, "second_device", true);
    if (forgotten.empty()) return std::nullopt;
    return Error(msg::kDeviceForgotten, displayName(file), forgotten);
}

Expected<void> writeWindowSettings(const WindowSettings& settings, const std::filesystem::path& file) {
    std::error_code failure;
    std::filesystem::create_directories(file.parent_path(), failure);  // opening the file reports the failure
    return writeFile(file, windowSettingsText(settings));
}

}  // namespace tactooth
