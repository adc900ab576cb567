// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/volume_files.h"

#include "app/command.h"
#include "app/wording.h"
#include "core/exchange/volume_input.h"

namespace burin {

Result<RunVolume> readVolume(const std::string& file, const std::string& table, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Reading"));
    Result<VolumeInput> input = readAnyVolume(file, table, context.progress());
    if (!input) return withTableOption(std::move(input).error(), "--table");
    if (!input->unitKnown) tellUnknownUnit(file, context);
    return std::move(input->volume);
}

Error withTableOption(Error error, const char* option) {
    if (error.code == ErrorCode::argumentInvalid && error.subject == "table") error.subject = option;
    return error;
}

void tellUnknownUnit(const std::string& file, CommandContext& context) {
    context.message(worded(BURIN_TEXT("Command", "%1 gives no unit of length; it was read in mm."), {file}));
}

} // namespace burin
