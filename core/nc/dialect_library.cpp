// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/dialect_library.h"

#include "core/base/file.h"

#include <nlohmann/json.hpp>

#include <dlfcn.h>

#include <algorithm>
#include <system_error>

namespace burin {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* metadataName = "plugin.json";

Error invalid(const fs::path& file, std::string detail) {
    return Error{ErrorCode::pluginInvalid, file.string(), "", std::move(detail)};
}

/// The text under a key that has to be there and not empty.
Result<std::string> textOf(const Json& object, const char* key, const fs::path& file) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_string() || found->get_ref<const std::string&>().empty())
        return invalid(file, std::string("\"") + key + "\" has to be a text");
    return found->get<std::string>();
}

/// Only letters, digits, dash, underscore and points inside: such a name can't leave the plugin's folder.
bool isPlainName(const std::string& name) {
    return name.front() != '.' && std::ranges::all_of(name, [](unsigned char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
                      c == '_' || c == '.';
           });
}

Result<DialectDescription> describe(const fs::path& file, const Json& metadata) {
    if (!metadata.is_object()) return invalid(file, "not a JSON object");
    DialectDescription description;
    std::string kind, library;
    const std::pair<const char*, std::string*> texts[] = {
        {"id", &description.id},           {"kind", &kind},       {"name", &description.name},
        {"version", &description.version}, {"library", &library}, {"file_suffix", &description.fileSuffix}};
    for (const auto& [key, target] : texts) {
        Result<std::string> text = textOf(metadata, key, file);
        if (!text) return text.error();
        *target = *text;
    }
    for (const auto& [key, value] : metadata.items()) {
        const bool known = key == "interface_version" ||
                           std::ranges::any_of(texts, [&key = key](const auto& text) { return key == text.first; });
        if (!known) return invalid(file, "unknown key \"" + key + "\"");
    }
    const auto version = metadata.find("interface_version");
    if (version == metadata.end() || !version->is_number_integer())
        return invalid(file, "\"interface_version\" has to be a whole number");
    description.interfaceVersion = version->get<int>();
    if (kind != "dialect") return invalid(file, "\"kind\" has to be \"dialect\"");
    if (!isPlainName(library) || !isPlainName(description.id) || !isPlainName(description.fileSuffix))
        return invalid(file, "\"id\", \"library\" and \"file_suffix\" have to be plain names");
    description.library = file.parent_path() / library;
    return description;
}

Result<DialectDescription> readDescription(const fs::path& file) {
    Result<std::string> text = readFile(file);
    if (!text) return text.error();
    const Json metadata = Json::parse(*text, nullptr, false);
    if (metadata.is_discarded()) return invalid(file, "not JSON");
    return describe(file, metadata);
}

std::string loaderFault() {
    const char* reason = dlerror();
    return reason != nullptr ? reason : "unknown reason";
}

/// Keeps the library in memory for as long as the post-processor out of it lives.
struct LibraryCloser {
    void operator()(void* library) const noexcept { dlclose(library); }
};
using Library = std::shared_ptr<void>;

Result<std::shared_ptr<const PostProcessor>> create(const DialectDescription& description) {
    void* handle = dlopen(description.library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) return invalid(description.library, loaderFault());
    const Library library(handle, LibraryCloser{});
    void* symbol = dlsym(handle, dialectEntryPoint);
    if (symbol == nullptr) return invalid(description.library, loaderFault());
    const auto function = reinterpret_cast<CreatePostProcessor>(symbol); // POSIX: dlsym gives functions as void*
    PostProcessor* post = nullptr;
    try {
        post = function();
    } catch (...) { // a fault of foreign code must not pass our border
        return invalid(description.library, "its entry point threw");
    }
    if (post == nullptr) return invalid(description.library, "its entry point gave nothing");
    return std::shared_ptr<const PostProcessor>(post, [library](const PostProcessor* owned) { delete owned; });
}

} // namespace

Result<std::vector<DialectDescription>> dialects(const fs::path& folder) {
    const fs::path root = folder.empty() ? pluginDirectory() / "dialects" : folder;
    std::vector<DialectDescription> found;
    std::error_code fault;
    for (fs::directory_iterator at(root, fault), end; !fault && at != end; at.increment(fault)) {
        const fs::path file = at->path() / metadataName;
        std::error_code ignored;
        if (!fs::is_regular_file(file, ignored)) continue;
        Result<DialectDescription> description = readDescription(file);
        if (!description) return description.error();
        found.push_back(std::move(*description));
    }
    if (fault) {
        const bool missing = fault == std::errc::no_such_file_or_directory;
        return Error{missing ? ErrorCode::fileNotFound : ErrorCode::fileNotReadable, root.string(), "",
                     fault.message()};
    }
    std::ranges::sort(found, {}, &DialectDescription::id);
    const auto twice = std::ranges::adjacent_find(found, {}, &DialectDescription::id);
    if (twice != found.end()) return invalid(std::next(twice)->library, "id \"" + twice->id + "\" is taken already");
    return found;
}

Result<std::shared_ptr<const PostProcessor>> loadDialect(const std::string& id, const fs::path& folder) {
    Result<std::vector<DialectDescription>> known = dialects(folder);
    if (!known) return known.error();
    std::string ids;
    for (const DialectDescription& description : *known) {
        ids += (ids.empty() ? "" : " ") + description.id;
        if (description.id != id) continue;
        if (description.interfaceVersion != PostProcessor::interfaceVersion)
            return Error{ErrorCode::pluginIncompatible, description.library.string(),
                         std::to_string(description.interfaceVersion), std::to_string(PostProcessor::interfaceVersion)};
        return create(description);
    }
    return Error{ErrorCode::dialectNotFound, id, "", ids};
}

} // namespace burin
