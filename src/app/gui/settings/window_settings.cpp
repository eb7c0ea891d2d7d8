// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/settings/window_settings.h"

#include <toml++/toml.h>

#include <QStandardPaths>
#include <optional>
#include <sstream>

#include "devices/open_device.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "session/io/limited_toml.h"

namespace tactooth {
namespace {

/// Reads values from a file; skips and reports an invalid one.
class SettingsReader {
public:
    SettingsReader(const toml::table& root, std::string_view name) : root_(root), name_(name) {}

    void text(std::string_view table, std::string_view key, std::string& value) {
        const toml::node* found = node(table, key);
        if (found == nullptr) return;
        if (const auto* held = found->as_string()) {
            value = held->get();
        } else {
            refuse(*found, key, "a text in quotes");
        }
    }
    void yesOrNo(std::string_view table, std::string_view key, bool& value) {
        const toml::node* found = node(table, key);
        if (found == nullptr) return;
        if (const auto* held = found->as_boolean()) {
            value = held->get();
        } else {
            refuse(*found, key, "true or false");
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
        std::ostringstream wanted;
        wanted << "a number from " << option.lowest << " to " << option.highest;
        if (option.zero != nullptr) wanted << ", or \"" << option.zero << '"';
        refuse(*found, option.key, wanted.str());
    }
    [[nodiscard]] const std::vector<Error>& refused() const { return refused_; }

private:
    const toml::node* node(std::string_view table, std::string_view key) {
        const toml::node* section = root_.get(table);
        if (section == nullptr) return nullptr;
        if (!section->is_table()) {
            refuse(*section, table, "a table");
            return nullptr;
        }
        return section->as_table()->get(key);
    }
    void refuse(const toml::node& node, std::string_view key, std::string_view wanted) {
        Error error{std::string(name_) + ", line " + std::to_string(node.source().begin.line) + ": '" +
                    std::string(key) + "' must be " + std::string(wanted) + "."};
        // A value in place of a table is reported for each key of the table.
        if (refused_.empty() || refused_.back().message != error.message) refused_.push_back(std::move(error));
    }

    const toml::table& root_;
    std::string_view name_;
    std::vector<Error> refused_;
};

ParsedSettings settingsFrom(const toml::table& root, std::string_view name) {
    SettingsReader reader(root, name);
    ParsedSettings settings;
    for (const WindowOption& option : windowOptions()) {
        if (const auto* text = std::get_if<WindowOption::Text>(&option.value)) {
            reader.text(option.table, option.key, (*text)(settings));
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
    if (failure) return unexpected(failure.message());
    return aside;
}

std::string resetUnknownDevices(DeviceSettings& hand, const std::filesystem::path& file) {
    const DeviceSettings usual;
    std::string forgotten;
    const auto keepValid = [&](std::string& device, const std::string& otherwise, const char* key, bool isSecond) {
        if (checkDeviceName(device, key, isSecond)) return;
        forgotten += (forgotten.empty() ? "'" : " and no '") + device + "' (" + key + ")";
        device = otherwise;
    };
    keepValid(hand.device, usual.device, "device", false);
    keepValid(hand.secondDevice, usual.secondDevice, "second_device", true);
    if (forgotten.empty()) return {};
    return displayName(file) + ": Tactooth knows no device " + forgotten +
           "; the usual one takes its place, choose another in the panel Hand.";
}

Expected<void> writeWindowSettings(const WindowSettings& settings, const std::filesystem::path& file) {
    std::error_code failure;
    std::filesystem::create_directories(file.parent_path(), failure);  // opening the file reports the failure
    return writeFile(file, windowSettingsText(settings));
}

}  // namespace tactooth
