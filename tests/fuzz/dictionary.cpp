#include "dictionary/Dictionary.h"

#include <cstdio>
#include <cstdlib>

// Any text is read or refused, and nothing else: no crash, no endless loop, no memory beyond the
// limits. Run with the annotated dictionaries as a start:
//   cmake --preset fuzz && cmake --build --preset fuzz
//   mkdir -p corpus && build-fuzz/bin/fuzz_dictionary -max_total_time=60 corpus etc/caseDicts

using namespace fpm;

namespace {

template <class Read>
void tried(Read read)
{
    try {
        read();
    } catch (const Error&) { // refused with a reason
    }
}

void readEverything(const Dictionary& dictionary)
{
    for (const std::string& key : dictionary.keys()) {
        tried([&] { dictionary.number(key); });
        tried([&] { dictionary.integer(key, -5, 5); });
        tried([&] { dictionary.word(key); });
        tried([&] { dictionary.vector(key); });
        tried([&] { dictionary.numbers(key); });
        tried([&] { dictionary.words(key); });
        tried([&] { dictionary.items(key); });
        tried([&] { dictionary.rows(key, 2); });
        tried([&] { dictionary.tailRows(key, 2); });
        tried([&] { dictionary.tailNumbers(key); });
        tried([&] { readEverything(dictionary.sub(key)); });
        tried([&] {
            for (const Dictionary& part : dictionary.subList(key)) readEverything(part);
        });
    }
}

/// The canonical text says the same as what it was made from.
void compareCanonical(const Dictionary& dictionary)
{
    const std::string once = dictionary.canonicalText();
    if (Dictionary::parse(once).canonicalText() == once) return;
    std::fprintf(stderr, "not canonical:\n%s\n", once.c_str());
    std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(bytes), size);
    tried([&] {
        const Dictionary dictionary = Dictionary::parse(text);
        dictionary.keyPaths();
        readEverything(dictionary);
        tried([&] { dictionary.requireAllUsed(); });
        compareCanonical(dictionary);
    });
    return 0;
}
