#pragma once

#include "fields/FieldBase.h"

#include <string>
#include <utility>

namespace fpm {

/// The types that a run computes with, one per family of numbers; see NumberField.
struct NumberTypes {
    ValueType position = ValueType::float64, motion = ValueType::float64, work = ValueType::float64,
              sum = ValueType::float64;
};

/// Fields that live together: each is a member of a class derived from this, which it enters by
/// being declared. What holds for all of them is a loop over fields().
class FieldSet
{
public:
    FieldSet(std::string name, const Memory& memory, const NumberTypes& numbers);
    FieldSet(const FieldSet&) = delete;
    FieldSet& operator=(const FieldSet&) = delete;

    const std::string& name() const { return name_; }
    const Memory& memory() const { return memory_; }
    const NumberTypes& numbers() const { return numbers_; }
    /// In the order in which they are declared.
    const std::vector<FieldBase*>& fields() const { return fields_; }
    std::size_t bytes() const;

    /// Values of all fields of a role, with their names; setImages() wants the same ones, in the
    /// sizes the fields have now but for lists. Throws Error(checkpoint) for others.
    using Images = std::vector<std::pair<std::string, std::vector<std::byte>>>;
    Images images(Role role) const;
    void setImages(Role role, const Images& images);

private:
    friend class FieldBase;
    std::string name_;
    const Memory& memory_;
    NumberTypes numbers_;
    std::vector<FieldBase*> fields_;
};

} // namespace fpm
