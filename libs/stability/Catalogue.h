#pragma once

#include "model/Model.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace fpm {

/// How contact is computed in a scene of the catalogue: as a case has it by default, by
/// `algorithm paper`, or by default with the remedy that the entry names.
enum class ContactVariant { standard, paper, remedy };
inline constexpr std::array<ContactVariant, 3> allVariants{
    ContactVariant::standard, ContactVariant::paper, ContactVariant::remedy};
const char* nameOf(ContactVariant variant);

/// What becomes of contact there. `refused`, `warned`: at set-up, in the words that the entry has;
/// `none`: the variant does not exist.
enum class Fate { holds, loses, warned, refused, none };
const char* nameOf(Fate fate);

/// What a scene gave: a value to compare with the entry's limit, or what was said at set-up.
struct Measure {
    double value = 0;
    std::string said;
    bool stopped = false; ///< it was an error, not a warning
};

/// One failure of node-to-face penalty contact, and the scene that shows it.
struct Failure {
    int number;             ///< F1 to F27, as doc/failures.md counts
    std::string name{};     ///< of the scene
    std::string fails{};    ///< what goes wrong where nothing is done about it
    std::string quantity{}; ///< what is measured; its unit, where it has one
    double limit = 0;       ///< the value may be that large ...
    bool atLeast = false;   ///< ... or, that small
    std::string reason{};   ///< source of the limit
    std::string words{};    ///< set-up: part of what must be said; there is no value then
    std::array<Fate, 3> expected{Fate::holds, Fate::holds, Fate::none}; ///< by ContactVariant
    std::string remedy{}; ///< what the default does about it, or what to choose
    std::string note{};   ///< why a variant loses contact, or holds against expectation
    std::function<Measure(ContactVariant)> run{};
};

/// All entries by number. Scenes of a few hundred elements, none longer than about a second.
const std::vector<Failure>& catalogue();

/// Result of one variant in one scene.
struct Verdict {
    Measure measure;
    Fate fate = Fate::none;
};
Verdict judge(const Failure& failure, ContactVariant variant);
/// True where the entry says so.
bool isExpected(const Failure& failure, ContactVariant variant, Fate fate);

/// The model as it is, or with the forms of the paper.
Model asVariant(Model model, ContactVariant variant);

} // namespace fpm
