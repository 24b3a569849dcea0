#pragma once

#include "base/Types.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fpm {

/// Turns the tags of a mesh file (any positive numbers, gaps allowed) into numbers 0 ... n-1 in
/// ascending order of the tags.
class TagMap
{
public:
    TagMap() = default;
    explicit TagMap(std::vector<std::size_t> tags) : tags_(std::move(tags))
    {
        std::sort(tags_.begin(), tags_.end());
        tags_.erase(std::unique(tags_.begin(), tags_.end()), tags_.end());
    }
    std::size_t size() const { return tags_.size(); }
    /// -1 for an unknown tag.
    Index find(std::size_t tag) const
    {
        const auto place = std::lower_bound(tags_.begin(), tags_.end(), tag);
        return place == tags_.end() || *place != tag ? -1 : Index(place - tags_.begin());
    }
    std::size_t tag(Index number) const { return tags_[number]; }

private:
    std::vector<std::size_t> tags_;
};

} // namespace fpm
