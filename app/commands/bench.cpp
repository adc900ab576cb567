// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/wording.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>

#include <array>

namespace burin {

namespace {

using nlohmann::json;

/// A program that tests/benchmarks builds separately, because it links other projects that Burin itself does not need.
struct Benchmark {
    const char* name;
    const char* program;
    TextId shows;
};
constexpr std::array benchmarks{
    Benchmark{
        "volume", "burin-bench-volume",
        BURIN_TEXT("Command",
                   "the S-RLE engine and cutting, compared with the paper's method, dense grids, OpenVDB and VTK")},
    Benchmark{"verify", "burin-bench-verify",
              BURIN_TEXT("Command",
                         "reading programs back and judging them, compared with CAMotics, and where the time goes")},
    Benchmark{
        "scale", "burin-bench-scale",
        BURIN_TEXT(
            "Command",
            "CPU time and memory at three sizes of recordings, programs, paths, stocks and models, and how they grow")},
    Benchmark{"haptics", "burin-bench-haptics",
              BURIN_TEXT("Command", "the haptic loop: cost of a tick, push-back, stability, guards")},
};

struct BenchArguments {
    std::string name, only;
    int rounds = 1;
};

QString programOf(const Benchmark& benchmark) {
    return QCoreApplication::applicationDirPath() + QStringLiteral("/") + QString::fromLatin1(benchmark.program);
}

bool isBuilt(const Benchmark& benchmark) {
    return QFileInfo(programOf(benchmark)).isExecutable();
}

void listBenchmarks(CommandContext& context) {
    json list = json::array();
    std::string text;
    for (const Benchmark& benchmark : benchmarks) {
        const bool built = isBuilt(benchmark);
        list.push_back({{"name", benchmark.name}, {"shows", benchmark.shows.text}, {"built", built}});
        text += (text.empty() ? "" : "\n") + std::string(benchmark.name) + "  " + worded(benchmark.shows) +
                (built ? "" : " " + worded(BURIN_TEXT("Command", "(not built: tests/run --bench builds it)")));
    }
    context.answer(list, text);
}

/// Runs the benchmark with our standard output and error; both processes receive Ctrl-C.
int start(const Benchmark& benchmark, const BenchArguments& arguments, CommandContext& context) {
    QStringList words;
    if (context.json) words << QStringLiteral("--json");
    if (!arguments.only.empty()) words << QStringLiteral("--only") << QString::fromStdString(arguments.only);
    words << QStringLiteral("--rounds") << QString::number(arguments.rounds);
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedChannels);
    process.setInputChannelMode(QProcess::ForwardedInputChannel);
    process.start(programOf(benchmark), words);
    constexpr int wait = 100; // ms
    for (bool asked = false; process.state() != QProcess::NotRunning;) {
        process.waitForFinished(wait);
        if (!context.progress().cancelled() || asked) continue;
        process.terminate(); // the signal was sent to this process only
        asked = true;
    }
    if (process.error() == QProcess::FailedToStart || process.exitStatus() == QProcess::CrashExit)
        return context.fail({ErrorCode::internalFault, benchmark.program, {}, process.errorString().toStdString()});
    return process.exitCode();
}

int runBench(const BenchArguments& arguments, CommandContext& context) {
    if (arguments.name.empty()) {
        listBenchmarks(context);
        return 0;
    }
    std::string known;
    for (const Benchmark& benchmark : benchmarks) {
        known += (known.empty() ? "" : ", ") + std::string(benchmark.name);
        if (arguments.name != benchmark.name) continue;
        if (!isBuilt(benchmark))
            return context.fail({ErrorCode::fileNotFound, programOf(benchmark).toStdString(), {}, {}});
        return start(benchmark, arguments, context);
    }
    return context.fail({ErrorCode::nameUnknown, "benchmark", arguments.name, known});
}

} // namespace

void registerBench(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<BenchArguments>();
    const CommandParser command = program.command("bench", BURIN_TEXT("Help", "Run Burin's benchmarks"));
    command.positional(BURIN_TEXT("Argument", "NAME"), arguments->name,
                       BURIN_TEXT("Help", "Benchmark to run (default: list the benchmarks)"));
    command.option("--only", arguments->only, BURIN_TEXT("Help", "Only figures whose names begin with this"));
    command
        .option("--rounds", arguments->rounds, BURIN_TEXT("Help", "Number of rounds in which everything is measured"))
        .range(1, 1000)
        .showDefault();
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runBench(*arguments, context); });
}

} // namespace burin
