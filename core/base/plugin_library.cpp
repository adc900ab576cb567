// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/plugin_library.h"

#include "core/base/file.h"
#include "core/base/json_number.h"
#include "core/base/resource_folder.h"

#include <nlohmann/json.hpp>

#include <dlfcn.h>

#include <algorithm>
#include <limits>
#include <system_error>

namespace burin {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* metadataName = "plugin.json";
constexpr std::string_view versionKey = "interface_version";

Error invalid(const fs::path& file, std::string detail) {
    return Error{ErrorCode::pluginInvalid, file.string(), "", std::move(detail)};
}

/// Letters, digits, dash, underscore and points inside only: such a name cannot lead out of the plugin's folder.
bool isPlainName(const std::string& name) {
    return name.front() != '.' && std::ranges::all_of(name, [](unsigned char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
                      c == '_' || c == '.';
           });
}

/// The texts of a plugin: all of them required and not empty, and no others.
Result<std::map<std::string, std::string, std::less<>>> textsOf(const PluginKind& kind, const fs::path& file,
                                                                const Json& metadata) {
    std::vector<std::string_view> keys{"id", "kind", "name", "version", "library"};
    keys.insert(keys.end(), kind.furtherKeys.begin(), kind.furtherKeys.end());
    std::map<std::string, std::string, std::less<>> texts;
    for (const std::string_view key : keys) {
        const auto found = metadata.find(key);
        if (found == metadata.end() || !found->is_string() || found->get_ref<const std::string&>().empty())
            return invalid(file, "\"" + std::string(key) + "\" has to be a text");
        texts.emplace(key, found->get<std::string>());
    }
    for (const auto& entry : metadata.items())
        if (entry.key() != versionKey && !texts.contains(entry.key()))
            return invalid(file, "unknown key \"" + entry.key() + "\"");
    return texts;
}

Result<PluginDescription> describe(const PluginKind& kind, const fs::path& file, const Json& metadata) {
    if (!metadata.is_object()) return invalid(file, "not a JSON object");
    auto texts = textsOf(kind, file, metadata);
    if (!texts) return std::move(texts).error();
    const auto found = metadata.find(versionKey);
    using Int = std::numeric_limits<int>;
    const auto version = found != metadata.end() ? wholeNumber(*found, Int::min(), Int::max()) : std::nullopt;
    if (!version) return invalid(file, "\"interface_version\" has to be a whole number");
    PluginDescription description;
    description.interfaceVersion = static_cast<int>(*version);
    const auto take = [&texts](std::string_view key) { return std::move(texts->extract(texts->find(key)).mapped()); };
    if (take("kind") != kind.name) return invalid(file, "\"kind\" has to be \"" + std::string(kind.name) + "\"");
    description.name = take("name");
    description.version = take("version");
    description.id = take("id");
    const std::string library = take("library");
    description.further = std::move(*texts);
    const auto plain = [](const auto& entry) { return isPlainName(entry.second); };
    if (!isPlainName(library) || !isPlainName(description.id) || !std::ranges::all_of(description.further, plain)) {
        std::string names = "\"id\", \"library\"";
        for (const std::string_view key : kind.furtherKeys) names += ", \"" + std::string(key) + "\"";
        return invalid(file, names + " must be file names without a folder");
    }
    description.library = file.parent_path() / library;
    return description;
}

Result<PluginDescription> readDescription(const PluginKind& kind, const fs::path& file) {
    Result<std::string> text = readFile(file);
    if (!text) return text.error();
    const Json metadata = Json::parse(*text, nullptr, false);
    if (metadata.is_discarded()) return invalid(file, "not JSON");
    return describe(kind, file, metadata);
}

/// Sorts by id. Duplicate ids are a fault.
std::optional<Error> sortById(std::vector<PluginDescription>& found) {
    std::ranges::sort(found, {}, &PluginDescription::id);
    const auto twice = std::ranges::adjacent_find(found, {}, &PluginDescription::id);
    if (twice == found.end()) return std::nullopt;
    return invalid(std::next(twice)->library, "id \"" + twice->id + "\" is taken already");
}

std::string loaderFault() {
    const char* reason = dlerror();
    return reason != nullptr ? reason : "unknown reason";
}

} // namespace

fs::path userPluginDirectory(const PluginKind& kind) {
    const fs::path plugins = userResourceDirectory({"plugin", "plugins"});
    return plugins.empty() ? plugins : plugins / kind.folder;
}

Result<std::vector<PluginDescription>> findPlugins(const PluginKind& kind, const fs::path& folder,
                                                   std::vector<Error>* faults) {
    const fs::path root = folder.empty() ? pluginDirectory() / kind.folder : folder;
    std::vector<PluginDescription> found;
    std::error_code fault;
    for (fs::directory_iterator at(root, fault), end; !fault && at != end; at.increment(fault)) {
        const fs::path file = at->path() / metadataName;
        std::error_code ignored;
        if (!fs::is_regular_file(file, ignored)) continue;
        Result<PluginDescription> description = readDescription(kind, file);
        if (description)
            found.push_back(std::move(*description));
        else if (faults != nullptr)
            faults->push_back(std::move(description).error());
        else
            return std::move(description).error();
    }
    if (fault) {
        const bool missing = fault == std::errc::no_such_file_or_directory;
        return Error{missing ? ErrorCode::fileNotFound : ErrorCode::fileNotReadable, root.string(), "",
                     fault.message()};
    }
    if (std::optional<Error> twice = sortById(found)) {
        if (faults == nullptr) return std::move(*twice);
        faults->push_back(std::move(*twice));
        const auto rest = std::ranges::unique(found, {}, &PluginDescription::id);
        found.erase(rest.begin(), rest.end());
    }
    return found;
}

Result<void*> loadPlugin(const PluginKind& kind, const PluginDescription& description, const char* entryPoint) {
    if (description.interfaceVersion != kind.interfaceVersion)
        return Error{ErrorCode::pluginIncompatible, description.library.string(),
                     std::to_string(description.interfaceVersion), std::to_string(kind.interfaceVersion)};
    void* library = dlopen(description.library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == nullptr) return invalid(description.library, loaderFault());
    void* symbol = dlsym(library, entryPoint);
    Result<void*> result = symbol;
    if (symbol == nullptr) result = invalid(description.library, loaderFault());
    dlclose(library); // RTLD_NODELETE keeps the code
    return result;
}

} // namespace burin
