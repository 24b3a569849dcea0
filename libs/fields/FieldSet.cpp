#include "fields/FieldSet.h"

#include "base/Error.h"
#include "base/Format.h"

namespace fpm {

FieldSet::FieldSet(std::string name, const Memory& memory, const NumberTypes& numbers)
    : name_(std::move(name)),
      memory_(memory),
      numbers_(numbers)
{
}

std::size_t FieldSet::bytes() const
{
    std::size_t sum = 0;
    for (const FieldBase* field : fields_) sum += field->bytes();
    return sum;
}

FieldSet::Images FieldSet::images(Role role) const
{
    Images out;
    for (const FieldBase* field : fields_)
        if (field->info().role == role)
            out.emplace_back(std::string(field->info().name), field->image());
    return out;
}

void FieldSet::setImages(Role role, const Images& images)
{
    std::size_t next = 0;
    for (FieldBase* field : fields_) {
        if (field->info().role != role) continue;
        if (next == images.size() || images[next].first != field->info().name)
            throw Error(ExitCode::checkpoint,
                        format("{}: no values of field {}", name_, field->info().name));
        const std::vector<std::byte>& image = images[next++].second;
        const bool grows =
            field->info().location == Location::list && image.size() % field->valueBytes() == 0;
        if (image.size() != field->bytes() && !grows)
            throw Error(ExitCode::checkpoint,
                        format("{}: {} bytes of field {}, which has {}", name_, image.size(),
                               field->info().name, field->bytes()));
        if (image.size() != field->bytes()) field->resize(image.size() / field->valueBytes());
        field->setImage(image);
    }
    if (next != images.size())
        throw Error(ExitCode::checkpoint, format("{} has no field {}", name_, images[next].first));
}

} // namespace fpm
