#pragma once

#include <cstdint>

/// What the program asks of the module that it loads when mpirun has started it. Plain functions: the module
/// is found by these names. All but heed_mpi_start() are called by every process in the same order.
extern "C" {
/// Joins the others. \returns 0, or not 0 where that failed
int heed_mpi_start(int* rank, int* size);
/// The lowest rank that called it with \p failed not 0; -1 where none did.
int heed_mpi_first_failed(int failed);
void heed_mpi_sum(std::uint64_t* counts, int size);
/// Gives everybody what \p from has in its buffer.
void heed_mpi_tell(int from, char* buffer, int size);
void heed_mpi_finish();
}
