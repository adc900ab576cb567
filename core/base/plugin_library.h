// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A kind of plugin: each is a folder below `plugins/<folder>` with plugin.json and the library that it names.
struct PluginKind {
    std::string_view name;   ///< value of the key "kind"
    std::string_view folder; ///< below pluginDirectory()
    int interfaceVersion = 0;
    std::span<const std::string_view> furtherKeys; ///< texts that its metadata must have besides those of every plugin
};

/// What a plugin says of itself, read without running its code: plugin.json has exactly the keys "id", "kind", "name",
/// "version", "library", "interface_version" and those of its kind.
struct PluginDescription {
    std::string id, name, version;
    int interfaceVersion = 0;
    std::filesystem::path library;
    std::map<std::string, std::string, std::less<>> further; ///< texts of the kind's own keys, plain names
};

/// Folder of the user's own plugins of a kind: $XDG_DATA_HOME/burin/plugins/<folder>, or below ~/.local/share where
/// that is not set. Need not exist; empty when there is no home either.
std::filesystem::path userPluginDirectory(const PluginKind& kind);

/// Descriptions of all plugins of a kind below `folder` (default: the kind's folder in pluginDirectory()), sorted by
/// id. With `faults` a plugin with invalid metadata is noted there and left out; without, it is the error. Errors:
/// fileNotFound (the folder), fileNotReadable, pluginInvalid (subject: plugin.json).
Result<std::vector<PluginDescription>> findPlugins(const PluginKind& kind, const std::filesystem::path& folder = {},
                                                   std::vector<Error>* faults = nullptr);

/// The function that a plugin exports as `entryPoint`. Once loaded, its code stays for the life of the process: objects
/// out of it need not be outlived by anything. Errors: pluginIncompatible (interface version), pluginInvalid (does not
/// load, has no entry point).
Result<void*> loadPlugin(const PluginKind& kind, const PluginDescription& description, const char* entryPoint);

} // namespace burin
