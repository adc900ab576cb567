// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/machine/machine_profile.h"
#include "core/nc/program.h"

#include <string>
#include <string_view>

namespace burin {

/// Receives the lines of a program, one at a time, without their line ends.
class LineSink {
public:
    virtual ~LineSink() = default;
    virtual Result<void> line(std::string_view text) = 0;
};

/// Writes a checked program in one controller's dialect. Keeps no state between calls; used by one thread at a time.
/// Every coordinate is in millimetres, in the frame of the work offset in force; the dialect rounds and formats them.
class PostProcessor {
public:
    static constexpr int interfaceVersion = 5; ///< +1 with any change to this declaration or to NcProgram
    virtual ~PostProcessor() = default;
    virtual Result<void> write(const NcProgram& program, const MachineProfile& machine, LineSink& sink,
                               Progress& progress) const = 0;
};

/// A dialect that cannot be expressed as data is a plugin: a folder with plugin.json ({"id", "kind": "dialect", "name",
/// "version", "interface_version", "library", "file_suffix"}) and the library it names, which exports this one
/// function. The metadata is read, and the interface version compared, before any code of the plugin runs. All other
/// dialects are data: dialect_data.h.
inline constexpr const char* dialectEntryPoint = "burinCreatePostProcessor";
using CreatePostProcessor = PostProcessor* (*)(); ///< the caller owns the object and deletes it

} // namespace burin
