#include "app/cli.h"

int main(int argc, char** argv) {
  return verstat::app::run_program(argc, argv);
}
