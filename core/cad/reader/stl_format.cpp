// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/file_format.h"
#include "core/cad/reader/stl_file.h"
#include "core/cad/reader/stl_model.h"

#include <utility>

namespace burin {

namespace {

/// Many binary files begin with "solid" too; they are recognised by their length.
bool isText(std::string_view content) {
    return !hasLengthOfBinaryStl(content) && isTextStl(content);
}

} // namespace

FormatMatch matchFormat(StlFormat, std::string_view content) {
    if (hasLengthOfBinaryStl(content) || isTextStl(content) || isLongerBinaryStl(content)) return {true, {}};
    std::string end = whereBinaryStlEnds(content);
    return {!end.empty(), std::move(end)};
}

Result<Model> readFormat(StlFormat, ModelSource& source) {
    return readStlModel(source.content, !isText(source.content), source.request.fileUnit);
}

} // namespace burin
