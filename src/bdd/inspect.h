#pragma once

#include <heed/bdd/bdd.h>

#include <span>

#include "kernel.h"
#include "words.h"

/// What reads diagrams and makes no nodes.
namespace heed::bdd {

/// Variables (kernel numbers) that it depends on, ascending.
[[nodiscard]] std::vector<std::uint32_t> support_variables(Kernel& kernel, Edge f);
/// Whether that one (a kernel number) is among them, without listing all.
[[nodiscard]] bool depends_on(Kernel& kernel, Edge f, std::uint32_t variable);
/// Nodes below the roots, shared ones once, with the terminal.
[[nodiscard]] std::size_t shared_size(Kernel& kernel, std::span<const Edge> roots);
[[nodiscard]] double count_double(Kernel& kernel, Edge f, std::size_t variables);
[[nodiscard]] Words count_exactly(Kernel& kernel, Edge f, std::size_t variables);
/// The nodes and roots of serialise(); its order is left to the caller.
[[nodiscard]] Serialised listed(Kernel& kernel, std::span<const Edge> roots);

}  // namespace heed::bdd
