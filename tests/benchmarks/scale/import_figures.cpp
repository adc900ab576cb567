// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/import.h"
#include "core/cad/import_stages.h"
#include "tests/benchmarks/scale/scale.h"
#include "tests/places.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <sstream>
#include <string_view>
#include <thread>
#include <unistd.h>

namespace burin::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t fileBytes = 20'000'000;
constexpr int runs = 5;

/// A part with freeform faces, with points that nothing uses before the end of its data: 20 MB. Removed at the end.
struct LargeStepFile {
    LargeStepFile();
    ~LargeStepFile() {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
    LargeStepFile(const LargeStepFile&) = delete;
    LargeStepFile& operator=(const LargeStepFile&) = delete;

    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("burin-bench-import-" + std::to_string(::getpid()) + ".step");
};

LargeStepFile::LargeStepFile() {
    std::ifstream part(BURIN_FIXTURES "/models/mouse-cover.step");
    std::string text{std::istreambuf_iterator<char>(part), {}};
    const std::size_t end = text.rfind("ENDSEC;");
    std::ostringstream points;
    for (int id = 1'000'000; static_cast<std::size_t>(points.tellp()) + text.size() < fileBytes; ++id)
        points << '#' << id << "=CARTESIAN_POINT('',(" << id << ".,0.,0.));\n";
    text.insert(end, points.str());
    std::ofstream(path) << text;
}

/// Returns the time from cancelling to the return, ms. @param text what the import is doing when it is cancelled
double cancelled(Session& session, const std::filesystem::path& file, std::string_view text) {
    ImportOptions options;
    options.worker = BURIN_BUILD_DIRECTORY "/burin-import";
    Progress progress;
    Clock::time_point asked;
    std::atomic<bool> ended = false;
    std::thread canceller([&] {
        while (!ended && progress.step().text.text != text) std::this_thread::sleep_for(std::chrono::microseconds(200));
        asked = Clock::now();
        progress.cancel();
    });
    const Result<Model> model = importModel(file, options, progress);
    const Clock::time_point returned = Clock::now();
    ended = true;
    canceller.join();
    session.check(!model && model.error().code == ErrorCode::cancelled, "an import is cancelled");
    return std::chrono::duration<double, std::milli>(returned - asked).count();
}

} // namespace

void importFigures(Session& session) {
    constexpr double limit = 1000.0; // ms
    if (!session.wants("import.cancel")) return;
    const LargeStepFile file;
    for (const auto& [name, stage] : {std::pair{"reading", ImportStage::reading},
                                      {"converting", ImportStage::converting},
                                      {"meshing", ImportStage::meshing}}) {
        session.stage(std::string("Cancelling an import: ") + name);
        double longest = 0.0;
        for (int run = 0; run < runs; ++run)
            longest = std::max(longest, cancelled(session, file.path, textOf(stage).text));
        session.add(figure(std::string("import.cancel.") + name, longest, "ms", limit));
    }
}

} // namespace burin::benchmarks
