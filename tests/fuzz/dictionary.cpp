#include "dictionary/Dictionary.h"

#include "fuzz/tried.h"

// Any text is a dictionary or refused; its canonical text says the same.

using namespace fpm;
using fuzz::tried;

namespace {

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
    fuzz::require(Dictionary::parse(once).canonicalText() == once, "canonical text is canonical");
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
