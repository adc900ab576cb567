// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/compression.h"
#include "tests/test_program.h"

#include <QtTest>

#include <dlfcn.h>
#include <new>
#include <zstd.h>

namespace burin::tst_compression {

namespace {

bool noContext = false, noTables = false; ///< allocations of Zstandard that fail

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

} // namespace

// The program's own definitions take precedence over the library's.
extern "C" ZSTD_CCtx* ZSTD_createCCtx() {
    return noContext ? nullptr : next<decltype(ZSTD_createCCtx)>("ZSTD_createCCtx")();
}

extern "C" std::size_t ZSTD_compress2(ZSTD_CCtx* context, void* frame, std::size_t room, const void* bytes,
                                      std::size_t size) {
    constexpr auto memoryAllocation = static_cast<std::size_t>(-64); // zstd_errors.h
    if (noTables) return memoryAllocation;
    return next<decltype(ZSTD_compress2)>("ZSTD_compress2")(context, frame, room, bytes, size);
}

class TestCompression : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { noContext = noTables = false; }

    void whatIsCompressedComesBack() {
        for (const std::string& bytes : {std::string(), std::string("a"), std::string(100'000, 'x')})
            QVERIFY(decompress(compress(bytes), bytes.size()) == bytes);
        QVERIFY(compress(std::string(100'000, 'x')).size() < 1'000);
    }

    /// Uniform data are compressed ten thousand times; they must be readable even by a reader with limits.
    void whatIsEvenStaysWithinTheBoundsOfReading() {
        for (const std::size_t size : {std::size_t{100'000}, std::size_t{1} << 20U, std::size_t{64} << 20U}) {
            const std::string bytes(size, 'x'), frame = compress(bytes);
            QVERIFY(decompress(frame, mostUnpacked(frame.size())) == bytes);
            QVERIFY(1000 * size <= mostUnpackedTogether(1000 * frame.size()));
        }
    }

    void aFrameThatClaimsMuchIsRefused() {
        const std::string bytes(std::size_t{64} << 20U, 'x');
        std::string frame(ZSTD_compressBound(bytes.size()), '\0');
        frame.resize(ZSTD_compress(frame.data(), frame.size(), bytes.data(), bytes.size(), 1));
        QVERIFY(decompress(frame, bytes.size()) == bytes);
        QVERIFY(!decompress(frame, mostUnpacked(frame.size())));
    }

    void aFrameThatIsNotWholeGivesNothing() {
        std::string frame = compress("what was written");
        QVERIFY(!decompress(frame, 15));
        QVERIFY(!decompress(frame.substr(0, frame.size() - 1), 100));
        frame[frame.size() / 2] = static_cast<char>(frame[frame.size() / 2] ^ 1);
        QVERIFY(!decompress(frame, 100));
    }

    /// Writers of files handle std::bad_alloc, and no other exception.
    void aLackOfMemoryIsThrown() {
        noContext = true;
        QVERIFY_EXCEPTION_THROWN((void)compress("bytes"), std::bad_alloc);
        noContext = false;
        noTables = true;
        QVERIFY_EXCEPTION_THROWN((void)compress("bytes"), std::bad_alloc);
    }
};

BURIN_TEST(TestCompression, NoApplication)

} // namespace burin::tst_compression

#include "tst_compression.moc"
