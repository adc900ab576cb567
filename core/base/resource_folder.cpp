// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/resource_folder.h"

#include "core/base/file.h"
#include "core/base/staged_file.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <numeric>
#include <set>
#include <system_error>
#include <utility>

namespace burin {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view suffix = ".json";

bool isLetterOrDigit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// An environment variable that contains an absolute path, as the XDG base directory specification requires.
fs::path absolutePathFrom(const char* variable) {
    const char* value = std::getenv(variable);
    const fs::path path = value != nullptr ? fs::path(value) : fs::path();
    return path.is_absolute() ? path : fs::path();
}

std::string joined(const std::vector<std::string>& ids) {
    std::string text;
    for (const std::string& id : ids) text += (text.empty() ? "" : ", ") + id;
    return text;
}

std::string fileName(std::string_view id) {
    return std::string(id) + std::string(suffix);
}

bool isIn(const fs::path& folder, std::string_view id) {
    std::error_code ignored;
    return isResourceId(id) && !folder.empty() && fs::exists(folder / fileName(id), ignored);
}

/// The number of letters to insert, remove or change to turn one text into another (Levenshtein distance).
std::size_t editsBetween(std::string_view one, std::string_view other) {
    std::vector<std::size_t> row(other.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < one.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t k = 0; k < other.size(); ++k) {
            const std::size_t changed = diagonal + (one[i] == other[k] ? 0 : 1);
            diagonal = std::exchange(row[k + 1], std::min({changed, row[k] + 1, row[k + 1] + 1}));
        }
    }
    return row.back();
}

/// All ids if there are few; otherwise those that may have been meant, the most similar first.
std::vector<std::string> mostAlike(std::vector<std::string> ids, std::string_view wanted) {
    constexpr std::size_t readable = 20, named = 8, longest = 64;
    if (ids.size() <= readable) return ids;
    std::ranges::stable_sort(
        ids, {}, [wanted = wanted.substr(0, longest)](const std::string& id) { return editsBetween(id, wanted); });
    ids.resize(named);
    ids.emplace_back("…");
    return ids;
}

} // namespace

bool isResourceId(std::string_view id) {
    return !id.empty() && isLetterOrDigit(id.front()) &&
           std::ranges::all_of(id, [](char c) { return isLetterOrDigit(c) || c == '-' || c == '_' || c == '.'; });
}

fs::path userResourceDirectory(ResourceKind kind) {
    if (const fs::path data = absolutePathFrom("XDG_DATA_HOME"); !data.empty()) return data / "burin" / kind.folder;
    if (const fs::path home = absolutePathFrom("HOME"); !home.empty())
        return home / ".local" / "share" / "burin" / kind.folder;
    return {};
}

std::vector<fs::path> resourceSearchPath(ResourceKind kind) {
    std::vector<fs::path> folders;
    if (fs::path user = userResourceDirectory(kind); !user.empty()) folders.push_back(std::move(user));
    folders.push_back(resourceDirectory() / kind.folder);
    return folders;
}

std::string resourceIdFrom(std::string_view name) {
    std::string id;
    for (const char character : name) {
        const auto byte = static_cast<unsigned char>(character);
        if (byte < 0x80 && std::isalnum(byte) != 0)
            id += static_cast<char>(std::tolower(byte));
        else if (!id.empty() && id.back() != '-')
            id += '-';
    }
    while (!id.empty() && id.back() == '-') id.pop_back();
    return id;
}

Result<ResourceText> findResource(ResourceKind kind, std::string_view id) {
    if (isResourceId(id)) {
        for (const fs::path& folder : resourceSearchPath(kind)) {
            const fs::path file = folder / fileName(id);
            std::error_code ignored;
            if (!fs::exists(file, ignored)) continue;
            Result<std::string> text = readFile(file);
            if (!text) return text.error();
            return ResourceText{*std::move(text), file.string()};
        }
    }
    return Error{ErrorCode::nameUnknown, std::string(kind.name), std::string(id),
                 joined(mostAlike(resourceIds(kind), id))};
}

std::vector<std::string> resourceIds(ResourceKind kind) {
    std::set<std::string> ids;
    for (const fs::path& folder : resourceSearchPath(kind)) {
        std::error_code failed;
        for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
            const fs::path& file = entry->path();
            if (file.extension() == suffix && isResourceId(file.stem().string())) ids.insert(file.stem().string());
        }
    }
    return {ids.begin(), ids.end()};
}

bool isShipped(ResourceKind kind, std::string_view id) {
    return isIn(resourceDirectory() / kind.folder, id);
}

bool isOfUser(ResourceKind kind, std::string_view id) {
    return isIn(userResourceDirectory(kind), id);
}

Result<fs::path> userResourceFile(ResourceKind kind, const std::string& id) {
    if (!isResourceId(id))
        return Error{ErrorCode::argumentInvalid, std::string(kind.name), id,
                     "letters, digits, '-', '_' and '.', a letter or digit first"};
    const fs::path folder = userResourceDirectory(kind);
    if (folder.empty()) return Error{ErrorCode::fileNotWritable, fileName(id), {}, "there is no home folder"};
    return folder / fileName(id);
}

Result<fs::path> saveUserResource(ResourceKind kind, const std::string& id, std::string_view content) {
    Result<fs::path> file = userResourceFile(kind, id);
    if (!file) return file;
    if (Result<void> made = makeFolderOf(*file); !made) return made.error();
    if (Result<void> written = writeFileAtomically(*file, content); !written) return written.error();
    return file;
}

Result<void> removeUserResource(ResourceKind kind, const std::string& id) {
    const Result<fs::path> file = userResourceFile(kind, id);
    if (!file) return file.error();
    if (!isOfUser(kind, id)) {
        std::vector<std::string> own = resourceIds(kind);
        std::erase_if(own, [&](const std::string& one) { return !isOfUser(kind, one); });
        return Error{ErrorCode::nameUnknown, std::string(kind.name), id, joined(own)};
    }
    std::error_code failed;
    fs::remove(*file, failed);
    if (failed) return writeError(*file, failed.value());
    return {};
}

} // namespace burin
