// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/resource_folder.h"
#include "core/base/result.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A file of the user's in a library of tools, machines or materials, or that there is none: what an entry of the undo
/// stack goes between. Such files are a few kilobytes, and are written before anything shows them.
template <class Item>
struct OwnFile {
    std::string id;
    std::optional<Item> item;
};

/// @param save takes an item and whether one of its id is replaced @param remove takes an id
template <class Item, class Save, class Remove>
Result<void> write(const OwnFile<Item>& own, Save save, Remove remove) {
    if (!own.item) return remove(own.id);
    const auto file = save(*own.item, true);
    return file ? Result<void>() : Result<void>(file.error());
}

/// The item of an id, which a library of `items` has or has not.
template <class Item>
std::optional<Item> itemOf(const std::vector<Item>& items, const std::string& id) {
    const auto found = std::ranges::find(items, id, &Item::id);
    return found == items.end() ? std::nullopt : std::optional(*found);
}

/// `wanted`, with a number where one of `items` has it already.
template <class Item>
std::string freeId(const std::vector<Item>& items, const std::string& wanted) {
    return freeResourceId(
        wanted, [&](const std::string& id) { return std::ranges::find(items, id, &Item::id) != items.end(); });
}

} // namespace burin
