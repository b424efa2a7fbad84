// The one place that knows MPI. It is a module of its own, loaded under mpirun only: linked into the program,
// Open MPI's libraries alone would take longer to load than many commands take to run.
#include "module.h"

#include <mpi.h>

#include <climits>

int heed_mpi_start(int* rank, int* size) {
  int provided = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS) return 1;
  MPI_Comm_rank(MPI_COMM_WORLD, rank);
  MPI_Comm_size(MPI_COMM_WORLD, size);
  return provided < MPI_THREAD_FUNNELED ? 1 : 0;
}

int heed_mpi_first_failed(int failed) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  int mine = failed != 0 ? rank : INT_MAX, first = INT_MAX;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return first == INT_MAX ? -1 : first;
}

void heed_mpi_sum(std::uint64_t* counts, int size) {
  MPI_Allreduce(MPI_IN_PLACE, counts, size, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
}

void heed_mpi_tell(int from, char* buffer, int size) {
  MPI_Bcast(buffer, size, MPI_CHAR, from, MPI_COMM_WORLD);
}

void heed_mpi_finish() {
  MPI_Finalize();
}
