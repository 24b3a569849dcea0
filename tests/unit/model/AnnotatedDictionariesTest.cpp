#include "base/Format.h"
#include "model/ContactSetup.h"
#include "model/PartMaterial.h"
#include "model/readModel.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/CaseFolder.h"
#include "unit/model/Refusal.h"

#include <algorithm>
#include <set>

// etc/caseDicts is the manual of the dictionaries: each file must read as it stands, and must show
// every key that its reader asks for. The readers say themselves what they ask for: an unknown
// keyword is answered with the keys that are valid where it stands.

using namespace fpm;
using fpm::test::contains;

namespace {

const std::filesystem::path source = FPM_SOURCE_DIR;
const std::vector<std::string> files{"constant/caseProperties",     "constant/partProperties",
                                     "constant/boundaryConditions", "0/initialConditions",
                                     "system/contactDict",          "system/controlDict"};

std::string annotated(const std::string& relative)
{
    return test::readText(source / "etc/caseDicts" / std::filesystem::path(relative).filename());
}

void readAll(const test::CaseFolder& folder)
{
    Log log = Log::quiet();
    Mesh mesh = test::rodAndPlates();
    test::addBox(mesh, {"striker", {0, 0, 50}, {10, 10, 2}});
    test::addBox(mesh, {"sleeve", {60, 0, 0}, {5, 5, 5}});
    setContact(mesh, folder.open().dictionary("system/contactDict"), folder.open(), log);
    folder.write(mesh);
    readModel(folder.open(), log);
}

/// Places where an entry may begin: behind the opening brace of every dictionary but FoamFile, and
/// the end of the text.
std::vector<std::size_t> placesForEntries(const std::string& text)
{
    const std::string brace = "{\n";
    std::vector<std::size_t> places;
    for (std::size_t at = text.find(brace); at != std::string::npos; at = text.find(brace, at + 1))
        places.push_back(at + brace.size());
    places.front() = text.size();
    return places;
}

/// Names behind "valid here:" of a message; none when the message is about something else.
std::vector<std::string> validKeys(const std::string& message)
{
    const std::string mark = "valid here: ";
    const std::size_t start = message.find(mark);
    if (message.find("unknown keyword 'notAKey'") == std::string::npos
        || start == std::string::npos)
        return {};
    std::istringstream words(message.substr(start + mark.size()));
    std::vector<std::string> keys;
    for (std::string word; words >> word;) {
        word.erase(std::remove(word.begin(), word.end(), ','), word.end());
        keys.push_back(word);
    }
    return keys;
}

/// Every key of a dictionary, at whatever depth.
std::set<std::string> keysShown(const std::string& text)
{
    std::set<std::string> keys;
    for (const std::string& path : Dictionary::parse(text).keyPaths()) {
        std::istringstream words(path);
        for (std::string key; std::getline(words, key, '.');) keys.insert(key);
    }
    return keys;
}

/// Words of a text with one blank between them, comment marks left out.
std::string plainText(const std::string& text)
{
    std::istringstream words(text);
    std::string plain = " ";
    for (std::string word; words >> word;)
        if (word != "//") plain += word + " ";
    return plain;
}

/// From the first entry `key` of a plain text to the next entry.
std::string entryOf(const std::string& text, const std::string& key)
{
    const std::size_t at = text.find(" " + key + " ");
    if (at == std::string::npos) return {};
    std::size_t end = text.find(';', at);
    for (int i = 0; i < 3 && end != std::string::npos; ++i) end = text.find(';', end + 1);
    return text.substr(at, std::min(text.size(), end + 80) - at) + " ";
}

} // namespace

TEST(AnnotatedDictionaries, ReadAsTheyStand)
{
    const test::CaseFolder folder;
    for (const std::string& file : files) folder.write(file, annotated(file));

    EXPECT_NO_THROW(readAll(folder));
}

TEST(AnnotatedDictionaries, ShowEveryMaterialWithItsParameters)
{
    const std::string text = plainText(annotated("constant/partProperties"));
    const std::string words = entryOf(text, "model");
    for (const std::string& word : kindWords())
        EXPECT_NE(words.find(" " + word + " "), std::string::npos) << words;
    for (const MaterialEntry& material : materialEntries) {
        if (material.parameters.empty()) continue;
        const std::size_t at = text.find(std::string(" ") + material.word + " {");
        ASSERT_NE(at, std::string::npos) << "no dictionary " << material.word;
        const std::string entries = text.substr(at, text.find('}', at) - at);
        for (const Parameter& p : material.parameters) {
            const Range range{p.lower, p.upper, p.lowerOpen, p.upperOpen};
            EXPECT_NE(entryOf(entries, p.word)
                          .find(format("{}; {}; {}; {} ", p.meaning, p.unit,
                                       p.required ? "required" : toText(p.preset), range.text())),
                      std::string::npos)
                << "etc/caseDicts/partProperties should say: " << p.word << " <value>; // "
                << p.meaning << "; " << p.unit << "; "
                << (p.required ? "required" : toText(p.preset)) << "; " << range.text();
        }
    }
}

TEST(AnnotatedDictionaries, ShowEveryKeyTheReadersAskFor)
{
    for (const std::string& file : files) {
        const std::string text = annotated(file);
        const std::set<std::string> shown = keysShown(text);
        std::size_t answers = 0;
        for (const std::size_t place : placesForEntries(text)) {
            const test::CaseFolder folder;
            for (const std::string& other : files) folder.write(other, annotated(other));
            folder.write(file, std::string(text).insert(place, "notAKey 1;\n"));
            std::string message;
            try {
                readAll(folder);
            } catch (const Error& error) {
                message = error.what();
            }
            EXPECT_FALSE(message.empty()) << file << ": an unknown keyword was accepted";
            const auto keys = validKeys(message);
            answers += !keys.empty();
            for (const std::string& key : keys)
                EXPECT_TRUE(shown.count(key)) << file << " does not show '" << key << "'";
        }
        EXPECT_GT(answers, 0u) << file;
    }
}
