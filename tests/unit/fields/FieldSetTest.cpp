#include "base/Error.h"
#include "fields/NumberField.h"
#include "fields/Value.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

struct Contactors : FieldSet {
    explicit Contactors(const NumberTypes& numbers) : FieldSet("contactors", hostMemory(), numbers)
    {
    }
    Field<Index> face{*this, {"face", Location::contactor, Role::state}};
    NumberField xi{
        *this, {"xi", Location::contactor, Role::state, Renewal::keptInContact}, Family::work};
    Field<double> work{*this, {"work", Location::contactor, Role::state, Renewal::kept}};
    NumberField stiffness{*this, {"stiffness", Location::contactor, Role::constant}, Family::work};
    Field<double> sums{*this, {"sums", Location::block, Role::scratch}};
};

TEST(FieldSet, HoldsWhatIsDeclaredInOrder)
{
    const Contactors set(numberTypes<DoublePrecision>());
    std::string names;
    for (const FieldBase* field : set.fields()) names += std::string(field->info().name) + " ";
    EXPECT_EQ(names, "face xi work stiffness sums ");
}

TEST(FieldSet, TypesFollowFamilyAndPrecision)
{
    Contactors precise(numberTypes<DoublePrecision>()), mixed(numberTypes<MixedPrecision>());
    for (Contactors* set : {&precise, &mixed}) {
        set->face.resize(3);
        set->xi.resize(3);
    }
    EXPECT_EQ(precise.bytes(), 3 * (4 + 8));
    EXPECT_EQ(mixed.bytes(), 3 * (4 + 4));
}

TEST(FieldSet, NumbersAreRoundedOnceAndReadExactly)
{
    Contactors single(numberTypes<SinglePrecision>());
    single.xi.assign({0.1, 3});
    EXPECT_EQ(single.xi.toDoubles(), (std::vector<double>{double(0.1f), 3}));
    NumberField position(single, {"position", Location::node, Role::state}, Family::position,
                         std::vector<double>{1 + 0x1p-40});
    EXPECT_EQ(position.toDoubles(), (std::vector<double>{1 + 0x1p-40})); // a sum of two floats
    EXPECT_THROW(single.face.toDoubles(), Error);
}

TEST(FieldSet, ImagesBringTheStateIntoAnotherSet)
{
    Contactors from(numberTypes<MixedPrecision>()), to(numberTypes<MixedPrecision>());
    from.face.assign({4, 5});
    from.xi.assign({0.25, 0.5});
    from.stiffness.assign({7, 8});
    to.stiffness.assign({1, 2});
    to.face.resize(2);
    to.xi.resize(2);
    to.setImages(Role::state, from.images(Role::state));
    EXPECT_EQ(to.face.toHost(), (std::vector<Index>{4, 5}));
    EXPECT_EQ(to.xi.toDoubles(), (std::vector<double>{0.25, 0.5}));
    EXPECT_EQ(to.stiffness.toDoubles(), (std::vector<double>{1, 2})) << "no state";
    FieldSet::Images other = from.images(Role::state);
    other[1].first = "eta";
    EXPECT_THROW(to.setImages(Role::state, other), Error);
    other.pop_back();
    EXPECT_THROW(to.setImages(Role::state, other), Error);
}

/// What a new value of a contactor costs: its line. Renewal and state know it.
struct MoreContactors : Contactors {
    using Contactors::Contactors;
    Field<double> wear{*this, {"wear", Location::contactor, Role::state, Renewal::kept}};
};

TEST(FieldSet, OneLineMakesAValueOfAContactorPartOfRenewalAndState)
{
    MoreContactors set(numberTypes<DoublePrecision>()), renewed(numberTypes<DoublePrecision>());
    set.wear.assign({1, 2, 3});
    renewed.wear.resize(2);
    for (std::size_t k = 0; k < set.fields().size(); ++k)
        if (set.fields()[k]->info().renewal == Renewal::kept)
            renewed.fields()[k]->take(*set.fields()[k], {2, -1}, 3);
    EXPECT_EQ(renewed.wear.toHost(), (std::vector<double>{3, 0}));
    MoreContactors restored(numberTypes<DoublePrecision>());
    restored.wear.resize(3);
    restored.setImages(Role::state, set.images(Role::state));
    EXPECT_EQ(restored.wear.toHost(), (std::vector<double>{1, 2, 3}));
}

TEST(FieldBase, TakesPlanesOverByTheirOldNumbers)
{
    FieldSet set("vectors", hostMemory(), {});
    const Field<double> old(set, {"force", Location::contactor, Role::state},
                            std::vector<double>{1, 2, 3, 10, 20, 30});
    Field<double> renewed(set, {"force", Location::contactor, Role::state}, 8);
    renewed.take(old, {2, -1, 0, 2}, 3);
    EXPECT_EQ(renewed.toHost(), (std::vector<double>{3, 0, 1, 3, 30, 0, 10, 30}));
}

TEST(FieldBase, RefusesAnotherNumberOfValues)
{
    FieldSet set("vectors", hostMemory(), {});
    Field<double> field(set, {"force", Location::contactor, Role::state}, 2);
    EXPECT_THROW(field.fromHost({1, 2, 3}), Error);
}

TEST(Value, IsPartOfTheState)
{
    FieldSet ledger("ledger", hostMemory(), {}), other("ledger", hostMemory(), {});
    Value<double> energy(ledger, "energy"), restored(other, "energy");
    energy = 2;
    energy += 0.5;
    other.setImages(Role::state, ledger.images(Role::state));
    EXPECT_EQ(restored(), 2.5);
}

} // namespace
} // namespace fpm
