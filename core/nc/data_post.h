// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/dialect.h"
#include "core/nc/dialect_data.h"

namespace burin {

/// A post-processor defined by the data of a dialect. Errors of `write`: programLimit (a coordinate that is not a valid
/// position, a missing feed or work offset), notSupported (several tools, a coolant or work offset that the control
/// does not have), argumentInvalid (a section that does not begin with a rapid), cancelled.
class DataPost final : public PostProcessor {
public:
    explicit DataPost(DialectData dialect) : dialect_(std::move(dialect)) {}
    Result<void> write(const NcProgram& program, const MachineProfile& machine, LineSink& sink,
                       Progress& progress) const override;

private:
    DialectData dialect_;
};

} // namespace burin
