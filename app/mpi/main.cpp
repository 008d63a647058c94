// verstat-mpi: the same program, its replications on the ranks of an MPI job.
//   mpirun -n 9 verstat-mpi optimize STUDY.json --db night.db
#include <csignal>
#include <cstdio>
#include <memory>

#include <mpi.h>
#include <unistd.h>

#include "app/cli.h"
#include "app/elsewhere.h"
#include "app/mpi/ranks.h"

namespace {

volatile int exit_code = 0;

// A rank that died unnoticed would keep the others in MPI_Finalize for ever: after this time they go without.
constexpr unsigned farewell_s = 10;
void leave(int) {
  ::_exit(exit_code);
}

}  // namespace

int main(int argc, char** argv) {
  int provided = MPI_THREAD_SINGLE;
  if (MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS ||
      provided < MPI_THREAD_FUNNELED) {
    std::fputs("error: this MPI cannot be used beside threads\n", stderr);
    return verstat::app::failure;
  }
  int rank = 0;
  int size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  int code = verstat::app::success;
  if (rank > 0) {
    verstat::app::serve_rank_0();
  } else if (size == 1) {
    code = verstat::app::run_program(argc, argv);
  } else {
    auto ranks = std::make_unique<verstat::app::Ranks>(size);
    verstat::app::elsewhere() = [&](const auto& scenario, std::uint64_t first, std::int64_t count,
                                    const auto& check) { return ranks->run(scenario, first, count, check); };
    code = verstat::app::run_program(argc, argv);
    const bool all = ranks->stop();
    std::fflush(nullptr);
    if (!all) ::_exit(code);  // MPI_Finalize would wait for the dead
  }
  exit_code = code;
  std::signal(SIGALRM, leave);
  ::alarm(farewell_s);
  // A code other than 0 from MPI_Finalize on would look like a crash of the job: rank 0 tells it.
  MPI_Finalize();
  return code;
}
