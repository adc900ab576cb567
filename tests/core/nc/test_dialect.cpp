// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/dialect.h"

#include <cstdlib>
#include <fstream>

namespace {

/// Runs as soon as the library is loaded.
struct Trace {
    Trace() {
        if (const char* file = std::getenv("BURIN_TEST_TRACE"); file != nullptr) std::ofstream(file) << "loaded";
    }
} trace;

class NameOnly final : public burin::PostProcessor {
public:
    burin::Result<void> write(const burin::NcProgram& program, const burin::MachineProfile&, burin::LineSink& sink,
                              burin::Progress&) const override {
        return sink.line(program.name);
    }
};

} // namespace

extern "C" [[gnu::visibility("default")]] burin::PostProcessor* burinCreatePostProcessor() {
    return new NameOnly();
}
