// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/dialect.h"
#include "core/nc/dialect_data.h"

namespace burin {

/// Words programs by a dialect's data. Errors of `write`: programLimit (a coordinate that is no place, a feed or work
/// offset that is missing), notSupported (several tools, a coolant or work offset that the control does not have),
/// argumentInvalid (a section that does not begin with a rapid), cancelled.
class DataPost final : public PostProcessor {
public:
    explicit DataPost(DialectData dialect) : dialect_(std::move(dialect)) {}
    Result<void> write(const NcProgram& program, const MachineProfile& machine, LineSink& sink,
                       Progress& progress) const override;

private:
    DialectData dialect_;
};

} // namespace burin
