#pragma once

#include <span>

#include "kernel.h"
#include "words.h"

/// What reads diagrams and makes no nodes.
namespace heed::bdd {

/// Variables (kernel numbers) that it depends on, ascending.
[[nodiscard]] std::vector<std::uint32_t> support_variables(const Kernel& kernel, Edge f);
/// Nodes below the roots, shared ones once, with the terminal.
[[nodiscard]] std::size_t shared_size(const Kernel& kernel, std::span<const Edge> roots);
[[nodiscard]] double count_double(const Kernel& kernel, Edge f, std::size_t variables);
[[nodiscard]] Words count_exactly(const Kernel& kernel, Edge f, std::size_t variables);

}  // namespace heed::bdd
