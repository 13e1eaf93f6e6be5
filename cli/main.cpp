#include "isolaw/app/app.hpp"

int main(int argc, char** argv) {
  return isolaw::app::run(argc, argv);
}
