#include "fields/NumberField.h"

namespace fpm {

namespace {

ValueType typeOf(const NumberTypes& numbers, Family family)
{
    switch (family) {
    case Family::position:
        return numbers.position;
    case Family::motion:
        return numbers.motion;
    case Family::work:
        return numbers.work;
    case Family::sum:
        break;
    }
    return numbers.sum;
}

std::size_t bytesOf(ValueType type)
{
    return type == ValueType::float32 ? sizeof(float) : sizeof(double);
}
static_assert(sizeof(Compensated) == sizeof(double));

template <class T>
std::vector<T> rounded(const std::vector<double>& values)
{
    return {values.begin(), values.end()};
}

} // namespace

NumberField::NumberField(FieldSet& set, const FieldInfo& info, Family family, std::size_t size)
    : FieldBase(set, info, typeOf(set.numbers(), family), bytesOf(typeOf(set.numbers(), family))),
      number_(typeOf(set.numbers(), family))
{
    resize(size);
}

NumberField::NumberField(FieldSet& set,
                         const FieldInfo& info,
                         Family family,
                         const std::vector<double>& values)
    : NumberField(set, info, family)
{
    assign(values);
}

void NumberField::assign(const std::vector<double>& values)
{
    resize(values.size());
    if (number_ == ValueType::float64)
        upload(values.data(), values.size());
    else if (number_ == ValueType::float32)
        upload(rounded<float>(values).data(), values.size());
    else
        upload(rounded<Compensated>(values).data(), values.size());
}

} // namespace fpm
