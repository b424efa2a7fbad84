#pragma once

#include <functional>
#include <string_view>

namespace heed::util {

/// Called with a stage ("synthesize awareness") and how far it is, 0 ... 1. Empty: nobody looks.
using Progress = std::function<void(std::string_view stage, double done)>;

}  // namespace heed::util
