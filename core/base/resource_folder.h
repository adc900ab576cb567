// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A kind of data file that is shipped with Burin and that the user may add: `<id>.json` in one folder.
struct ResourceKind {
    std::string_view name;   ///< "tool", the subject of nameUnknown
    std::string_view folder; ///< "tools", below the folders of resources
};
inline constexpr ResourceKind materialResource{"material", "materials"};
inline constexpr ResourceKind toolResource{"tool", "tools"};
inline constexpr ResourceKind holderResource{"holder", "holders"};
inline constexpr ResourceKind machineResource{"machine", "machines"};
inline constexpr ResourceKind dialectResource{"dialect", "dialects"};

/// The content of a data file.
struct ResourceText {
    std::string text;
    std::string file; ///< path, for messages
};

/// Folder of the user's own files of a kind: $XDG_DATA_HOME/burin/<folder>, or ~/.local/share/burin/<folder> if that is
/// not set. Need not exist; empty if there is no home folder either.
std::filesystem::path userResourceDirectory(ResourceKind kind);

/// Folders that are searched, the user's first, so that it may replace shipped files.
std::vector<std::filesystem::path> resourceSearchPath(ResourceKind kind);

/// Whether the id consists of letters, digits, '-', '_' and '.', beginning with a letter or digit, so that it cannot
/// lead out of a folder.
bool isResourceId(std::string_view id);

/// An id derived from a name: "Aluminum (Soft Wrought Alloy)" becomes "aluminum-soft-wrought-alloy"; empty if the name
/// has neither letters nor digits of ASCII.
std::string resourceIdFrom(std::string_view name);

/// `wanted`, or `wanted` with the first free number from 2 appended. @param taken whether an id is in use
template <class Taken>
std::string freeResourceId(const std::string& wanted, Taken taken) {
    std::string id = wanted;
    for (int i = 2; taken(id); ++i) id = wanted + "-" + std::to_string(i);
    return id;
}

/// The file of `id` from the first folder that has it.
/// Errors: nameUnknown (detail: existing ids; the most similar ones if there are many), those of readFile.
Result<ResourceText> findResource(ResourceKind kind, std::string_view id);

/// Ids of all files of a kind, sorted, each once.
std::vector<std::string> resourceIds(ResourceKind kind);

/// Whether a file of this id is shipped with Burin; the user's own may take precedence.
bool isShipped(ResourceKind kind, std::string_view id);
/// Whether the user has a file of this id.
bool isOfUser(ResourceKind kind, std::string_view id);

/// The path of the user's own file of `id`, which need not exist. Errors: argumentInvalid (not a valid id),
/// fileNotWritable (there is no home folder).
Result<std::filesystem::path> userResourceFile(ResourceKind kind, const std::string& id);
/// Writes the user's own file of `id`, creating its folder if needed; the old content is kept until the new one is
/// complete. @return the file. Errors: those of userResourceFile and writeFileAtomically.
Result<std::filesystem::path> saveUserResource(ResourceKind kind, const std::string& id, std::string_view content);
/// Deletes the user's own file of `id`. Errors: those of userResourceFile, nameUnknown (the user has no such file;
/// detail: the ids of the user's files), fileNotWritable.
Result<void> removeUserResource(ResourceKind kind, const std::string& id);

} // namespace burin
