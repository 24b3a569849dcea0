#pragma once

#include "base/Types.h"
#include "parallel/Memory.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace fpm {

class FieldSet;

/// What the values of a field belong to. `table`: none of the others, as long as the set-up says;
/// `list`: of any length.
enum class Location {
    global,
    node,
    element,
    patch,
    contactNode,
    contactor,
    face,
    body,
    block,
    table,
    list
};

/// What a field is for. `constant`: from the set-up, no step writes it. `state`: a step reads what
/// earlier steps wrote, so a checkpoint holds it. `derived`: follows from constants and state,
/// and is made anew when deletions renew a contact pass.
/// `scratch`: written before it is read.
enum class Role { constant, state, derived, scratch };

/// Fate of a contactor's values when deleted elements renew its pass: they are reset, kept with the
/// contactor, or kept only while the face it is in contact with is kept too.
enum class Renewal { reset, kept, keptInContact };

/// Declaration of a field: all that loops over fields need.
struct FieldInfo {
    std::string_view name;
    Location location;
    Role role;
    Renewal renewal = Renewal::reset;
};

/// Types of numbers that can be read as doubles. `record`: no number.
enum class ValueType : std::uint8_t { float32, float64, compensated, record };

/// Named values of one type in the memory of an executor, zero at first. A member of the set that
/// declares it, so it neither moves nor is copied.
class FieldBase
{
public:
    FieldBase(FieldSet& set, const FieldInfo& info, ValueType type, std::size_t valueBytes);
    FieldBase(const FieldBase&) = delete;
    FieldBase& operator=(const FieldBase&) = delete;
    ~FieldBase();

    const FieldInfo& info() const { return info_; }
    std::size_t size() const { return size_; } ///< in values
    std::size_t valueBytes() const { return valueBytes_; }
    std::size_t bytes() const { return size_ * valueBytes_; }
    /// New memory for so many values, all zero.
    void resize(std::size_t size);

    /// All values as they lie in memory; setImage() needs as many bytes as there are.
    std::vector<std::byte> image() const;
    void setImage(const std::vector<std::byte>& image);
    /// Planes of as many values as `from` has, of those that `old` has of `oldCount`: value i is
    /// that of from[i], and stays where that is -1. Both are fields of one declaration.
    void take(const FieldBase& old, const std::vector<Index>& from, std::size_t oldCount);
    /// Numbers, each as a double; exact. Records are refused as an internal error.
    std::vector<double> toDoubles() const;

protected:
    void* memory_ = nullptr;
    void upload(const void* values, std::size_t size);
    void download(void* values) const;

private:
    const FieldSet& set_;
    FieldInfo info_;
    ValueType type_;
    std::size_t valueBytes_, size_ = 0;
};

} // namespace fpm
