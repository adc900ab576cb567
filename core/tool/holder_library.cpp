// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/holder_library.h"

#include "core/base/resource_folder.h"
#include "core/tool/segment_json.h"

namespace burin {

Result<Holder> holderFromJson(std::string_view text, const std::string& origin) {
    Result<JsonObject> file = JsonObject::parse(text, origin);
    if (!file) return file.error();
    Holder holder;
    holder.id = file->text("id");
    holder.name = file->text("name");
    holder.source = file->text("source");
    readSegments(*file, "segments", holder.segments);
    if (holder.segments.empty()) file->fail("segments", "has to have one at least");
    for (const HolderSegment& segment : holder.segments)
        if (!(segment.lowerDiameter > 0.0 && segment.upperDiameter > 0.0 && segment.length > 0.0))
            file->fail("segments", "has to have diameters and lengths above 0");
    if (Result<void> read = file->finish(); !read) return read.error();
    return holder;
}

Result<Holder> loadHolder(std::string_view id) {
    Result<ResourceText> file = findResource(holderResource, id);
    if (!file) return file.error();
    Result<Holder> holder = holderFromJson(file->text, file->file);
    if (holder && holder->id != id)
        return Error{ErrorCode::resourceInvalid, file->file, "id", "has to be the file's name"};
    return holder;
}

std::vector<std::string> holderIds() {
    return resourceIds(holderResource);
}

} // namespace burin
