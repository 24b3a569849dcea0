#include "fields/FieldBase.h"

#include "base/Error.h"
#include "base/Format.h"
#include "fields/FieldSet.h"
#include "parallel/Precision.h"

#include <cstring>

namespace fpm {

namespace {

template <class T>
std::vector<double> widened(const std::vector<std::byte>& image)
{
    std::vector<T> values(image.size() / sizeof(T));
    if (!image.empty()) std::memcpy(values.data(), image.data(), image.size());
    std::vector<double> out;
    out.reserve(values.size());
    for (const T& value : values) out.push_back(double(value));
    return out;
}

} // namespace

FieldBase::FieldBase(FieldSet& set, const FieldInfo& info, ValueType type, std::size_t valueBytes)
    : set_(set),
      info_(info),
      type_(type),
      valueBytes_(valueBytes)
{
    set.fields_.push_back(this);
}

FieldBase::~FieldBase()
{
    if (memory_) set_.memory().release(memory_);
}

void FieldBase::resize(std::size_t size)
{
    if (memory_) set_.memory().release(memory_);
    memory_ = nullptr;
    size_ = 0;
    if (size > 0) memory_ = set_.memory().allocate(size * valueBytes_);
    size_ = size;
}

void FieldBase::upload(const void* values, std::size_t size)
{
    if (size != size_)
        throw Error(ExitCode::internal, format("field {} of {} has {} values and was given {}",
                                               info_.name, set_.name(), size_, size));
    if (size_ > 0) set_.memory().toDevice(memory_, values, bytes());
}

void FieldBase::download(void* values) const
{
    if (size_ > 0) set_.memory().toHost(values, memory_, bytes());
}

std::vector<std::byte> FieldBase::image() const
{
    std::vector<std::byte> out(bytes());
    download(out.data());
    return out;
}

void FieldBase::setImage(const std::vector<std::byte>& image)
{
    upload(image.data(), image.size() / valueBytes_);
}

void FieldBase::take(const FieldBase& old, const std::vector<Index>& from, std::size_t oldCount)
{
    if (oldCount == 0 || old.size() == 0 || size() == 0 || from.empty()) return;
    const std::vector<std::byte> before = old.image();
    std::vector<std::byte> after = image();
    for (std::size_t plane = 0; plane < old.size() / oldCount; ++plane)
        for (std::size_t i = 0; i < from.size(); ++i)
            if (from[i] >= 0)
                std::memcpy(&after[(plane * from.size() + i) * valueBytes_],
                            &before[(plane * oldCount + std::size_t(from[i])) * valueBytes_],
                            valueBytes_);
    setImage(after);
}

std::vector<double> FieldBase::toDoubles() const
{
    switch (type_) {
    case ValueType::float32:
        return widened<float>(image());
    case ValueType::float64:
        return widened<double>(image());
    case ValueType::compensated:
        return widened<Compensated>(image());
    case ValueType::record:
        break;
    }
    throw Error(ExitCode::internal,
                format("field {} of {} holds no numbers", info_.name, set_.name()));
}

} // namespace fpm
